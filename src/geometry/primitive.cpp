#include "geometry/primitive.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace blockfsi::geometry
{

namespace
{

void check_size(std::string_view what, double size)
{
  if (!(size > 0.0 && std::isfinite(size)))
    throw Error(fmt::format("the {} is {:.9g} m; it must be positive", what, size));
}

Point unit(std::string_view what, const Point& direction)
{
  const double size = norm(direction);
  if (!(size > 0.0 && std::isfinite(size)))
    throw Error(fmt::format("the {} is ({:.9g}, {:.9g}, {:.9g}); it must have a length", what, direction[0],
                            direction[1], direction[2]));
  return scaled(1.0 / size, direction);
}

/// The distance to a point and its gradient by the vector to there.
Level length(const Point& v)
{
  const double size = norm(v);
  return {size, size > 0.0 ? scaled(1.0 / size, v) : Point{}};
}

/// How far outside each pair of sides, and the outward direction (-1 or 1) of the nearer side.
struct Outside
{
  Point distance;
  Point sign;
};

Outside outside(const Point& x, const Point& low, const Point& high)
{
  Outside result{};
  for (std::size_t c = 0; c < 3; ++c)
  {
    const double below = low[c] - x[c];
    const double above = x[c] - high[c];
    result.distance[c] = std::max(below, above);
    result.sign[c] = below > above ? -1.0 : 1.0;
  }
  return result;
}

Level box_level(const Point& x, const Point& low, const Point& high)
{
  const auto [distance, sign] = outside(x, low, high);
  const auto nearest = std::max_element(distance.begin(), distance.end()) - distance.begin();
  Level level{distance[nearest], {}};
  if (level.value <= 0.0)
  {
    level.gradient[nearest] = sign[nearest];
    return level;
  }
  level = length({std::max(distance[0], 0.0), std::max(distance[1], 0.0), std::max(distance[2], 0.0)});
  for (std::size_t c = 0; c < 3; ++c)
    level.gradient[c] *= sign[c];
  return level;
}

}  // namespace

LevelSet sphere(const Point& center, double radius)
{
  check_size("radius of the sphere", radius);
  return {fmt::format("sphere of radius {:.6g}", radius),
          [=](const Point& x)
          {
            Level level = length(subtract(x, center));
            level.value -= radius;
            return level;
          },
          [=](const Point& x) { return distance(x, center) - radius; }};
}

LevelSet cylinder(const Point& point, const Point& axis, double radius)
{
  check_size("radius of the cylinder", radius);
  const Point along = unit("axis of the cylinder", axis);
  const auto across = [=](const Point& x)
  {
    const Point from = subtract(x, point);
    return add_scaled(from, -dot(from, along), along);
  };
  return {fmt::format("cylinder of radius {:.6g}", radius),
          [=](const Point& x)
          {
            Level level = length(across(x));
            level.value -= radius;
            return level;
          },
          [=](const Point& x) { return norm(across(x)) - radius; }};
}

LevelSet box(const Point& low, const Point& high)
{
  for (std::size_t c = 0; c < 3; ++c)
    if (!(low[c] < high[c]))
      throw Error(
          fmt::format("the box goes from {:.9g} to {:.9g} in {}; the second corner must be the larger",
                      low[c], high[c], "xyz"[c]));
  return {"box", [=](const Point& x) { return box_level(x, low, high); }};
}

LevelSet plane(const Point& point, const Point& normal)
{
  const Point out = unit("normal of the plane", normal);
  const double offset = dot(out, point);
  return {"plane", [=](const Point& x) { return Level{dot(out, x) - offset, out}; }};
}

LevelSet torus(const Point& center, const Point& axis, double ring, double tube)
{
  check_size("ring radius of the torus", ring);
  check_size("tube radius of the torus", tube);
  if (!(tube < ring))
    throw Error(fmt::format("the tube of the torus has a radius of {:.9g} m, which must be smaller than that "
                            "of the ring, {:.9g} m",
                            tube, ring));
  const Point along = unit("axis of the torus", axis);
  return {
      fmt::format("torus of radii {:.6g} and {:.6g}", ring, tube), [=](const Point& x)
      {
        const Point from = subtract(x, center);
        const double height = dot(from, along);
        const Level radial = length(add_scaled(from, -height, along));
        const double excess = radial.value - ring;
        const double distance = std::hypot(excess, height);
        if (distance == 0.0)
          return Level{-tube, {}};
        return Level{distance - tube, combine(excess / distance, radial.gradient, height / distance, along)};
      }};
}

}  // namespace blockfsi::geometry
