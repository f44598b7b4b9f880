#include "geometry/nurbs.hpp"

#include "core/error.hpp"
#include "geometry/difference.hpp"
#include "shapes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace blockfsi;
using namespace blockfsi::geometry;

namespace
{

template <typename Shape>
std::string message_of(const Shape& shape)
{
  try
  {
    check("the NURBS", shape);
  }
  catch (const Error& error)
  {
    return error.message();
  }
  return "";
}

/// A cubic with uneven knots and weights.
NurbsCurve wild_curve()
{
  return {.degree = 3,
          .knots = {-2, -2, -2, -2, 0.5, 1, 3, 3, 3, 3},
          .points = {{0, 0, 0}, {1, 2, 0.5}, {2, -1, 1}, {3, 1, -1}, {4, 0, 0.2}, {5, 1, 1}},
          .weights = {1, 0.7, 1.5, 1, 1.4, 1.2}};
}

NurbsSurface wild_surface()
{
  NurbsSurface surface;
  surface.degrees = {2, 3};
  surface.knots = {std::vector<double>{0, 0, 0, 1, 3, 3, 3},
                   std::vector<double>{1, 1, 1, 1, 1.5, 2, 2, 2, 2}};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 5; ++j)
    {
      surface.points.push_back({i + 0.1 * j, j - 0.2 * i, std::sin(1.0 + i * j)});
      surface.weights.push_back(1.0 + 0.2 * std::cos(i + 3.0 * j));
    }
  return surface;
}

}  // namespace

TEST_CASE("a NURBS circle is round to rounding")
{
  const NurbsCurve curve = shapes::circle(2.5);
  CHECK(message_of(curve) == "");
  for (int i = 0; i <= 1000; ++i)
  {
    const CurveJet c = jet(curve, i / 1000.0);
    CHECK(std::abs(norm(c.x) - 2.5) < 2.5e-14 / 2.5);
    CHECK(std::abs(dot(c.x, c.first)) < 1e-12);
    // c . c'' = -|c'|^2 on a circle about the origin.
    CHECK(std::abs(dot(c.x, c.second) + dot(c.first, c.first)) < 1e-11 * dot(c.first, c.first));
  }
}

TEST_CASE("a NURBS sphere and torus hold their equations to rounding")
{
  const NurbsSurface sphere = shapes::sphere(1.5);
  const NurbsSurface torus = shapes::torus(2.0, 0.7);
  CHECK(message_of(sphere) == "");
  CHECK(message_of(torus) == "");
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j)
    {
      CHECK(std::abs(norm(evaluate(sphere, i / 40.0, j / 40.0)) - 1.5) < 1e-14);
      const Point x = evaluate(torus, i / 40.0, j / 40.0);
      CHECK(std::abs(std::hypot(std::hypot(x[0], x[1]) - 2.0, x[2]) - 0.7) < 1e-14);
    }
}

TEST_CASE("a curve starts and ends at its outer control points bit for bit")
{
  const NurbsCurve curve = wild_curve();
  CHECK(evaluate(curve, 0.0) == curve.points.front());
  CHECK(evaluate(curve, 1.0) == curve.points.back());
}

TEST_CASE("the derivatives of NURBS are those of their points")
{
  const NurbsCurve curve = wild_curve();
  // Not at the knots, at 0.5 and 0.6, where the third derivative jumps.
  for (const double t : {0.0, 0.1, 0.35, 0.55, 0.7, 1.0})
  {
    const CurveJet c = jet(curve, t);
    CHECK(distance(c.x, evaluate(curve, t)) < 1e-14);
    CHECK(distance(c.first, differentiate([&](double s) { return evaluate(curve, s); }, t)) < 1e-9);
    CHECK(distance(c.second, differentiate([&](double s) { return jet(curve, s).first; }, t)) < 1e-8);
  }
  const NurbsSurface surface = wild_surface();
  for (const double u : {0.0, 0.2, 0.7, 1.0})
    for (const double v : {0.0, 0.4, 0.8, 1.0})
    {
      const SurfaceJet s = jet(surface, u, v);
      CHECK(distance(s.x, evaluate(surface, u, v)) < 1e-14);
      CHECK(distance(s.u, differentiate([&](double r) { return evaluate(surface, r, v); }, u)) < 1e-9);
      CHECK(distance(s.v, differentiate([&](double r) { return evaluate(surface, u, r); }, v)) < 1e-9);
      CHECK(distance(s.uu, differentiate([&](double r) { return jet(surface, r, v).u; }, u)) < 1e-8);
      CHECK(distance(s.uv, differentiate([&](double r) { return jet(surface, u, r).u; }, v)) < 1e-8);
      CHECK(distance(s.vv, differentiate([&](double r) { return jet(surface, u, r).v; }, v)) < 1e-8);
    }
}

TEST_CASE("many points at once are those one by one, with weights and without")
{
  NurbsCurve curve = wild_curve();
  NurbsSurface surface = wild_surface();
  const std::vector<double> t{0.0, 0.3, 0.1, 1.0, 0.5, 0.99};
  const std::vector<double> v{1.0, 0.2, 0.9, 0.0, 0.5, 0.3};
  std::vector<Point> x(t.size());
  for (int pass = 0; pass < 2; ++pass)
  {
    evaluate(curve, t, x);
    for (std::size_t i = 0; i < t.size(); ++i)
      CHECK(x[i] == evaluate(curve, t[i]));
    evaluate(surface, t, v, x);
    for (std::size_t i = 0; i < t.size(); ++i)
      CHECK(x[i] == evaluate(surface, t[i], v[i]));
    curve.weights.clear();
    surface.weights.clear();
  }
}

TEST_CASE("equal weights change nothing")
{
  NurbsCurve curve = wild_curve();
  curve.weights.assign(curve.points.size(), 3.0);
  NurbsCurve plain = curve;
  plain.weights.clear();
  for (const double t : {0.1, 0.4, 0.9})
  {
    CHECK(distance(evaluate(curve, t), evaluate(plain, t)) < 1e-14);
    CHECK(distance(jet(curve, t).second, jet(plain, t).second) < 1e-11);
  }
}

TEST_CASE("wrong weights and points of NURBS are refused by name")
{
  NurbsCurve curve = wild_curve();
  CHECK(message_of(curve) == "");
  curve.weights[2] = -1.0;
  CHECK(message_of(curve) == "the NURBS: weight 3 is -1; it must be positive");
  curve.weights.pop_back();
  CHECK(message_of(curve) == "the NURBS: found 5 weights for 6 control points; each needs one");
  curve.weights.clear();
  curve.points[1][2] = std::nan("");
  CHECK(message_of(curve) == "the NURBS: control point 2 is (1, 2, nan); it must be finite");

  NurbsSurface surface = wild_surface();
  CHECK(message_of(surface) == "");
  surface.points.pop_back();
  CHECK(message_of(surface) == "the NURBS: found 19 control points; the knots and degrees need 4 x 5 = 20");
  surface.knots[1][4] = 7.0;
  CHECK(message_of(surface) ==
        "the NURBS along v: knot 6 is 2, less than knot 5, 7; knots must not decrease");
  surface.degrees[0] = 30;
  CHECK(message_of(surface) == "the NURBS along u: the degree is 30; it must be from 1 to 25");
}
