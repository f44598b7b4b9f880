#include "block/reference_triangular.hpp"

#include "block/cells.hpp"
#include "block/crossing.hpp"
#include "block/kernel.hpp"
#include "block/numbering.hpp"
#include "block/resample.hpp"
#include "block/triangle_nodes.hpp"
#include "element/table.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace blockfsi::block
{

namespace
{

using element::LatticePoint;
using element::Shape;

/// Parameters of lattice points along an edge.
using Line = std::vector<double>;
using Lines = std::vector<Line>;

Line every(const Line& line, int step)
{
  Line result;
  for (std::size_t i = 0; i < line.size(); i += static_cast<std::size_t>(step))
    result.push_back(line[i]);
  return result;
}

/// The same cells with nodes at equal steps.
Line with_equal_steps(const Line& line, int order)
{
  Line result = line;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    const std::size_t step = i % static_cast<std::size_t>(order);
    if (step != 0)
    {
      const double low = line[i - step];
      const double high = line[i - step + static_cast<std::size_t>(order)];
      result[i] = low + static_cast<double>(step) / order * (high - low);
    }
  }
  return result;
}

bool has_equal_steps(const Line& line)
{
  const auto n = static_cast<double>(line.size() - 1);
  for (std::size_t i = 0; i < line.size(); ++i)
    if (std::abs(line[i] - static_cast<double>(i) / n) > 8.0 * std::numeric_limits<double>::epsilon())
      return false;
  return true;
}

/// An edge of the block between two of its corners, in this direction.
Line between(Shape shape, const Lines& lines, int from, int to)
{
  const auto edges = element::edges(shape);
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    if (edges[e][0] == from && edges[e][1] == to)
      return lines[e];
    if (edges[e][0] == to && edges[e][1] == from)
    {
      Line turned(lines[e].rbegin(), lines[e].rend());
      for (double& t : turned)
        t = 1.0 - t;
      return turned;
    }
  }
  return {};
}

/// The edges of a side in its own directions.
Lines side_lines(Shape shape, const Lines& lines, const element::SideShape& side)
{
  Lines result;
  for (const auto& edge : element::edges(side.shape))
    result.push_back(between(shape, lines, side.corners[edge[0]], side.corners[edge[1]]));
  return result;
}

/// Weights (without the first) with r = sum_i w_i T_i(r): the fixed point of the parallel form; `start` if it
/// has none inside.
template <int dimension>
std::array<double, 3> fixed_point(const std::array<std::array<double, 3>, 4>& T,
                                  const std::array<double, 3>& start)
{
  Eigen::Matrix<double, dimension, dimension> matrix;
  Eigen::Matrix<double, dimension, 1> right;
  for (int row = 0; row < dimension; ++row)
  {
    right(row) = T[0][row];
    for (int column = 0; column < dimension; ++column)
      matrix(row, column) = (row == column ? 1.0 : 0.0) - (T[column + 1][row] - T[0][row]);
  }
  const Eigen::Matrix<double, dimension, 1> found = matrix.fullPivLu().solve(right);
  std::array<double, 3> result{};
  double rest = 1.0;
  double smallest = 1.0;
  for (int d = 0; d < dimension; ++d)
  {
    result[d] = found(d);
    rest -= found(d);
    smallest = std::min(smallest, found(d));
  }
  const bool inside = std::isfinite(rest) && std::min(smallest, rest) > -1e-12;
  if (inside)
    return result;
  double first = 1.0;
  for (int d = 0; d < dimension; ++d)
    first -= start[d];
  for (int d = 0; d < dimension; ++d)
  {
    result[d] = first * T[0][d];
    for (int i = 1; i <= dimension; ++i)
      result[d] += start[i - 1] * T[i][d];
  }
  return result;
}

/// Graded coordinates of the corners of the cells of a triangle, shape (lattice, 2).
std::vector<double> triangle_corners(const Lines& edges)
{
  const int n = static_cast<int>(edges[0].size()) - 1;
  std::vector<double> result;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i + j <= n; ++i)
    {
      const double a = edges[0][i + j];
      const double b = edges[1][j];
      const double c = edges[2][i + j];
      const double d = edges[1][n - i];
      const std::array<double, 3> uniform{static_cast<double>(i) / n, static_cast<double>(j) / n, 0.0};
      const auto r = fixed_point<2>(
          {{{edges[0][i], edges[2][j], 0.0}, {a - b, b, 0.0}, {1.0 - d, c + d - 1.0, 0.0}, {}}}, uniform);
      result.insert(result.end(), {r[0], r[1]});
    }
  return result;
}

