#include "block/place.hpp"

#include "../allocations.hpp"
#include "block/blend.hpp"
#include "block/corner_layout.hpp"
#include "block/move.hpp"
#include "block/numbering.hpp"
#include "layouts.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace blockfsi;
using namespace blockfsi::block;
using namespace blockfsi::block::testing;

namespace
{

/// A unit square with random wiggles and a different grading on each side.
Layout curved_block(int order, std::mt19937& random)
{
  std::uniform_real_distribution<double> wiggle(-0.08, 0.08);
  Layout layout = unit_square(order, 5);
  const std::array<Grading, 4> gradings{Geometric{1.2}, FirstCell{0.1, true}, Uniform{}, TwoSided{0.1, 0.15}};
  for (int side = 0; side < 4; ++side)
  {
    Edge& edge = add_edge(layout, side, (side + 1) % 4);
    edge.grading = gradings[side];
    geometry::Through through;
    const auto& a = layout.points[edge.a].x;
    const auto& b = layout.points[edge.b].x;
    for (const double t : {0.3, 0.7})
      through.points.push_back(
          {a[0] + t * (b[0] - a[0]) + wiggle(random), a[1] + t * (b[1] - a[1]) + wiggle(random), 0.0});
    edge.curve = through;
  }
  return layout;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace

TEST_CASE("the transfinite map reproduces its four sides")
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  // A lattice of 2 x 2 steps whose only inner node is put anywhere on the boundary: corners 0..3, middles of
  // the sides 4..7.
  std::vector<double> skeleton(16);
  for (double& value : skeleton)
    value = number(random);
  const auto placed_at = [&](int side, double t)
  {
    BlockPlan plan;
    plan.grid = {element::Shape::quadrilateral, {2, 2, 0}};
    plan.corners = {0, 1, 2, 3};
    plan.sides = {{0, 4, 1}, {1, 5, 2}, {3, 6, 2}, {0, 7, 3}};
    // On a side the sides at its ends contribute their corners.
    const int low = side == 1 ? 1 : 0;
    plan.rows = {{1, 0, 1, 2, 0}};
    if (side % 2 == 0)
    {
      plan.sides[3][1] = side == 0 ? 0 : 3;
      plan.sides[1][1] = side == 0 ? 1 : 2;
      plan.reference = {t, side == 0 ? 0.0 : 1.0};
    }
    else
    {
      plan.sides[0][1] = low == 1 ? 1 : 0;
      plan.sides[2][1] = low == 1 ? 2 : 3;
      plan.reference = {static_cast<double>(low), t};
    }
    std::vector<double> work(work_size(plan, 2));
    std::array<double, 2> x{};
    blend(plan, 2, skeleton.data(), work.data(), x.data());
    return x;
  };
  for (const double t : {0.0, 0.2, 0.7, 1.0})
    for (int side = 0; side < 4; ++side)
      for (int c = 0; c < 2; ++c)
        CHECK(std::abs(placed_at(side, t)[c] - skeleton[2 * (4 + side) + c]) < 1e-15);
}

TEST_CASE("nodes on curved, graded sides sit on their curves at their parameters")
{
  std::mt19937 random(1);
  for (int order = 1; order <= 8; ++order)
  {
    const Layout layout = curved_block(order, random);
    const Skeleton skeleton = make_skeleton(layout);
    const Connected all = connect(layout, skeleton, "", {});
    const std::vector<double> x = place(all, skeleton);
    for (const PlacedEdge& edge : skeleton.edges)
    {
      const auto match =
          std::find_if(layout.edges.begin(), layout.edges.end(),
                       [&](const Edge& candidate) { return candidate.a == edge.a && candidate.b == edge.b; });
      REQUIRE(match != layout.edges.end());
      for (std::int64_t node = edge.first; node < edge.first + edge.count; ++node)
      {
        const std::int64_t local = node;
        const geometry::Point wanted = geometry::evaluate(match->curve, layout.points[edge.a].x,
                                                          layout.points[edge.b].x, skeleton.parameter[node]);
        CHECK(std::abs(x[2 * local] - wanted[0]) < 1e-13);
        CHECK(std::abs(x[2 * local + 1] - wanted[1]) < 1e-13);
      }
    }
    CHECK(measure(all.mesh, x).smallest > 0.0);
  }
}

TEST_CASE("a block with straight, equally divided sides is bilinear to the last digits")
{
  const std::array<std::array<double, 2>, 4> corners{{{0.1, 0.2}, {2.0, -0.3}, {2.5, 1.9}, {-0.4, 1.1}}};
  for (int order = 1; order <= 8; ++order)
  {
    const Layout layout = one_block(corners, order, 3);
    const Skeleton skeleton = make_skeleton(layout);
    const Connected all = connect(layout, skeleton, "fluid", {});
    const std::vector<double> x = place(all, skeleton);
    const std::vector<double> xi = element::lobatto(order);
    for (int c = 0; c < 9; ++c)
      for (int j = 0; j <= order; ++j)
        for (int i = 0; i <= order; ++i)
        {
          const double u = (c % 3 + xi[i]) / 3.0;
          const auto row = c / 3;
          const double v = (static_cast<double>(row) + xi[j]) / 3.0;
          const int node = all.mesh.cell(c)[i + j * (order + 1)];
          for (int k = 0; k < 2; ++k)
          {
            const double wanted = (1 - u) * (1 - v) * corners[0][k] + u * (1 - v) * corners[1][k] +
                                  u * v * corners[2][k] + (1 - u) * v * corners[3][k];
            CHECK(std::abs(x[2 * node + k] - wanted) < 2e-15);
          }
        }
  }
}

TEST_CASE("straight sides with any gradings keep nodes on the straight lines that join opposite sides")
{
  Layout layout = unit_square(3, 6);
  const std::array<Grading, 4> gradings{Geometric{1.5}, FirstCell{0.02, false}, Geometric{0.8}, Uniform{}};
  const std::array<std::array<int, 2>, 4> ends{{{0, 1}, {1, 2}, {3, 2}, {0, 3}}};
  for (int side = 0; side < 4; ++side)
  {
    Edge& edge = add_edge(layout, ends[side][0], ends[side][1]);
    edge.grading = gradings[side];
  }
  const Skeleton skeleton = make_skeleton(layout);
  const Connected all = connect(layout, skeleton, "", {});
  const std::vector<double> x = place(all, skeleton);
  const BlockLattice lattice = block_lattice(layout, skeleton, 0);
  const auto at = [&](int i, int j, int c) { return x[2 * lattice.number({i, j, 0}) + c]; };
  const int n = 18;
  for (int j = 1; j < n; ++j)
    for (int i = 1; i < n; ++i)
    {
      const double u = at(i, j, 0);
      const double v = at(i, j, 1);
      CHECK(std::abs(u - ((1 - v) * at(i, 0, 0) + v * at(i, n, 0))) < 1e-15);
      CHECK(std::abs(v - ((1 - u) * at(0, j, 1) + u * at(n, j, 1))) < 1e-15);
    }
}

TEST_CASE("placing allocates nothing")
{
  const Layout layout = flap_layout(4);
  const Skeleton skeleton = make_skeleton(layout);
  const Connected fluid = connect(layout, skeleton, "fluid", {});
  std::vector<double> x(2 * fluid.mesh.node_count());
  const long before = blockfsi::testing::allocation_count();
  block::place(fluid.plan, skeleton.x, x);
  const long after = blockfsi::testing::allocation_count();
  CHECK(before > 0);
  CHECK(after == before);
}

TEST_CASE("placing is linear in the skeleton and carries translations over")
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const Layout layout = flap_layout(3);
  Skeleton skeleton = make_skeleton(layout);
  const Connected fluid = connect(layout, skeleton, "fluid", {});
  Skeleton other = skeleton;
  Skeleton sum = skeleton;
  Skeleton shifted = skeleton;
  for (std::size_t i = 0; i < skeleton.x.size(); ++i)
  {
    other.x[i] = number(random);
    sum.x[i] = 2.0 * skeleton.x[i] - 3.0 * other.x[i];
    shifted.x[i] = skeleton.x[i] + (i % 2 == 0 ? 0.25 : -4.0);
  }
  const std::vector<double> x = place(fluid, skeleton);
  std::vector<double> expected = place(fluid, other);
  for (std::size_t i = 0; i < x.size(); ++i)
    expected[i] = 2.0 * x[i] - 3.0 * expected[i];
  CHECK(largest_difference(place(fluid, sum), expected) < 1e-14);
  for (std::size_t i = 0; i < x.size(); ++i)
    expected[i] = x[i] + (i % 2 == 0 ? 0.25 : -4.0);
  CHECK(largest_difference(place(fluid, shifted), expected) < 1e-14);
}

