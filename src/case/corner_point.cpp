#include "case/corner_point.hpp"

#include "case/level_set.hpp"
#include "geometry/project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <variant>

namespace blockfsi::case_file
{

using geometry::LevelSet;
using geometry::Point;

namespace
{

/// Where a point of blocks lies on level sets.
struct OnSurface
{
  Point near{};
  std::vector<LevelSet> on;
  std::optional<Point> direction;
};

const Keys<OnSurface>& on_surface_keys()
{
  static const Keys<OnSurface> keys = {
      {{"near", "[number, number] or [number, number, number]", "required", "m",
        "where to look for the point"},
       [](const Value& v, Reading& r, OnSurface& o) { o.near = point_in_space(v, r.constants); }},
      {{"on", "name or formula, or list of two", "required", "",
        "level set, or two, that the point lies on: the nearest point along the gradient"},
       [](const Value& v, Reading& r, OnSurface& o) { o.on = one_or_two_level_sets(v, r); }},
      {{"direction", "[number, number] or [number, number, number]", "the gradient", "-",
        "where to look from there, both ways; for one level set"},
       [](const Value& v, Reading& r, OnSurface& o) { o.direction = point_in_space(v, r.constants); }}};
  return keys;
}

}  // namespace

Point corner_point(const Value& value, Reading& reading)
{
  if (!std::holds_alternative<Value::Table>(value.content))
    return point(value, reading.constants);
  OnSurface data;
  read_keys(value, on_surface_keys(), reading, data);
  if (data.on.size() == 2 && data.direction)
    fail(value, "a point on two level sets has no direction");
  // How far away the point may be is for the user to judge, so that far is as large as the place itself.
  const double size = std::max(geometry::norm(data.near), 1e-3);
  const geometry::SearchLimits limits{.size = size, .farthest = 10.0 * size};
  const geometry::Found found_point = data.on.size() == 2 ? project(data.on[0], data.on[1], data.near, limits)
                                      : data.direction
                                          ? project(data.on[0], data.near, *data.direction, limits)
                                          : project_along_gradient(data.on[0], data.near, limits);
  if (!found_point.ok())
    fail(value,
         fmt::format(
             "no point of the level set '{}' was found from {}: {}; look nearer or in another direction",
             data.on[0].text(), geometry::text(data.near), geometry::text(found_point.status)));
  return found_point.x;
}

std::vector<Section> point_sections()
{
  return {
      section("NAME = { ... }", "a point on level sets, in [blocks.points] and in place", on_surface_keys())};
}

}  // namespace blockfsi::case_file
