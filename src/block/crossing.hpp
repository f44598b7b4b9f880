#pragma once

#include <array>

namespace blockfsi::block
{

/// Where the lines between opposite parameters of a quadrilateral's edges cross: u = (1 - v) bottom + v top,
/// v = (1 - u) left + u right.
inline std::array<double, 2> crossing(double bottom, double top, double left, double right)
{
  const double determinant = 1.0 - (right - left) * (top - bottom);
  return {(bottom + left * (top - bottom)) / determinant, (left + bottom * (right - left)) / determinant};
}

}  // namespace blockfsi::block
