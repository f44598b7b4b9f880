#include "geometry/boolean.hpp"

#include "core/error.hpp"
#include "differences.hpp"
#include "geometry/primitive.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace blockfsi;
using namespace blockfsi::geometry;

namespace
{

const Point origin{};

/// The half planes x < 0 and y < 0.
std::vector<LevelSet> half_planes()
{
  return {geometry::plane(origin, {1.0, 0.0, 0.0}), geometry::plane(origin, {0.0, 1.0, 0.0})};
}

}  // namespace

TEST_CASE("union, intersection, difference and complement take the points that they should")
{
  const LevelSet a = geometry::sphere({-0.5, 0.0, 0.0}, 1.0);
  const LevelSet b = geometry::sphere({0.5, 0.0, 0.0}, 1.0);
  const LevelSet c = geometry::sphere({0.0, 0.8, 0.0}, 0.5);
  for (double x = -1.95; x < 2.0; x += 0.1)
    for (double y = -1.95; y < 2.0; y += 0.1)
    {
      const Point p{x, y, 0.1};
      const auto in = [&p](const LevelSet& domain) { return domain.value(p) < 0.0; };
      CHECK(in(unite({a, b, c})) == (in(a) || in(b) || in(c)));
      CHECK(in(intersect({a, b, c})) == (in(a) && in(b) && in(c)));
      CHECK(in(difference({a, b, c})) == (in(a) && !in(b) && !in(c)));
      CHECK(in(complement(a)) == !in(a));
      CHECK(unite({a, b, c})(p).value == unite({a, b, c}).value(p));
    }
}

TEST_CASE("a blend makes a circular fillet of its radius where two planes meet at a right angle")
{
  const double r = 0.3;
  const LevelSet concave = unite(half_planes(), r);
  const LevelSet convex = intersect(half_planes(), r);
  for (double angle = 0.05; angle < 1.55; angle += 0.1)
  {
    // The fillet of the union lies about (r, r), that of the intersection about (-r, -r).
    const Point on_concave{r - r * std::cos(angle), r - r * std::sin(angle), 0.0};
    const Point on_convex{-r + r * std::cos(angle), -r + r * std::sin(angle), 0.0};
    CHECK(std::abs(concave.value(on_concave)) < 1e-15);
    CHECK(std::abs(convex.value(on_convex)) < 1e-15);
  }
  CHECK(concave.value({0.0, r, 0.0}) == 0.0);
  CHECK(concave.value({0.0, 2.0, 0.0}) == 0.0);
  CHECK(convex.value({0.0, -r, 0.0}) == 0.0);
}

TEST_CASE("blended unions, intersections and differences have continuous gradients that are exact")
{
  const std::vector<LevelSet> parts{geometry::sphere({-0.5, 0.0, 0.0}, 1.0),
                                    geometry::sphere({0.6, 0.1, 0.0}, 0.9),
                                    geometry::plane({}, {0.1, 1.0, 0.2})};
  const double r = 0.25;
  for (const LevelSet& domain : {unite(parts, r), intersect(parts, r), difference(parts, r)})
  {
    double largest_change = 0.0;
    Point before = domain({-1.4, 0.43, 0.2}).gradient;
    for (double x = -1.4; x < 1.4; x += 1e-4)
    {
      const Point gradient = domain({x, 0.43, 0.2}).gradient;
      largest_change = std::fmax(largest_change, geometry::distance(gradient, before));
      before = gradient;
    }
    // By the formula the blend of two unit gradients changes by at most 4 / r per length, each of them by 1 /
    // 0.9.
    CHECK(largest_change < (4.0 / r + 1.0 / 0.9) * 1e-4);
    for (double x = -1.2; x < 1.3; x += 0.237)
      CHECK(gradient_error(domain, {x, 0.43, 0.2}, 1e-4) < 1e-7);
  }
  // Without a blend the gradient jumps.
  const LevelSet sharp = unite(half_planes());
  CHECK(sharp({0.1 - 1e-9, 0.1, 0.0}).gradient == Point{1.0, 0.0, 0.0});
  CHECK(sharp({0.1 + 1e-9, 0.1, 0.0}).gradient == Point{0.0, 1.0, 0.0});
}

TEST_CASE("booleans of nothing and negative blends are refused")
{
  CHECK_THROWS_WITH_AS(geometry::unite({}), "the union of no level sets is asked for; name at least one",
                       Error);
  CHECK_THROWS_WITH_AS(intersect(half_planes(), -1.0),
                       "the blend of the intersection is -1; it must be a length or 0", Error);
}
