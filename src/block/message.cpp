#include "block/message.hpp"

#include <fmt/format.h>

#include <utility>

namespace blockfsi::block
{

std::string point_text(const Layout& layout, int point)
{
  const Point& p = layout.points[point];
  if (layout.dim == 3)
    return fmt::format("'{}' ({:.9g}, {:.9g}, {:.9g})", p.name, p.x[0], p.x[1], p.x[2]);
  return fmt::format("'{}' ({:.9g}, {:.9g})", p.name, p.x[0], p.x[1]);
}

std::string edge_text(const Layout& layout, int a, int b)
{
  return fmt::format("from {} to {}", point_text(layout, a), point_text(layout, b));
}

std::string side_text(const Layout& layout, const std::vector<int>& points)
{
  if (points.size() == 2)
    return "edge " + edge_text(layout, points[0], points[1]);
  std::string text = "face over ";
  for (std::size_t p = 0; p < points.size(); ++p)
    text += (p == 0 ? "" : p + 1 == points.size() ? " and " : ", ") + point_text(layout, points[p]);
  return text;
}

std::string place_text(const Location& where)
{
  if (where.file.empty())
    return "";
  if (where.line == 0)
    return fmt::format(" ({})", where.file);
  return fmt::format(" ({}:{}:{})", where.file, where.line, where.column);
}

Error mistake(const Location& where, std::string message)
{
  return where.file.empty() ? Error(std::move(message)) : Error(where, std::move(message));
}

}  // namespace blockfsi::block
