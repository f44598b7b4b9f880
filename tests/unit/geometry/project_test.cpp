#include "geometry/project.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

using namespace blockfsi;
using geometry::Found;
using geometry::Level;
using geometry::LevelSet;
using geometry::Point;
using geometry::SearchStatus;

namespace
{

constexpr std::array<std::string_view, 3> space{"x", "y", "z"};

LevelSet formula(std::string_view text)
{
  return LevelSet(Expression(text, {}, space));
}

/// Half axes 2 and 1/2.
LevelSet ellipse()
{
  return formula("(x / 2)^2 + (2 * y)^2 - 1");
}

Point on_ellipse(double angle)
{
  return {2.0 * std::cos(angle), 0.5 * std::sin(angle), 0.0};
}

/// How nodes of the straight line between two points of the ellipse are projected.
struct Row
{
  int evaluations = 0;
  double residual = 0.0;  ///< largest |φ|
  double spacing = 0.0;   ///< largest over smallest distance of neighbours
  bool monotone = true;
  int failed = 0;
  int flat = 0;
};

Row project_row(const LevelSet& surface, double from, double to, bool along_gradient)
{
  const Point a = on_ellipse(from);
  const Point b = on_ellipse(to);
  const Point normal{b[1] - a[1], a[0] - b[0], 0.0};
  const geometry::SearchLimits limits{.size = geometry::distance(a, b)};
  constexpr int n = 40;
  Row row;
  std::vector<Point> x{a};
  for (int i = 1; i < n; ++i)
  {
    const double t = static_cast<double>(i) / n;
    const Point start = geometry::combine(1.0 - t, a, t, b);
    const Found found = along_gradient ? project_along_gradient(surface, start, limits)
                                       : project(surface, start, normal, limits);
    row.evaluations += found.evaluations;
    row.residual = std::max(row.residual, std::abs(surface.value(found.x)));
    row.failed += found.ok() ? 0 : 1;
    row.flat += found.flat ? 1 : 0;
    x.push_back(found.x);
  }
  x.push_back(b);
  double smallest = std::numeric_limits<double>::max();
  double largest = 0.0;
  double before = from;
  for (std::size_t i = 1; i < x.size(); ++i)
  {
    const double size = geometry::distance(x[i], x[i - 1]);
    smallest = std::min(smallest, size);
    largest = std::max(largest, size);
    const double angle = std::atan2(2.0 * x[i][1], 0.5 * x[i][0]);
    row.monotone = row.monotone && angle > before;
    before = angle;
  }
  row.spacing = largest / smallest;
  return row;
}

Found search(const LevelSet& surface, const Point& start, const Point& direction)
{
  return project(surface, start, direction, {.size = 1.0});
}

}  // namespace

TEST_CASE("on a 4:1 ellipse the chord's normal spaces nodes far more evenly than the gradient")
{
  // The ratios are those of the prototype of this search (see docs/geometry.md).
  const double quarter = std::numbers::pi / 2.0;
  const Row normal = project_row(ellipse(), 0.0, quarter, false);
  const Row gradient = project_row(ellipse(), 0.0, quarter, true);
  CHECK(normal.spacing == doctest::Approx(1.8).epsilon(0.03));
  CHECK(gradient.spacing == doctest::Approx(3.7).epsilon(0.03));
  const Row wide_normal = project_row(ellipse(), 0.0, 2.4, false);
  const Row wide_gradient = project_row(ellipse(), 0.0, 2.4, true);
  CHECK(wide_normal.spacing == doctest::Approx(1.8).epsilon(0.03));
  CHECK(wide_gradient.spacing == doctest::Approx(8.0).epsilon(0.03));
  for (const Row& row : {normal, gradient, wide_normal, wide_gradient})
  {
    CHECK(row.failed == 0);
    CHECK(row.flat == 0);
    CHECK(row.monotone);
    CHECK(row.residual < 1e-15);
    CHECK(row.evaluations <= 15 * 39);
  }
}

TEST_CASE("a level set whose gradient vanishes at its root is found, with a warning")
{
  const LevelSet cube = formula("((x / 2)^2 + (2 * y)^2 - 1)^3");
  const Row row = project_row(cube, 0.0, 2.4, false);
  CHECK(row.failed == 0);
  CHECK(row.flat == 39);
  CHECK(row.monotone);
  // The root of φ³ is that of φ, whose gradient is at least 1: a distance below 1e-12 of the chord.
  CHECK(std::cbrt(row.residual) < 1e-12 * geometry::distance(on_ellipse(0.0), on_ellipse(2.4)));
  CHECK(row.evaluations <= 123 * 39);
}

TEST_CASE("a search takes the nearest root, on whichever side")
{
  const LevelSet circle = formula("x^2 + y^2 - 1");
  const Found above = search(circle, {0.0, 0.3, 0.0}, {0.0, 1.0, 0.0});
  CHECK(above.ok());
  CHECK(above.moved == doctest::Approx(0.7).epsilon(1e-13));
  const Found against = search(circle, {0.0, 0.3, 0.0}, {0.0, -5.0, 0.0});
  CHECK(against.x == above.x);
  CHECK(against.moved == doctest::Approx(-0.7).epsilon(1e-13));
  CHECK(against.low <= against.moved);
  CHECK(against.moved <= against.high);
  const Found outside = search(circle, {0.0, 1.3, 0.0}, {0.0, 1.0, 0.0});
  CHECK(outside.moved == doctest::Approx(-0.3).epsilon(1e-13));
  const Found forbidden =
      project(circle, {0.0, 1.3, 0.0}, {0.0, 1.0, 0.0}, {.size = 1.0, .both_ways = false});
  CHECK(forbidden.status == SearchStatus::no_bracket);
  CHECK(forbidden.low == 0.0);
  CHECK(forbidden.high == 1.0);
}

