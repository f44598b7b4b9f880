#include "case/sections.hpp"

#include "block/lattice.hpp"
#include "case/corner_point.hpp"
#include "case/edge.hpp"
#include "case/level_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

namespace blockfsi::case_file
{

namespace
{

/// A lattice on its way: what its keys fill.
struct Draft
{
  block::Lattice lattice;
  std::vector<block::GradeTowards> grade_towards;
};

std::vector<int> counts(const Value& value, const Constants& constants)
{
  std::vector<int> result;
  for (const Value& entry : list(value))
    result.push_back(integer(entry, constants, 0, most_cells));
  return result;
}

std::vector<std::optional<block::Grading>> gradings(const Value& value, Reading& reading)
{
  std::vector<std::optional<block::Grading>> result;
  for (const Value& entry : list(value))
    result.emplace_back(read_grading(entry, reading));
  return result;
}

const Keys<Draft>& divide_keys()
{
  static const Keys<Draft> keys = {
      {{"x", "list of whole numbers", "[]", "", "cells across each column, 0: not said here"},
       [](const Value& v, Reading& r, Draft& d) { d.lattice.divide_x = counts(v, r.constants); }},
      {{"y", "list of whole numbers", "[]", "", "cells across each row, top row first, 0: not said here"},
       [](const Value& v, Reading& r, Draft& d) { d.lattice.divide_y = counts(v, r.constants); }}};
  return keys;
}

/// Reads the number in "x3" or "y2".
bool read_index(std::string_view word, char letter, int& index)
{
  if (word.size() < 2 || word[0] != letter)
    return false;
  const auto [end, error] = std::from_chars(word.data() + 1, word.data() + word.size(), index);
  return error == std::errc() && end == word.data() + word.size() && index >= 0;
}

/// The indices of a point of this lattice, "x3 y2" or "NAME x3 y2".
std::array<int, 2> indices(const std::string& name, const block::Lattice& lattice, const Location& where,
                           const std::string& path)
{
  std::string rest = name;
  if (rest.starts_with(lattice.name + " "))
    rest.erase(0, lattice.name.size() + 1);
  std::istringstream stream(rest);
  std::string x;
  std::string y;
  std::string more;
  stream >> x >> y;
  std::array<int, 2> result{};
  if ((stream >> more) || !read_index(x, 'x', result[0]) || !read_index(y, 'y', result[1]))
    throw Error(where, fmt::format("{}: found \"{}\", allowed is a point of this lattice, such as \"x0 y1\"",
                                   path, name));
  if (result[0] >= static_cast<int>(lattice.x.size()) || result[1] >= static_cast<int>(lattice.y.size()))
    throw Error(where, fmt::format("{}: found \"{}\", allowed are x0 to x{} and y0 to y{}", path, name,
                                   lattice.x.size() - 1, lattice.y.size() - 1));
  return result;
}

void read_places(const Value& value, Reading& reading, Draft& draft)
{
  for (const Field& field : table(value))
  {
    const auto [i, j] = indices(field.name, draft.lattice, field.where, field.value.path);
    const auto x = corner_point(field.value, reading);
    draft.lattice.places.push_back({i, j, {x[0], x[1]}});
  }
}

/// An entry of `curve`: the edges that it speaks of and their shape.
struct CurveEntry
{
  const block::Lattice& lattice;
  EdgeData data;
  std::optional<int> hole;
  std::optional<std::array<std::array<int, 2>, 2>> edge;
};

void read_sides(const Value& value, Reading&, CurveEntry& entry)
{
  const std::optional<block::ByHole> hole = hole_named(value);
  if (!hole || hole->lattice != entry.lattice.name)
    fail(value, fmt::format("found {}, allowed is a hole of this lattice, \"hole 1 in {}\"", found(value),
                            entry.lattice.name));
  entry.hole = hole->number;
}

void read_edge(const Value& value, Reading&, CurveEntry& entry)
{
  const auto ends = edge_ends(value.where, value.path, text(value));
  entry.edge = {indices(ends[0], entry.lattice, value.where, value.path),
                indices(ends[1], entry.lattice, value.where, value.path)};
}

const Keys<CurveEntry>& curve_entry_keys()
{
  static const Keys<CurveEntry> keys = {
      {{"sides", "\"hole N in NAME\"", "", "", "all sides of a hole become arcs of the circle"}, read_sides},
      {{"edge", "\"x0 y1 - x1 y1\"", "", "", "one edge of the lattice"}, read_edge}};
  return keys;
}

void add_curve(const Value& value, const CurveEntry& entry, block::Lattice& lattice)
{
  if (entry.hole.has_value() == entry.edge.has_value())
    fail(value, "allowed is exactly one of sides and edge");
  require_one_curve(value, false);
  if (entry.edge)
  {
    lattice.curves.push_back({(*entry.edge)[0], (*entry.edge)[1], *entry.data.curve});
    return;
  }
  const auto* arc = std::get_if<geometry::Arc>(&*entry.data.curve);
  if (!arc || !entry.data.radius)
    fail(value, "the sides of a hole need circle = { center = [x, y], radius = r }");
  lattice.circles.push_back({*entry.hole, {arc->center[0], arc->center[1]}, *entry.data.radius});
}

void read_curves(const Value& value, Reading& reading, Draft& draft)
{
  std::vector<std::string> known = names(curve_entry_keys());
  for (const std::string& name : names(curve_keys()))
    known.push_back(name);
  for (const Value& item : list(value))
  {
    CurveEntry entry{draft.lattice, {}, {}, {}};
    read_keys(item, curve_entry_keys(), reading, entry,
              [&](const Field& field)
              {
                const auto key = std::find_if(curve_keys().begin(), curve_keys().end(),
                                              [&](const auto& k) { return k.says.name == field.name; });
                if (key == curve_keys().end())
                  unknown_key(field, known);
                key->read(field.value, reading, entry.data);
              });
    add_curve(item, entry, draft.lattice);
  }
}

/// Keys in the order in which they are read: places and curves refer to x and y.
const Keys<Draft>& lattice_keys()
{
  static const Keys<Draft> keys = {
      {{"x", "list of numbers", "required", "m", "coordinates between which the columns lie, ascending"},
       [](const Value& v, Reading& r, Draft& d) { d.lattice.x = numbers(v, r.constants); }},
      {{"y", "list of numbers", "required", "m", "coordinates between which the rows lie, top row first"},
       [](const Value& v, Reading& r, Draft& d) { d.lattice.y = numbers(v, r.constants); }},
      {{"draw", "list of texts", "required", "",
        "one line per row, one word per column: the region of the block, or '.' for a hole"},
       [](const Value& v, Reading&, Draft& d)
       {
         for (const Value& line : list(v))
           d.lattice.draw.push_back(text(line));
       }},
      {{"divide", "table with x and y", "{}", "", "numbers of cells"},
       [](const Value& v, Reading& r, Draft& d) { read_keys(v, divide_keys(), r, d); }},
      {{"grade", "list of tables", "[]", "", "cell sizes towards boundaries and regions"},
       [](const Value& v, Reading& r, Draft& d) { read_grade_towards(v, r, d.grade_towards); }},
      {{"grade_x", "list of gradings", "[]", "", "of the cells across each column, towards increasing x"},
       [](const Value& v, Reading& r, Draft& d) { d.lattice.grade_x = gradings(v, r); }},
      {{"grade_y", "list of gradings", "[]", "", "of the cells across each row, towards increasing y"},
       [](const Value& v, Reading& r, Draft& d) { d.lattice.grade_y = gradings(v, r); }},
      {{"place", "table \"x1 y2\" = [number, number] or table", "{}", "m",
        "points that do not sit where the lattice has them"},
       read_places},
      {{"curve", "list of tables", "[]", "", "edges that are not straight"}, read_curves}};
  return keys;
}

void require_count(const Value& lattice, const char* list_name, const char* key, std::size_t wanted,
                   const char* unit)
{
  const Value* value = lattice.find(list_name);
  if (value && key)
    value = value->find(key);
  if (value && list(*value).size() != wanted && !list(*value).empty())
    fail(*value,
         fmt::format("found {}, allowed is one entry for each of the {} {}", found(*value), wanted, unit));
}

/// The lattice checks itself; here the mistakes are found that can be pinned to a line.
void check_sizes(const Value& value, const block::Lattice& lattice)
{
  for (const char* name : {"x", "y"})
    if (list(*value.find(name)).size() < 2)
      fail(*value.find(name),
           fmt::format("found {}, allowed are at least two coordinates", found(*value.find(name))));
  const std::size_t columns = lattice.x.size() - 1;
  const std::size_t rows = lattice.y.size() - 1;
  const Value& draw = *value.find("draw");
  if (lattice.draw.size() != rows)
    fail(draw, fmt::format("found {}, allowed is one line for each of the {} rows between the {} y",
                           found(draw), rows, rows + 1));
  for (const Value& line : list(draw))
  {
    std::istringstream stream(text(line));
    std::size_t count = 0;
    for (std::string word; stream >> word;)
      ++count;
    if (count != columns)
      fail(line,
           fmt::format("found {}, allowed is one word for each of the {} columns between the {} x, not {}",
                       found(line), columns, columns + 1, count));
  }
  require_count(value, "divide", "x", columns, "columns");
  require_count(value, "divide", "y", rows, "rows");
  require_count(value, "grade_x", nullptr, columns, "columns");
  require_count(value, "grade_y", nullptr, rows, "rows");
}

}  // namespace

void read_lattice(const Field& field, Reading& reading, block::Layout& layout)
{
  Draft draft;
  draft.lattice.name = field.name;
  draft.lattice.where = field.value.where;
  for (const Field& known : table(field.value))
    if (std::none_of(lattice_keys().begin(), lattice_keys().end(),
                     [&](const Key<Draft>& key) { return key.says.name == known.name; }))
      unknown_key(known, names(lattice_keys()));
  for (const Key<Draft>& key : lattice_keys())
  {
    if (const Value* value = field.value.find(key.says.name))
      key.read(*value, reading, draft);
    else if (key.says.fallback == "required")
      missing_key(field.value, key.says);
  }
  check_sizes(field.value, draft.lattice);
  block::add(layout, draft.lattice);
  layout.grade_towards.insert(layout.grade_towards.end(), draft.grade_towards.begin(),
                              draft.grade_towards.end());
}

std::vector<Section> lattice_sections()
{
  Section entry = section("curve = [{ ... }]", "exactly one of sides and edge with one of the curves",
                          curve_entry_keys());
  for (const Key<EdgeData>& key : curve_keys())
    entry.keys.push_back(key.says);
  return {section("[blocks.lattice.NAME]", "blocks drawn as text; point (i, j) is called \"NAME xi yj\"",
                  lattice_keys()),
          section("divide = { ... }", "in lattices; also written divide.x = [...]", divide_keys()),
          std::move(entry)};
}

}  // namespace blockfsi::case_file