/// Nodes between the corners of their cells.
class Refinement
{
public:
  Refinement(const Grid& nodes, element::Lattice cell, int diagonal)
      : corners_(
            Grid{nodes.shape,
                 {nodes.steps[0] / cell.order, nodes.steps[1] / cell.order, nodes.steps[2] / cell.order}}),
        cells_(corners_, cell.order, diagonal), coarse_(corners_, 1, diagonal)
  {
    for (const CellKind& kind : cells_.kinds())
      weights_.push_back(element::resample(kind.shape, {1, element::NodeKind::equispaced}, cell));
  }

  /// Appends the coordinates of a node, given those of all corners of cells, shape (lattice, dimension).
  void add(const LatticePoint& node, const std::vector<double>& corners, std::vector<double>& result) const
  {
    const auto dimension = static_cast<std::size_t>(element::dimension(corners_.shape));
    const BlockCells::Found cell = cells_.find(node);
    const std::vector<LatticePoint>& offsets = coarse_.kinds()[cell.kind].nodes;
    const double* w = weights_[cell.kind].data() + cell.local * offsets.size();
    result.resize(result.size() + dimension, 0.0);
    double* x = result.data() + result.size() - dimension;
    for (const LatticePoint& offset : offsets)
    {
      const LatticePoint corner{cell.box[0] + offset[0], cell.box[1] + offset[1], cell.box[2] + offset[2]};
      const double* at = corners.data() + dimension * index(corners_, corner);
      for (std::size_t d = 0; d < dimension; ++d)
        x[d] += *w * at[d];
      ++w;
    }
  }

private:
  Grid corners_;
  BlockCells cells_;
  BlockCells coarse_;
  std::vector<std::vector<double>> weights_;
};

/// Graded coordinates of the nodes of a triangle with these edges.
std::vector<double> triangle_nodes(const Lines& edges, int order)
{
  const int n = static_cast<int>(edges[0].size()) - 1;
  const Grid nodes{Shape::triangle, {n, n, 0}};
  const std::vector<double> corners =
      triangle_corners({every(edges[0], order), every(edges[1], order), every(edges[2], order)});
  const Refinement refinement(nodes, {order, element::NodeKind::equispaced}, 0);
  std::vector<double> result;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i + j <= n; ++i)
      refinement.add({i, j, 0}, corners, result);
  return result;
}

std::vector<double> quadrilateral_nodes(const Lines& edges)
{
  std::vector<double> result;
  for (std::size_t j = 0; j < edges[1].size(); ++j)
    for (std::size_t i = 0; i < edges[0].size(); ++i)
    {
      const std::array<double, 2> uv = crossing(edges[0][i], edges[2][i], edges[3][j], edges[1][j]);
      result.insert(result.end(), uv.begin(), uv.end());
    }
  return result;
}

std::vector<double> side_nodes(const Lines& edges, Shape shape, int order)
{
  switch (shape)
  {
  case Shape::segment:
    return edges[0];
  case Shape::triangle:
    return triangle_nodes(edges, order);
  default:
    return quadrilateral_nodes(edges);
  }
}

/// What the corners of cells on a side differ by from equal steps, in coordinates of the block.
std::vector<double> side_difference(const Grid& corners, int side, const std::vector<double>& reference)
{
  const element::SideShape& of = element::sides(corners.shape)[side];
  const auto all = element::corners(corners.shape);
  const Grid grid = side_grid(corners, side);
  std::vector<double> result;
  const double* r = reference.data();
  for (int t = 0; t < row_count(grid, 0); ++t)
    for (int s = 0; s < row_length(grid, t, 0); ++s, r += 2)
    {
      const double u = static_cast<double>(s) / grid.steps[0];
      const double v = static_cast<double>(t) / grid.steps[1];
      const auto& origin = all[of.corners[0]];
      const auto& first = all[of.corners[1]];
      const auto& second = all[of.corners[element::corner_count(of.shape) - 1]];
      // The corners of a pyramid's base, too, make a parallelogram.
      for (int d = 0; d < 3; ++d)
        result.push_back((r[0] - u) * (first[d] - origin[d]) + (r[1] - v) * (second[d] - origin[d]));
    }
  return result;
}

