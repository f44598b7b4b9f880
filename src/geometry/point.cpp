#include "geometry/point.hpp"

#include <fmt/format.h>

namespace blockfsi::geometry
{

std::string text(const Point& p)
{
  return p[2] == 0.0 ? fmt::format("({:.9g}, {:.9g})", p[0], p[1])
                     : fmt::format("({:.9g}, {:.9g}, {:.9g})", p[0], p[1], p[2]);
}

}  // namespace blockfsi::geometry
