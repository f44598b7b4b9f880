#include "case/sections.hpp"

#include "case/edge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace blockfsi::case_file
{

namespace
{

/// A boundary by edges with the layout that their points are looked up in.
struct EdgeList
{
  const block::Layout& layout;
  block::ByEdges rule;
};

const Keys<EdgeList>& boundary_keys()
{
  static const Keys<EdgeList> keys = {
      {{"edges", "list of \"a - b\"", "required", "", "edges between two points each"},
       [](const Value& v, Reading&, EdgeList& e)
       {
         for (const Value& entry : list(v))
           e.rule.edges.push_back(edge_points(e.layout, entry.where, entry.path, text(entry)));
       }}};
  return keys;
}

/// A boundary named like a key could not get a condition.
void check_name(const Field& field)
{
  for (const auto& sections : {fluid_sections(), solid_sections()})
    for (const Description& key : sections.front().keys)
      if (key.name == field.name)
        throw Error(field.where,
                    fmt::format("{}: this is the name of a key in {}; choose another for the boundary",
                                field.value.path, sections.front().title));
}

}  // namespace

std::optional<block::ByHole> hole_named(const Value& value)
{
  std::istringstream stream(text(value));
  std::string hole;
  std::string in;
  block::ByHole result;
  std::string more;
  if (!(stream >> hole) || hole != "hole")
    return std::nullopt;
  if (!(stream >> result.number >> in >> result.lattice) || in != "in" || (stream >> more))
    fail(value, fmt::format("found {}, allowed is \"hole N in LATTICE\"", found(value)));
  return result;
}

void read_boundaries(const Value& value, Reading& reading, block::Layout& layout)
{
  for (const Field& field : table(value))
  {
    check_name(field);
    block::Boundary boundary{field.name, block::ByEdges{}, field.where};
    if (std::holds_alternative<Value::Table>(field.value.content))
    {
      EdgeList edges{layout, {}};
      read_keys(field.value, boundary_keys(), reading, edges);
      boundary.rule = edges.rule;
    }
    else if (!std::holds_alternative<std::string>(field.value.content))
      fail(field.value,
           fmt::format("found {}, allowed is a condition such as \"x = 0\", \"hole 1 in LATTICE\" or "
                       "{{ edges = [\"a - b\"] }}",
                       found(field.value)));
    else if (const auto hole = hole_named(field.value))
      boundary.rule = *hole;
    else
      boundary.rule = block::ByCondition{condition(field.value, reading.constants)};
    layout.boundaries.push_back(std::move(boundary));
    reading.boundaries.push_back(field.name);
  }
}

std::vector<Section> boundaries_sections()
{
  return {
      {"[boundaries]",
       "every outer edge belongs to one of them",
       {{"NAME", "condition in x, y; \"hole N in LATTICE\"; or table", "", "m",
         "edges that fulfil a condition such as \"y = 0 or y = 0.41\", lie around a hole or are listed"}}},
      section("[boundaries] NAME = { ... }", "", boundary_keys())};
}

}  // namespace blockfsi::case_file
