#include "case/edge.hpp"

#include "block/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace blockfsi::case_file
{

namespace
{

struct Circle
{
  geometry::Point center{};
  std::optional<double> radius;
};

const Keys<Circle>& circle_keys()
{
  static const Keys<Circle> keys = {
      {{"center", "[number, number]", "required", "m", "centre of the circle"},
       [](const Value& v, Reading& r, Circle& c) { c.center = point(v, r.constants); }},
      {{"radius", "number", "from the ends", "m", "needed for the sides of a hole, whose points it moves"},
       [](const Value& v, Reading& r, Circle& c) { c.radius = number(v, r.constants, positive); }}};
  return keys;
}

void read_circle(const Value& value, Reading& reading, EdgeData& edge)
{
  Circle circle;
  read_keys(value, circle_keys(), reading, circle);
  edge.curve = geometry::Arc{circle.center};
  edge.radius = circle.radius;
}

void read_through(const Value& value, Reading& reading, EdgeData& edge)
{
  geometry::Through through;
  for (const Value& entry : list(value))
    through.points.push_back(point(entry, reading.constants));
  if (through.points.empty())
    fail(value, "found an empty list, allowed are points [x, y] between the ends");
  edge.curve = through;
}

/// Undefined values would only show as a broken mesh later.
void check_formula(const Value& value, const Expression& formula)
{
  constexpr int samples = 32;
  for (int i = 0; i <= samples; ++i)
  {
    const double t = static_cast<double>(i) / samples;
    const double result = formula(0.0, 0.0, 0.0, t);
    if (!std::isfinite(result))
      fail(value, fmt::format("\"{}\" is {} at t = {}; it must be finite from t = 0 to 1", formula.text(),
                              number_text(result), t));
  }
}

void read_formula(const Value& value, Reading& reading, EdgeData& edge)
{
  const geometry::Formula formula{vector(value, reading.constants, along_curve)};
  for (std::size_t i = 0; i < 2; ++i)
    check_formula(list(value)[i], formula.x[i]);
  edge.curve = formula;
}

struct Sizes
{
  std::optional<double> ratio;
  std::optional<double> first;
  std::optional<double> last;
};

const Keys<Sizes>& sizes_keys()
{
  static const Keys<Sizes> keys = {
      {{"ratio", "number", "", "-",
        "each cell is so many times as long as the one before; excludes first and last"},
       [](const Value& v, Reading& r, Sizes& s) { s.ratio = number(v, r.constants, positive); }},
      {{"first", "number", "", "m", "size of the first cell"},
       [](const Value& v, Reading& r, Sizes& s) { s.first = number(v, r.constants, positive); }},
      {{"last", "number", "", "m", "size of the last cell"},
       [](const Value& v, Reading& r, Sizes& s) { s.last = number(v, r.constants, positive); }}};
  return keys;
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
  static const Keys<EdgeData> keys = {
      {{"circle", "table", "", "", "the shorter arc between the ends about a centre"}, read_circle},
      {{"through", "list of [number, number]", "", "m",
        "Lagrange's curve through these points between the ends"},
       read_through},
      {{"formula", "[formula, formula] in t", "", "m", "x and y for t from 0 at the start to 1 at the end"},
       read_formula}};
  return keys;
}

const Keys<EdgeData>& cells_keys()
{
  static const Keys<EdgeData> keys = {
      {{"divide", "whole number", "from opposite edges", "", "number of cells"},
       [](const Value& v, Reading& r, EdgeData& e) { e.divisions = integer(v, r.constants, 1, 100000); }},
      {{"grade", "\"uniform\" or table", "uniform", "",
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
    if (const auto* word = std::get_if<std::string>(&value.content); !word || *word != "uniform")
      fail(value, fmt::format("found {}, allowed is \"uniform\" or a table with {}", found(value),
                              listed(names(sizes_keys()))));
    return block::Uniform{};
  }
  Sizes sizes;
  read_keys(value, sizes_keys(), reading, sizes);
  if (sizes.ratio && !sizes.first && !sizes.last)
    return block::Geometric{*sizes.ratio};
  if (sizes.ratio || (!sizes.first && !sizes.last))
    fail(value, "allowed is either ratio or one or both of first and last");
  if (sizes.first && sizes.last)
    return block::TwoSided{*sizes.first, *sizes.last};
  return block::FirstCell{sizes.first ? *sizes.first : *sizes.last, !sizes.first};
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
  return {section("circle = { ... }", "", circle_keys()),
          section("grade = { ... }", "either ratio or one or both of first and last", sizes_keys()),
          section("grade = [{ ... }]", "in [blocks] and in lattices", towards_keys())};
}

}  // namespace blockfsi::case_file
