#include "block/blend.hpp"
#include "block/cells.hpp"
#include "block/connect.hpp"
#include "block/numbering.hpp"
#include "block/reference.hpp"
#include "block/resample.hpp"

#include "element/quadrature.hpp"
#include "element/table.hpp"
#include "layouts.hpp"
#include "mesh/validity.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <random>
#include <set>

using namespace blockfsi;
using namespace blockfsi::block;
using namespace blockfsi::block::testing;
using element::Shape;

namespace
{

constexpr std::array<Shape, 6> shapes{Shape::triangle,   Shape::quadrilateral, Shape::tetrahedron,
                                      Shape::hexahedron, Shape::prism,         Shape::pyramid};

/// Volume, or area, of a mesh of any cells, by quadrature, and the smallest Jacobian there.
Measure measure_cells(const mesh::Mesh& mesh, const std::vector<double>& x)
{
  Measure result;
  for (const mesh::CellRun& run : mesh.runs)
  {
    const element::CellRule rule = element::quadrature(run.shape, 3 * mesh.order);
    const element::CellTable table = element::tabulate(run.shape, mesh.order, rule.points);
    for (std::int32_t c = run.first; c < run.first + run.count; ++c)
      for (int q = 0; q < table.point_count; ++q)
      {
        double J[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        for (int d = 0; d < mesh.dim; ++d)
          for (int k = 0; k < mesh.dim; ++k)
          {
            J[d][k] = 0.0;
            for (int n = 0; n < table.node_count; ++n)
              J[d][k] += table.first[d][q * table.node_count + n] * x[mesh.dim * mesh.cell(c)[n] + k];
          }
        const double determinant = J[0][0] * (J[1][1] * J[2][2] - J[1][2] * J[2][1]) -
                                   J[0][1] * (J[1][0] * J[2][2] - J[1][2] * J[2][0]) +
                                   J[0][2] * (J[1][0] * J[2][1] - J[1][1] * J[2][0]);
        result.area += rule.weights[q] * determinant;
        result.smallest = std::min(result.smallest, determinant);
      }
  }
  return result;
}

/// A block over the corners of the reference cell, moved by an affine map; all its sides are "wall".
Layout one_cell(Shape shape, int order, int divisions)
{
  Layout layout;
  layout.dim = element::dimension(shape);
  layout.order = order;
  layout.default_divisions = divisions;
  Block block{"block", "fluid", {}, {}, shape};
  for (const auto& x : element::corners(shape))
  {
    block.points.push_back(static_cast<int>(layout.points.size()));
    const double z = layout.dim == 2 ? 0.0 : x[2];
    layout.points.push_back(
        {"p" + std::to_string(block.points.back()),
         {x[0] + 0.2 * x[1] + 0.1 * z, x[1] - 0.1 * x[0], 1.5 * z + 0.3 * x[0] * (layout.dim - 2)},
         {}});
  }
  layout.blocks.push_back(block);
  layout.boundaries.push_back({"wall", ByCondition{{"x > -10", {}}}, {}});
  return layout;
}

double reference_volume(Shape shape)
{
  const element::CellRule rule = element::quadrature(shape, 1);
  double sum = 0.0;
  for (const double w : rule.weights)
    sum += w;
  return sum;
}

double affine_factor(int dim)
{
  return dim == 2 ? 1.02 : 1.0 * (1.0 * 1.5) - 0.2 * (-0.1 * 1.5) + 0.1 * (-0.3);
}

std::size_t cell_count(Shape shape, std::size_t n)
{
  switch (shape)
  {
  case Shape::triangle:
  case Shape::quadrilateral:
    return n * n;
  case Shape::pyramid:
    return n * (2 * n * n + 1) / 3 + 2 * (n - 1) * n * (n + 1) / 3;
  default:
    return n * n * n;
  }
}

/// Sets of nodes of the sides of all cells, with how many cells have them.
std::map<std::set<std::int32_t>, int> sides_of(const mesh::Mesh& mesh)
{
  std::map<std::set<std::int32_t>, int> count;
  for (const mesh::CellRun& run : mesh.runs)
    for (std::size_t side = 0; side < element::sides(run.shape).size(); ++side)
    {
      const std::vector<std::int32_t> at =
          element::side_lattice(run.shape, mesh.order, static_cast<int>(side));
      for (std::int32_t c = run.first; c < run.first + run.count; ++c)
      {
        std::set<std::int32_t> nodes;
        for (const std::int32_t n : at)
          nodes.insert(mesh.cell(c)[n]);
        ++count[nodes];
      }
    }
  return count;
}

/// A plan for a single block whose "skeleton" holds the nodes of all its lattice, with these parameters of
/// the edges' cells (corners of cells, in the direction of element::edges).
struct Single
{
  Single(Shape shape, int order, const std::vector<std::vector<double>>& corners)
  {
    const auto n = static_cast<int>(corners[0].size()) - 1;
    plan.grid = {shape, {n * order, n * order, element::dimension(shape) == 2 ? 0 : n * order}};
    for (int c = 0; c < element::corner_count(shape); ++c)
      plan.corners[c] = static_cast<std::int32_t>(index(plan.grid, corner_point(plan.grid, c)));
    for (int side = 0; side < static_cast<int>(element::sides(shape).size()); ++side)
    {
      const Grid grid = side_grid(plan.grid, side);
      const SideFrame frame = side_frame(plan.grid, side);
      plan.sides.emplace_back();
      for (int t = 0; t < row_count(grid, 0); ++t)
        for (int s = 0; s < row_length(grid, t, 0); ++s)
          plan.sides.back().push_back(static_cast<std::int32_t>(index(plan.grid, frame.at(s, t))));
    }
    plan.rows = inner_rows(plan.grid);
    const std::vector<double> inner = element::lobatto(order);
    EdgeParameters edges;
    for (const auto& t : corners)
    {
      edges.emplace_back();
      for (int i = 0; i < n * order; ++i)
        edges.back().push_back(t[i / order] + inner[i % order] * (t[i / order + 1] - t[i / order]));
      edges.back().push_back(1.0);
    }
    set_reference(edges, order, 0, plan);
  }

  /// Blends three components given on all nodes; the inner ones are overwritten.
  std::vector<double> blend(const std::vector<double>& data) const
  {
    std::vector<double> x = data;
    for (const BlockPlan::Row& row : plan.rows)
      for (int i = 3 * row.node; i < 3 * (row.node + row.end - row.begin); ++i)
        x[i] = -99.0;
    std::vector<double> work(work_size(plan, 3));
    block::blend(plan, 3, data.data(), work.data(), x.data());
    return x;
  }

  BlockPlan plan;
};

/// Reference coordinates of all nodes of a uniformly divided block: warped within each cell.
std::vector<std::array<double, 3>> reference_nodes(const Grid& grid, int order)
{
  const int n = grid.steps[0] / order;
  const int levels = element::dimension(grid.shape) == 2 ? 0 : n;
  const BlockCells cells({grid.shape, {n, n, levels}}, order, 0);
  const BlockCells coarse({grid.shape, {n, n, levels}}, 1, 0);
  std::vector<std::array<double, 3>> result;
  std::vector<std::vector<double>> weights;
  for (const CellKind& kind : cells.kinds())
    weights.push_back(
        element::resample(kind.shape, {1, element::NodeKind::warped}, {order, element::NodeKind::warped}));
  for (const BlockPlan::Row& row : all_rows(grid))
    for (int i = row.begin; i < row.end; ++i)
    {
      const BlockCells::Found cell = cells.find({i, row.j, row.k});
      const auto& offsets = coarse.kinds()[cell.kind].nodes;
      std::array<double, 3> x{};
      for (std::size_t c = 0; c < offsets.size(); ++c)
        for (int d = 0; d < 3; ++d)
          x[d] += weights[cell.kind][cell.local * offsets.size() + c] * (cell.box[d] + offsets[c][d]) / n;
      result.push_back(x);
    }
  return result;
}

std::vector<std::vector<double>> equal_edges(Shape shape, int n)
{
  std::vector<double> t;
  for (int i = 0; i <= n; ++i)
    t.push_back(static_cast<double>(i) / n);
  return std::vector<std::vector<double>>(element::edges(shape).size(), t);
}

/// Largest error of blending the trace of a monomial on a uniformly divided block.
double monomial_error(Shape shape, int order, int n, const std::array<int, 3>& powers)
{
  const Single block(shape, order, equal_edges(shape, n));
  std::vector<double> data;
  for (const auto& x : reference_nodes(block.plan.grid, order))
  {
    const double value = std::pow(x[0], powers[0]) * std::pow(x[1], powers[1]) * std::pow(x[2], powers[2]);
    data.insert(data.end(), {value, value, value});
  }
  const std::vector<double> found = block.blend(data);
  double largest = 0.0;
  for (std::size_t i = 0; i < data.size(); ++i)
    largest = std::max(largest, std::abs(found[i] - data[i]));
  return largest;
}

}  // namespace

TEST_CASE("blocks of all shapes have the cells of the formulas, of exact volume, at any order")
{
  for (const Shape shape : shapes)
    for (const int n : {1, 2, 3, 5})
      for (const int order : {1, 2, 3, 4})
      {
        if (n == 5 && order > 2)
          continue;
        CAPTURE(element::name(shape));
        CAPTURE(n);
        CAPTURE(order);
        const Layout layout = one_cell(shape, order, n);
        const Skeleton skeleton = make_skeleton(layout);
        const Connected all = connect(layout, skeleton, "", {});
        CHECK(all.mesh.cell_count() == cell_count(shape, static_cast<std::size_t>(n)));
        CHECK(all.mesh.node_count() == static_cast<std::size_t>(element::lattice_size(shape, n * order)));
        const Measure found = measure_cells(all.mesh, place(all, skeleton));
        CHECK(found.area ==
              doctest::Approx(reference_volume(shape) * affine_factor(layout.dim)).epsilon(1e-12));
        CHECK(found.smallest > 0.0);
      }
}

TEST_CASE("cells of all shapes meet side to side: inner sides have two cells, outer ones lie on the boundary")
{
  for (const Shape shape : shapes)
    for (const int n : {1, 2, 4})
      for (const int order : {1, 2, 3})
      {
        CAPTURE(element::name(shape));
        const Layout layout = one_cell(shape, order, n);
        const mesh::Mesh mesh = connect(layout, make_skeleton(layout), "", {}).mesh;
        const auto count = sides_of(mesh);
        std::size_t outer = 0;
        for (const auto& [nodes, cells] : count)
        {
          CHECK(cells <= 2);
          outer += cells == 1 ? 1 : 0;
        }
        const std::vector<mesh::Side>& wall = mesh.boundaries.at("wall");
        CHECK(wall.size() == outer);
        for (const mesh::Side& side : wall)
        {
          std::set<std::int32_t> nodes;
          for (const std::int32_t at : element::side_lattice(mesh.shape(side.cell), order, side.side))
            nodes.insert(mesh.cell(side.cell)[at]);
          CHECK(count.at(nodes) == 1);
        }
      }
}

TEST_CASE("the maps reproduce polynomials to the degrees of the formulation and lose the next")
{
  struct Expected
  {
    Shape shape;
    int degree;  ///< every monomial up to this total degree is reproduced
    std::array<int, 3> lost;
  };
  const std::vector<Expected> table{{Shape::triangle, 1, {1, 1, 0}},    {Shape::quadrilateral, 3, {2, 2, 0}},
                                    {Shape::tetrahedron, 2, {1, 1, 1}}, {Shape::hexahedron, 5, {2, 2, 2}},
                                    {Shape::prism, 2, {1, 1, 2}},       {Shape::pyramid, 3, {2, 2, 0}}};
  for (const Expected& expected : table)
    for (const auto& [order, n] : {std::array{1, 5}, std::array{2, 3}, std::array{5, 2}})
    {
      CAPTURE(element::name(expected.shape));
      CAPTURE(order);
      const bool flat = element::dimension(expected.shape) == 2;
      for (int a = 0; a <= expected.degree; ++a)
        for (int b = 0; a + b <= expected.degree; ++b)
          for (int c = 0; a + b + c <= expected.degree; ++c)
            if (!flat || c == 0)
            {
              CAPTURE(a);
              CAPTURE(b);
              CAPTURE(c);
              CHECK(monomial_error(expected.shape, order, n, {a, b, c}) < 1e-13);
            }
      CHECK(monomial_error(expected.shape, order, n, expected.lost) > 1e-4);
    }
}

TEST_CASE("nodes of triangles sit where the parallel form has their warped coordinates, at any order")
{
  // Edges bent by a polynomial of the order of the cells, less at its ends, so that cells carry it exactly.
  for (int order = 1; order <= element::largest_order; ++order)
  {
    CAPTURE(order);
    const Single block(Shape::triangle, order, equal_edges(Shape::triangle, 3));
    const auto bend = [order](int edge, double t)
    { return order == 1 ? 0.0 : (edge + 1) * t * (1.0 - t) * std::pow(t + 0.3, order - 2); };
    const auto form = [&bend](double u, double v)
    {
      const double w = 1.0 - u - v;
      return w * (bend(0, u) + bend(2, v)) + u * (bend(0, u + v) + bend(1, v)) +
             v * (bend(2, u + v) + bend(1, 1.0 - u));
    };
    std::vector<double> data;
    for (const auto& x : reference_nodes(block.plan.grid, order))
      data.insert(data.end(), {x[0], x[1], form(x[0], x[1])});
    const std::vector<double> found = block.blend(data);
    for (std::size_t i = 0; i < data.size(); ++i)
      CHECK(std::abs(found[i] - data[i]) < 1e-13);
  }
}

TEST_CASE("graded blocks with straight edges stay straight: the graded coordinates are a fixed point")
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> ratio(1.2, 1.6);
  for (const Shape shape : shapes)
    for (const int order : {1, 2, 3})
    {
      CAPTURE(element::name(shape));
      CAPTURE(order);
      const int n = 4;
      Layout layout = one_cell(shape, order, n);
      for (std::size_t e = 0; e < element::edges(shape).size(); ++e)
      {
        const auto& ends = element::edges(shape)[e];
        add_edge(layout, ends[0], ends[1]).grading = Geometric{ratio(random)};
      }
      const Skeleton skeleton = make_skeleton(layout);
      const Connected all = connect(layout, skeleton, "", {});
      const std::vector<double> x = place(all, skeleton);
      const Measure found = measure_cells(all.mesh, x);
      CHECK(found.area ==
            doctest::Approx(reference_volume(shape) * affine_factor(layout.dim)).epsilon(1e-12));
      CHECK(found.smallest > 0.0);
    }
}

