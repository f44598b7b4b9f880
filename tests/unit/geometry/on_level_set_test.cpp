#include "geometry/on_level_set.hpp"

#include "core/error.hpp"
#include "element/line.hpp"
#include "geometry/primitive.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

using namespace blockfsi;
using namespace blockfsi::geometry;

namespace
{

constexpr std::array<std::string_view, 3> space{"x", "y", "z"};

LevelSet formula(std::string_view text)
{
  return LevelSet(Expression(text, {}, space));
}

/// A closed domain of the plane: its level set and the corners of its edges, counter-clockwise.
struct Domain
{
  LevelSet surface;
  std::vector<Point> corners;
};

template <typename Radius>
Domain star(LevelSet surface, int edges, Radius radius)
{
  Domain domain{std::move(surface), {}};
  for (int i = 0; i < edges; ++i)
  {
    const double angle = 2.0 * std::numbers::pi * i / edges;
    domain.corners.push_back({radius(angle) * std::cos(angle), radius(angle) * std::sin(angle), 0.0});
  }
  return domain;
}

Domain disc()
{
  return star(formula("x^2 + y^2 - 1"), 4, [](double) { return 1.0; });
}

Domain ellipse()
{
  return {formula("(x / 2)^2 + y^2 - 1"),
          {{2.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {-2.0, 0.0, 0.0}, {0.0, -1.0, 0.0}}};
}

Domain flower()
{
  return star(formula("sqrt(x^2 + y^2) - (1 + 0.2 * cos(5 * atan2(y, x)))"), 20,
              [](double angle) { return 1.0 + 0.2 * std::cos(5.0 * angle); });
}

struct Size
{
  double area = 0.0;
  double perimeter = 0.0;
};

/// Area and perimeter enclosed by isoparametric edges of order p, n cells per edge.
Size measure(const Domain& domain, int p, int n, bool by_length)
{
  const std::vector<double> nodes = element::lobatto(p);
  const element::Rule rule = element::gauss(p + 4);
  const element::Table table = element::lagrange(nodes, rule.points);
  Size size;
  for (std::size_t e = 0; e < domain.corners.size(); ++e)
  {
    const Point& a = domain.corners[e];
    const Point& b = domain.corners[(e + 1) % domain.corners.size()];
    OnLevelSet curve{domain.surface, {}, {}};
    if (by_length)
      curve = measured(curve, a, b);
    for (int cell = 0; cell < n; ++cell)
    {
      std::vector<double> t;
      for (const double node : nodes)
        t.push_back((cell + node) / n);
      std::vector<Point> x(t.size());
      CHECK(project_edge(curve, a, b, t, x).ok());
      for (std::size_t q = 0; q < rule.points.size(); ++q)
      {
        Point at{};
        Point slope{};
        for (std::size_t k = 0; k < x.size(); ++k)
        {
          at = combine(1.0, at, table.value[q * x.size() + k], x[k]);
          slope = combine(1.0, slope, table.first[q * x.size() + k], x[k]);
        }
        size.area += 0.5 * rule.weights[q] * (at[0] * slope[1] - at[1] * slope[0]);
        size.perimeter += rule.weights[q] * norm(slope);
      }
    }
  }
  return size;
}

std::string message_of(const OnLevelSet& curve, const Point& a, const Point& b)
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

TEST_CASE("areas and perimeters of projected edges of order p converge with order p + 1 or better")
{
  // Exact values: pi, 2 pi; 2 pi and a complete elliptic integral; pi (1 + 0.2² / 2).
  struct Reference
  {
    Domain domain;
    double area;
    double perimeter;
  };
  const std::vector<Reference> references{{disc(), std::numbers::pi, 2.0 * std::numbers::pi},
                                          {ellipse(), 2.0 * std::numbers::pi, 9.688448220547675},
                                          {flower(), 3.2044245066615886, 0.0}};
  for (const Reference& reference : references)
    for (const bool by_length : {false, true})
      for (int p = 1; p <= 4; ++p)
      {
        CAPTURE(p);
        CAPTURE(by_length);
        CAPTURE(reference.domain.surface.text());
        // Shares of the chord make a less even map, which takes finer cells to show its order.
        const int n = reference.domain.corners.size() > 4 ? 4 : by_length ? 8 : 16;
        const Size coarse = measure(reference.domain, p, n, by_length);
        const Size fine = measure(reference.domain, p, 2 * n, by_length);
        const auto order = [](double a, double b, double exact)
        { return std::log2(std::abs(a - exact) / (std::abs(b - exact) + 1e-15 * exact)); };
        CHECK(order(coarse.area, fine.area, reference.area) > p + 1 - 0.3);
        if (reference.perimeter > 0.0)
          CHECK(order(coarse.perimeter, fine.perimeter, reference.perimeter) > p + 1 - 0.3);
        CHECK(fine.area == doctest::Approx(reference.area).epsilon(0.01));
      }
}

TEST_CASE("all nodes of projected edges lie on the level set to 1e-13 of its size")
{
  for (const Domain& domain : {disc(), ellipse(), flower()})
    for (std::size_t e = 0; e < domain.corners.size(); ++e)
    {
      const OnLevelSet curve{domain.surface, {}, {}};
      const Point& a = domain.corners[e];
      const Point& b = domain.corners[(e + 1) % domain.corners.size()];
      CHECK(message_of(curve, a, b) == "");
      for (double t = 0.05; t < 1.0; t += 0.05)
      {
        const Point x = evaluate(curve, a, b, t);
        const geometry::Level level = domain.surface(x);
        CHECK(std::abs(level.value) / norm(level.gradient) < 1e-13);
      }
    }
}

TEST_CASE("a measured edge is cut into equal lengths")
{
  const Domain domain = ellipse();
  const Point& a = domain.corners[0];
  const Point& b = domain.corners[1];
  const OnLevelSet curve = measured({domain.surface, {}, {}}, a, b);
  CHECK(std::abs(curve.lengths->length() - 9.688448220547675 / 4.0) < 1e-12);
  CHECK(evaluate(curve, a, b, 0.0) == a);
  CHECK(evaluate(curve, a, b, 1.0) == b);
  // Lengths of the parts up to the nodes by the trapezoidal rule of the ellipse's angle, extrapolated.
  for (const double t : {0.1, 0.25, 0.5, 0.9})
  {
    const Point x = evaluate(curve, a, b, t);
    const double end = std::atan2(x[1], 0.5 * x[0]);
    const element::Rule rule = element::gauss(30);
    double length = 0.0;
    for (std::size_t q = 0; q < rule.points.size(); ++q)
    {
      const double angle = end * rule.points[q];
      length += rule.weights[q] * end * std::hypot(2.0 * std::sin(angle), std::cos(angle));
    }
    CHECK(std::abs(length / curve.lengths->length() - t) < 1e-12);
  }
}

TEST_CASE("the length of a curve does not depend on its parameter")
{
  const auto parabola = [](double t) { return Point{t, t * t, 0.0}; };
  const auto slow_start = [](double t) {
    return Point{t * (1.0 + t) / 2.0, std::pow(t * (1.0 + t) / 2.0, 2), 0.0};
  };
  const double exact = 0.5 * std::sqrt(5.0) + 0.25 * std::asinh(2.0);
  const ArcLength one(parabola);
  const ArcLength other(slow_start);
  CHECK(std::abs(one.length() - exact) < 1e-13);
  CHECK(std::abs(other.length() - exact) < 1e-13);
  for (const double share : {0.0, 0.01, 0.3, 0.77, 1.0})
    CHECK(geometry::distance(parabola(one.parameter(share)), slow_start(other.parameter(share))) < 1e-12);
}

TEST_CASE("an edge on a sphere follows the great circle, at constant speed if measured")
{
  const LevelSet sphere = formula("x^2 + y^2 + z^2 - 4");
  const Point a{2.0, 0.0, 0.0};
  const Point b{0.0, 2.0 * std::cos(0.4), 2.0 * std::sin(0.4)};
  const OnLevelSet curve = measured({sphere, {}, {}}, a, b);
  CHECK(message_of(curve, a, b) == "");
  for (const double t : {0.2, 0.5, 0.9})
  {
    const double angle = 0.5 * std::numbers::pi * t;
    const Point exact = geometry::combine(std::cos(angle), a, std::sin(angle), b);
    CHECK(geometry::distance(evaluate(curve, a, b, t), exact) < 1e-12);
  }
}

TEST_CASE("an edge on two level sets lies on their curve, its nodes in planes normal to the chord")
{
  const LevelSet sphere = formula("x^2 + y^2 + z^2 - 4");
  const LevelSet plane = geometry::plane({0.0, 0.0, 1.0}, {0.0, 0.0, 1.0});
  const double r = std::sqrt(3.0);
  const Point a{r, 0.0, 1.0};
  const Point b{0.0, r, 1.0};
  const OnLevelSet curve{sphere, plane, {}};
  CHECK(message_of(curve, a, b) == "");
  for (const double t : {0.2, 0.5, 0.9})
  {
    const Point x = evaluate(curve, a, b, t);
    CHECK(std::abs(norm(x) - 2.0) < 1e-14);
    CHECK(std::abs(x[2] - 1.0) < 1e-14);
    const Point start = geometry::combine(1.0 - t, a, t, b);
    CHECK(std::abs(dot(geometry::subtract(x, start), geometry::subtract(b, a))) < 1e-14);
  }
}

TEST_CASE("a direction of the user is searched both ways")
{
  const LevelSet wave = formula("y - 0.3 * sin(2 * pi * x)");
  const OnLevelSet curve{wave, {}, Point{0.0, 1.0, 0.0}};
  CHECK(message_of(curve, {}, {1.0, 0.0, 0.0}) == "");
  CHECK(evaluate(curve, {}, {1.0, 0.0, 0.0}, 0.25)[1] == doctest::Approx(0.3).epsilon(1e-13));
  CHECK(evaluate(curve, {}, {1.0, 0.0, 0.0}, 0.75)[1] == doctest::Approx(-0.3).epsilon(1e-13));
}

TEST_CASE("edges that do not fit their level set are refused with the reason and a remedy")
{
  const LevelSet circle = formula("x^2 + y^2 - 1");
  const Point a{1.0, 0.0, 0.0};
  const Point b{0.0, 1.0, 0.0};
  CHECK(message_of({circle, {}, {}}, a, {0.0, 1.1, 0.0}) ==
        "the end (0, 1.1) of the edge does not lie on the level set 'x^2 + y^2 - 1', whose value there is "
        "0.21; move it "
        "there, for instance to (0, 1)");
  CHECK(message_of({circle, {}, Point{1.0, -1.0, 0.0}}, a, b) ==
        "the edge turns back at (1, 0) on the level set 'x^2 + y^2 - 1'; give another direction or split the "
        "edge");
  CHECK(message_of({formula("(x^2 + y^2 - 1) * (x + y - 0.2)"), {}, Point{0.0, 0.0, 1.0}}, a, b) ==
        "the search from (0.96875, 0.03125) along (0, 0, 1) found no point of the level set '(x^2 + y^2 - 1) "
        "* (x + y - "
        "0.2)': no change of sign between -1.41421 m and 1.41421 m; correct the level set or the ends, give "
        "a direction "
        "or split the edge");
  // Near its start the outer circle is next to the chord, near its end the inner one.
  CHECK(message_of({formula("(x^2 + y^2 - 1) * (x^2 + y^2 - 4)"), {}, {}}, {2.0, 0.0, 0.0}, b)
            .starts_with("the edge jumps from ("));
}
