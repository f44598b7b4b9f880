#include "block/tubes.hpp"

#include "case/edge.hpp"
#include "case/level_set.hpp"
#include "case/pieces.hpp"
#include "core/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace blockfsi::case_file
{

namespace
{

/// Tubes on their way from the file.
struct Draft
{
  block::Tubes tubes;
  const Value* segments = nullptr;  ///< read last, as they name nodes
};

void read_nodes(const Value& value, Reading& reading, Draft& draft)
{
  for (const Field& field : table(value))
    draft.tubes.nodes.push_back({field.name, point_in_space(field.value, reading.constants)});
}

int node_named(const Value& value, const Draft& draft)
{
  const std::string& name = text(value);
  const auto& nodes = draft.tubes.nodes;
  const auto found_node = std::find_if(nodes.begin(), nodes.end(),
                                       [&](const block::Tubes::Node& node) { return node.name == name; });
  if (found_node != nodes.end())
    return static_cast<int>(found_node - nodes.begin());
  std::vector<std::string> known;
  for (const block::Tubes::Node& node : nodes)
    known.push_back(node.name);
  fail(value,
       fmt::format("found \"{}\", allowed is a node: {}{}", name, listed(known), did_you_mean(name, known)));
}

/// A segment ["a", "b"] or ["a", "b", sections...].
void read_segments(const Value& value, Reading& reading, Draft& draft)
{
  for (const Value& entry : list(value))
  {
    if (list(entry).size() < 2)
      fail(entry,
           fmt::format("found {}, allowed are two nodes and places of sections between, [\"a\", \"b\", 0.5]",
                       found(entry)));
    block::Tubes::Segment segment{node_named(list(entry)[0], draft), node_named(list(entry)[1], draft), {}};
    for (std::size_t i = 2; i < list(entry).size(); ++i)
      segment.sections.push_back(number(list(entry)[i], reading.constants,
                                        {.low = 0,
                                         .high = 1,
                                         .low_allowed = false,
                                         .high_allowed = false,
                                         .words = "a number between 0 and 1"}));
    draft.tubes.segments.push_back(std::move(segment));
  }
}

const Keys<Draft>& tubes_keys()
{
  static const Keys<Draft> keys = {
      {{"region", "text", "required", "", "region that the blocks belong to"},
       [](const Value& v, Reading&, Draft& d) { d.tubes.region = text(v); }},
      {{"nodes", "table NAME = [x, y, z]", "required", "m", "joints, bends and ends, inside the tubes"},
       read_nodes},
      {{"segments", "list of [\"a\", \"b\", ...]", "required", "",
        "tubes from node to node, up to three at a node; numbers between 0 and 1 add sections"},
       [](const Value& v, Reading&, Draft& d) { d.segments = &v; }},
      {{"wall", "level set", "required", "", "where the wall lies: negative inside"},
       [](const Value& v, Reading& r, Draft& d) { d.tubes.wall = level_set(v, r); }},
      {{"reach", "number", "required", "m", "the wall is looked for so far from the nodes"},
       [](const Value& v, Reading& r, Draft& d) { d.tubes.reach = number(v, r.constants, positive); }},
      {{"core", "number", "0.5", "-", "size of the square in the middle of the sections over the radius"},
       [](const Value& v, Reading& r, Draft& d)
       {
         d.tubes.core = number(v, r.constants,
                               {.low = 0,
                                .high = 0.85,
                                .low_allowed = false,
                                .high_allowed = false,
                                .words = "a number between 0 and 0.85"});
       }},
      {{"around", "whole number", "2", "", "cells along each eighth of a section"},
       [](const Value& v, Reading& r, Draft& d) { d.tubes.around = integer(v, r.constants, 1, most_cells); }},
      {{"radial", "whole number", "4", "", "cells between the square and the wall"},
       [](const Value& v, Reading& r, Draft& d) { d.tubes.radial = integer(v, r.constants, 1, most_cells); }},
      {{"grade", "grading", "uniform", "", "of these cells, towards the wall"},
       [](const Value& v, Reading& r, Draft& d) { d.tubes.radial_grading = read_grading(v, r); }},
      {{"axial", "number", "required", "m", "length of the cells along the tubes, about"},
       [](const Value& v, Reading& r, Draft& d) { d.tubes.axial_size = number(v, r.constants, positive); }}};
  return keys;
}

void read_tubes(const Field& field, Reading& reading, Pieces&, block::Layout& layout)
{
  Draft draft;
  draft.tubes.name = field.name;
  draft.tubes.where = field.where;
  read_keys(field.value, tubes_keys(), reading, draft);
  read_segments(*draft.segments, reading, draft);
  block::add(layout, draft.tubes);
}

}  // namespace

std::span<const PieceKind> tube_kinds()
{
  static const std::array<PieceKind, 1> kinds = {
      {{{"tubes", "tables NAME", "", "", "networks of tubes, such as vessels"},
        read_tubes,
        []
        {
          return std::vector<Section>{
              section("[blocks.tubes.NAME]",
                      "sections are O-grids of twelve blocks; boundaries \"NAME wall\" and the "
                      "names of the end nodes",
                      tubes_keys())};
        }}}};
  return kinds;
}

}  // namespace blockfsi::case_file
