#include "geometry/primitive.hpp"

#include "core/error.hpp"
#include "differences.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace blockfsi;
using geometry::LevelSet;
using geometry::Point;

TEST_CASE("primitives are signed distances with unit gradients")
{
  const Point center{0.2, -0.1, 0.3};
  const Point axis{1.0, 2.0, -2.0};
  const std::vector<LevelSet> all{geometry::sphere(center, 0.7), geometry::cylinder(center, axis, 0.4),
                                  geometry::box({-0.5, -0.4, -0.3}, {0.6, 0.5, 0.7}),
                                  geometry::plane(center, axis), geometry::torus(center, axis, 0.8, 0.25)};
  for (const LevelSet& one : all)
    for (const Point& x :
         {Point{0.31, 0.22, 0.13}, Point{0.9, 0.8, 1.1}, Point{-0.8, 0.1, 0.2}, Point{0.1, -0.9, 1.3}})
    {
      CHECK(one(x).value == doctest::Approx(one.value(x)).epsilon(1e-15));
      CHECK(geometry::norm(one(x).gradient) == doctest::Approx(1.0).epsilon(1e-14));
      CHECK(gradient_error(one, x) < 1e-9);
      // A step of the distance along the gradient ends on the surface.
      CHECK(std::abs(one.value(geometry::combine(1.0, x, -one(x).value, one(x).gradient))) < 1e-14);
    }
}

TEST_CASE("a box may be open and is a distance outside its corners")
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const LevelSet strip = geometry::box({-infinity, 0.0, -infinity}, {infinity, 1.0, infinity});
  CHECK(strip.value({1e9, 0.25, 3.0}) == -0.25);
  CHECK(strip({1e9, 0.25, 3.0}).gradient == Point{0.0, -1.0, 0.0});
  const LevelSet square = geometry::box({0.0, 0.0, -infinity}, {1.0, 1.0, infinity});
  CHECK(square.value({4.0, 5.0, 7.0}) == 5.0);
}

TEST_CASE("where a distance has no gradient it is zero, not undefined")
{
  CHECK(geometry::sphere({}, 2.0)({}).gradient == Point{});
  CHECK(geometry::sphere({}, 2.0)({}).value == -2.0);
  CHECK(geometry::torus({}, {0.0, 0.0, 1.0}, 2.0, 0.5)({2.0, 0.0, 0.0}).gradient == Point{});
}

TEST_CASE("primitives refuse sizes and directions that make no sense")
{
  CHECK_THROWS_WITH_AS(geometry::sphere({}, 0.0), "the radius of the sphere is 0 m; it must be positive",
                       Error);
  CHECK_THROWS_WITH_AS(geometry::cylinder({}, {}, 1.0),
                       "the axis of the cylinder is (0, 0, 0); it must have a length", Error);
  CHECK_THROWS_WITH_AS(geometry::box({0.0, 1.0, 0.0}, {1.0, 1.0, 1.0}),
                       "the box goes from 1 to 1 in y; the second corner must be the larger", Error);
  CHECK_THROWS_WITH_AS(
      geometry::torus({}, {0.0, 0.0, 1.0}, 1.0, 1.5),
      "the tube of the torus has a radius of 1.5 m, which must be smaller than that of the ring, 1 m", Error);
}
