#include "case/sections.hpp"

#include "block/names.hpp"
#include "case/edge.hpp"
#include "case/level_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace blockfsi::case_file
{

namespace
{

using block::Layout;

const Layout defaults;

const Keys<Layout>& blocks_keys()
{
  static const Keys<Layout> keys = {
      {{"order", "whole number", fmt::format("{}", defaults.order), "",
        "polynomial order of the cells, 1 to 8"},
       [](const Value& v, Reading& r, Layout& l) { l.order = integer(v, r.constants, 1, 8); }},
      {{"divide", "whole number", "none", "", "number of cells along edges for which nothing else gives one"},
       [](const Value& v, Reading& r, Layout& l)
       { l.default_divisions = integer(v, r.constants, 1, 100000); }},
      {{"grade", "list of tables", "[]", "", "cell sizes towards boundaries and regions"},
       [](const Value& v, Reading& r, Layout& l) { read_grade_towards(v, r, l.grade_towards); }}};
  return keys;
}

/// A block with the layout that its corners are looked up in.
struct Quad
{
  const Layout& layout;
  block::Block block;
};

const Keys<Quad>& quad_keys()
{
  static const Keys<Quad> keys = {
      {{"corners", "list of four names of points", "required", "", "corners, counter-clockwise"},
       [](const Value& v, Reading&, Quad& q)
       {
         if (list(v).size() != 4)
           fail(v, fmt::format("found {}, allowed are four names of points, counter-clockwise", found(v)));
         for (const Value& corner : list(v))
           q.block.points.push_back(
               placed(corner, [&] { return block::find_point(q.layout, text(corner)); }));
       }},
      {{"region", "text", "required", "", "region that the block belongs to"},
       [](const Value& v, Reading&, Quad& q) { q.block.region = text(v); }}};
  return keys;
}

const Keys<EdgeData>& edge_keys()
{
  static const Keys<EdgeData> keys = []
  {
    Keys<EdgeData> all = curve_keys();
    all.insert(all.end(), cells_keys().begin(), cells_keys().end());
    return all;
  }();
  return keys;
}

void read_lattices(const Value& value, Reading& reading, Layout& layout)
{
  for (const Field& field : table(value))
    read_lattice(field, reading, layout);
}

void read_points(const Value& value, Reading& reading, Layout& layout)
{
  for (const Field& field : table(value))
    layout.points.push_back({field.name, corner_point(field.value, reading), field.where});
}

void read_quads(const Value& value, Reading& reading, Layout& layout)
{
  for (const Field& field : table(value))
  {
    Quad quad{layout, {field.name, "", {}, field.where}};
    read_keys(field.value, quad_keys(), reading, quad);
    layout.blocks.push_back(std::move(quad.block));
  }
}

void read_edges(const Value& value, Reading& reading, Layout& layout)
{
  for (const Field& field : table(value))
  {
    EdgeData data;
    read_keys(field.value, edge_keys(), reading, data);
    require_one_curve(field.value, true);
    block::Edge edge;
    const auto [a, b] = edge_points(layout, field.where, field.value.path, field.name);
    edge.a = a;
    edge.b = b;
    edge.curve = data.curve.value_or(geometry::Segment{});
    edge.grading = data.grading;
    edge.divisions = data.divisions || !data.grading ? data.divisions : block::cell_count(*data.grading);
    edge.where = field.where;
    layout.edges.push_back(std::move(edge));
  }
}

struct Pieces
{
  Description says;
  void (*read)(const Value& value, Reading& reading, Layout& layout);
};

/// In the order in which they refer to each other, whatever the order of the file.
const std::array<Pieces, 4>& pieces()
{
  static const std::array<Pieces, 4> all = {
      {{{"lattice", "tables NAME", "", "", "drawn lattices of blocks"}, read_lattices},
       {{"points", "table NAME = [x, y]", "", "m", "single points"}, read_points},
       {{"quads", "table NAME = { ... }", "", "", "single blocks"}, read_quads},
       {{"edges", "table \"a - b\" = { ... }", "", "", "curves, cells and gradings of single edges"},
        read_edges}}};
  return all;
}

}  // namespace

void read_blocks(const Value& value, Reading& reading, Layout& layout)
{
  std::vector<std::string> known = names(blocks_keys());
  for (const Pieces& piece : pieces())
    known.push_back(piece.says.name);
  read_keys(value, blocks_keys(), reading, layout,
            [&](const Field& field)
            {
              if (std::find(known.begin(), known.end(), field.name) == known.end())
                unknown_key(field, known);
            });
  for (const Pieces& piece : pieces())
    if (const Value* part = value.find(piece.says.name))
      piece.read(*part, reading, layout);
  if (layout.blocks.empty())
    fail(value,
         "there are no blocks; draw a lattice in [blocks.lattice.NAME] or list blocks in [blocks.quads]");
}

std::vector<Section> blocks_sections()
{
  Section blocks =
      section("[blocks]", "the domain as coarse blocks; pieces that coincide are merged", blocks_keys());
  for (const Pieces& piece : pieces())
    blocks.keys.push_back(piece.says);
  std::vector<Section> result = {std::move(blocks)};
  for (Section& lattice : lattice_sections())
    result.push_back(std::move(lattice));
  result.push_back({"[blocks.points]", "", {{"NAME", "[number, number] or table", "", "m", "a point"}}});
  for (Section& point : point_sections())
    result.push_back(std::move(point));
  result.push_back(section("[blocks.quads] NAME = { ... }", "", quad_keys()));
  result.push_back(section("[blocks.edges] \"a - b\" = { ... }",
                           "at most one of circle, through, formula and level_set", edge_keys()));
  for (Section& edge : edge_sections())
    result.push_back(std::move(edge));
  return result;
}

}  // namespace blockfsi::case_file
