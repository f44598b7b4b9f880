#include "block/blend.hpp"

#include "block/round.hpp"
#include "block/sweep.hpp"
#include "measure.hpp"
#include "mesh/validity.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <vector>

using namespace blockfsi::block;
namespace element = blockfsi::element;
namespace geometry = blockfsi::geometry;
namespace mesh = blockfsi::mesh;
using element::Shape;
using std::numbers::pi;

namespace
{

constexpr std::array<Shape, 6> shapes{Shape::triangle,   Shape::quadrilateral, Shape::tetrahedron,
                                      Shape::hexahedron, Shape::prism,         Shape::pyramid};

constexpr int degree = 5;

/// x + a random polynomial of total degree 5, small enough that its Jacobian stays positive in the unit cube.
class Bend
{
public:
  Bend() = default;  ///< no bend
  Bend(int dim, unsigned seed)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-0.012, 0.012);
    for (int a = 0; a <= degree; ++a)
      for (int b = 0; a + b <= degree; ++b)
        for (int c = 0; a + b + c <= (dim == 2 ? a + b : degree); ++c)
          if (a + b + c >= 2)
            terms_.push_back({{a, b, c}, {any(random), any(random), dim == 2 ? 0.0 : any(random)}});
  }

  geometry::Point operator()(const geometry::Point& x) const
  {
    geometry::Point result = x;
    for (const Term& term : terms_)
      result = geometry::add_scaled(result, monomial(term.powers, x), term.factor);
    return result;
  }

  double jacobian(const geometry::Point& x) const
  {
    std::array<geometry::Point, 3> d{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (const Term& term : terms_)
      for (int k = 0; k < 3; ++k)
        if (term.powers[k] > 0)
        {
          std::array<int, 3> lower = term.powers;
          --lower[k];
          d[k] = geometry::add_scaled(d[k], term.powers[k] * monomial(lower, x), term.factor);
        }
    return geometry::dot(d[0], geometry::cross(d[1], d[2]));
  }

private:
  struct Term
  {
    std::array<int, 3> powers;
    geometry::Point factor;
  };

  static double monomial(const std::array<int, 3>& powers, const geometry::Point& x)
  {
    return std::pow(x[0], powers[0]) * std::pow(x[1], powers[1]) * std::pow(x[2], powers[2]);
  }

  std::vector<Term> terms_;
};

/// The patch that the bend makes of a straight face over three or four corners.
geometry::Surface bent_face(const Bend& bend, const std::vector<geometry::Point>& corners)
{
  const auto at = [&](double u, double v)
  {
    const geometry::Point along = geometry::add_scaled(geometry::combine(1.0 - u, corners[0], u, corners[1]),
                                                       v, geometry::subtract(corners.back(), corners[0]));
    return bend(along);
  };
  std::vector<geometry::Point> points;
  if (corners.size() == 3)
  {
    for (int j = 0; j <= degree; ++j)
      for (int i = 0; i + j <= degree; ++i)
        points.push_back(at(static_cast<double>(i) / degree, static_cast<double>(j) / degree));
    return geometry::TrianglePatch{degree, points};
  }
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree; ++j)
      points.push_back(at(static_cast<double>(i) / degree, static_cast<double>(j) / degree));
  return geometry::equispaced_patch(degree, degree, points);
}

/// Adds a block over points of a layout.
void add_block(Layout& layout, Shape shape, std::vector<int> points)
{
  layout.blocks.push_back(
      {"block " + std::to_string(layout.blocks.size()), "fluid", std::move(points), {}, shape});
}