TEST_CASE("curved and graded blocks have the same nodes in every share, bit for bit")
{
  for (const Shape shape : shapes)
    for (const auto& [alike, order] : {std::pair{true, 2}, {false, 2}, {true, 4}, {false, 3}})
    {
      CAPTURE(element::name(shape));
      CAPTURE(alike);
      CAPTURE(order);
      std::mt19937 random(7);
      std::uniform_real_distribution<double> shift(-0.05, 0.05);
      Layout layout = one_cell(shape, order, order == 2 ? 9 : 5);
      for (const auto& ends : element::edges(shape))
      {
        geometry::Point middle{};
        for (int c = 0; c < layout.dim; ++c)
          middle[c] = 0.5 * (layout.points[ends[0]].x[c] + layout.points[ends[1]].x[c]) + shift(random);
        Edge& edge = add_edge(layout, ends[0], ends[1]);
        edge.curve = geometry::ArcThrough{middle};
        if (!alike)
          edge.grading = Geometric{1.1 + shift(random)};
      }
      const Skeleton skeleton = make_skeleton(layout);
      const std::vector<double> expected = place(connect(layout, skeleton, "", {}), skeleton);
      for (const int parts : {2, 5})
        for (int rank = 0; rank < parts; ++rank)
        {
          const Connected part = connect(layout, skeleton, "fluid", {rank, parts});
          const std::vector<double> x = place(part, skeleton);
          int different = 0;
          for (std::size_t n = 0; n < part.mesh.node_count(); ++n)
            for (int c = 0; c < layout.dim; ++c)
              different +=
                  x[layout.dim * n + c] != expected[layout.dim * std::size_t(part.mesh.lattice[n]) + c] ? 1
                                                                                                        : 0;
          CHECK(different == 0);
        }
    }
}

