#include "geometry/quadric.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace blockfsi::geometry
{

namespace
{

constexpr double turn = 2.0 * std::numbers::pi;

/// Orthonormal directions: `from`, across it, the axis.
struct Frame
{
  Point e;
  Point f;
  Point a;
};

Point unit(const Point& v)
{
  return scaled(1.0 / norm(v), v);
}

Frame make_frame(const Point& axis, const Point& from)
{
  const Point a = unit(axis);
  const Point e = unit(add_scaled(from, -dot(from, a), a));
  return {e, cross(a, e), a};
}

/// A circle about the centre of the frame at a share of the turn: the unit radius and its derivatives.
CurveJet circle(const Frame& frame, double share)
{
  const double c = std::cos(turn * share);
  const double s = std::sin(turn * share);
  const Point radius = combine(c, frame.e, s, frame.f);
  return {radius, scaled(turn, combine(-s, frame.e, c, frame.f)), scaled(-turn * turn, radius)};
}

double share_of_turn(double y, double x)
{
  const double share = std::atan2(y, x) / turn;
  // A tiny negative share becomes 1 by rounding, which is the same place.
  return share < 0.0 ? share + 1.0 : share;
}

void check_vector(std::string_view what, const char* name, const Point& v)
{
  if (!is_finite(v) || !(norm(v) > 0.0))
    throw Error(fmt::format("{}: its {} is {}; it must be a vector other than 0", what, name, text(v)));
}

void check_across(std::string_view what, const char* first_name, const Point& first, const char* second_name,
                  const Point& second)
{
  constexpr double smallest_sine = 1e-9;
  check_vector(what, first_name, first);
  check_vector(what, second_name, second);
  if (!(norm(cross(first, second)) > smallest_sine * norm(first) * norm(second)))
    throw Error(
        fmt::format("{}: its {} {} and its {} {} are parallel; they must point in different directions", what,
                    first_name, text(first), second_name, text(second)));
}

void check_center(std::string_view what, const Point& center)
{
  if (!is_finite(center))
    throw Error(fmt::format("{}: its centre is {}; it must be finite", what, text(center)));
}

void check_radius(std::string_view what, const char* name, double radius)
{
  if (!(radius > 0.0) || !std::isfinite(radius))
    throw Error(fmt::format("{}: its {} is {:.9g} m; it must be positive", what, name, radius));
}

}  // namespace

void check(std::string_view what, const Plane& plane)
{
  check_center(what, plane.origin);
  check_across(what, "first vector", plane.first, "second vector", plane.second);
}

void check(std::string_view what, const Sphere& sphere)
{
  check_center(what, sphere.center);
  check_radius(what, "radius", sphere.radius);
  check_across(what, "axis", sphere.axis, "direction of u = 0", sphere.from);
}

void check(std::string_view what, const Cylinder& cylinder)
{
  check_center(what, cylinder.center);
  check_radius(what, "radius", cylinder.radius);
  check_across(what, "axis", cylinder.axis, "direction of u = 0", cylinder.from);
}

void check(std::string_view what, const Torus& torus)
{
  check_center(what, torus.center);
  check_radius(what, "major radius", torus.major);
  check_radius(what, "minor radius", torus.minor);
  if (!(torus.minor < torus.major))
    throw Error(fmt::format("{}: its minor radius, {:.9g} m, must be less than its major radius, {:.9g} m",
                            what, torus.minor, torus.major));
  check_across(what, "axis", torus.axis, "direction of u = 0", torus.from);
}

SurfaceJet jet(const Plane& plane, double u, double v)
{
  return {add_scaled(add_scaled(plane.origin, u, plane.first), v, plane.second),
          plane.first,
          plane.second,
          {},
          {},
          {}};
}

SurfaceJet jet(const Sphere& sphere, double u, double v)
{
  constexpr double pi = std::numbers::pi;
  const Frame frame = make_frame(sphere.axis, sphere.from);
  const CurveJet r = circle(frame, u);
  const double c = sphere.radius * std::cos(pi * (v - 0.5));
  const double s = sphere.radius * std::sin(pi * (v - 0.5));
  const Point radius = combine(c, r.x, s, frame.a);
  return {add(sphere.center, radius), scaled(c, r.first),       scaled(pi, combine(-s, r.x, c, frame.a)),
          scaled(c, r.second),        scaled(-pi * s, r.first), scaled(-pi * pi, radius)};
}

SurfaceJet jet(const Cylinder& cylinder, double u, double v)
{
  const CurveJet r = circle(make_frame(cylinder.axis, cylinder.from), u);
  return {add_scaled(add_scaled(cylinder.center, v, cylinder.axis), cylinder.radius, r.x),
          scaled(cylinder.radius, r.first),
          cylinder.axis,
          scaled(cylinder.radius, r.second),
          {},
          {}};
}

SurfaceJet jet(const Torus& torus, double u, double v)
{
  const Frame frame = make_frame(torus.axis, torus.from);
  const CurveJet r = circle(frame, u);
  const double c = torus.minor * std::cos(turn * v);
  const double s = torus.minor * std::sin(turn * v);
  const double radius = torus.major + c;
  return {add(torus.center, combine(radius, r.x, s, frame.a)),
          scaled(radius, r.first),
          scaled(turn, combine(-s, r.x, c, frame.a)),
          scaled(radius, r.second),
          scaled(-turn * s, r.first),
          scaled(turn * turn, combine(-c, r.x, -s, frame.a))};
}

std::array<double, 2> closest_parameters(const Plane& plane, const Point& point)
{
  const Point d = subtract(point, plane.origin);
  const Point normal = cross(plane.first, plane.second);
  const double area = dot(normal, normal);
  return {dot(cross(d, plane.second), normal) / area, dot(cross(plane.first, d), normal) / area};
}

std::array<double, 2> closest_parameters(const Sphere& sphere, const Point& point)
{
  const Frame frame = make_frame(sphere.axis, sphere.from);
  const Point d = subtract(point, sphere.center);
  const double x = dot(d, frame.e);
  const double y = dot(d, frame.f);
  return {share_of_turn(y, x), 0.5 + std::atan2(dot(d, frame.a), std::hypot(x, y)) / std::numbers::pi};
}

std::array<double, 2> closest_parameters(const Cylinder& cylinder, const Point& point)
{
  const Frame frame = make_frame(cylinder.axis, cylinder.from);
  const Point d = subtract(point, cylinder.center);
  return {share_of_turn(dot(d, frame.f), dot(d, frame.e)), dot(d, frame.a) / norm(cylinder.axis)};
}

std::array<double, 2> closest_parameters(const Torus& torus, const Point& point)
{
  const Frame frame = make_frame(torus.axis, torus.from);
  const Point d = subtract(point, torus.center);
  const double x = dot(d, frame.e);
  const double y = dot(d, frame.f);
  return {share_of_turn(y, x), share_of_turn(dot(d, frame.a), std::hypot(x, y) - torus.major)};
}

}  // namespace blockfsi::geometry