/// Bends a layout of straight blocks whose faces are parallelograms or triangles: the points, in the plane
/// all edges, in space all faces.
Layout bent(const Layout& straight, const Bend& bend)
{
  Layout layout = straight;
  for (Point& point : layout.points)
    point.x = bend(point.x);
  std::set<std::set<int>> known;
  for (const Block& block : straight.blocks)
    for (const element::SideShape& side : element::sides(block.shape))
    {
      std::vector<int> points;
      std::vector<geometry::Point> corners;
      for (int c = 0; c < element::corner_count(side.shape); ++c)
      {
        points.push_back(block.points[side.corners[c]]);
        corners.push_back(straight.points[points.back()].x);
      }
      if (!known.insert({points.begin(), points.end()}).second)
        continue;
      if (layout.dim == 3)
      {
        layout.faces.push_back({points, Patch{bent_face(bend, corners)}, {}});
        continue;
      }
      Edge& edge = layout.edges.emplace_back();
      edge.a = points[0];
      edge.b = points[1];
      edge.curve = geometry::Function{[bend, corners](double t)
                                      { return bend(geometry::combine(1.0 - t, corners[0], t, corners[1])); },
                                      {},
                                      geometry::Speed::own};
    }
  return layout;
}

Layout empty(int dim, int order, int divisions)
{
  Layout layout;
  layout.dim = dim;
  layout.order = order;
  layout.default_divisions = divisions;
  layout.boundaries.push_back({"wall", ByCondition{{"x > -10", {}}}, {}});
  return layout;
}

/// One straight block that is the reference cell.
Layout one_cell(Shape shape, int order, int divisions)
{
  Layout layout = empty(element::dimension(shape), order, divisions);
  std::vector<int> points;
  for (const auto& x : element::corners(shape))
  {
    points.push_back(static_cast<int>(layout.points.size()));
    layout.points.push_back({"p" + std::to_string(points.back()), x, {}});
  }
  add_block(layout, shape, points);
  return layout;
}

/// Largest distance of the nodes of the boundary from where the bend takes those of the straight mesh, which
/// has the same numbers.
double boundary_error(const sample::Made& straight, const sample::Made& curved, const Bend& bend)
{
  const auto at = [](const sample::Made& made, std::int32_t n)
  {
    geometry::Point x{};
    for (int d = 0; d < made.mesh.dim; ++d)
      x[d] = made.x[static_cast<std::size_t>(n) * made.mesh.dim + d];
    return x;
  };
  double largest = 0.0;
  for (const mesh::Side& side : curved.mesh.boundaries.at("wall"))
    for (const std::int32_t local :
         element::side_lattice(curved.mesh.shape(side.cell), curved.mesh.order, side.side))
    {
      const std::int32_t n = curved.mesh.cell(side.cell)[local];
      largest = std::max(largest, geometry::distance(at(curved, n), bend(at(straight, n))));
    }
  return largest;
}

/// The error of a volume is that of integrating by the nodes of the sides: Gauss-Lobatto rules are exact to
/// degree 2p - 1, the warped nodes of triangles to p, and to p + 1 for even p by symmetry.
int expected_order(Shape shape, int order)
{
  if (element::dimension(shape) == 2 || shape == Shape::hexahedron)
    return 2 * order;
  return order + (order % 2 == 0 ? 2 : 1);
}

double bent_volume(Shape shape, const Bend& bend)
{
  const element::CellRule rule = element::quadrature(shape, 3 * degree);
  double sum = 0.0;
  for (std::size_t q = 0; q < rule.weights.size(); ++q)
    sum += rule.weights[q] * bend.jacobian(rule.points[q]);
  return sum;
}

/// Order with which an error falls from one mesh to another of half the size.
double rate(double coarse, double fine)
{
  return std::log2(coarse / fine);
}

}  // namespace

TEST_CASE("blocks of all shapes reproduce random curved sides to 1e-13 at every order")
{
  for (const Shape shape : shapes)
    for (const auto& [order, divisions] :
         {std::pair{1, 5}, {2, 3}, {3, 2}, {4, 2}, {5, 1}, {6, 1}, {7, 1}, {8, 1}})
    {
      CAPTURE(element::name(shape));
      CAPTURE(order);
      const Bend bend(element::dimension(shape), static_cast<unsigned>(order));
      const Layout straight = one_cell(shape, order, divisions);
      const sample::Made curved = sample::make(bent(straight, bend));
      CHECK(boundary_error(sample::make(bent(straight, {})), curved, bend) < 1e-13);
      CHECK(mesh::certify(mesh::ValidityTables(curved.mesh), curved.mesh, curved.x).all_valid());
      // Sides of degree 5 are those of the cells from order 5 on, so the volume has no error.
      const double error = std::abs(sample::volume(curved) / bent_volume(shape, bend) - 1.0);
      if (order >= degree)
        CHECK(error < 1e-12);
      else
        CHECK(error > 1e-12);
    }
}

