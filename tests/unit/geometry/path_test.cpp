#include "geometry/path.hpp"

#include "core/error.hpp"
#include "geometry/difference.hpp"
#include "shapes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

using namespace blockfsi;
using namespace blockfsi::geometry;

namespace
{

constexpr std::array<std::string_view, 1> along_curve{"t"};

Expression formula(std::string_view text)
{
  return Expression(text, {}, along_curve);
}

struct Sample
{
  const char* name;
  Curve curve;
  Point a;
  Point b;
};

/// One of each kind, in space.
std::vector<Sample> samples()
{
  const NurbsCurve spline{.degree = 3,
                          .knots = {0, 0, 0, 0, 0.3, 0.6, 1, 1, 1, 1},
                          .points = {{0, 0, 0}, {1, 2, 0.5}, {2, -1, 1}, {3, 1, -1}, {4, 0, 0.2}, {5, 1, 1}},
                          .weights = {1, 0.7, 1.5, 1, 1.4, 1.2}};
  const Point on_ellipse{0.5 + 2.0 * std::cos(1.9), std::sin(1.9) * 0.6, 1.0 + std::sin(1.9) * 0.8};
  return {{"segment", Segment{}, {0, 0, 1}, {1, 2, 4}},
          {"arc", Arc{{0, 0, 1}}, {2, 0, 1}, {0, 1.2, 2.6}},
          {"longer arc", Arc{{0, 0, 1}, true}, {2, 0, 1}, {0, 1.2, 2.6}},
          {"arc through a point", ArcThrough{{1, 1, 3}}, {2, 0, 1}, {0, 0.3, 1}},
          {"ellipse", Ellipse{{0.5, 0, 1}, {2, 0, 0}, {0, 0.6, 0.8}}, {2.5, 0, 1}, on_ellipse},
          {"longer ellipse", Ellipse{{0.5, 0, 1}, {2, 0, 0}, {0, 0.6, 0.8}, true}, {2.5, 0, 1}, on_ellipse},
          {"through", Through{{{1, 1, 0}, {2, 1, 1}}}, {0, 0, 0}, {3, 0, 1}},
          {"through at parameters", Through{{{1, 1, 0}, {2, 1, 1}}, {0.25, 0.6}}, {0, 0, 0}, {3, 0, 1}},
          {"formula",
           Formula{{formula("t^2 + t"), formula("sin(3 * t)"), formula("exp(t) - 1")}},
           {0, 0, 0},
           {2, std::sin(3.0), std::exp(1.0) - 1.0}},
          {"spline", Spline{spline}, {0, 0, 0}, {5, 1, 1}},
          {"function",
           Function{[](double t) {
             return Point{t + t * t, std::cos(t), t};
           }},
           {0, 1, 0},
           {2, std::cos(1.0), 1}}};
}

/// Complete elliptic integral of the second kind E(m), m = k^2, by the arithmetic-geometric mean (Abramowitz
/// & Stegun 1964, 17.6).
double elliptic_integral(double m)
{
  double a = 1.0;
  double b = std::sqrt(1.0 - m);
  double sum = 0.5 * m;
  double power = 0.5;
  for (int i = 0; i < 20; ++i)
  {
    const double c = 0.5 * (a - b);
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
    power *= 2.0;
    sum += power * c * c;
  }
  return std::numbers::pi / (2.0 * a) * (1.0 - sum);
}

}  // namespace

TEST_CASE("on every curve equal steps of t are equal lengths")
{
  for (const Sample& sample : samples())
  {
    CAPTURE(std::string(sample.name));
    check(sample.curve, sample.a, sample.b);
    const Path path(sample.curve, sample.a, sample.b);
    for (const double t : {0.0, 0.013, 0.3, 0.5, 0.77, 1.0})
    {
      CHECK(norm(path.derivative(t)) == doctest::Approx(path.length()).epsilon(1e-12));
      // The speed does not only claim to be the length: the points move so.
      const Point moving = differentiate([&](double s) { return path.evaluate(s); }, t);
      CHECK(distance(moving, path.derivative(t)) < 2e-9 * path.length());
    }
    CHECK(path.evaluate(0.0) == sample.a);
    CHECK(path.evaluate(1.0) == sample.b);
  }
}

TEST_CASE("a curve from its end to its start has the same points bit for bit")
{
  for (Sample& sample : samples())
  {
    CAPTURE(std::string(sample.name));
    const Path forward(sample.curve, sample.a, sample.b);
    // The points of `through` are given in the order from the start.
    if (auto* through = std::get_if<Through>(&sample.curve))
    {
      std::reverse(through->points.begin(), through->points.end());
      std::reverse(through->parameters.begin(), through->parameters.end());
      for (double& t : through->parameters)
        t = 1.0 - t;
      if (!through->parameters.empty())
        continue;  // 1 - 0.6 is not exact
    }
    const Path backward(sample.curve, sample.b, sample.a);
    CHECK(forward.length() == backward.length());
    for (int i = 0; i <= 64; ++i)
      CHECK(forward.evaluate(i / 64.0) == backward.evaluate(1.0 - i / 64.0));
    CHECK(forward.derivative(0.25) == scaled(-1.0, backward.derivative(0.75)));
  }
}

TEST_CASE("the quarter of an ellipse has the length of the complete elliptic integral")
{
  for (const double minor : {0.9, 0.3, 0.05})
  {
    const Path path(Ellipse{{}, {1, 0, 0}, {0, minor, 0}}, {1, 0, 0}, {0, minor, 0});
    CHECK(path.length() == doctest::Approx(elliptic_integral(1.0 - minor * minor)).epsilon(1e-13));
  }
  // Tabulated: E(0.5) = 1.3506438810 (Abramowitz & Stegun 1964, table 17.1).
  CHECK(elliptic_integral(0.5) == doctest::Approx(1.3506438810).epsilon(1e-10));
}

