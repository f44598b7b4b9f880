#include "block/boundaries.hpp"

#include "block/message.hpp"
#include "core/nearest.hpp"
#include "element/line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace blockfsi::block
{

namespace
{

/// Diagonal of the box around all points [m].
double layout_size(const Layout& layout)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 2> low{infinity, infinity};
  std::array<double, 2> high{-infinity, -infinity};
  for (const Point& point : layout.points)
    for (std::size_t c = 0; c < 2; ++c)
    {
      low[c] = std::min(low[c], point.x[c]);
      high[c] = std::max(high[c], point.x[c]);
    }
  return std::hypot(high[0] - low[0], high[1] - low[1]);
}

/// Whether all nodes of an edge fulfil a condition. A curve does not depend on the grading, which may itself
/// depend on the boundaries, so the nodes are those of equal cells.
bool lies_on(const Layout& layout, const Topology& topology, int edge, const Condition& condition,
             double tolerance)
{
  const std::vector<double> inner = element::lobatto(layout.order);
  const int n = topology.edges[edge].divisions;
  for (int cell = 0; cell < n; ++cell)
    for (const double xi : inner)
    {
      const geometry::Point x = edge_point(layout, topology, edge, (cell + xi) / n);
      if (!condition.holds(x[0], x[1], x[2], tolerance))
        return false;
    }
  return true;
}

std::vector<int> edges_by(const ByCondition& rule, const Layout& layout, const Topology& topology)
{
  const double tolerance = 1e-8 * layout_size(layout);
  std::vector<int> edges;
  for (std::size_t e = 0; e < topology.edges.size(); ++e)
    if (topology.edges[e].blocks.size() == 1 &&
        lies_on(layout, topology, static_cast<int>(e), rule.condition, tolerance))
      edges.push_back(static_cast<int>(e));
  if (edges.empty())
    throw Error(
        fmt::format("no outer edge lies on \"{}\": at least one edge must fulfil it with all its nodes",
                    rule.condition.text()));
  return edges;
}

int existing_edge(const Layout& layout, const Topology& topology, int a, int b)
{
  const int edge = find_edge(topology, a, b);
  if (edge < 0)
    throw Error(fmt::format("no block has an edge {}", edge_text(layout, a, b)));
  return edge;
}

std::vector<int> edges_by(const ByHole& rule, const Layout& layout, const Topology& topology)
{
  std::vector<int> edges;
  std::set<std::string> lattices;
  int hole_count = 0;
  for (const HoleEdge& hole : layout.hole_edges)
  {
    lattices.insert(hole.lattice);
    if (hole.lattice != rule.lattice)
      continue;
    hole_count = std::max(hole_count, hole.number);
    if (hole.number == rule.number)
      edges.push_back(existing_edge(layout, topology, hole.a, hole.b));
  }
  if (!edges.empty())
    return edges;
  if (hole_count > 0)
    throw Error(fmt::format("the lattice '{}' has no hole {}; its holes are numbered from 1 to {}",
                            rule.lattice, rule.number, hole_count));
  throw Error(
      fmt::format("no lattice '{}' with holes exists{}", rule.lattice, did_you_mean(rule.lattice, lattices)));
}

std::vector<int> edges_by(const ByEdges& rule, const Layout& layout, const Topology& topology)
{
  std::vector<int> edges;
  for (const auto& [a, b] : rule.edges)
    edges.push_back(existing_edge(layout, topology, a, b));
  if (edges.empty())
    throw Error("it lists no edges; list at least one or remove the boundary");
  return edges;
}

/// Whether an edge lies within a region.
bool is_inner(const Layout& layout, const PlacedEdge& edge)
{
  return edge.blocks.size() == 2 &&
         layout.blocks[edge.blocks[0]].region == layout.blocks[edge.blocks[1]].region;
}

void claim(const Layout& layout, PlacedEdge& edge, int boundary)
{
  if (is_inner(layout, edge))
    throw Error(fmt::format(
        "the edge {} lies inside the region '{}', between the blocks '{}' and '{}'; a boundary can "
        "only lie where a region ends",
        edge_text(layout, edge.a, edge.b), layout.blocks[edge.blocks[0]].region,
        layout.blocks[edge.blocks[0]].name, layout.blocks[edge.blocks[1]].name));
  if (edge.boundary >= 0 && edge.boundary != boundary)
    throw Error(fmt::format(
        "the edge {} belongs to the boundary '{}'{} as well; an edge can belong to one boundary only",
        edge_text(layout, edge.a, edge.b), layout.boundaries[edge.boundary].name,
        place_text(layout.boundaries[edge.boundary].where)));
  edge.boundary = boundary;
}

void assign(const Layout& layout, Topology& topology, int boundary)
{
  const Boundary& given = layout.boundaries[boundary];
  const auto edges =
      std::visit([&](const auto& rule) { return edges_by(rule, layout, topology); }, given.rule);
  for (const int edge : edges)
    claim(layout, topology.edges[edge], boundary);
}

void check_name(const Layout& layout, int boundary)
{
  const std::string& name = layout.boundaries[boundary].name;
  if (name == interface_name)
    throw Error("this name is reserved for the edges between two regions; choose another");
  for (int other = 0; other < boundary; ++other)
    if (layout.boundaries[other].name == name)
      throw Error(fmt::format("a boundary of this name exists already{}; choose another",
                              place_text(layout.boundaries[other].where)));
}

/// Nothing may be left over: a forgotten boundary would silently become a free surface.
void check_complete(const Layout& layout, const Topology& topology)
{
  const auto forgotten = [](const PlacedEdge& edge) { return edge.blocks.size() == 1 && edge.boundary < 0; };
  const auto first = std::find_if(topology.edges.begin(), topology.edges.end(), forgotten);
  if (first == topology.edges.end())
    return;
  const auto others = std::count_if(first + 1, topology.edges.end(), forgotten);
  const Block& block = layout.blocks[first->blocks[0]];
  throw mistake(
      block.where,
      fmt::format("the outer edge {} of the block '{}' belongs to no boundary{}; add it to one, or join the "
                  "blocks if there should be another beside it",
                  edge_text(layout, first->a, first->b), block.name,
                  others > 0 ? fmt::format(" (as do {} others)", others) : ""));
}

}  // namespace

void assign_boundaries(const Layout& layout, Topology& topology)
{
  for (std::size_t boundary = 0; boundary < layout.boundaries.size(); ++boundary)
  {
    try
    {
      check_name(layout, static_cast<int>(boundary));
      assign(layout, topology, static_cast<int>(boundary));
    }
    catch (const Error& error)
    {
      const Boundary& given = layout.boundaries[boundary];
      throw mistake(given.where, error.within(fmt::format("the boundary '{}'", given.name)).message());
    }
  }
  check_complete(layout, topology);
}

}  // namespace blockfsi::block