TEST_CASE("volumes of curved blocks of all shapes converge with the order of their sides")
{
  for (const Shape shape : shapes)
    for (int order = 1; order < degree; ++order)
    {
      CAPTURE(element::name(shape));
      CAPTURE(order);
      const Bend bend(element::dimension(shape), 7);
      const double exact = bent_volume(shape, bend);
      const int divisions = order == 1 ? 8 : order == 4 ? 2 : 3;
      std::array<double, 2> error{};
      for (int i = 0; i < 2; ++i)
        error[i] = std::abs(
            sample::volume(sample::make(bent(one_cell(shape, order, divisions << i), bend))) / exact - 1.0);
      CHECK(error[1] < 1e-4);
      CHECK(rate(error[0], error[1]) > expected_order(shape, order) - 0.3);
    }
}

TEST_CASE("areas and volumes of a ball and a torus converge with twice the order")
{
  for (int order = 1; order <= 6; ++order)
  {
    CAPTURE(order);
    std::array<std::array<double, 2>, 4> errors{};
    for (int i = 0; i < 2; ++i)
    {
      const int around = (order == 3 ? 4 : order == 5 ? 3 : 2) << i;
      Layout layout = empty(3, order, 1);
      layout.boundaries.clear();
      Ball ball;
      ball.name = "b";
      ball.region = "solid";
      ball.around = around;
      ball.radial = 1;
      add(layout, ball);
      const sample::Made round = sample::make(layout);
      errors[0][i] = std::abs(sample::volume(round) / (4.0 / 3.0 * pi) - 1.0);
      errors[1][i] = std::abs(sample::area(round, "b wall") / (4.0 * pi) - 1.0);
      Layout base = empty(3, order, 1);
      base.boundaries.clear();
      Disc disc;
      disc.name = "d";
      disc.region = "solid";
      disc.center = {2.0, 0.0, 0.0};
      disc.radius = 0.5;
      disc.around = 1 << i;
      disc.radial = 1;
      add(base, disc);
      Revolution revolution;
      revolution.name = "t";
      revolution.of = "d";
      revolution.around = 2 << i;
      const sample::Made torus = sample::make(revolved(base, revolution));
      errors[2][i] = std::abs(sample::volume(torus) / (pi * pi) - 1.0);
      errors[3][i] = std::abs(sample::area(torus, "t wall") / (4.0 * pi * pi) - 1.0);
    }
    for (const auto& error : errors)
    {
      // Errors of less than 1e-13 are rounding, and orders 5 and 6 reach them before their rates settle.
      if (error[1] > 1e-13)
        CHECK(rate(error[0], error[1]) > 2 * order - (order <= 4 ? 0.3 : 1.0));
    }
  }
}

