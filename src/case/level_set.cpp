#include "case/level_set.hpp"

#include "case/primitives.hpp"
#include "case/skeleton.hpp"
#include "core/nearest.hpp"
#include "geometry/boolean.hpp"
#include "geometry/primitive.hpp"
#include "geometry/sampled.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <optional>

namespace blockfsi::case_file
{

namespace
{

using geometry::LevelSet;
using geometry::Point;

constexpr std::array<std::string_view, 3> in_xyz = {"x", "y", "z"};

struct File
{
  std::filesystem::path path;
};

const Keys<File>& file_keys()
{
  static const Keys<File> keys = {{{"file", "text", "required", "",
                                    "samples, relative to the case: an ascii .vti image, or a text with nx "
                                    "ny nz, origin, spacing, values"},
                                   [](const Value& v, Reading&, File& f) {
                                     f.path = std::filesystem::path(v.where.file).parent_path() / text(v);
                                   }}};
  return keys;
}

using Combine = LevelSet (*)(const std::vector<LevelSet>&, double);

struct Growth
{
  Point center{};
  double factor = 1.0;
};

struct Turn
{
  Point center{};
  Point axis{0.0, 0.0, 1.0};
  double angle = 0.0;
};

/// A table of [geometry] while it is read: what it describes, then what is done to it.
struct Draft
{
  std::optional<LevelSet> shape;
  std::vector<LevelSet> parts;  ///< of a union, an intersection or a difference
  Combine combine = nullptr;
  double blend = 0.0;
  std::optional<Growth> growth;
  std::optional<Turn> turn;
  Point move{};
};

const Keys<Growth>& scale_keys()
{
  static const Keys<Growth> keys = {
      {{"center", "[number, number] or [number, number, number]", "[0, 0, 0]", "m", "the point that stays"},
       [](const Value& v, Reading& r, Growth& g) { g.center = point_in_space(v, r.constants); }},
      {{"factor", "number", "required", "-", "so many times larger"},
       [](const Value& v, Reading& r, Growth& g) { g.factor = number(v, r.constants, positive); }}};
  return keys;
}

const Keys<Turn>& rotate_keys()
{
  static const Keys<Turn> keys = {
      {{"center", "[number, number] or [number, number, number]", "[0, 0, 0]", "m", "a point of the axis"},
       [](const Value& v, Reading& r, Turn& t) { t.center = point_in_space(v, r.constants); }},
      {{"axis", "[number, number, number]", "[0, 0, 1]", "-",
        "direction of the axis, by the right-hand rule"},
       [](const Value& v, Reading& r, Turn& t) { t.axis = point_in_space(v, r.constants); }},
      {{"angle", "number", "required", "rad", "angle; 90 degrees are \"pi / 2\""},
       [](const Value& v, Reading& r, Turn& t) { t.angle = number(v, r.constants); }}};
  return keys;
}

template <Combine combine>
void read_parts(const Value& value, Reading& reading, Draft& draft)
{
  for (const Value& entry : list(value))
    draft.parts.push_back(level_set(entry, reading));
  if (draft.parts.empty())
    fail(value, "found an empty list, allowed are names of level sets or formulas in x, y, z");
  draft.combine = combine;
}

/// What a level set is: exactly one of these.
const Keys<Draft>& shape_keys()
{
  static const Keys<Draft> keys = {
      {{"level_set", "formula in x, y, z", "", "", "negative inside, 0 on the boundary, positive outside"},
       [](const Value& v, Reading& r, Draft& d) { d.shape = LevelSet(expression(v, r.constants, in_xyz)); }},
      {{"sphere", "table", "", "", "sphere, in the plane circle"},
       [](const Value& v, Reading& r, Draft& d) { d.shape = read_sphere(v, r); }},
      {{"cylinder", "table", "", "", "infinite cylinder"},
       [](const Value& v, Reading& r, Draft& d) { d.shape = read_cylinder(v, r); }},
      {{"box", "table", "", "", "box, in the plane rectangle"},
       [](const Value& v, Reading& r, Draft& d) { d.shape = read_box(v, r); }},
      {{"plane", "table", "", "", "half space, in the plane half plane"},
       [](const Value& v, Reading& r, Draft& d) { d.shape = read_plane(v, r); }},
      {{"torus", "table", "", "", "torus"},
       [](const Value& v, Reading& r, Draft& d) { d.shape = read_torus(v, r); }},
      {{"convolution", "table", "", "", "smooth tube about a skeleton of lines and arcs"},
       [](const Value& v, Reading& r, Draft& d) { d.shape = read_convolution(v, r); }},
      {{"sampled", "table", "", "", "cubic spline through samples on a regular grid"},
       [](const Value& v, Reading& r, Draft& d)
       {
         File file;
         read_keys(v, file_keys(), r, file);
         d.shape = placed(
             v, [&] { return geometry::sampled(geometry::read_samples(file.path), text(*v.find("file"))); });
       }},
      {{"union", "list of names or formulas", "", "", "the points in any of these"},
       read_parts<geometry::unite>},
      {{"intersection", "list of names or formulas", "", "", "the points in all of these"},
       read_parts<geometry::intersect>},
      {{"difference", "list of names or formulas", "", "",
        "the points in the first but in none of the others"},
       read_parts<geometry::difference>},
      {{"complement", "name or formula", "", "", "the points outside of it"},
       [](const Value& v, Reading& r, Draft& d) { d.shape = geometry::complement(level_set(v, r)); }}};
  return keys;
}

/// What is done to it, in this order.
const Keys<Draft>& change_keys()
{
  static const Keys<Draft> keys = {
      {{"blend", "number", "0", "m",
        "radius of the fillets where parts of a union, intersection or difference meet"},
       [](const Value& v, Reading& r, Draft& d) { d.blend = number(v, r.constants, not_negative); }},
      {{"scale", "table", "", "", "makes it larger"},
       [](const Value& v, Reading& r, Draft& d) { read_keys(v, scale_keys(), r, d.growth.emplace()); }},
      {{"rotate", "table", "", "", "then turns it"},
       [](const Value& v, Reading& r, Draft& d) { read_keys(v, rotate_keys(), r, d.turn.emplace()); }},
      {{"move", "[number, number] or [number, number, number]", "[0, 0, 0]", "m", "then moves it"},
       [](const Value& v, Reading& r, Draft& d) { d.move = point_in_space(v, r.constants); }}};
  return keys;
}

const Keys<Draft>& all_keys()
{
  static const Keys<Draft> keys = []
  {
    Keys<Draft> all = shape_keys();
    all.insert(all.end(), change_keys().begin(), change_keys().end());
    return all;
  }();
  return keys;
}

LevelSet read_table(const Value& value, Reading& reading)
{
  Draft draft;
  table(value);
  const auto count =
      std::count_if(shape_keys().begin(), shape_keys().end(),
                    [&](const Key<Draft>& key) { return value.find(key.says.name) != nullptr; });
  read_keys(value, all_keys(), reading, draft);
  if (count != 1)
    fail(value, fmt::format("found {} of {}, allowed is exactly one", count, listed(names(shape_keys()))));
  if (const Value* blend = value.find("blend"); blend && !draft.combine)
    fail(*blend, "only a union, an intersection or a difference has a blend");
  if (draft.combine)
    draft.shape = placed(value, [&] { return draft.combine(draft.parts, draft.blend); });
  LevelSet result = *draft.shape;
  if (const auto& growth = draft.growth)
    result = geometry::grown(result, growth->center, growth->factor);
  if (const auto& turn = draft.turn)
    result = placed(value, [&] { return geometry::rotated(result, turn->center, turn->axis, turn->angle); });
  return draft.move == Point{} ? result : geometry::translated(result, draft.move);
}

/// The level set of a name; it is read now if it stands further down in the file.
LevelSet named(const Field& field, const Value& where, Reading& reading)
{
  if (const auto known = reading.level_sets.find(field.name); known != reading.level_sets.end())
    return known->second;
  if (std::find(reading.unfinished.begin(), reading.unfinished.end(), field.name) != reading.unfinished.end())
    fail(where, fmt::format("'{}' is made of itself", field.name));
  reading.unfinished.push_back(field.name);
  const LevelSet result = read_table(field.value, reading).named(field.name);
  reading.unfinished.pop_back();
  reading.level_sets.emplace(field.name, result);
  return result;
}

bool is_word(const std::string& text)
{
  return std::all_of(text.begin(), text.end(),
                     [](unsigned char c) { return std::isalnum(c) || c == '_' || c == ' ' || c >= 0x80; });
}

}  // namespace

Point point_in_space(const Value& value, const Constants& constants)
{
  const auto* content = std::get_if<Value::List>(&value.content);
  if (!content || content->size() < 2 || content->size() > 3)
    fail(value, fmt::format("found {}, allowed is a list of two or three numbers [x, y] or [x, y, z]",
                            found(value)));
  Point result{};
  for (std::size_t c = 0; c < content->size(); ++c)
    result[c] = number((*content)[c], constants);
  return result;
}

LevelSet level_set(const Value& value, Reading& reading)
{
  const std::string& name = text(value);
  std::vector<std::string> known;
  if (reading.geometry)
    for (const Field& field : table(*reading.geometry))
    {
      if (field.name == name)
        return named(field, value, reading);
      known.push_back(field.name);
    }
  if (is_word(name) && !reading.constants.contains(name) && name != "x" && name != "y" && name != "z")
    fail(value, fmt::format("there is no level set '{}' in [geometry]{}", name,
                            known.empty() ? "" : suggestion(name, known)));
  return LevelSet(expression(value, reading.constants, in_xyz));
}

std::vector<LevelSet> one_or_two_level_sets(const Value& value, Reading& reading)
{
  const auto* entries = std::get_if<Value::List>(&value.content);
  if (!entries)
    return {level_set(value, reading)};
  if (entries->size() != 2)
    fail(value, fmt::format("found {}, allowed is a name or formula or a list of two", found(value)));
  return {level_set((*entries)[0], reading), level_set((*entries)[1], reading)};
}

void read_geometry(const Value& value, Reading& reading)
{
  reading.geometry = &value;
  for (const Field& field : table(value))
    named(field, field.value, reading);
}

std::vector<Section> geometry_sections()
{
  std::vector<Section> sections = {section(
      "[geometry.NAME]", "a level set by name: exactly one of the keys up to complement", all_keys())};
  for (const std::vector<Section>& more : {primitive_sections(), skeleton_sections()})
    sections.insert(sections.end(), more.begin(), more.end());
  sections.push_back(section("sampled = { ... }", "", file_keys()));
  sections.push_back(section("scale = { ... }", "", scale_keys()));
  sections.push_back(section("rotate = { ... }", "", rotate_keys()));
  return sections;
}

}  // namespace blockfsi::case_file