TEST_CASE("a start on the level set stays where it is")
{
  const Found found = search(formula("y"), {0.2, 1e-14, 0.0}, {0.0, 1.0, 0.0});
  CHECK(found.ok());
  CHECK(found.x == Point{0.2, 1e-14, 0.0});
  CHECK(found.evaluations == 1);
}

TEST_CASE("searches that cannot succeed say why and leave the start")
{
  const Point start{0.1, 0.2, 0.3};
  const auto status = [&](std::string_view text, const Point& direction)
  {
    const Found found = search(formula(text), start, direction);
    CHECK(found.x == start);
    return found.status;
  };
  const Point up{0.0, 1.0, 0.0};
  CHECK(status("y - 1", {}) == SearchStatus::no_gradient);
  CHECK(status("y - 1", {std::nan(""), 0.0, 0.0}) == SearchStatus::no_gradient);
  CHECK(status("y - 2", up) == SearchStatus::no_bracket);
  CHECK(status("(y - 0.5)^2", up) == SearchStatus::no_bracket);
  CHECK(status("log(y - 1)", up) == SearchStatus::no_bracket);
  CHECK(status("if(y < 0.5, -1, 1)", up) == SearchStatus::jump);
  CHECK(status("1 / (y - 0.5)", up) == SearchStatus::jump);
  CHECK(project_along_gradient(formula("1"), start, {.size = 1.0}).status == SearchStatus::no_gradient);
}

TEST_CASE("a root is found to 1e-13 of the local size, far from the origin to the rounding there")
{
  for (const double size : {1e-6, 1.0, 1e6})
    for (const double offset : {0.0, 1.0, 1e3})
    {
      const double at = offset + 0.43 * size;
      const LevelSet surface("",
                             [&](const Point& x)
                             {
                               const double y = (x[1] - at) / size;
                               return Level{std::expm1(y), {0.0, std::exp(y) / size, 0.0}};
                             });
      const Found found = project(surface, {0.0, offset, 0.0}, {0.0, 1.0, 0.0}, {.size = size});
      CHECK(found.ok());
      CHECK(std::abs(found.x[1] - at) <= 1e-13 * size + 4.0 * 2.3e-16 * offset);
    }
}

TEST_CASE("a point of two level sets is found in space and in a plane")
{
  const LevelSet sphere = formula("x^2 + y^2 + z^2 - 4");
  const LevelSet cylinder = formula("(x - 1)^2 + y^2 - 1");  // their curve is Viviani's
  const Point start{0.9, 1.2, 1.3};
  const Point normal{0.2, 0.1, 1.0};
  const Found least = project(sphere, cylinder, start, {.size = 1.0});
  const Found in_plane = project(sphere, cylinder, start, {.size = 1.0}, normal);
  for (const Found& found : {least, in_plane})
  {
    CHECK(found.ok());
    CHECK(std::abs(sphere.value(found.x)) < 1e-14);
    CHECK(std::abs(cylinder.value(found.x)) < 1e-14);
    CHECK(found.evaluations < 20);
    CHECK_FALSE(found.flat);
  }
  CHECK(std::abs(geometry::dot(geometry::subtract(in_plane.x, start), normal)) < 1e-14);
  CHECK(least.moved < in_plane.moved);
  // Where the surfaces touch or miss each other there is no such point.
  const LevelSet touching = formula("x - 2");
  CHECK(project(sphere, touching, {1.7, 0.0, 0.0}, {.size = 1.0}).status == SearchStatus::no_gradient);
  CHECK_FALSE(project(sphere, formula("z - 2.5"), {0.1, 0.1, 2.2}, {.size = 1.0}).ok());
}

TEST_CASE("the nodes of a face are projected together and failures listed")
{
  const LevelSet sphere = formula("x^2 + y^2 + z^2 - 1");
  std::vector<Point> start{{0.5, 0.5, 0.5}, {0.0, 0.0, 3.0}, {0.5, -0.5, 0.6}, {0.1, 0.0, 0.2}};
  const std::vector<Point> normal{{0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, {1.0, 1.0, 0.0}, {0.0, 0.0, 0.0}};
  std::vector<Point> x(start.size());
  const geometry::ProjectionReport report = project_nodes(sphere, start, normal, {.size = 1.0}, x);
  CHECK_FALSE(report.ok());
  REQUIRE(report.failures.size() == 2);
  CHECK(report.failures[0].index == 1);
  CHECK(report.failures[0].found.status == SearchStatus::no_bracket);
  CHECK(report.failures[1].index == 3);
  CHECK(text(report.failures[1].found.status) == "no gradient");
  CHECK(x[1] == start[1]);
  CHECK(x[0][2] == doctest::Approx(std::sqrt(0.5)).epsilon(1e-13));
  CHECK(std::abs(sphere.value(x[2])) < 1e-13);
  CHECK(report.farthest == doctest::Approx(std::sqrt(0.14)).epsilon(1e-12));
}