/// Corners of the cells of a tetrahedron or a pyramid: all points of the lattice, at the fixed point of the
/// blend. With all corners of the block at 0 the kernels give what the blend adds to equal steps, for given
/// weights.
class SolidCorners
{
public:
  SolidCorners(const Grid& grid, const Lines& edges)
  {
    plan_.grid = grid;
    plan_.rows = inner_rows(grid);
    for (const BlockPlan::Row& row : all_rows(grid))
      for (int i = row.begin; i < row.end; ++i)
        for (const int coordinate : {i, row.j, row.k})
          uniform_.push_back(static_cast<double>(coordinate) / grid.steps[0]);
    points_ = uniform_;
    set_sides(edges);
    work_.resize(kernel_work(plan_, 3));
    boundary_.work = work_.data();
    if (grid.shape == Shape::tetrahedron)
      solve_tetrahedron();
    else
      solve_pyramid();
  }

  /// Shape (lattice, 3).
  const std::vector<double>& points() const { return points_; }

private:
  void set_sides(const Lines& edges)
  {
    const Grid& grid = plan_.grid;
    const auto sides = element::sides(grid.shape);
    for (std::size_t side = 0; side < sides.size(); ++side)
    {
      const Lines lines = side_lines(grid.shape, edges, sides[side]);
      differences_[side] = side_difference(grid, static_cast<int>(side),
                                           sides[side].shape == Shape::triangle ? triangle_corners(lines)
                                                                                : quadrilateral_nodes(lines));
      boundary_.side[side] = differences_[side].data();
      const Grid on = side_grid(grid, static_cast<int>(side));
      const SideFrame frame = side_frame(grid, static_cast<int>(side));
      const double* difference = differences_[side].data();
      for (int t = 0; t < row_count(on, 0); ++t)
        for (int s = 0; s < row_length(on, t, 0); ++s)
        {
          const std::int64_t at = index(grid, frame.at(s, t));
          for (int d = 0; d < 3; ++d)
            points_[3 * at + d] = uniform_[3 * at + d] + *difference++;
        }
    }
  }

  template <typename Visit>
  void for_each_inner(const Visit& visit) const
  {
    for (const BlockPlan::Row& row : plan_.rows)
      for (int i = 0; i < row.end - row.begin; ++i)
        visit(3 * (static_cast<std::size_t>(row.node) + i));
  }

  /// The blend is linear in the weights: one system per point.
  void solve_tetrahedron()
  {
    std::array<std::vector<double>, 4> sums;
    for (int corner = 0; corner < 4; ++corner)
    {
      plan_.reference.clear();
      for_each_inner(
          [&](std::size_t)
          {
            for (int d = 0; d < 3; ++d)
              plan_.reference.push_back(corner == d + 1 ? 1.0 : 0.0);
          });
      sums[corner].resize(points_.size());
      place_tetrahedron(plan_, plan_.rows, boundary_, sums[corner].data());
    }
    for_each_inner(
        [&](std::size_t at)
        {
          std::array<std::array<double, 3>, 4> T{};
          for (int corner = 0; corner < 4; ++corner)
            for (int d = 0; d < 3; ++d)
              T[corner][d] = uniform_[at + d] + sums[corner][at + d];
          const auto r = fixed_point<3>(T, {uniform_[at], uniform_[at + 1], uniform_[at + 2]});
          std::copy(r.begin(), r.end(), points_.begin() + static_cast<std::ptrdiff_t>(at));
        });
  }

  void solve_pyramid()
  {
    std::vector<double> added(points_.size(), 0.0);
    for (int sweep = 0; sweep < 100; ++sweep)
    {
      plan_.reference.clear();
      for_each_inner(
          [&](std::size_t at)
          {
            plan_.reference.insert(plan_.reference.end(), points_.begin() + static_cast<std::ptrdiff_t>(at),
                                   points_.begin() + static_cast<std::ptrdiff_t>(at) + 3);
          });
      place_pyramid(plan_, plan_.rows, boundary_, added.data());
      double change = 0.0;
      for_each_inner(
          [&](std::size_t at)
          {
            for (std::size_t n = at; n < at + 3; ++n)
            {
              const double next = uniform_[n] + added[n];
              change = std::max(change, std::abs(next - points_[n]));
              points_[n] = next;
            }
          });
      if (change < 1e-15)
        break;
    }
  }

