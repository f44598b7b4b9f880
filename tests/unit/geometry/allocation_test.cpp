#include "../allocations.hpp"
#include "geometry/boolean.hpp"
#include "geometry/convolution.hpp"
#include "geometry/on_level_set.hpp"
#include "geometry/primitive.hpp"
#include "geometry/sampled.hpp"

#include <doctest/doctest.h>

#include <array>
#include <string_view>
#include <vector>

using namespace blockfsi;
using namespace blockfsi::geometry;

TEST_CASE("searches for points of level sets allocate nothing")
{
  constexpr std::array<std::string_view, 3> space{"x", "y", "z"};
  const LevelSet ball(Expression("sqrt(x^2 + y^2 + z^2) - 1", {}, space));
  const LevelSet vessel =
      tube(Convolution({{{0.0, 0.0, -2.0}, {0.0, 0.0, 2.0}}, {1.0, 1.0}, {{0, 1, {}}}, 2.0, 1.0}));
  Samples samples{{5, 5, 5}, {-2.0, -2.0, -2.0}, {1.0, 1.0, 1.0}, {}};
  for (int i = 0; i < 125; ++i)
    samples.values.push_back(ball.value({i % 5 - 2.0, i / 5 % 5 - 2.0, i / 25 - 2.0}));
  const LevelSet grid = sampled(samples, "grid");
  const LevelSet both =
      unite({rotated(ball, {}, {1.0, 0.0, 0.0}, 0.3), cylinder({}, {0.0, 0.0, 1.0}, 0.9)}, 0.2);
  const LevelSet cut = plane({}, {0.0, 0.0, 1.0});
  for (const LevelSet& surface : {ball, vessel, grid, both})
  {
    const OnLevelSet edge{surface, {}, {}};
    const long before = testing::allocation_count();
    const Found along = project(surface, {0.3, 0.2, 0.1}, {1.0, 0.0, 0.0}, {.size = 1.0, .farthest = 3.0});
    const Found common = project(surface, cut, {0.8, 0.2, 0.1}, {.size = 1.0});
    const Found node = find(edge, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.4);
    CHECK(testing::allocation_count() == before);
    CHECK(along.ok());
    CHECK(common.ok());
    CHECK(node.ok());
  }
}