TEST_CASE("pushing a wall by 5 % leaves thin first cells positive, because the weights are graded")
{
  // With index weights the first cell would shrink to -1.5 of itself (formulation.md 3).
  for (const int order : {1, 2, 4})
  {
    Layout layout = unit_square(order, 20);
    for (const auto& [a, b] : {std::array{0, 3}, std::array{1, 2}})
    {
      Edge& edge = add_edge(layout, a, b);
      edge.grading = FirstCell{1e-3, false};
    }
    const Skeleton skeleton = make_skeleton(layout);
    const Connected all = connect(layout, skeleton, "", {});
    std::vector<std::int64_t> wall{0, 1};
    for (std::int64_t node = skeleton.edges[0].first;
         node < skeleton.edges[0].first + skeleton.edges[0].count; ++node)
      wall.push_back(node);
    SkeletonMotion motion(skeleton, wall, corner_motion(layout, skeleton, "fluid", wall, {}));
    std::vector<double> displacement(2 * wall.size(), 0.0);
    for (std::size_t i = 1; i < displacement.size(); i += 2)
      displacement[i] = 0.05;
    std::vector<double> moved_skeleton(skeleton.x.size());
    motion.move(displacement, moved_skeleton);
    const std::vector<double> x = place(all, skeleton);
    std::vector<double> moved(x.size());
    block::place(all.plan, moved_skeleton, moved);
    double smallest = 1e300;
    for (std::size_t c = 0; c < all.mesh.cell_count(); ++c)
    {
      const std::int32_t low = all.mesh.cell(c)[0];
      const std::int32_t high = all.mesh.cell(c)[order * (order + 1)];
      smallest =
          std::min(smallest, (moved[2 * high + 1] - moved[2 * low + 1]) / (x[2 * high + 1] - x[2 * low + 1]));
    }
    CHECK(smallest == doctest::Approx(0.95).epsilon(1e-10));
  }
}

