#include "block/topology.hpp"

#include "block/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace blockfsi::block
{

namespace
{

using EdgeOfPoints = std::map<std::pair<int, int>, int>;

std::pair<int, int> key(int a, int b)
{
  return std::minmax(a, b);
}

void check_numbers(const Layout& layout)
{
  if (layout.dim != 2)
    throw Error(fmt::format("the layout has {} dimensions; only 2 are supported", layout.dim));
  if (layout.order < 1 || layout.order > 8)
    throw Error(fmt::format("the order of the mesh is {}; it must be 1 to 8", layout.order));
  if (layout.blocks.empty())
    throw Error("the layout has no blocks; draw a lattice or give single blocks");
}

void check_points_used(const Layout& layout)
{
  std::vector<bool> used(layout.points.size(), false);
  for (const Block& block : layout.blocks)
    for (const int point : block.points)
      used[point] = true;
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused == used.end())
    return;
  const int point = static_cast<int>(unused - used.begin());
  throw mistake(
      layout.points[point].where,
      fmt::format("the point {} is used by no block; use it or remove it", point_text(layout, point)));
}

/// Twice the signed area of the triangle at corner c: positive where the corners run counter-clockwise.
double corner_area(const Layout& layout, const Block& block, int c)
{
  const auto& at = layout.points[block.points[c]].x;
  const auto& next = layout.points[block.points[(c + 1) % 4]].x;
  const auto& before = layout.points[block.points[(c + 3) % 4]].x;
  return (next[0] - at[0]) * (before[1] - at[1]) - (next[1] - at[1]) * (before[0] - at[0]);
}

/// All four corners must turn left, else the transfinite map has a Jacobian <= 0 there.
void check_corners(const Layout& layout, const Block& block)
{
  int wrong_count = 0;
  int wrong_corner = 0;
  for (int c = 0; c < 4; ++c)
    if (!(corner_area(layout, block, c) > 0.0))
    {
      ++wrong_count;
      wrong_corner = c;
    }
  if (wrong_count == 4)
    throw mistake(block.where,
                  fmt::format("the block '{}' is inside out: its points run clockwise; list them "
                              "counter-clockwise, that is {}, {}, {}, {}",
                              block.name, point_text(layout, block.points[0]),
                              point_text(layout, block.points[3]), point_text(layout, block.points[2]),
                              point_text(layout, block.points[1])));
  if (wrong_count > 0)
    throw mistake(block.where,
                  fmt::format("the block '{}' is inside out at its corner {}: the angle there must be "
                              "between 0 and 180 degrees; move or reorder its points",
                              block.name, point_text(layout, block.points[wrong_corner])));
}

/// Two blocks at an edge lie on either side of it just if they run along it in opposite directions.
void check_neighbours(const Layout& layout, const PlacedEdge& edge)
{
  const auto forward = [&layout, &edge](int b)
  {
    const auto& p = layout.blocks[b].points;
    return std::any_of(p.begin(), p.end(),
                       [&](const int& q) { return q == edge.a && p[(&q - p.data() + 1) % 4] == edge.b; });
  };
  if (edge.blocks.size() == 2 && forward(edge.blocks[0]) == forward(edge.blocks[1]))
    throw mistake(
        layout.blocks[edge.blocks[1]].where,
        fmt::format("the blocks '{}' and '{}' lie on the same side of their common edge {}, so they overlap; "
                    "remove or reorder one of them",
                    layout.blocks[edge.blocks[0]].name, layout.blocks[edge.blocks[1]].name,
                    edge_text(layout, edge.a, edge.b)));
}

int edge_of_side(Topology& topology, EdgeOfPoints& known, std::array<int, 2> ends)
{
  const auto [entry, is_new] =
      known.try_emplace(key(ends[0], ends[1]), static_cast<int>(topology.edges.size()));
  if (is_new)
  {
    topology.edges.emplace_back();
    topology.edges.back().a = ends[0];
    topology.edges.back().b = ends[1];
  }
  return entry->second;
}

void add_block(const Layout& layout, int b, Topology& topology, EdgeOfPoints& known)
{
  std::array<int, 4> sides{};
  for (int side = 0; side < 4; ++side)
  {
    sides[side] = edge_of_side(topology, known, side_ends(layout.blocks[b], side));
    PlacedEdge& edge = topology.edges[sides[side]];
    if (edge.blocks.size() == 2)
      throw mistake(
          layout.blocks[b].where,
          fmt::format("the edge {} is shared by three blocks, '{}', '{}' and '{}'; at most two can meet at "
                      "an edge",
                      edge_text(layout, edge.a, edge.b), layout.blocks[edge.blocks[0]].name,
                      layout.blocks[edge.blocks[1]].name, layout.blocks[b].name));
    edge.blocks.push_back(b);
  }
  topology.block_edges.push_back(sides);
}

void check_curve(const Layout& layout, const Edge& edge)
{
  try
  {
    geometry::check(edge.curve, layout.points[edge.a].x, layout.points[edge.b].x);
  }
  catch (const Error& error)
  {
    throw mistake(edge.where, error.within("the edge " + edge_text(layout, edge.a, edge.b)).message());
  }
}

void add_info(const Layout& layout, int entry, const EdgeOfPoints& known, Topology& topology)
{
  const Edge& edge = layout.edges[entry];
  const auto found = known.find(key(edge.a, edge.b));
  if (found == known.end())
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
  check_curve(layout, edge);
}

}  // namespace

std::array<int, 2> side_ends(const Block& block, int side)
{
  constexpr std::array<std::array<int, 2>, 4> corners{{{0, 1}, {1, 2}, {3, 2}, {0, 3}}};
  return {block.points[corners[side][0]], block.points[corners[side][1]]};
}

int find_edge(const Topology& topology, int a, int b)
{
  for (std::size_t e = 0; e < topology.edges.size(); ++e)
    if (key(topology.edges[e].a, topology.edges[e].b) == key(a, b))
      return static_cast<int>(e);
  return -1;
}

Topology make_topology(const Layout& layout)
{
  check_numbers(layout);
  check_points_used(layout);
  for (const Block& block : layout.blocks)
    check_corners(layout, block);
  Topology topology;
  EdgeOfPoints known;
  for (std::size_t b = 0; b < layout.blocks.size(); ++b)
    add_block(layout, static_cast<int>(b), topology, known);
  for (const PlacedEdge& edge : topology.edges)
    check_neighbours(layout, edge);
  topology.info.assign(topology.edges.size(), -1);
  for (std::size_t entry = 0; entry < layout.edges.size(); ++entry)
    add_info(layout, static_cast<int>(entry), known, topology);
  return topology;
}

geometry::Point edge_point(const Layout& layout, const Topology& topology, int edge, double t)
{
  const int info = topology.info[edge];
  const geometry::Point& a = layout.points[topology.edges[edge].a].x;
  const geometry::Point& b = layout.points[topology.edges[edge].b].x;
  return geometry::evaluate(info < 0 ? geometry::Curve{} : layout.edges[info].curve, a, b, t);
}

double edge_length(const Layout& layout, const Topology& topology, int edge)
{
  const int info = topology.info[edge];
  const geometry::Point& a = layout.points[topology.edges[edge].a].x;
  const geometry::Point& b = layout.points[topology.edges[edge].b].x;
  return geometry::length(info < 0 ? geometry::Curve{} : layout.edges[info].curve, a, b);
}

}  // namespace blockfsi::block
