#include "geometry/level_set.hpp"

#include "core/error.hpp"
#include "differences.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

using namespace blockfsi;
using geometry::Level;
using geometry::LevelSet;
using geometry::Point;

namespace
{

constexpr std::array<std::string_view, 3> space{"x", "y", "z"};

LevelSet ellipsoid()
{
  return LevelSet(Expression("(x / 2)^2 + (y / 1.5)^2 + z^2 - 1", {}, space));
}

}  // namespace

TEST_CASE("a level set of a formula has its value, its gradient and its text")
{
  const LevelSet domain = ellipsoid();
  const Point x{0.3, -0.8, 0.4};
  const Level level = domain(x);
  CHECK(level.value == doctest::Approx(0.0225 + 0.64 / 2.25 + 0.16 - 1.0).epsilon(1e-15));
  CHECK(domain.value(x) == level.value);
  CHECK(level.gradient[0] == doctest::Approx(0.15).epsilon(1e-15));
  CHECK(level.gradient[1] == doctest::Approx(-1.6 / 2.25).epsilon(1e-15));
  CHECK(level.gradient[2] == doctest::Approx(0.8).epsilon(1e-15));
  CHECK(domain.text() == "(x / 2)^2 + (y / 1.5)^2 + z^2 - 1");
}

TEST_CASE("a level set may be a function of the program")
{
  const LevelSet plane("slanted",
                       [](const Point& x) {
                         return Level{x[0] + 2.0 * x[1] - 3.0, {1.0, 2.0, 0.0}};
                       });
  CHECK(plane.value({1.0, 1.0, 5.0}) == 0.0);
  CHECK(plane.text() == "slanted");
}

TEST_CASE("moved, turned and grown level sets carry their zeros and gradients along")
{
  const LevelSet domain = ellipsoid();
  const Point center{0.2, 0.1, -0.3};
  const LevelSet moved = translated(domain, {1.0, -2.0, 0.5});
  CHECK(std::abs(moved.value({3.0, -2.0, 0.5})) < 1e-15);
  // A quarter turn about z through the origin takes the long axis from x to y.
  const LevelSet turned = rotated(domain, {}, {0.0, 0.0, 2.0}, std::numbers::pi / 2.0);
  CHECK(std::abs(turned.value({0.0, 2.0, 0.0})) < 1e-15);
  CHECK(std::abs(turned.value({-1.5, 0.0, 0.0})) < 1e-15);
  const LevelSet larger = grown(domain, center, 3.0);
  const Point on = geometry::combine(1.0, center, 3.0, geometry::subtract({0.0, 0.0, 1.0}, center));
  CHECK(std::abs(larger.value(on)) < 1e-14);
  const LevelSet all = rotated(grown(moved, center, 0.7), center, {1.0, 2.0, 3.0}, 0.8);
  for (const Point& x : {Point{0.3, -0.8, 0.4}, Point{1.1, 0.4, -0.2}})
    for (const LevelSet& one : {moved, turned, larger, all})
    {
      CHECK(one(x).value == one.value(x));
      CHECK(gradient_error(one, x) < 1e-9);
    }
}

TEST_CASE("a rotation needs an axis and a growth a positive factor")
{
  CHECK_THROWS_WITH_AS(rotated(ellipsoid(), {}, {}, 1.0),
                       "the axis of a rotation is (0, 0, 0); it must have a length", Error);
  CHECK_THROWS_WITH_AS(grown(ellipsoid(), {}, -1.0),
                       "a level set is scaled by -1; the factor must be positive", Error);
}
