#include "case/edge.hpp"

#include "block/names.hpp"
#include "case/curve.hpp"
#include "case/level_set.hpp"
#include "geometry/on_level_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace blockfsi::case_file
{

namespace
{

/// An edge on level sets.
struct Surfaces
{
  std::vector<geometry::LevelSet> of;
  std::optional<geometry::Point> direction;
  bool by_length = true;
};

const Keys<Surfaces>& level_set_keys()
{
  static const Keys<Surfaces> keys = {
      {{"of", "name or formula, or list of two", "required", "",
        "level set of [geometry] or formula in x, y, z; with two, the edge lies on both"},
       [](const Value& v, Reading& r, Surfaces& s) { s.of = one_or_two_level_sets(v, r); }},
      {{"direction", "[number, number] or [number, number, number]", "gradient across the chord", "-",
        "where to look from the chord, both ways"},
       [](const Value& v, Reading& r, Surfaces& s) { s.direction = point_in_space(v, r.constants); }},
      {{"spacing", "\"length\" or \"chord\"", "length", "",
        "what the grading divides: the curve's length or the chord between its ends"},
       [](const Value& v, Reading&, Surfaces& s)
       {
         static constexpr std::array<std::string_view, 2> kinds = {"length", "chord"};
         s.by_length = choice(v, kinds) == 0;
       }}};
  return keys;
}

void read_level_set(const Value& value, Reading& reading, EdgeData& edge)
{
  Surfaces surfaces;
  if (std::holds_alternative<Value::Table>(value.content))
    read_keys(value, level_set_keys(), reading, surfaces);
  else
    surfaces.of = one_or_two_level_sets(value, reading);
  if (surfaces.of.size() == 2 && surfaces.direction)
    fail(value, "an edge on two level sets has no direction");
  geometry::OnLevelSet curve{surfaces.of[0], {}, surfaces.direction, surfaces.by_length, {}};
  if (surfaces.of.size() == 2)
    curve.second = surfaces.of[1];
  edge.curve = curve;
}

/// What a grading's table says.
struct GradingData
{
  std::optional<double> ratio;
  std::optional<double> first;
  std::optional<double> last;
  bool hyperbolic = false;
  std::vector<double> positions;
  std::vector<double> sizes;
};

std::vector<double> grading_list(const Value& value, const Constants& constants, std::size_t at_least)
{
  std::vector<double> result;
  for (const Value& entry : list(value))
    result.push_back(number(entry, constants));
  if (result.size() < at_least)
    fail(value, fmt::format("found {}, allowed are {} numbers or more", found(value), at_least));
  return result;
}

const Keys<GradingData>& grading_keys()
{
  static const Keys<GradingData> keys = {
      {{"ratio", "number", "", "-", "each cell is so many times as long as the one before"},
       [](const Value& v, Reading& r, GradingData& g) { g.ratio = number(v, r.constants, positive); }},
      {{"first", "number", "", "m", "size of the first cell"},
       [](const Value& v, Reading& r, GradingData& g) { g.first = number(v, r.constants, positive); }},
      {{"last", "number", "", "m", "size of the last cell"},
       [](const Value& v, Reading& r, GradingData& g) { g.last = number(v, r.constants, positive); }},
      {{"law", "\"geometric\" or \"tanh\"", "geometric", "",
        "how cells grow away from first or last; with both it is a hyperbolic tangent"},
       [](const Value& v, Reading&, GradingData& g)
       {
         static constexpr std::array<std::string_view, 2> laws = {"geometric", "tanh"};
         g.hyperbolic = choice(v, laws) == 1;
       }},
      {{"positions", "list of numbers", "", "-", "ends of the cells, ascending, on any scale"},
       [](const Value& v, Reading& r, GradingData& g) { g.positions = grading_list(v, r.constants, 2); }},
      {{"sizes", "list of numbers", "", "-", "sizes of the cells, relative to each other"},
       [](const Value& v, Reading& r, GradingData& g) { g.sizes = grading_list(v, r.constants, 1); }}};
  return keys;
}

block::Grading grading_of(const Value& value, const GradingData& data)
{
  const bool by_ends = data.first || data.last;
  const int kinds = (data.ratio ? 1 : 0) + (by_ends ? 1 : 0) + (data.positions.empty() ? 0 : 1) +
                    (data.sizes.empty() ? 0 : 1);
  if (kinds != 1)
    fail(value, "allowed is exactly one of ratio, positions, sizes, or one or both of first and last");
  if (value.find("law") && !by_ends)
    fail(value, "a law goes with first or last only");
  if (data.first && data.last && value.find("law") && !data.hyperbolic)
    fail(value, "cells with both a first and a last size grow by a hyperbolic tangent; leave out the law");
  if (data.ratio)
    return block::Geometric{*data.ratio};
  if (!data.positions.empty())
    return block::Positions{data.positions};
  if (!data.sizes.empty())
    return block::Sizes{data.sizes};
  if (data.first && data.last)
    return block::TwoSided{*data.first, *data.last};
  const double size = data.first ? *data.first : *data.last;
  if (data.hyperbolic)
    return block::OneSided{size, !data.first};
  return block::FirstCell{size, !data.first};
}

const Keys<block::GradeTowards>& towards_keys()
{
  static const Keys<block::GradeTowards> keys = {
      {{"towards", "text", "required", "", "names of boundaries or regions with blanks between"},
       [](const Value& v, Reading&, block::GradeTowards& g)
       {
         std::istringstream stream(text(v));
         for (std::string word; stream >> word;)
           g.names.push_back(word);
         if (g.names.empty())
           fail(v, "found no name, allowed are names of boundaries or regions with blanks between");
       }},
      {{"first", "number", "required", "m", "size of the cells that touch them"},
       [](const Value& v, Reading& r, block::GradeTowards& g)
       { g.first = number(v, r.constants, positive); }}};
  return keys;
}

std::string trimmed(std::string_view text)
{
  const auto first = text.find_first_not_of(' ');
  if (first == std::string_view::npos)
    return "";
  return std::string(text.substr(first, text.find_last_not_of(' ') - first + 1));
}

}  // namespace

const Keys<EdgeData>& curve_keys()
{
  static const Keys<EdgeData> keys = []
  {
    Keys<EdgeData> all = explicit_curve_keys();
    all.push_back({{"level_set", "name, formula, list of two or table", "", "",
                    "on a level set, or on two: found from the chord between the ends"},
                   read_level_set});
    return all;
  }();
  return keys;
}

const Keys<EdgeData>& cells_keys()
{
  static const Keys<EdgeData> keys = {
      {{"divide", "whole number", "from opposite edges", "", "number of cells"},
       [](const Value& v, Reading& r, EdgeData& e) { e.divisions = integer(v, r.constants, 1, most_cells); }},
      {{"grade", "\"uniform\", \"cosine\" or table", "uniform", "",
        "distribution of the cells from the first point to the second"},
       [](const Value& v, Reading& r, EdgeData& e) { e.grading = read_grading(v, r); }}};
  return keys;
}

void require_one_curve(const Value& value, bool optional)
{
  const auto count =
      std::count_if(curve_keys().begin(), curve_keys().end(),
                    [&](const Key<EdgeData>& key) { return value.find(key.says.name) != nullptr; });
  if (count > 1 || (count == 0 && !optional))
    fail(value, fmt::format("found {} of {}, allowed is {}one", count, listed(names(curve_keys())),
                            optional ? "at most " : ""));
}

block::Grading read_grading(const Value& value, Reading& reading)
{
  if (!std::holds_alternative<Value::Table>(value.content))
  {
    const auto* word = std::get_if<std::string>(&value.content);
    if (word && *word == "uniform")
      return block::Uniform{};
    if (word && *word == "cosine")
      return block::Cosine{};
    fail(value, fmt::format("found {}, allowed is \"uniform\", \"cosine\" or a table with {}", found(value),
                            listed(names(grading_keys()))));
  }
  GradingData data;
  read_keys(value, grading_keys(), reading, data);
  const block::Grading grading = grading_of(value, data);
  // Mistakes of lists are the same for every edge, so they are best told here.
  if (const std::optional<int> count = block::cell_count(grading))
    placed(value, [&] { return block::parameters(grading, *count, 1.0); });
  return grading;
}

void read_grade_towards(const Value& value, Reading& reading, std::vector<block::GradeTowards>& grades)
{
  for (const Value& entry : list(value))
  {
    block::GradeTowards grade;
    grade.where = entry.where;
    read_keys(entry, towards_keys(), reading, grade);
    grades.push_back(std::move(grade));
  }
}

std::array<std::string, 2> edge_ends(const Location& where, const std::string& path, std::string_view name)
{
  constexpr std::string_view dash = " - ";
  const auto position = name.find(dash);
  if (position == std::string_view::npos || name.find(dash, position + 1) != std::string_view::npos)
    throw Error(where, fmt::format("{}: found \"{}\", allowed are two points with a dash between, \"a - b\"",
                                   path, name));
  return {trimmed(name.substr(0, position)), trimmed(name.substr(position + dash.size()))};
}

std::array<int, 2> edge_points(const block::Layout& layout, const Location& where, const std::string& path,
                               std::string_view name)
{
  const auto [a, b] = edge_ends(where, path, name);
  try
  {
    return {block::find_point(layout, a), block::find_point(layout, b)};
  }
  catch (const Error& error)
  {
    throw error.within(path).at(where);
  }
}

std::vector<Section> edge_sections()
{
  std::vector<Section> result = explicit_curve_sections();
  for (Section& other : std::vector<Section>{
           section("level_set = { ... }", "of edges", level_set_keys()),
           section("grade = { ... }",
                   "exactly one of ratio, positions, sizes, or one or both of first and last",
                   grading_keys()),
           section("grade = [{ ... }]", "in [blocks] and in lattices", towards_keys())})
    result.push_back(std::move(other));
  return result;
}

}  // namespace blockfsi::case_file
