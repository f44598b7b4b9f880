#include "block/topology.hpp"

#include "block/check.hpp"
#include "block/intersections.hpp"
#include "block/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <variant>

namespace blockfsi::block
{

namespace
{

using EdgeOfPoints = std::map<std::pair<int, int>, int>;
using FaceOfPoints = std::map<std::vector<int>, int>;

/// Edges and faces by their points.
struct Known
{
  EdgeOfPoints edges;
  FaceOfPoints faces;
};

std::pair<int, int> key(int a, int b)
{
  return std::minmax(a, b);
}

std::vector<int> key(std::span<const int> points)
{
  std::vector<int> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

/// Two blocks at a side lie on either side of it just if their sides' outward cycles run against each other.
bool runs_along(const Layout& layout, const Topology& topology, int b, int side)
{
  const Block& block = layout.blocks[b];
  const element::SideShape& of = element::sides(block.shape)[side];
  const std::vector<int> points = side_points(topology, topology.block_sides[b][side]);
  const auto first = std::find(points.begin(), points.end(), block.points[of.corners[0]]) - points.begin();
  const bool same = points[(first + 1) % points.size()] == block.points[of.corners[1]];
  if (topology.dim == 2)
    return (first == 0) == of.outward;
  return same == of.outward;
}

void check_neighbours(const Layout& layout, const Topology& topology, int side)
{
  const std::vector<int>& blocks = side_blocks(topology, side);
  if (blocks.size() != 2)
    return;
  std::array<bool, 2> along{};
  for (std::size_t i = 0; i < 2; ++i)
  {
    const std::vector<int>& sides = topology.block_sides[blocks[i]];
    const auto at = std::find(sides.begin(), sides.end(), side) - sides.begin();
    along[i] = runs_along(layout, topology, blocks[i], static_cast<int>(at));
  }
  if (along[0] == along[1])
    throw mistake(layout.blocks[blocks[1]].where,
                  fmt::format("the blocks '{}' and '{}' lie on the same side of their common {}, so they "
                              "overlap; remove or reorder one of them",
                              layout.blocks[blocks[0]].name, layout.blocks[blocks[1]].name,
                              side_text(layout, side_points(topology, side))));
}

/// Enters a block at a side of it.
void claim_side(const Layout& layout, int b, const std::vector<int>& points, std::vector<int>& blocks)
{
  if (std::find(blocks.begin(), blocks.end(), b) != blocks.end())
    throw mistake(layout.blocks[b].where, fmt::format("two sides of the block '{}' are the same {}",
                                                      layout.blocks[b].name, side_text(layout, points)));
  if (blocks.size() == 2)
    throw mistake(
        layout.blocks[b].where,
        fmt::format("the {} is shared by three blocks, '{}', '{}' and '{}'; at most two can meet at {}",
                    side_text(layout, points), layout.blocks[blocks[0]].name, layout.blocks[blocks[1]].name,
                    layout.blocks[b].name, points.size() == 2 ? "an edge" : "a face"));
  blocks.push_back(b);
}

int enter_edge(Topology& topology, Known& known, std::array<int, 2> ends)
{
  const auto [entry, is_new] =
      known.edges.try_emplace(key(ends[0], ends[1]), static_cast<int>(topology.edges.size()));
  if (is_new)
  {
    topology.edges.emplace_back();
    topology.edges.back().a = ends[0];
    topology.edges.back().b = ends[1];
  }
  return entry->second;
}

int enter_face(Topology& topology, Known& known, element::Shape shape, const std::vector<int>& points)
{
  const auto [entry, is_new] = known.faces.try_emplace(key(points), static_cast<int>(topology.faces.size()));
  if (is_new)
  {
    PlacedFace& face = topology.faces.emplace_back();
    face.shape = shape;
    std::copy(points.begin(), points.end(), face.points.begin());
    const auto edges = element::edges(shape);
    for (std::size_t e = 0; e < edges.size(); ++e)
      face.edges[e] = known.edges.at(key(points[edges[e][0]], points[edges[e][1]]));
  }
  return entry->second;
}

void add_edges(const Layout& layout, int b, Topology& topology, Known& known)
{
  const Block& block = layout.blocks[b];
  std::vector<int> edges;
  for (std::size_t e = 0; e < element::edges(block.shape).size(); ++e)
  {
    const std::array<int, 2> ends = edge_ends(block, static_cast<int>(e));
    edges.push_back(enter_edge(topology, known, ends));
    std::vector<int>& blocks = topology.edges[edges.back()].blocks;
    if (topology.dim == 2)
      claim_side(layout, b, {ends[0], ends[1]}, blocks);
    else
      blocks.push_back(b);
  }
  topology.block_edges.push_back(edges);
}

void add_sides(const Layout& layout, int b, Topology& topology, Known& known)
{
  if (topology.dim == 2)
  {
    topology.block_sides.push_back(topology.block_edges.back());
    return;
  }
  const Block& block = layout.blocks[b];
  std::vector<int> faces;
  for (const element::SideShape& side : element::sides(block.shape))
  {
    std::vector<int> points;
    for (int c = 0; c < element::corner_count(side.shape); ++c)
      points.push_back(block.points[side.corners[c]]);
    faces.push_back(enter_face(topology, known, side.shape, points));
    claim_side(layout, b, points, topology.faces[faces.back()].blocks);
  }
  topology.block_sides.push_back(faces);
}

void add_edge_info(const Layout& layout, int entry, const Known& known, Topology& topology)
{
  const Edge& edge = layout.edges[entry];
  const auto found = known.edges.find(key(edge.a, edge.b));
  if (found == known.edges.end())
    throw mistake(edge.where, fmt::format("no block has an edge {}; correct the points or remove the entry",
                                          edge_text(layout, edge.a, edge.b)));
  int& info = topology.info[found->second];
  if (info >= 0)
    throw mistake(edge.where,
                  fmt::format("the edge {} is described twice, here and before{}; describe it once",
                              edge_text(layout, edge.a, edge.b), place_text(layout.edges[info].where)));
  info = entry;
  topology.edges[found->second].a = edge.a;
  topology.edges[found->second].b = edge.b;
}

void add_face_info(const Layout& layout, int entry, const Known& known, Topology& topology)
{
  const Face& face = layout.faces[entry];
  const auto found = known.faces.find(key(face.points));
  if (found == known.faces.end())
    throw mistake(face.where, fmt::format("no block has a {}; correct the points or remove the entry",
                                          side_text(layout, face.points)));
  int& info = topology.face_info[found->second];
  if (info >= 0)
    throw mistake(face.where,
                  fmt::format("the {} is described twice, here and before{}; describe it once",
                              side_text(layout, face.points), place_text(layout.faces[info].where)));
  info = entry;
}

}  // namespace

std::array<int, 2> edge_ends(const Block& block, int edge)
{
  const auto& ends = element::edges(block.shape)[edge];
  return {block.points[ends[0]], block.points[ends[1]]};
}

int find_edge(std::span<const PlacedEdge> edges, int a, int b)
{
  const auto found = std::find_if(edges.begin(), edges.end(),
                                  [&](const PlacedEdge& edge) { return key(edge.a, edge.b) == key(a, b); });
  return found == edges.end() ? -1 : static_cast<int>(found - edges.begin());
}

int find_face(std::span<const PlacedFace> faces, std::span<const int> points)
{
  const auto found =
      std::find_if(faces.begin(), faces.end(),
                   [&](const PlacedFace& face)
                   {
                     const std::span corners(face.points.data(), element::corner_count(face.shape));
                     return std::is_permutation(points.begin(), points.end(), corners.begin(), corners.end());
                   });
  return found == faces.end() ? -1 : static_cast<int>(found - faces.begin());
}

Topology make_topology(const Layout& layout)
{
  check_layout(layout);
  Topology topology;
  topology.dim = layout.dim;
  Known known;
  for (std::size_t b = 0; b < layout.blocks.size(); ++b)
  {
    add_edges(layout, static_cast<int>(b), topology, known);
    add_sides(layout, static_cast<int>(b), topology, known);
  }
  for (int side = 0; side < side_count(topology); ++side)
    check_neighbours(layout, topology, side);
  topology.info.assign(topology.edges.size(), -1);
  for (std::size_t entry = 0; entry < layout.edges.size(); ++entry)
    add_edge_info(layout, static_cast<int>(entry), known, topology);
  topology.face_info.assign(topology.faces.size(), -1);
  for (std::size_t entry = 0; entry < layout.faces.size(); ++entry)
    add_face_info(layout, static_cast<int>(entry), known, topology);
  check_intersections(layout, topology);
  return topology;
}

geometry::Path edge_path(const Layout& layout, const Topology& topology, int edge)
{
  static const geometry::Curve straight = geometry::Segment{};
  const int info = topology.info[edge];
  return {info < 0 ? straight : layout.edges[info].curve, layout.points[topology.edges[edge].a].x,
          layout.points[topology.edges[edge].b].x};
}

bool is_straight(const Layout& layout, const Topology& topology, int edge)
{
  const int info = topology.info[edge];
  return info < 0 || std::holds_alternative<geometry::Segment>(layout.edges[info].curve);
}

double edge_length(const Layout& layout, const Topology& topology, int edge)
{
  return edge_path(layout, topology, edge).length();
}

double layout_size(const Layout& layout)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{infinity, infinity, infinity};
  std::array<double, 3> high{-infinity, -infinity, -infinity};
  for (const Point& point : layout.points)
    for (std::size_t c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], point.x[c]);
      high[c] = std::max(high[c], point.x[c]);
    }
  return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

}  // namespace blockfsi::block
