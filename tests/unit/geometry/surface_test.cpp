#include "geometry/surface.hpp"

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

constexpr std::array<std::string_view, 2> on_surface{"u", "v"};

Expression formula(std::string_view text)
{
  return Expression(text, {}, on_surface);
}

std::string message_of(const Surface& surface)
{
  try
  {
    check(surface);
  }
  catch (const Error& error)
  {
    return error.message();
  }
  return "";
}

const Sphere tilted_sphere{{0.3, -1, 2}, 1.5, {1, 1, 0.5}, {0, 1, 3}};
const Cylinder tilted_cylinder{{0.3, -1, 2}, 0.6, {1, 1, 0.5}, {0, 1, 3}};
const Torus tilted_torus{{0.3, -1, 2}, 1.5, 0.4, {1, 1, 0.5}, {0, 1, 3}};
const FormulaSurface saddle{{formula("u"), formula("v"), formula("u * v - v^2")}};

std::vector<Surface> all_surfaces()
{
  TrianglePatch triangle{2, {{0, 0, 0}, {0.5, 0, 0.1}, {1, 0, 0}, {0, 0.5, 0.2}, {0.6, 0.5, 0}, {0, 1, 0}}};
  return {
      Plane{{1, 2, 3}, {1, 0, 1}, {0.5, 2, 0}},
      tilted_sphere,
      tilted_cylinder,
      tilted_torus,
      equispaced_patch(1, 2, {{0, 0, 0}, {0.2, 0.5, 0.3}, {0, 1, 0}, {1, 0, 0}, {1, 0.5, 0.1}, {1.2, 1, 0}}),
      triangle,
      shapes::torus(2.0, 0.5),
      saddle,
      FunctionSurface{[](double u, double v) {
        return Point{u, std::exp(v), std::sin(u * v)};
      }}};
}

/// A point off the surface, on the normal at u, v.
Point lifted(const Surface& surface, double u, double v, double height)
{
  const SurfaceJet s = jet(surface, u, v);
  const Point normal = cross(s.u, s.v);
  return add_scaled(s.x, height / norm(normal), normal);
}

}  // namespace

TEST_CASE("the derivatives of every surface are those of its points")
{
  for (const Surface& surface : all_surfaces())
    for (const double u : {0.1, 0.45, 0.6})
      for (const double v : {0.07, 0.3})
      {
        const SurfaceJet s = jet(surface, u, v);
        CHECK(distance(s.x, evaluate(surface, u, v)) < 1e-14);
        CHECK(distance(s.u, differentiate([&](double r) { return evaluate(surface, r, v); }, u)) < 1e-10);
        CHECK(distance(s.v, differentiate([&](double r) { return evaluate(surface, u, r); }, v)) < 1e-10);
        CHECK(distance(s.uu, differentiate([&](double r) { return jet(surface, r, v).u; }, u)) < 1e-7);
        CHECK(distance(s.uv, differentiate([&](double r) { return jet(surface, u, r).u; }, v)) < 1e-7);
        CHECK(distance(s.vv, differentiate([&](double r) { return jet(surface, u, r).v; }, v)) < 1e-7);
      }
}

TEST_CASE("many points of every surface at once are those one by one")
{
  const std::vector<double> u{0.0, 0.5, 0.2};
  const std::vector<double> v{0.1, 0.3, 0.8};
  for (const Surface& surface : all_surfaces())
  {
    std::vector<Point> x(3);
    evaluate(surface, u, v, x);
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(x[i] == evaluate(surface, u[i], v[i]));
  }
}

TEST_CASE("the corners of a surface are those of its parameters")
{
  CHECK(corner_count(saddle) == 4);
  CHECK(corner(saddle, 2) == Point{1, 1, 0});
  CHECK(corner(saddle, 3) == Point{0, 1, -1});
  const Surface triangle = TrianglePatch{1, {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}};
  CHECK(corner_count(triangle) == 3);
  CHECK(corner(triangle, 2) == Point{0, 2, 0});
}

TEST_CASE("a sphere, a cylinder and a torus hold their equations")
{
  for (const double u : {0.0, 0.2, 0.7})
    for (const double v : {0.1, 0.5, 0.9})
    {
      CHECK(std::abs(distance(evaluate(tilted_sphere, u, v), tilted_sphere.center) - 1.5) < 1e-14);
      const Point a = scaled(1.0 / 1.5, tilted_cylinder.axis);
      const Point d = subtract(evaluate(tilted_cylinder, u, v), tilted_cylinder.center);
      CHECK(std::abs(norm(cross(d, a)) - 0.6) < 1e-14);
      CHECK(dot(d, a) == doctest::Approx(1.5 * v).epsilon(1e-13));
      const Point e = subtract(evaluate(tilted_torus, u, v), tilted_torus.center);
      CHECK(std::abs(std::hypot(norm(cross(e, a)) - 1.5, dot(e, a)) - 0.4) < 1e-14);
    }
  // The poles lie on the axis.
  CHECK(distance(evaluate(tilted_sphere, 0.3, 1.0), add(tilted_sphere.center, tilted_sphere.axis)) < 1e-14);
}

