#pragma once

#include "geometry/point.hpp"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace blockfsi::geometry
{

/// All points between two corners [m].
struct Box
{
  Point low{};
  Point high{};

  /// Whether they have a point in common.
  bool meets(const Box& other) const
  {
    for (std::size_t c = 0; c < 3; ++c)
      if (low[c] > other.high[c] || other.low[c] > high[c])
        return false;
    return true;
  }
};

/// The box around some points, wider by a margin on all sides; the points must be one at least.
Box box_around(std::span<const Point> points, double margin);

/// The box around two boxes.
Box joined(const Box& a, const Box& b);

/// The pairs i < j of boxes that meet, ascending. In time n log n plus what is found, by a tree that halves
/// the boxes along the longest extent of their centres (Ericson 2005, Real-Time Collision Detection, ch. 6).
std::vector<std::pair<std::int32_t, std::int32_t>> meeting_pairs(std::span<const Box> boxes);

}  // namespace blockfsi::geometry
