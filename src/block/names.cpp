#include "block/names.hpp"

#include "core/error.hpp"
#include "core/nearest.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace blockfsi::block
{

namespace
{

/// "x3 y2" of "channel x3 y2": what stays when a prefix of words is left out.
bool ends_with_words(std::string_view full, std::string_view name)
{
  return full.size() > name.size() && full.ends_with(name) && full[full.size() - name.size() - 1] == ' ';
}

/// Full names and names without their lattices, to suggest from.
std::vector<std::string> suggestions(const Layout& layout)
{
  std::vector<std::string> names;
  for (const Point& point : layout.points)
  {
    names.push_back(point.name);
    if (const auto blank = point.name.find(' '); blank != std::string::npos)
      names.push_back(point.name.substr(blank + 1));
  }
  return names;
}

}  // namespace

int find_point(const Layout& layout, std::string_view name)
{
  std::vector<int> found;
  for (std::size_t p = 0; p < layout.points.size(); ++p)
  {
    if (layout.points[p].name == name)
      return static_cast<int>(p);
    if (ends_with_words(layout.points[p].name, name))
      found.push_back(static_cast<int>(p));
  }
  if (found.size() == 1)
    return found[0];
  if (found.empty())
    throw Error(fmt::format("there is no point '{}'{}", name, did_you_mean(name, suggestions(layout))));
  std::vector<std::string> full;
  full.reserve(found.size());
  for (const int point : found)
    full.push_back("'" + layout.points[point].name + "'");
  throw Error(fmt::format("'{}' may be any of the points {}; give the full name", name, listed(full)));
}

}  // namespace blockfsi::block