TEST_CASE("a bump of one side fades linearly in the graded coordinate")
{
  const Layout layout = unit_square(2, 4);
  const Skeleton skeleton = make_skeleton(layout);
  const Connected all = connect(layout, skeleton, "", {});
  Skeleton bumped = skeleton;
  const PlacedEdge& bottom = skeleton.edges[0];
  for (std::int64_t node = bottom.first; node < bottom.first + bottom.count; ++node)
    bumped.x[2 * node + 1] += 0.1 * std::sin(std::acos(-1.0) * skeleton.x[2 * node]);
  const std::vector<double> x = place(all, skeleton);
  const std::vector<double> y = place(all, bumped);
  for (std::size_t n = 0; n < all.mesh.node_count(); ++n)
  {
    const double wanted = 0.1 * std::sin(std::acos(-1.0) * x[2 * n]) * (1.0 - x[2 * n + 1]);
    CHECK(std::abs(y[2 * n] - x[2 * n]) < 1e-15);
    CHECK(std::abs(y[2 * n + 1] - x[2 * n + 1] - wanted) < 1e-15);
  }
}

TEST_CASE("the area of a ring converges with twice the order")
{
  const double exact = std::acos(-1.0) * (1.0 - 0.16);
  for (int order = 1; order <= 4; ++order)
  {
    std::array<double, 2> error{};
    for (int k = 0; k < 2; ++k)
    {
      const Layout layout = ring(0.4, 1.0, order, 2 << k);
      const Skeleton skeleton = make_skeleton(layout);
      const Connected all = connect(layout, skeleton, "", {});
      const Measure found = measure(all.mesh, place(all, skeleton));
      error[k] = std::abs(found.area - exact);
      CHECK(found.smallest > 0.0);
    }
    const double rate = std::log2(error[0] / error[1]);
    CHECK(rate == doctest::Approx(2.0 * order).epsilon(0.03));
  }
}