TEST_CASE("the closest point of a surface to a point on one of its normals is the foot of the normal")
{
  for (const Surface& surface : all_surfaces())
    for (const double height : {0.0, 0.05, -0.1})
      for (const double u : {0.12, 0.41, 0.66})
        for (const double v : {0.08, 0.27})
        {
          const Point point = lifted(surface, u, v, height);
          const Closest found = closest(surface, point);
          CHECK(found.converged);
          CHECK(found.distance == doctest::Approx(std::abs(height)).epsilon(1e-12));
          CHECK(distance(found.x, evaluate(surface, u, v)) < 1e-12);
          CHECK(found.u == doctest::Approx(u).epsilon(1e-11));
          CHECK(found.v == doctest::Approx(v).epsilon(1e-11));
        }
}

TEST_CASE("the closest points on a NURBS sphere and torus are those of the sphere and the torus")
{
  const Surface sphere = shapes::sphere(1.5);
  const Surface torus = shapes::torus(2.0, 0.5);
  std::vector<Point> points;
  for (int i = 0; i < 60; ++i)
    points.push_back(
        {3.0 * std::sin(1.0 + 7.0 * i), 3.0 * std::sin(2.0 + 11.0 * i), 1.5 * std::sin(3.0 * i)});
  const std::vector<Closest> on_sphere = closest(sphere, points);
  const std::vector<Closest> on_torus = closest(torus, points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Closest exact_sphere = closest(Sphere{.radius = 1.5}, points[i]);
    const Closest exact_torus = closest(Torus{.major = 2.0, .minor = 0.5}, points[i]);
    CHECK(on_sphere[i].converged);
    CHECK(distance(on_sphere[i].x, exact_sphere.x) < 2e-13);
    CHECK(on_torus[i].converged);
    CHECK(distance(on_torus[i].x, exact_torus.x) < 2e-13);
    CHECK(distance(closest(torus, points[i]).x, on_torus[i].x) < 1e-13);
  }
}

TEST_CASE("a search from the parameters of a neighbour ends at the same point, also across the seam")
{
  const Surface torus = shapes::torus(2.0, 0.5);
  for (const double angle : {-1e-3, 0.5, 3.0})
  {
    const Point point{2.7 * std::cos(angle), 2.7 * std::sin(angle), 0.1};
    const Point exact = closest(Torus{.major = 2.0, .minor = 0.5}, point).x;
    const Closest cold = closest(torus, point);
    CHECK(distance(cold.x, exact) < 2e-13);
    CHECK(distance(closest(torus, point, {{cold.u + 0.01, cold.v + 0.005}}).x, exact) < 2e-13);
    // The seam of the parameters lies between this start and the point.
    CHECK(distance(closest(torus, point, {{0.001, 0.001}}).x, exact) < 2e-13);
  }
}

TEST_CASE("closest points stay within the bounds of the parameters")
{
  const Surface patch = equispaced_patch(1, 1, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}});
  CHECK(distance(closest(patch, {2.0, 0.4, 1.0}).x, {1.0, 0.4, 0.0}) < 1e-13);
  CHECK(distance(closest(patch, {-2.0, 1.4, 1.0}).x, {0.0, 1.0, 0.0}) < 1e-13);
  const Surface triangle = TrianglePatch{1, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  CHECK(distance(closest(triangle, {1.0, 1.2, 0.3}).x, {0.4, 0.6, 0.0}) < 1e-13);
  CHECK(distance(closest(triangle, {3.0, 0.0, 0.3}).x, {1.0, 0.0, 0.0}) < 1e-13);
  CHECK(distance(closest(triangle, {0.3, -1.0, 0.3}).x, {0.3, 0.0, 0.0}) < 1e-13);
  CHECK(closest(triangle, {3.0, 0.0, 0.3}).converged);
}

TEST_CASE("the centre of a sphere and the axis of a torus still have closest points")
{
  CHECK(closest(tilted_sphere, tilted_sphere.center).distance == doctest::Approx(1.5));
  CHECK(closest(tilted_torus, tilted_torus.center).distance == doctest::Approx(1.1));
  CHECK(closest(tilted_cylinder, tilted_cylinder.center).distance == doctest::Approx(0.6));
}

TEST_CASE("surfaces that make no sense are refused with the reason")
{
  for (const Surface& surface : all_surfaces())
    CHECK(message_of(surface) == "");
  CHECK(message_of(Plane{{}, {1, 0, 0}, {2, 0, 0}}) ==
        "the plane: its first vector (1, 0) and its second vector (2, 0) are parallel; they must point in "
        "different "
        "directions");
  CHECK(message_of(Sphere{.radius = -1.0}) == "the sphere: its radius is -1 m; it must be positive");
  CHECK(message_of(Sphere{.axis = {}}) == "the sphere: its axis is (0, 0); it must be a vector other than 0");
  CHECK(message_of(Cylinder{.axis = {2, 0, 0}}) == "the cylinder: its axis (2, 0) and its direction of u = 0 "
                                                   "(1, 0) are parallel; they must point in different "
                                                   "directions");
  CHECK(message_of(Torus{.major = 1.0, .minor = 1.0}) ==
        "the torus: its minor radius, 1 m, must be less than its major radius, 1 m");
  CHECK(message_of(FormulaSurface{{formula("u"), formula("1 / v"), 0.0}}) ==
        "the formula of the surface has no finite value at u = 0, v = 0; it must have one for u and v from 0 "
        "to 1");
  CHECK(message_of(FunctionSurface{}) == "the function of the surface is empty; give one");
  NurbsSurface torus = shapes::torus(2.0, 0.5);
  torus.weights[5] = 0.0;
  CHECK(message_of(torus) == "the B-spline surface: weight 6 is 0; it must be positive");
}
