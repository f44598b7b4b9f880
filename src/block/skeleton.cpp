#include "block/boundaries.hpp"
#include "block/connect.hpp"
#include "block/distribution.hpp"
#include "block/message.hpp"
#include "block/strips.hpp"
#include "block/topology.hpp"
#include "element/line.hpp"

#include <algorithm>
#include <cmath>

namespace blockfsi::block
{

namespace
{

/// Numbers points, edges and blocks one after the other.
void number(const Layout& layout, Skeleton& skeleton)
{
  const int order = skeleton.order;
  std::int64_t next = skeleton.point_count = static_cast<std::int64_t>(layout.points.size());
  for (PlacedEdge& edge : skeleton.edges)
  {
    edge.first = next;
    edge.count = static_cast<std::int64_t>(edge.divisions) * order - 1;
    next += edge.count;
  }
  skeleton.count = next;
  skeleton.block_first.push_back(next);
  for (const auto& sides : skeleton.block_edges)
  {
    next += skeleton.edges[sides[0]].count * skeleton.edges[sides[3]].count;
    skeleton.block_first.push_back(next);
  }
}

void place_points(const Layout& layout, Skeleton& skeleton)
{
  for (std::size_t p = 0; p < layout.points.size(); ++p)
  {
    skeleton.point_names.push_back(layout.points[p].name);
    for (int c = 0; c < skeleton.dim; ++c)
      skeleton.x[p * skeleton.dim + c] = layout.points[p].x[c];
  }
}

/// Inner nodes of an edge: Gauss-Lobatto points of each cell, affine in the graded parameter.
void place_edge(const Layout& layout, const Topology& topology, int e, const std::vector<double>& corners,
                const std::vector<double>& inner, Skeleton& skeleton)
{
  const PlacedEdge& edge = skeleton.edges[e];
  for (std::int64_t k = 0; k < edge.count; ++k)
  {
    const std::int64_t cell = (k + 1) / skeleton.order;
    const std::int64_t i = (k + 1) % skeleton.order;
    const double t = i == 0 ? corners[cell] : corners[cell] + inner[i] * (corners[cell + 1] - corners[cell]);
    const geometry::Point x = edge_point(layout, topology, e, t);
    const std::int64_t node = edge.first + k;
    skeleton.parameter[node] = t;
    std::copy_n(x.begin(), skeleton.dim, skeleton.x.begin() + node * skeleton.dim);
  }
}

void check_finite(const Layout& layout, const Skeleton& skeleton)
{
  for (const PlacedEdge& edge : skeleton.edges)
    for (std::int64_t i = edge.first * skeleton.dim; i < (edge.first + edge.count) * skeleton.dim; ++i)
      if (!std::isfinite(skeleton.x[i]))
        throw mistake(layout.blocks[edge.blocks[0]].where,
                      "the curve of the edge " + edge_text(layout, edge.a, edge.b) +
                          " has no finite value at one of its nodes; correct its formula");
}

}  // namespace

Skeleton make_skeleton(const Layout& layout)
{
  Topology topology = make_topology(layout);
  const std::vector<Strip> strips = make_strips(layout, topology);
  const std::vector<int> divisions = strip_divisions(layout, topology, strips);
  for (std::size_t s = 0; s < strips.size(); ++s)
    for (const int edge : strips[s].edges)
      topology.edges[edge].divisions = divisions[s];
  assign_boundaries(layout, topology);
  const std::vector<std::vector<double>> corners = distribute(layout, topology, strips);

  Skeleton skeleton;
  skeleton.dim = layout.dim;
  skeleton.order = layout.order;
  skeleton.edges = topology.edges;
  skeleton.block_edges = topology.block_edges;
  number(layout, skeleton);
  skeleton.x.resize(skeleton.count * skeleton.dim);
  skeleton.parameter.assign(skeleton.count, 0.0);
  place_points(layout, skeleton);
  const std::vector<double> inner = element::lobatto(layout.order);
  for (std::size_t e = 0; e < skeleton.edges.size(); ++e)
    place_edge(layout, topology, static_cast<int>(e), corners[e], inner, skeleton);
  check_finite(layout, skeleton);
  return skeleton;
}

std::vector<std::int64_t> interface_nodes(const Layout& layout, const Skeleton& skeleton,
                                          std::string_view region_a, std::string_view region_b)
{
  std::vector<std::int64_t> nodes;
  for (const PlacedEdge& edge : skeleton.edges)
  {
    if (edge.blocks.size() != 2)
      continue;
    const std::string_view first = layout.blocks[edge.blocks[0]].region;
    const std::string_view second = layout.blocks[edge.blocks[1]].region;
    if (first == second ||
        !((first == region_a && second == region_b) || (first == region_b && second == region_a)))
      continue;
    nodes.push_back(edge.a);
    nodes.push_back(edge.b);
    for (std::int64_t k = 0; k < edge.count; ++k)
      nodes.push_back(edge.first + k);
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace blockfsi::block
