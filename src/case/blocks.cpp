#include "case/sections.hpp"

#include "block/names.hpp"
#include "case/corner_point.hpp"
#include "case/edge.hpp"
#include "case/face.hpp"
#include "case/level_set.hpp"
#include "case/pieces.hpp"

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
      {{"dim", "2 or 3", fmt::format("{}", defaults.dim), "",
        "dimensions; only blocks of two can be simulated"},
       [](const Value& v, Reading& r, Layout& l) { l.dim = integer(v, r.constants, 2, 3); }},
      {{"order", "whole number", fmt::format("{}", defaults.order), "",
        "polynomial order of the cells, 1 to 8"},
       [](const Value& v, Reading& r, Layout& l) { l.order = integer(v, r.constants, 1, 8); }},
      {{"divide", "whole number", "none", "", "number of cells along edges for which nothing else gives one"},
       [](const Value& v, Reading& r, Layout& l)
       { l.default_divisions = integer(v, r.constants, 1, most_cells); }},
      {{"grade", "list of tables", "[]", "", "cell sizes towards boundaries and regions"},
       [](const Value& v, Reading& r, Layout& l) { read_grade_towards(v, r, l.grade_towards); }}};
  return keys;
}

/// A single block with the layout that its corners are looked up in.
struct Single
{
  const Layout& layout;
  block::Block block;
};

/// How the corners of a shape are counted, in words for messages.
std::string_view corners_text(element::Shape shape)
{
  switch (shape)
  {
  case element::Shape::triangle:
    return "three names of points, counter-clockwise";
  case element::Shape::tetrahedron:
    return "four names of points, three counter-clockwise seen from the fourth, then that";
  case element::Shape::hexahedron:
    return "eight names of points, four counter-clockwise seen from the other four, then those in the same "
           "order";
  case element::Shape::prism:
    return "six names of points, three counter-clockwise seen from the other three, then those in the same "
           "order";
  case element::Shape::pyramid:
    return "five names of points, four counter-clockwise seen from the fifth, then that";
  default:
    return "four names of points, counter-clockwise";
  }
}

const Keys<Single>& single_keys()
{
  static const Keys<Single> keys = {
      {{"corners", "list of names of points", "required", "",
        "corners, counter-clockwise; in 3D those of the bottom seen from above, then those of the top"},
       [](const Value& v, Reading&, Single& s)
       {
         if (static_cast<int>(list(v).size()) != element::corner_count(s.block.shape))
           fail(v, fmt::format("found {}, allowed are {}", found(v), corners_text(s.block.shape)));
         for (const Value& corner : list(v))
           s.block.points.push_back(
               placed(corner, [&] { return block::find_point(s.layout, text(corner)); }));
       }},
      {{"region", "text", "required", "", "region that the block belongs to"},
       [](const Value& v, Reading&, Single& s) { s.block.region = text(v); }}};
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

void read_points(const Value& value, Reading& reading, Layout& layout)
{
  for (const Field& field : table(value))
  {
    const bool listed_in_space = layout.dim == 3 && std::holds_alternative<Value::List>(field.value.content);
    layout.points.push_back({field.name,
                             listed_in_space ? point_in_space(field.value, reading.constants)
                                             : corner_point(field.value, reading),
                             field.where});
  }
}

template <element::Shape shape>
void read_single(const Value& value, Reading& reading, Layout& layout)
{
  for (const Field& field : table(value))
  {
    if (element::dimension(shape) != layout.dim)
      throw Error(field.where,
                  fmt::format("{}: found a {}, but the blocks have {} dimensions; say dim = {} in [blocks]",
                              field.value.path, element::name(shape), layout.dim, element::dimension(shape)));
    Single single{layout, {field.name, "", {}, field.where, shape}};
    read_keys(field.value, single_keys(), reading, single);
    layout.blocks.push_back(std::move(single.block));
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

/// Single points, blocks, edges and faces, which may name what pieces bring.
struct Singles
{
  Description says;
  void (*read)(const Value& value, Reading& reading, Layout& layout);
};

/// In the order in which they refer to each other, whatever the order of the file.
const std::array<Singles, 9>& singles()
{
  using element::Shape;
  static const std::array<Singles, 9> all = {
      {{{"points", "table NAME = [x, y]", "", "m", "single points"}, read_points},
       {{"quads", "table NAME = { ... }", "", "", "single quadrilaterals"},
        read_single<Shape::quadrilateral>},
       {{"triangles", "table NAME = { ... }", "", "", "single triangles"}, read_single<Shape::triangle>},
       {{"hexes", "table NAME = { ... }", "", "", "single hexahedra"}, read_single<Shape::hexahedron>},
       {{"tets", "table NAME = { ... }", "", "", "single tetrahedra"}, read_single<Shape::tetrahedron>},
       {{"prisms", "table NAME = { ... }", "", "", "single prisms"}, read_single<Shape::prism>},
       {{"pyramids", "table NAME = { ... }", "", "", "single pyramids"}, read_single<Shape::pyramid>},
       {{"edges", "table \"a - b\" = { ... }", "", "", "curves, cells and gradings of single edges"},
        read_edges},
       {{"faces", "table \"a - b - c - d\" = { ... }", "", "", "surfaces of single faces, in 3D"},
        read_faces}}};
  return all;
}

}  // namespace

void read_blocks(const Value& value, Reading& reading, Layout& layout)
{
  std::vector<std::string> known = names(blocks_keys());
  for (const PieceKind& kind : all_kinds())
    known.push_back(kind.says.name);
  for (const Singles& single : singles())
    known.push_back(single.says.name);
  read_keys(value, blocks_keys(), reading, layout,
            [&](const Field& field)
            {
              if (std::find(known.begin(), known.end(), field.name) == known.end())
                unknown_key(field, known);
            });
  Layout empty;
  empty.dim = layout.dim;
  empty.order = layout.order;
  empty.default_divisions = layout.default_divisions;
  Pieces(value, reading, std::move(empty)).append_to(layout);
  for (const Singles& single : singles())
    if (const Value* part = value.find(single.says.name))
      single.read(*part, reading, layout);
  for (const block::Boundary& boundary : layout.boundaries)
    reading.boundaries.push_back(boundary.name);
  if (layout.blocks.empty())
    fail(value,
         "there are no blocks; draw a lattice in [blocks.lattice.NAME] or list blocks in [blocks.quads]");
}

std::vector<Section> blocks_sections()
{
  Section blocks =
      section("[blocks]", "the domain as coarse blocks; pieces that coincide are merged", blocks_keys());
  for (const PieceKind& kind : all_kinds())
    blocks.keys.push_back(kind.says);
  for (const Singles& single : singles())
    blocks.keys.push_back(single.says);
  std::vector<Section> result = {std::move(blocks)};
  for (const PieceKind& kind : all_kinds())
    for (Section& sections : kind.sections())
      result.push_back(std::move(sections));
  result.push_back({"[blocks.points]", "", {{"NAME", "[number, number] or table", "", "m", "a point"}}});
  for (Section& point : point_sections())
    result.push_back(std::move(point));
  result.push_back(section("[blocks.quads] NAME = { ... }",
                           "the same in [blocks.triangles], hexes, tets, prisms and pyramids",
                           single_keys()));
  result.push_back(section("[blocks.edges] \"a - b\" = { ... }", "at most one curve", edge_keys()));
  for (Section& edge : edge_sections())
    result.push_back(std::move(edge));
  for (Section& face : face_sections())
    result.push_back(std::move(face));
  return result;
}

}  // namespace blockfsi::case_file
