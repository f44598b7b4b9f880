#include "block/strips.hpp"

#include "block/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace blockfsi::block
{

namespace
{

using element::Shape;

/// Groups of a shape's edges, each edge in one.
using Groups = std::vector<std::vector<int>>;

/// Edges that are parallel in the reference cell, all in the same direction.
const Groups& parallel_edges(Shape shape)
{
  static const Groups alone3{{0}, {1}, {2}};
  static const Groups alone6{{0}, {1}, {2}, {3}, {4}, {5}};
  static const Groups quadrilateral{{0, 2}, {1, 3}};
  static const Groups hexahedron{{0, 2, 4, 6}, {1, 3, 5, 7}, {8, 9, 10, 11}};
  static const Groups prism{{0, 3}, {1, 4}, {2, 5}, {6, 7, 8}};
  static const Groups pyramid{{0, 2}, {1, 3}, {4}, {5}, {6}, {7}};
  switch (shape)
  {
  case Shape::triangle:
    return alone3;
  case Shape::tetrahedron:
    return alone6;
  case Shape::hexahedron:
    return hexahedron;
  case Shape::prism:
    return prism;
  case Shape::pyramid:
    return pyramid;
  default:
    return quadrilateral;
  }
}

/// Edges that need the same number of cells.
const Groups& equal_edges(Shape shape)
{
  static const Groups all3{{0, 1, 2}};
  static const Groups all6{{0, 1, 2, 3, 4, 5}};
  static const Groups all8{{0, 1, 2, 3, 4, 5, 6, 7}};
  static const Groups prism{{0, 1, 2, 3, 4, 5}, {6, 7, 8}};
  switch (shape)
  {
  case Shape::triangle:
    return all3;
  case Shape::tetrahedron:
    return all6;
  case Shape::pyramid:
    return all8;
  case Shape::prism:
    return prism;
  default:
    return parallel_edges(shape);
  }
}

/// The group that an edge of a block belongs to, by the edge's number in the layout.
const std::vector<int>& group_of(const Topology& topology, const Groups& groups, int block, int edge)
{
  const std::vector<int>& edges = topology.block_edges[block];
  for (const std::vector<int>& group : groups)
    for (const int e : group)
      if (edges[e] == edge)
        return group;
  return groups.front();
}

/// Whether an edge runs as its place in the block does.
bool runs_along(const Layout& layout, const Topology& topology, int block, int e)
{
  return topology.edges[topology.block_edges[block][e]].a == edge_ends(layout.blocks[block], e)[0];
}

int place_in(const Topology& topology, int block, int edge)
{
  const std::vector<int>& edges = topology.block_edges[block];
  return static_cast<int>(std::find(edges.begin(), edges.end(), edge) - edges.begin());
}

/// A class of edges found by walking from edge to edge through blocks.
struct Walk
{
  std::vector<int> edges;
  std::vector<bool> reversed;  ///< whether the edge runs against the first one
  std::vector<int> from;       ///< place in `edges` that it was reached from, -1 for the first
  std::vector<int> block;      ///< block crossed on the way
};

using GroupsOf = const Groups& (*)(Shape);

/// Breadth first, so that the ways back are the shortest.
Walk walk(const Layout& layout, const Topology& topology, int start, GroupsOf groups_of,
          std::vector<bool>& visited)
{
  Walk walk{{start}, {false}, {-1}, {-1}};
  visited[start] = true;
  for (std::size_t at = 0; at < walk.edges.size(); ++at)
  {
    const int edge = walk.edges[at];
    for (const int block : topology.edges[edge].blocks)
    {
      const bool along = runs_along(layout, topology, block, place_in(topology, block, edge));
      for (const int e : group_of(topology, groups_of(layout.blocks[block].shape), block, edge))
      {
        const int next = topology.block_edges[block][e];
        if (visited[next])
          continue;
        visited[next] = true;
        walk.edges.push_back(next);
        walk.reversed.push_back(walk.reversed[at] != (along != runs_along(layout, topology, block, e)));
        walk.from.push_back(static_cast<int>(at));
        walk.block.push_back(block);
      }
    }
  }
  return walk;
}

/// "the blocks 'a', 'b' and 'c'": those on the shortest way between two edges of a class.
std::string chain_text(const Layout& layout, const std::vector<int>& blocks)
{
  std::string text = blocks.size() == 1 ? "the block " : "the blocks ";
  for (std::size_t k = 0; k < blocks.size(); ++k)
  {
    if (k > 0)
      text += k + 1 == blocks.size() ? " and " : ", ";
    text += fmt::format("'{}'", layout.blocks[blocks[k]].name);
  }
  return text;
}

const Edge* counted(const Layout& layout, const Topology& topology, int edge)
{
  const int info = topology.info[edge];
  return info >= 0 && layout.edges[info].divisions ? &layout.edges[info] : nullptr;
}

Error conflict(const Layout& layout, const Topology& topology, int first, int second)
{
  std::vector<bool> visited(topology.edges.size(), false);
  const Walk way = walk(layout, topology, first, equal_edges, visited);
  std::vector<int> blocks;
  auto at = static_cast<int>(std::find(way.edges.begin(), way.edges.end(), second) - way.edges.begin());
  for (; way.from[at] >= 0; at = way.from[at])
    blocks.push_back(way.block[at]);
  std::reverse(blocks.begin(), blocks.end());
  const bool opposite = std::all_of(blocks.begin(), blocks.end(),
                                    [&](int b)
                                    {
                                      const Shape shape = layout.blocks[b].shape;
                                      return shape == Shape::quadrilateral || shape == Shape::hexahedron;
                                    });
  const Edge& a = *counted(layout, topology, first);
  const Edge& b = *counted(layout, topology, second);
  return mistake(
      b.where,
      fmt::format(
          "the edge {} is divided into {} cells{} and the edge {} into {}{}, but they are {} {}, so both "
          "need the same number; change one of them or give only one",
          edge_text(layout, a.a, a.b), *a.divisions, place_text(a.where), edge_text(layout, b.a, b.b),
          *b.divisions, place_text(b.where), opposite ? "opposite each other across" : "tied by",
          chain_text(layout, blocks)));
}

int divisions_of(const Layout& layout, const Topology& topology, const std::vector<int>& edges)
{
  int given = -1;
  for (const int e : edges)
  {
    const Edge* edge = counted(layout, topology, e);
    if (!edge)
      continue;
    if (*edge->divisions < 1)
      throw mistake(edge->where, fmt::format("the edge {} is divided into {} cells; it needs at least 1",
                                             edge_text(layout, edge->a, edge->b), *edge->divisions));
    if (given >= 0 && *counted(layout, topology, given)->divisions != *edge->divisions)
      throw conflict(layout, topology, given, e);
    given = e;
  }
  if (given >= 0)
    return *counted(layout, topology, given)->divisions;
  if (layout.default_divisions > 0)
    return layout.default_divisions;
  const PlacedEdge& edge = topology.edges[edges[0]];
  const Block& block = layout.blocks[edge.blocks[0]];
  throw mistake(
      block.where,
      fmt::format("nobody says into how many cells the edge {} of the block '{}' and those that need the "
                  "same number are divided; give one of them a number or a default for all",
                  edge_text(layout, edge.a, edge.b), block.name));
}

}  // namespace

std::vector<Strip> make_strips(const Layout& layout, const Topology& topology)
{
  std::vector<Strip> strips;
  std::vector<bool> visited(topology.edges.size(), false);
  for (std::size_t e = 0; e < topology.edges.size(); ++e)
    if (!visited[e])
    {
      Walk found = walk(layout, topology, static_cast<int>(e), parallel_edges, visited);
      strips.push_back({std::move(found.edges), std::move(found.reversed)});
    }
  return strips;
}

std::vector<int> divide(const Layout& layout, const Topology& topology)
{
  std::vector<int> divisions(topology.edges.size(), 0);
  std::vector<bool> visited(topology.edges.size(), false);
  for (std::size_t e = 0; e < topology.edges.size(); ++e)
  {
    if (visited[e])
      continue;
    std::vector<int> edges = walk(layout, topology, static_cast<int>(e), equal_edges, visited).edges;
    std::sort(edges.begin(), edges.end());
    const int count = divisions_of(layout, topology, edges);
    for (const int edge : edges)
      divisions[edge] = count;
  }
  return divisions;
}

}  // namespace blockfsi::block
