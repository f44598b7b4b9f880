#pragma once

#include "geometry/level_set.hpp"

#include <cmath>

namespace blockfsi::geometry
{

/// Largest difference between the gradient of a level set and its central differences of order 4.
inline double gradient_error(const LevelSet& domain, const Point& x, double h = 1e-3)
{
  const Level level = domain(x);
  double error = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const auto value = [&](double shift)
    {
      Point moved = x;
      moved[c] += shift;
      return domain.value(moved);
    };
    const double difference =
        (8.0 * (value(h) - value(-h)) - (value(2.0 * h) - value(-2.0 * h))) / (12.0 * h);
    error = std::fmax(error, std::abs(level.gradient[c] - difference));
  }
  return error;
}

}  // namespace blockfsi::geometry
