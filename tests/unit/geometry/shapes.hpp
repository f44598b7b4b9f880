#pragma once

#include "geometry/nurbs.hpp"

#include <cmath>
#include <numbers>

/// NURBS of exact shapes, for the tests (Piegl & Tiller 1997, chapter 7).
namespace blockfsi::geometry::shapes
{

inline const double half_root = 1.0 / std::numbers::sqrt2;

/// The circle about the origin in the plane of x and y as four quarters of degree 2.
inline NurbsCurve circle(double radius)
{
  NurbsCurve curve;
  curve.degree = 2;
  curve.knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
  constexpr std::array<std::array<double, 2>, 9> corners{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}}};
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    curve.points.push_back({radius * corners[i][0], radius * corners[i][1], 0.0});
    curve.weights.push_back(i % 2 == 0 ? 1.0 : half_root);
  }
  return curve;
}

/// A profile in the plane of x (distance from the axis) and z, turned about z; u turns, v follows the
/// profile.
inline NurbsSurface revolve(const NurbsCurve& profile)
{
  const NurbsCurve turn = circle(1.0);
  NurbsSurface surface;
  surface.degrees = {turn.degree, profile.degree};
  surface.knots = {turn.knots, profile.knots};
  for (std::size_t i = 0; i < turn.points.size(); ++i)
    for (std::size_t j = 0; j < profile.points.size(); ++j)
    {
      const Point& p = profile.points[j];
      surface.points.push_back({p[0] * turn.points[i][0], p[0] * turn.points[i][1], p[2]});
      surface.weights.push_back(turn.weights[i] * profile.weights[j]);
    }
  return surface;
}

inline NurbsSurface sphere(double radius)
{
  const double r = radius;
  return revolve({.degree = 2,
                  .knots = {0, 0, 0, 1, 1, 2, 2, 2},
                  .points = {{0, 0, -r}, {r, 0, -r}, {r, 0, 0}, {r, 0, r}, {0, 0, r}},
                  .weights = {1, half_root, 1, half_root, 1}});
}

inline NurbsSurface torus(double major, double minor)
{
  NurbsCurve tube = circle(minor);
  for (Point& p : tube.points)
    p = {major + p[0], 0.0, p[1]};
  return revolve(tube);
}

}  // namespace blockfsi::geometry::shapes
