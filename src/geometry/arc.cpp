#include "geometry/arc.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blockfsi::geometry
{

namespace
{

constexpr double whole_turn = 2.0 * std::numbers::pi;

/// Angle at `center` between a and b, 0..pi; atan2 is accurate for small and for flat angles.
double opening_angle(const Point& center, const Point& a, const Point& b)
{
  const Point r = subtract(a, center);
  const Point s = subtract(b, center);
  return std::atan2(norm(cross(r, s)), dot(r, s));
}

/// The turn about an axis from a, right-handed, to the direction of b.
raw::Turn turn_about(const Point& center, const Point& axis, const Point& a, const Point& b)
{
  const Point r = subtract(a, center);
  const Point s = subtract(b, center);
  const Point upright = add_scaled(axis, -dot(axis, r) / dot(r, r), r);
  const Point second = scaled(1.0 / norm(upright), cross(upright, r));
  const double angle = std::atan2(dot(s, second), dot(s, r));
  return {center, r, second, 0.0, angle > 0.0 ? angle : angle + whole_turn};
}

/// The centre of the circle through three points. (Coxeter: the barycentrics of the circumcentre.)
Point circumcenter(const Point& a, const Point& b, const Point& c)
{
  const Point u = subtract(b, a);
  const Point v = subtract(c, a);
  const Point w = cross(u, v);
  return add_scaled(a, 0.5 / dot(w, w), combine(dot(v, v), cross(w, u), dot(u, u), cross(v, w)));
}

/// The shares of both half-axes in x - center, and how far x lies off their plane [m].
struct InAxes
{
  double first;
  double second;
  double off;
};

InAxes resolve(const Ellipse& ellipse, const Point& x)
{
  const Point d = subtract(x, ellipse.center);
  const Point normal = cross(ellipse.first, ellipse.second);
  const double area = dot(normal, normal);
  return {dot(cross(d, ellipse.second), normal) / area, dot(cross(ellipse.first, d), normal) / area,
          std::abs(dot(d, normal)) / std::sqrt(area)};
}

/// The difference of the angles of b and a, from -pi to pi.
double ellipse_angle(const InAxes& a, const InAxes& b)
{
  return std::atan2(a.first * b.second - a.second * b.first, a.first * b.first + a.second * b.second);
}

void check_axis(const Arc& arc, const Point& a, const Point& b)
{
  const double size = norm(*arc.axis);
  if (!(size > 0.0))
    throw Error("the axis of the arc is 0; it must be a direction");
  for (const Point& end : {a, b})
  {
    const Point radius = subtract(end, arc.center);
    if (!(std::abs(dot(radius, *arc.axis)) <= fit_tolerance * norm(radius) * size))
      throw Error(
          fmt::format("the axis {} of the arc about {} is not at right angles to the radius that ends at {}; "
                      "correct the axis, the centre or the point",
                      text(*arc.axis), text(arc.center), text(end)));
  }
}

}  // namespace

raw::Turn make_turn(const Arc& arc, const Point& a, const Point& b, bool reversed)
{
  if (arc.axis)
    return turn_about(arc.center, reversed ? scaled(-1.0, *arc.axis) : *arc.axis, a, b);
  const Point normal = cross(subtract(a, arc.center), subtract(b, arc.center));
  return turn_about(arc.center, arc.longer ? scaled(-1.0, normal) : normal, a, b);
}

raw::Turn make_turn(const ArcThrough& arc, const Point& a, const Point& b)
{
  return turn_about(circumcenter(a, arc.point, b), cross(subtract(arc.point, a), subtract(b, a)), a, b);
}

raw::Turn make_turn(const Ellipse& ellipse, const Point& a, const Point& b)
{
  const InAxes start = resolve(ellipse, a);
  double angle = ellipse_angle(start, resolve(ellipse, b));
  if (ellipse.longer)
    angle -= std::copysign(whole_turn, angle);
  return {ellipse.center, ellipse.first, ellipse.second, std::atan2(start.second, start.first), angle};
}

void check(const Arc& arc, const Point& a, const Point& b)
{
  const double radius_a = distance(a, arc.center);
  const double radius_b = distance(b, arc.center);
  const double radius = std::max(radius_a, radius_b);
  if (!(std::abs(radius_a - radius_b) <= fit_tolerance * radius))
    throw Error(
        fmt::format("the arc's end points {} and {} are {:.12g} m and {:.12g} m away from its centre {}; "
                    "both must have the same distance, so correct the centre or an end point",
                    text(a), text(b), radius_a, radius_b, text(arc.center)));
  if (arc.axis)
    check_axis(arc, a, b);
  else if (std::sin(opening_angle(arc.center, a, b)) < fit_tolerance)
    throw Error(
        fmt::format("the arc from {} to {} about {} is half a circle, so both ways round are equally long; "
                    "give the axis about which it turns or a point that it passes through",
                    text(a), text(b), text(arc.center)));
}

void check(const ArcThrough& arc, const Point& a, const Point& b)
{
  const Point u = subtract(arc.point, a);
  const Point v = subtract(b, a);
  if (!(norm(cross(u, v)) > fit_tolerance * norm(u) * norm(v)) || arc.point == b)
    throw Error(fmt::format("the arc's points {}, {} and {} lie on one line; they must span a circle",
                            text(a), text(arc.point), text(b)));
}

void check(const Ellipse& ellipse, const Point& a, const Point& b)
{
  const double size = norm(ellipse.first) + norm(ellipse.second);
  if (!(norm(cross(ellipse.first, ellipse.second)) >
        fit_tolerance * norm(ellipse.first) * norm(ellipse.second)))
    throw Error(fmt::format("the half-axes {} and {} of the ellipse must be vectors in different directions",
                            text(ellipse.first), text(ellipse.second)));
  for (const Point& end : {a, b})
  {
    const InAxes p = resolve(ellipse, end);
    const double radius = std::hypot(p.first, p.second);
    if (p.off > fit_tolerance * size)
      throw Error(
          fmt::format("{} lies {:.9g} m off the plane of the ellipse; correct its half-axes or the point",
                      text(end), p.off));
    if (!(std::abs(radius - 1.0) <=
          fit_tolerance * size / std::min(norm(ellipse.first), norm(ellipse.second))))
      throw Error(
          fmt::format("{} lies on an ellipse that is {:.12g} times as large as the given one; correct its "
                      "centre, its half-axes or the point",
                      text(end), radius));
  }
  if (std::abs(std::sin(ellipse_angle(resolve(ellipse, a), resolve(ellipse, b)))) < fit_tolerance)
    throw Error(
        fmt::format("the part from {} to {} is half the ellipse, so both ways round are equally long; split "
                    "the edge by a point on the way",
                    text(a), text(b)));
}

}  // namespace blockfsi::geometry
