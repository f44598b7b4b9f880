#include "block/edge_lines.hpp"

#include "layouts.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace blockfsi;
using namespace blockfsi::block;
using namespace blockfsi::block::testing;

TEST_CASE("lines of edges lie on their curves however coarse the mesh is")
{
  const double r = std::sqrt(2.0);
  Layout layout = one_block({{{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}}, 3, 1);
  layout.order = 1;
  add_edge(layout, 1, 2).curve = geometry::Arc{};
  const Skeleton skeleton = make_skeleton(layout);
  const std::vector<EdgeLine> lines = edge_lines(layout, skeleton, 3, 8);
  REQUIRE(lines.size() == 4);
  for (std::size_t e = 0; e < lines.size(); ++e)
  {
    const PlacedEdge& edge = skeleton.edges[e];
    const bool is_arc = std::minmax(edge.a, edge.b) == std::minmax(1, 2);
    CHECK(lines[e].pieces == (is_arc ? 8 : 1));
    REQUIRE(static_cast<int>(lines[e].x.size()) == 3 * lines[e].pieces + 1);
    CHECK(lines[e].x.front() == layout.points[edge.a].x);
    CHECK(lines[e].x.back() == layout.points[edge.b].x);
    CHECK(static_cast<int>(lines[e].cell_ends.size()) == edge.divisions - 1);
    if (is_arc)
      for (const std::array<double, 3>& x : lines[e].x)
        CHECK(std::hypot(x[0], x[1]) == doctest::Approx(r).epsilon(1e-14));
    else if (edge.divisions == 3)
      for (std::size_t k = 0; k < 2; ++k)
        CHECK(std::abs(lines[e].cell_ends[k][0]) == doctest::Approx(1.0 / 3.0).epsilon(1e-14));
  }
}

TEST_CASE("a curve without a finite value between nodes is refused where it shall be drawn")
{
  Layout layout = one_block({{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}}, 1, 1);
  layout.order = 1;
  add_edge(layout, 0, 1).curve = geometry::Function{[](double t) {
                                                      return geometry::Point{t, 0.0 / (t - 0.5) * 0.0, 0.0};
                                                    },
                                                    {},
                                                    geometry::Speed::own};
  const Skeleton skeleton = make_skeleton(layout);
  CHECK_THROWS_WITH_AS(edge_lines(layout, skeleton, 2, 1), doctest::Contains("no finite value"), Error);
}