TEST_CASE("a NURBS circle by its length is the circle by its angle")
{
  const NurbsCurve whole = shapes::circle(1.0);
  // Three quarters of it.
  const Curve spline = Spline{{.degree = 2,
                               .knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 3},
                               .points = {whole.points.begin(), whole.points.begin() + 7},
                               .weights = {whole.weights.begin(), whole.weights.begin() + 7}}};
  const Point a{1, 0, 0};
  const Point b{0, -1, 0};
  CHECK(length(spline, a, b) == doctest::Approx(1.5 * std::numbers::pi).epsilon(1e-14));
  for (const double t : {0.05, 0.2, 0.5, 0.71, 0.999})
  {
    const double angle = 1.5 * std::numbers::pi * t;
    CHECK(distance(evaluate(spline, a, b, t), {std::cos(angle), std::sin(angle), 0.0}) < 1e-13);
  }
}

TEST_CASE("lengths are right where the speed of the curve's parameter has a kink, a zero or no bound")
{
  const Point a{0, 0, 0};
  const Point b{1, 1, 0};
  // All of these run along the diagonal.
  for (const std::string text :
       {"t^3", "sqrt(t)", "if(t < 0.3, t / 3, 0.1 + (t - 0.3) * 9 / 7)", "1 - (1 - t)^4"})
  {
    const Curve curve = Formula{{formula(text), formula(text), 0.0}};
    CAPTURE(text);
    check(curve, a, b);
    CHECK(length(curve, a, b) == doctest::Approx(std::numbers::sqrt2).epsilon(1e-12));
    for (const double t : {0.001, 0.1, 0.3, 0.9})
      CHECK(distance(evaluate(curve, a, b, t), {t, t, 0}) < 1e-12);
  }
}

TEST_CASE("a curve that keeps its own speed passes through its points at their parameters")
{
  const Point a{0, 0, 0};
  const Point b{3, 0, 1};
  const Curve own = Through{{{1, 1, 0}, {2, 1, 1}}, {0.25, 0.6}, Speed::own};
  CHECK(distance(evaluate(own, a, b, 0.25), {1, 1, 0}) < 1e-15);
  CHECK(distance(evaluate(own, a, b, 0.6), {2, 1, 1}) < 1e-15);
  CHECK(length(own, a, b) == doctest::Approx(length(Through{{{1, 1, 0}, {2, 1, 1}}, {0.25, 0.6}}, a, b)));
}

TEST_CASE("many points at once are those one by one")
{
  const std::vector<double> t{0.0, 0.4, 0.1, 1.0, 0.9};
  for (const Sample& sample : samples())
  {
    const Path path(sample.curve, sample.a, sample.b);
    std::vector<Point> x(t.size());
    path.evaluate(t, x);
    for (std::size_t i = 0; i < t.size(); ++i)
      CHECK(x[i] == evaluate(sample.curve, sample.a, sample.b, t[i]));
  }
}

TEST_CASE("small misses at the ends are spread over the curve")
{
  const Point a{1, 0, 0};
  const Point b{0, 1 + 1e-10, 0};
  for (const Curve& curve :
       {Curve(Formula{{formula("cos(pi * t / 2)"), formula("sin(pi * t / 2)"), 0.0}}), Curve(Arc{})})
  {
    check(curve, a, b);
    const Path path(curve, a, b);
    CHECK(distance(path.evaluate(1.0 - 1e-7), b) == doctest::Approx(1e-7 * path.length()).epsilon(1e-5));
  }
}

TEST_CASE("an edge may be a part of a spline, of a closed one the shorter or the longer way through its seam")
{
  const auto at = [](double angle) { return Point{2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.0}; };
  const NurbsCurve circle = shapes::circle(2.0);
  for (const auto& [from, to] : {std::array{0.3, 1.9}, std::array{-0.7, 0.4}, std::array{0.0, 2.0},
                                 std::array{5.0, 6.5}, std::array{1.0, 1.0 + 0.5 * std::numbers::pi}})
    for (const bool longer : {false, true})
    {
      CAPTURE(from);
      const Curve curve = Spline{.curve = circle, .speed = Speed::constant, .part = true, .longer = longer};
      check(curve, at(from), at(to));
      const double turn = longer ? to - from - 2.0 * std::numbers::pi : to - from;
      const Path path(curve, at(from), at(to));
      const Path back(curve, at(to), at(from));
      CHECK(path.length() == doctest::Approx(2.0 * std::abs(turn)).epsilon(1e-12));
      for (const double t : {0.0, 0.125, 0.5, 0.75, 1.0})
      {
        CHECK(distance(path.evaluate(t), at(from + t * turn)) < 1e-12);
        CHECK(back.evaluate(1.0 - t) == path.evaluate(t));
      }
    }
  const NurbsCurve line{.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0, 0}, {4, 0, 0}}, .weights = {}};
  const Curve part = Spline{.curve = line, .speed = Speed::constant, .part = true};
  CHECK(distance(evaluate(part, {3, 0, 0}, {1, 0, 0}, 0.25), {2.5, 0, 0}) < 1e-14);
  std::string message;
  try
  {
    check(part, {3, 0.1, 0}, {1, 0, 0});
  }
  catch (const Error& error)
  {
    message = error.message();
  }
  CHECK(message ==
        "the edge starts at (3, 0.1), 0.1 m off its curve; move the point there, for instance to (3, 0, 0)");
}
