#include "block/strips.hpp"

#include "block/message.hpp"

#include <fmt/format.h>

namespace blockfsi::block
{

namespace
{

/// An edge about to be crossed into a block; block -1: the strip ends.
struct Step
{
  int edge;
  bool reversed;
  int block;
};

bool runs_along(const Layout& layout, const Topology& topology, int block, int side)
{
  const int edge = topology.block_edges[block][side];
  return topology.edges[edge].a == side_ends(layout.blocks[block], side)[0];
}

int other_block(const PlacedEdge& edge, int block)
{
  for (const int candidate : edge.blocks)
    if (candidate != block)
      return candidate;
  return -1;
}

/// Through the block to its opposite edge.
Step cross(const Layout& layout, const Topology& topology, const Step& from)
{
  int side = 0;
  while (topology.block_edges[from.block][side] != from.edge)
    ++side;
  const int opposite = (side + 2) % 4;
  const int edge = topology.block_edges[from.block][opposite];
  const bool turns =
      runs_along(layout, topology, from.block, side) != runs_along(layout, topology, from.block, opposite);
  return {edge, from.reversed != turns, other_block(topology.edges[edge], from.block)};
}

/// An end of the strip that an edge belongs to, looking inwards; the edge itself if the strip is closed.
Step find_end(const Layout& layout, const Topology& topology, int start)
{
  Step step{start, false, topology.edges[start].blocks[0]};
  while (step.block >= 0)
  {
    step = cross(layout, topology, step);
    if (step.edge == start)
      return {start, false, topology.edges[start].blocks[0]};
  }
  return {step.edge, false, topology.edges[step.edge].blocks[0]};
}

Strip make_strip(const Layout& layout, const Topology& topology, int edge)
{
  const Step start = find_end(layout, topology, edge);
  Strip strip{{start.edge}, {false}, {}};
  Step step = start;
  while (step.block >= 0)
  {
    strip.blocks.push_back(step.block);
    step = cross(layout, topology, step);
    if (step.edge == start.edge)
      break;
    strip.edges.push_back(step.edge);
    strip.reversed.push_back(step.reversed);
  }
  return strip;
}

/// "'a', 'b' and 'c'": blocks first..last-1 of a strip.
std::string chain_text(const Layout& layout, const Strip& strip, std::size_t first, std::size_t last)
{
  std::string text;
  for (std::size_t k = first; k < last; ++k)
  {
    if (k > first)
      text += k + 1 == last ? " and " : ", ";
    text += fmt::format("'{}'", layout.blocks[strip.blocks[k]].name);
  }
  return (last - first == 1 ? "the block " : "the blocks ") + text;
}

const Edge* counted(const Layout& layout, const Topology& topology, int edge)
{
  const int info = topology.info[edge];
  return info >= 0 && layout.edges[info].divisions ? &layout.edges[info] : nullptr;
}

Error conflict(const Layout& layout, const Strip& strip, std::size_t first, std::size_t second, const Edge& a,
               const Edge& b)
{
  return mistake(
      b.where,
      fmt::format("the edge {} is divided into {} cells{} and the edge {} into {}{}, but they are opposite "
                  "each other across {}, so both need the same number; change one of them or give only one",
                  edge_text(layout, a.a, a.b), *a.divisions, place_text(a.where), edge_text(layout, b.a, b.b),
                  *b.divisions, place_text(b.where), chain_text(layout, strip, first, second)));
}

int divisions_of(const Layout& layout, const Topology& topology, const Strip& strip)
{
  const Edge* given = nullptr;
  std::size_t first = 0;
  for (std::size_t k = 0; k < strip.edges.size(); ++k)
  {
    const Edge* edge = counted(layout, topology, strip.edges[k]);
    if (!edge)
      continue;
    if (*edge->divisions < 1)
      throw mistake(edge->where, fmt::format("the edge {} is divided into {} cells; it needs at least 1",
                                             edge_text(layout, edge->a, edge->b), *edge->divisions));
    if (given && *given->divisions != *edge->divisions)
      throw conflict(layout, strip, first, k, *given, *edge);
    given = edge;
    first = k;
  }
  if (given)
    return *given->divisions;
  if (layout.default_divisions > 0)
    return layout.default_divisions;
  const PlacedEdge& edge = topology.edges[strip.edges[0]];
  const Block& block = layout.blocks[strip.blocks[0]];
  throw mistake(block.where,
                fmt::format("nobody says into how many cells the edge {} of the block '{}' and those "
                            "opposite to it are divided; give one of them a number or a default for all",
                            edge_text(layout, edge.a, edge.b), block.name));
}

}  // namespace

std::vector<Strip> make_strips(const Layout& layout, const Topology& topology)
{
  std::vector<Strip> strips;
  std::vector<bool> done(topology.edges.size(), false);
  for (std::size_t e = 0; e < topology.edges.size(); ++e)
  {
    if (done[e])
      continue;
    strips.push_back(make_strip(layout, topology, static_cast<int>(e)));
    for (const int edge : strips.back().edges)
      done[edge] = true;
  }
  return strips;
}

std::vector<int> strip_divisions(const Layout& layout, const Topology& topology,
                                 const std::vector<Strip>& strips)
{
  std::vector<int> divisions;
  divisions.reserve(strips.size());
  for (const Strip& strip : strips)
    divisions.push_back(divisions_of(layout, topology, strip));
  return divisions;
}

}  // namespace blockfsi::block