  BlockPlan plan_;
  std::vector<double> uniform_;
  std::vector<double> points_;
  std::array<std::vector<double>, 6> differences_;
  BoundaryData<3> boundary_;
  std::vector<double> work_;
};

/// (1 - z) low + z high of the triangles' coordinates, with the height z = sum_i w_i z_i of the upright
/// edges.
void set_prism_reference(const Lines& edges, std::span<const BlockPlan::Row> rows, BlockPlan& plan)
{
  const std::vector<double>& low = plan.side_reference[side_at(Shape::prism, Wall::bottom)];
  const std::vector<double>& high = plan.side_reference[side_at(Shape::prism, Wall::top)];
  const int n = plan.grid.steps[0];
  const auto height = [&](const double* r, int k)
  { return (1.0 - r[0] - r[1]) * edges[6][k] + r[0] * edges[7][k] + r[1] * edges[8][k]; };
  for (const BlockPlan::Row& row : rows)
    for (int i = row.begin; i < row.end; ++i)
    {
      const std::ptrdiff_t at = 2 * (triangle_row(n, row.j) + i);
      const double a = height(low.data() + at, row.k);
      const double b = height(high.data() + at, row.k);
      const double z = a / (1.0 + a - b);
      plan.reference.push_back((1.0 - z) * low[at] + z * high[at]);
      plan.reference.push_back((1.0 - z) * low[at + 1] + z * high[at + 1]);
      plan.reference.push_back(z);
    }
}

}  // namespace

void set_triangular(const Lines& given, int order, int diagonal, BlockPlan& plan)
{
  const Shape shape = plan.grid.shape;
  const bool is_prism = shape == Shape::prism;
  const element::Lattice cell{order, shape == Shape::triangle ? element::NodeKind::warped
                                                              : element::NodeKind::equispaced};
  Lines edges = given;
  if (cell.kind == element::NodeKind::equispaced)
    for (std::size_t e = 0; e < (is_prism ? 6 : edges.size()); ++e)
      edges[e] = with_equal_steps(edges[e], order);
  const auto sides = element::sides(shape);
  for (const element::SideShape& side : sides)
    plan.side_reference.push_back(side_nodes(
        side.shape == Shape::segment ? Lines{between(shape, edges, side.corners[0], side.corners[1])}
                                     : side_lines(shape, edges, side),
        side.shape, order));
  if (order > 2 && shape == Shape::triangle)
    plan.triangle_nodes = std::make_shared<const TriangleNodes>(order);
  else if (order > 2)
    plan.resampling = std::make_shared<const Resampling>(plan.grid, order, diagonal, plan.rows);
  const std::span<const BlockPlan::Row> rows =
      plan.resampling ? plan.resampling->lattice_rows() : std::span<const BlockPlan::Row>(plan.rows);

  Lines corner_lines;
  for (const Line& edge : edges)
    corner_lines.push_back(every(edge, order));
  const auto coupled_end = corner_lines.begin() + (is_prism ? 6 : static_cast<std::ptrdiff_t>(edges.size()));
  if (std::all_of(corner_lines.begin(), coupled_end, has_equal_steps) &&
      (!is_prism || (edges[6] == edges[7] && edges[6] == edges[8])))
  {
    plan.lines[0] = edges[0];
    if (is_prism)
      plan.lines[2] = edges[6];
    return;
  }
  if (is_prism)
    return set_prism_reference(edges, rows, plan);
  const Grid corners{shape,
                     {plan.grid.steps[0] / order, plan.grid.steps[1] / order, plan.grid.steps[2] / order}};
  const std::vector<double> points = shape == Shape::triangle ? triangle_corners(corner_lines)
                                                              : SolidCorners(corners, corner_lines).points();
  const Refinement refinement(plan.grid, cell, diagonal);
  for (const BlockPlan::Row& row : rows)
    for (int i = row.begin; i < row.end; ++i)
      refinement.add({i, row.j, row.k}, points, plan.reference);
}

}  // namespace blockfsi::block
