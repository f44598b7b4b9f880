#pragma once

#include <array>
#include <cmath>
#include <string>

namespace blockfsi::geometry
{

/// A point or a vector [m]; the third coordinate is 0 in 2D.
using Point = std::array<double, 3>;

/// s a + t b
inline Point combine(double s, const Point& a, double t, const Point& b)
{
  return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]};
}

inline Point add(const Point& a, const Point& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// a + s b
inline Point add_scaled(const Point& a, double s, const Point& b)
{
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}

inline Point subtract(const Point& a, const Point& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Point scaled(double s, const Point& a)
{
  return {s * a[0], s * a[1], s * a[2]};
}

inline double dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point cross(const Point& a, const Point& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Euclidean length.
inline double norm(const Point& a)
{
  return std::hypot(a[0], a[1], a[2]);
}

inline double distance(const Point& a, const Point& b)
{
  return norm(subtract(a, b));
}

inline bool is_finite(const Point& a)
{
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

/// "(x, y)" in the plane, else "(x, y, z)", for messages.
std::string text(const Point& p);

}  // namespace blockfsi::geometry