namespace
{

/// Orders of the corners of a cell that turn it onto itself without mirroring it.
std::vector<std::vector<int>> turns(Shape shape)
{
  const auto corners = element::corners(shape);
  std::vector<int> order(corners.size());
  for (std::size_t c = 0; c < order.size(); ++c)
    order[c] = static_cast<int>(c);
  const auto edge_of = [&](int a, int b)
  {
    const auto edges = element::edges(shape);
    return std::any_of(edges.begin(), edges.end(),
                       [&](const auto& e) { return (e[0] == a && e[1] == b) || (e[0] == b && e[1] == a); });
  };
  // The volume that the edges at corner 0 span keeps its sign: in these shapes corners 1, the last of the
  // base and the one above 0 are its neighbours.
  const std::array<int, 3> next = shape == Shape::tetrahedron ? std::array{1, 2, 3}
                                  : shape == Shape::prism     ? std::array{1, 2, 3}
                                                              : std::array{1, 3, 4};
  std::vector<std::vector<int>> result;
  do
  {
    bool keeps = true;
    for (std::size_t a = 0; a < order.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        keeps = keeps && edge_of(static_cast<int>(a), static_cast<int>(b)) == edge_of(order[a], order[b]);
    const auto from = [&](int k) { return geometry::subtract(corners[order[next[k]]], corners[order[0]]); };
    if (keeps && geometry::dot(geometry::cross(from(0), from(1)), from(2)) > 0.0)
      result.push_back(order);
  } while (std::next_permutation(order.begin(), order.end()));
  return result;
}

/// A tetrahedron, a prism and a pyramid that share triangles with each other, bent.
Layout complex_of_triangles(int order, const std::array<std::vector<int>, 3>& turn, const Bend& bend)
{
  Layout layout = empty(3, order, 2);
  const std::vector<geometry::Point> x = {{0, 0, 0},  {1, 0, 0},  {0, 1, 0},  {0, 0, 1}, {0, 0, -1},
                                          {1, 0, -1}, {0, 1, -1}, {-1, 0, 0}, {-1, 0, 1}};
  for (std::size_t p = 0; p < x.size(); ++p)
    layout.points.push_back({"p" + std::to_string(p), geometry::scaled(0.7, x[p]), {}});
  const std::array<std::vector<int>, 3> corners{{{0, 1, 2, 3}, {4, 5, 6, 0, 1, 2}, {0, 7, 8, 3, 2}}};
  const std::array<Shape, 3> of{Shape::tetrahedron, Shape::prism, Shape::pyramid};
  for (int b = 0; b < 3; ++b)
    add_block(layout, of[b], corners[b]);
  layout = bent(layout, bend);
  for (int b = 0; b < 3; ++b)
    for (std::size_t c = 0; c < turn[b].size(); ++c)
      layout.blocks[b].points[c] = corners[b][turn[b][c]];
  return layout;
}

/// Coordinates of the nodes that several blocks share, in order.
std::vector<std::array<double, 3>> shared_nodes(const sample::Made& made)
{
  std::vector<std::set<std::int32_t>> blocks(made.mesh.node_count());
  for (std::size_t c = 0; c < made.mesh.cell_count(); ++c)
    for (const std::int32_t n : made.mesh.cell(c))
      blocks[n].insert(made.mesh.cell_block[c]);
  std::vector<std::array<double, 3>> result;
  for (std::size_t n = 0; n < blocks.size(); ++n)
    if (blocks[n].size() > 1)
      result.push_back({made.x[3 * n], made.x[3 * n + 1], made.x[3 * n + 2]});
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

TEST_CASE("tetrahedra, prisms and pyramids share triangles node by node in all turns of each")
{
  const Bend bend(3, 3);
  const std::array<std::vector<std::vector<int>>, 3> all{turns(Shape::tetrahedron), turns(Shape::prism),
                                                         turns(Shape::pyramid)};
  CHECK(all[0].size() == 12);
  CHECK(all[1].size() == 6);
  CHECK(all[2].size() == 4);
  const std::array<std::vector<int>, 3> none{{{0, 1, 2, 3}, {0, 1, 2, 3, 4, 5}, {0, 1, 2, 3, 4}}};
  for (const int order : {1, 3})
  {
    const sample::Made plain = sample::make(complex_of_triangles(order, none, bend));
    const auto shared = shared_nodes(plain);
    // Two triangles with a common edge, of 2 cells per edge.
    const std::size_t along = 2 * static_cast<std::size_t>(order);
    CHECK(shared.size() == (along + 1) * (along + 2) - (along + 1));
    const double volume = sample::volume(plain);
    for (int b = 0; b < 3; ++b)
      for (const std::vector<int>& turn : all[b])
      {
        std::array<std::vector<int>, 3> turned = none;
        turned[b] = turn;
        const sample::Made made = sample::make(complex_of_triangles(order, turned, bend));
        CHECK(made.mesh.node_count() == plain.mesh.node_count());
        CHECK(sample::volume(made) == doctest::Approx(volume).epsilon(1e-13));
        const auto now = shared_nodes(made);
        REQUIRE(now.size() == shared.size());
        // Faces are made as the first block lists them: the others may list theirs as they like, bit for bit.
        for (const geometry::Point& x : now)
          CHECK(std::any_of(shared.begin(), shared.end(),
                            [&](const geometry::Point& other)
                            { return b == 0 ? geometry::distance(x, other) < 1e-14 : x == other; }));
      }
  }
}
