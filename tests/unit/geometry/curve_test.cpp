#include "geometry/curve.hpp"

#include "core/error.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

using namespace blockfsi;
using geometry::Point;

namespace
{

constexpr std::array<std::string_view, 1> curve_variables{"t"};

Expression formula(std::string_view text)
{
  return Expression(text, {}, curve_variables);
}

double distance(const Point& a, const Point& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

std::string message_of(const geometry::Curve& curve, const Point& a, const Point& b)
{
  try
  {
    geometry::check(curve, a, b);
  }
  catch (const Error& error)
  {
    return error.message();
  }
  return "";
}

}  // namespace

TEST_CASE("every curve starts and ends exactly at its points")
{
  const Point a{0.1, 0.7, 0.0};
  const Point b{0.7, 0.1, 0.0};
  const std::array<geometry::Curve, 4> curves{
      geometry::Segment{}, geometry::Arc{{0.1, 0.1, 0.0}},
      geometry::Through{{{0.3, 0.3, 0.0}, {0.5, 0.3, 0.0}}},
      geometry::Formula{
          {formula("0.1 + 0.6 * sin(pi * t / 2)"), formula("0.1 + 0.6 * cos(pi * t / 2)"), 0.0}}};
  for (const geometry::Curve& curve : curves)
  {
    CHECK_NOTHROW(geometry::check(curve, a, b));
    CHECK(geometry::evaluate(curve, a, b, 0.0) == a);
    CHECK(geometry::evaluate(curve, a, b, 1.0) == b);
  }
}

TEST_CASE("a segment is traversed at constant speed")
{
  const Point x = geometry::evaluate(geometry::Segment{}, {1.0, 2.0, 3.0}, {5.0, 4.0, -1.0}, 0.25);
  CHECK(distance(x, {2.0, 2.5, 2.0}) < 1e-15);
  CHECK(geometry::length(geometry::Segment{}, {0.0, 0.0, 0.0}, {3.0, 4.0, 12.0}) == doctest::Approx(13.0));
}

TEST_CASE("an arc keeps its distance from the centre and its speed, in any plane and for any angle below 180 "
          "degrees")
{
  const Point center{0.3, -0.2, 0.5};
  for (const double angle : {1e-6, 0.3, 1.5, 3.0, 3.14159})
  {
    const double radius = 2.0;
    // A plane spanned by (1, 1, 0) / sqrt 2 and (0, 0, 1).
    const auto at = [&](double phi) -> Point
    {
      const double c = radius * std::cos(phi) / std::numbers::sqrt2;
      return {center[0] + c, center[1] + c, center[2] + radius * std::sin(phi)};
    };
    const geometry::Curve arc = geometry::Arc{center};
    // The position across the chord is known to a rounding divided by sin(angle).
    const double tolerance = 1e-14 / std::sin(angle);
    for (const double t : {0.1, 0.5, 0.9})
      CHECK(distance(geometry::evaluate(arc, at(0.2), at(0.2 + angle), t), at(0.2 + t * angle)) <
            std::max(tolerance, 1e-14));
    CHECK(geometry::length(arc, at(0.2), at(0.2 + angle)) == doctest::Approx(radius * angle).epsilon(1e-9));
  }
}

TEST_CASE("a curve through points meets each of them at its share of the chords")
{
  const Point a{0.0, 0.0, 0.0};
  const Point b{4.0, 3.0, 0.0};
  const geometry::Curve curve =
      geometry::Through{{{3.0, 0.0, 0.0}, {4.0, 0.0, 0.0}}, {}, geometry::Speed::own};
  CHECK(distance(geometry::evaluate(curve, a, b, 3.0 / 7.0), {3.0, 0.0, 0.0}) < 1e-14);
  CHECK(distance(geometry::evaluate(curve, a, b, 4.0 / 7.0), {4.0, 0.0, 0.0}) < 1e-14);
}

TEST_CASE("arcs go the longer way round, about an axis or through a point")
{
  const Point a{1.0, 0.0, 0.0};
  const Point b{0.0, 1.0, 0.0};
  const double quarter = 0.5 * std::numbers::pi;
  const double root = 1.0 / std::numbers::sqrt2;
  const auto at = [&](const geometry::Curve& curve, const Point& end)
  {
    geometry::check(curve, a, end);
    return geometry::evaluate(curve, a, end, 0.5);
  };
  CHECK(distance(at(geometry::Arc{}, b), {root, root, 0.0}) < 1e-15);
  CHECK(distance(at(geometry::Arc{{}, true}, b), {-root, -root, 0.0}) < 1e-15);
  CHECK(geometry::length(geometry::Arc{{}, true}, a, b) == doctest::Approx(3.0 * quarter).epsilon(1e-15));
  CHECK(distance(at(geometry::Arc{{}, false, Point{0, 0, 2}}, b), {root, root, 0.0}) < 1e-15);
  CHECK(distance(at(geometry::Arc{{}, false, Point{0, 0, -1}}, b), {-root, -root, 0.0}) < 1e-15);
  // Half circles.
  CHECK(distance(at(geometry::Arc{{}, false, Point{0, 0, 1}}, {-1, 0, 0}), {0, 1, 0}) < 1e-15);
  CHECK(distance(at(geometry::Arc{{}, false, Point{0, -1, 0}}, {-1, 0, 0}), {0, 0, 1}) < 1e-15);
  CHECK(distance(at(geometry::ArcThrough{{0, -1, 0}}, {-1, 0, 0}), {0, -1, 0}) < 1e-15);
  CHECK(distance(at(geometry::ArcThrough{{-root, -root, 0}}, b), {-root, -root, 0.0}) < 1e-15);
  CHECK(geometry::length(geometry::ArcThrough{{0, -1, 0}}, a, b) ==
        doctest::Approx(3.0 * quarter).epsilon(1e-15));
  // Seen from the other end.
  CHECK(geometry::length(geometry::Arc{{}, false, Point{0, 0, 1}}, b, a) ==
        doctest::Approx(3.0 * quarter).epsilon(1e-15));
}

TEST_CASE("an ellipse keeps its equation")
{
  const geometry::Curve curve = geometry::Ellipse{{1, 2, 3}, {3, 0, 0}, {0, 0, 1}, true};
  const Point a{4, 2, 3};
  const Point b{1, 2, 4};
  geometry::check(curve, a, b);
  for (int i = 0; i <= 20; ++i)
  {
    const Point x = geometry::evaluate(curve, a, b, i / 20.0);
    CHECK(std::hypot((x[0] - 1) / 3, x[2] - 3) == doctest::Approx(1.0).epsilon(1e-14));
    CHECK(x[1] == 2.0);
    if (i > 0 && i < 20)
      CHECK(!(x[0] > 1.0 && x[2] > 3.0));  // not the shorter way
  }
}

TEST_CASE("a curve through one point of a parabola is the parabola where the chords are equal")
{
  const Point a{-1.0, 1.0, 0.0};
  const Point b{1.0, 1.0, 0.0};
  const geometry::Curve curve = geometry::Through{{{0.0, 0.0, 0.0}}};
  for (const double t : {0.2, 0.35, 0.8})
  {
    const Point x = geometry::evaluate(curve, a, b, t);
    CHECK(x[1] == doctest::Approx(x[0] * x[0]).epsilon(1e-14));
  }
  // Length of y = x^2 on [-1, 1]: sqrt 5 + asinh(2) / 2.
  CHECK(geometry::length(curve, a, b) ==
        doctest::Approx(std::sqrt(5.0) + 0.5 * std::asinh(2.0)).epsilon(1e-12));
}

TEST_CASE("the length of a formula is that of the curve it describes")
{
  const geometry::Curve quarter =
      geometry::Formula{{formula("cos(pi * t / 2)"), formula("sin(pi * t / 2)"), 0.0}};
  CHECK(geometry::length(quarter, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}) ==
        doctest::Approx(std::numbers::pi / 2).epsilon(1e-12));
}