TEST_CASE("the shares of 1, 2, 3, 5 and 7 processes add up to the whole mesh for every shape")
{
  for (const Shape shape : shapes)
    for (const int order : {1, 2, 3})
    {
      CAPTURE(element::name(shape));
      const Layout layout = one_cell(shape, order, 3);
      const Skeleton skeleton = make_skeleton(layout);
      const Connected whole = connect(layout, skeleton, "", {});
      const std::vector<double> expected = place(whole, skeleton);
      for (const int parts : {1, 2, 3, 5, 7})
      {
        std::set<std::int64_t> cells;
        std::set<std::int64_t> owned;
        std::size_t sides = 0;
        for (int rank = 0; rank < parts; ++rank)
        {
          const Connected part = connect(layout, skeleton, "fluid", {rank, parts});
          const std::vector<double> x = place(part, skeleton);
          for (std::size_t n = 0; n < part.mesh.node_count(); ++n)
          {
            const auto number = static_cast<std::size_t>(part.mesh.lattice[n]);
            if (part.mesh.owner_of(static_cast<std::int32_t>(n)) == rank)
              CHECK(owned.insert(part.mesh.lattice[n]).second);
            for (int c = 0; c < layout.dim; ++c)
              CHECK(x[layout.dim * n + c] == expected[layout.dim * number + c]);
          }
          for (std::size_t c = 0; c < part.mesh.cell_count(); ++c)
          {
            const std::int64_t number = part.mesh.number_of_cell(c);
            CHECK(cells.insert(number).second);
            CHECK(part.mesh.shape(c) == whole.mesh.shape(static_cast<std::size_t>(number)));
            const auto nodes = part.mesh.cell(c);
            const auto same = whole.mesh.cell(static_cast<std::size_t>(number));
            for (std::size_t n = 0; n < nodes.size(); ++n)
              CHECK(part.mesh.lattice[nodes[n]] == same[n]);
          }
          sides += part.mesh.boundaries.at("wall").size();
        }
        CHECK(cells.size() == whole.mesh.cell_count());
        CHECK(owned.size() == whole.mesh.node_count());
        CHECK(sides == whole.mesh.boundaries.at("wall").size());
      }
    }
}