TEST_CASE("curves that do not fit their points are refused with the reason")
{
  const Point a{1.0, 0.0, 0.0};
  CHECK(message_of(geometry::Segment{}, a, a) ==
        "the edge starts and ends at (1, 0); an edge needs two different ends");
  CHECK(message_of(geometry::Arc{}, a, {0.0, 1.1, 0.0}) ==
        "the arc's end points (1, 0) and (0, 1.1) are 1 m and 1.1 m away from its centre (0, 0); both must "
        "have the "
        "same distance, so correct the centre or an end point");
  CHECK(message_of(geometry::Arc{}, a, {-1.0, 0.0, 0.0}) ==
        "the arc from (1, 0) to (-1, 0) about (0, 0) is half a circle, so both ways round are equally long; "
        "give "
        "the axis about which it turns or a point that it passes through");
  CHECK(message_of(geometry::Arc{{}, false, Point{0, 1, 1}}, a, {0.0, 1.0, 0.0}) ==
        "the axis (0, 1, 1) of the arc about (0, 0) is not at right angles to the radius that ends at (0, "
        "1); correct "
        "the axis, the centre or the point");
  CHECK(message_of(geometry::Arc{{}, false, Point{}}, a, {0.0, 1.0, 0.0}) ==
        "the axis of the arc is 0; it must be a direction");
  CHECK(message_of(geometry::ArcThrough{{2, 0, 0}}, a, {3.0, 0.0, 0.0}) ==
        "the arc's points (1, 0), (2, 0) and (3, 0) lie on one line; they must span a circle");
  CHECK(message_of(geometry::ArcThrough{a}, a, {3.0, 0.0, 0.0}) != "");
  CHECK(message_of(geometry::ArcThrough{{3, 0, 0}}, a, {3.0, 0.0, 0.0}) != "");
  CHECK(message_of(geometry::Ellipse{{}, {1, 0, 0}, {2, 0, 0}}, a, {0.0, 1.0, 0.0}) ==
        "the half-axes (1, 0) and (2, 0) of the ellipse must be vectors in different directions");
  CHECK(message_of(geometry::Ellipse{{}, {1, 0, 0}, {0, 2, 0}}, a, {0.0, 1.0, 0.0}) ==
        "(0, 1) lies on an ellipse that is 0.5 times as large as the given one; correct its centre, its "
        "half-axes or "
        "the point");
  CHECK(message_of(geometry::Ellipse{{}, {1, 0, 0}, {0, 2, 0}}, a, {0.0, 2.0, 0.1}) ==
        "(0, 2, 0.1) lies 0.1 m off the plane of the ellipse; correct its half-axes or the point");
  CHECK(message_of(geometry::Ellipse{{}, {1, 0, 0}, {0, 2, 0}}, a, {-1.0, 0.0, 0.0}) ==
        "the part from (1, 0) to (-1, 0) is half the ellipse, so both ways round are equally long; split the "
        "edge by "
        "a point on the way");
  CHECK(message_of(geometry::Through{{{1.5, 1, 0}, {1.7, 1, 0}}, {0.5, 0.5}}, a, {2.0, 0.0, 0.0}) ==
        "parameter 2 of the curve's points is 0.5, after 0.5; they must ascend between 0 and 1, where the "
        "edge starts "
        "and ends");
  CHECK(message_of(geometry::Through{{{1.5, 1, 0}}, {0.2, 0.5}}, a, {2.0, 0.0, 0.0}) ==
        "found 2 parameters for the 1 points that the curve passes through; each needs one");
  CHECK(message_of(geometry::Through{std::vector<Point>(25)}, a, {2.0, 0.0, 0.0}) ==
        "the curve passes through 25 points between its ends; one polynomial takes at most 24, so use a "
        "B-spline or "
        "split the edge");
  CHECK(message_of(
            geometry::Spline{{.degree = 1, .knots = {0, 0, 1, 1}, .points = {a, {1, 1, 0}}, .weights = {}}},
            a, {2, 0, 0}) == "the B-spline gives (1, 1) at t = 1 but the edge ends at (2, 0); correct the "
                             "control point or the point");
  CHECK(
      message_of(geometry::Spline{{.degree = 1, .knots = {0, 0, 1}, .points = {a, {2, 0, 0}}, .weights = {}}},
                 a, {2, 0, 0}) == "the B-spline: found 3 knots; 2 control points of degree 1 need 4");
  CHECK(message_of(geometry::Function{}, a, {2, 0, 0}) == "the function of the curve is empty; give one");
  CHECK(message_of(geometry::Through{{{1.0, 0.0, 0.0}}}, a, {2.0, 0.0, 0.0}) ==
        "the curve passes through (1, 0) twice in a row; each of its points, the ends included, must differ "
        "from the "
        "one before");
  CHECK(message_of(geometry::Formula{{formula("1 + t"), formula("t"), 0.0}}, a, {2.0, 0.5, 0.0}) ==
        "the formula of the curve gives (2, 1) at t = 1 but the edge ends at (2, 0.5); correct the formula "
        "or the point");
  CHECK(message_of(geometry::Formula{{formula("1 + t"), formula("t / 0"), 0.0}}, a, {2.0, 0.5, 0.0}) != "");
}

TEST_CASE("end points given with rounded digits are accepted")
{
  CHECK(message_of(geometry::Arc{{0.2, 0.2, 0.0}}, {0.24898979486, 0.21, 0.0}, {0.24898979486, 0.19, 0.0}) ==
        "");
}
