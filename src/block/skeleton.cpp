#include "block/blend.hpp"
#include "block/boundaries.hpp"
#include "block/connect.hpp"
#include "block/distribution.hpp"
#include "block/face_plan.hpp"
#include "block/face_shape.hpp"
#include "block/message.hpp"
#include "block/numbering.hpp"
#include "block/overlaps.hpp"
#include "block/reference.hpp"
#include "block/strips.hpp"
#include "block/topology.hpp"
#include "element/line.hpp"

#include <algorithm>
#include <cmath>

namespace blockfsi::block
{

namespace
{

/// Numbers points, edges, faces and blocks one after the other.
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
  for (PlacedFace& face : skeleton.faces)
  {
    const int last = element::corner_count(face.shape) - 1;
    face.divisions = {skeleton.edges[face.edges[0]].divisions, skeleton.edges[face.edges[last]].divisions};
    face.first = next;
    face.count = size(interior(face_grid(face, order)));
    next += face.count;
  }
  skeleton.count = next;
  skeleton.block_first.push_back(next);
  for (std::size_t b = 0; b < layout.blocks.size(); ++b)
  {
    next += size(interior(block_grid(layout.blocks[b], skeleton.block_edges[b], skeleton.edges, order)));
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
  if (edge.count == 0)
    return;
  const geometry::Path path = edge_path(layout, topology, e);
  for (std::int64_t k = 0; k < edge.count; ++k)
  {
    const std::int64_t cell = (k + 1) / skeleton.order;
    const std::int64_t i = (k + 1) % skeleton.order;
    const double t = i == 0 ? corners[cell] : corners[cell] + inner[i] * (corners[cell + 1] - corners[cell]);
    const geometry::Point x = path.evaluate(t);
    const std::int64_t node = edge.first + k;
    skeleton.parameter[node] = t;
    std::copy_n(x.begin(), skeleton.dim, skeleton.x.begin() + node * skeleton.dim);
  }
}

/// Inner nodes of a face between its edges.
void place_face(const PlacedFace& face, Skeleton& skeleton)
{
  const BlockPlan plan = face_plan(skeleton, face);
  std::vector<double> work(work_size(plan, skeleton.dim));
  blend(plan, skeleton.dim, skeleton.x.data(), work.data(), skeleton.x.data());
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

/// Coordinates of edges and faces for given parameters of the cell corners on each edge.
void place_all(const Layout& layout, const Topology& topology,
               const std::vector<std::vector<double>>& corners, Skeleton& skeleton)
{
  const std::vector<double> inner = element::lobatto(layout.order);
  for (std::size_t e = 0; e < skeleton.edges.size(); ++e)
    place_edge(layout, topology, static_cast<int>(e), corners[e], inner, skeleton);
  check_finite(layout, skeleton);
  for (const PlacedFace& face : skeleton.faces)
    place_face(face, skeleton);
  shape_faces(layout, topology, skeleton);
}

/// Cells of equal size on all edges.
std::vector<std::vector<double>> equal_cells(const Topology& topology)
{
  std::vector<std::vector<double>> corners;
  for (const PlacedEdge& edge : topology.edges)
    corners.push_back(parameters(Uniform{}, edge.divisions, 1.0));
  return corners;
}

}  // namespace

Skeleton make_skeleton(const Layout& given)
{
  const Layout layout = with_curves_on_faces(given);
  Topology topology = make_topology(layout);
  const std::vector<int> divisions = divide(layout, topology);
  for (std::size_t e = 0; e < topology.edges.size(); ++e)
    topology.edges[e].divisions = divisions[e];

  Skeleton skeleton;
  skeleton.dim = layout.dim;
  skeleton.order = layout.order;
  skeleton.edges = topology.edges;
  skeleton.faces = topology.faces;
  skeleton.block_edges = topology.block_edges;
  skeleton.block_sides = topology.block_sides;
  number(layout, skeleton);
  skeleton.x.resize(skeleton.count * skeleton.dim);
  skeleton.parameter.assign(skeleton.count, 0.0);
  place_points(layout, skeleton);

  // Gradings may refer to boundaries and these to where nodes are, which curves and surfaces decide: nodes at
  // equal distances serve to find the boundaries.
  const std::vector<std::vector<double>> equal = equal_cells(topology);
  place_all(layout, topology, equal, skeleton);
  check_overlaps(layout, skeleton);
  assign_boundaries(layout, skeleton);
  for (std::size_t e = 0; e < topology.edges.size(); ++e)
    topology.edges[e].boundary = skeleton.edges[e].boundary;
  for (std::size_t f = 0; f < topology.faces.size(); ++f)
    topology.faces[f].boundary = skeleton.faces[f].boundary;
  const std::vector<std::vector<double>> corners =
      distribute(layout, topology, make_strips(layout, topology));
  if (corners != equal)
    place_all(layout, topology, corners, skeleton);
  return skeleton;
}

std::vector<int> interface_sides(const Layout& layout, const Skeleton& skeleton, std::string_view region_a,
                                 std::string_view region_b)
{
  std::vector<int> sides;
  for (int side = 0; side < side_count(skeleton); ++side)
  {
    const std::vector<int>& blocks = side_blocks(skeleton, side);
    if (blocks.size() != 2)
      continue;
    const std::string_view first = layout.blocks[blocks[0]].region;
    const std::string_view second = layout.blocks[blocks[1]].region;
    if (first != second &&
        ((first == region_a && second == region_b) || (first == region_b && second == region_a)))
      sides.push_back(side);
  }
  return sides;
}

std::vector<std::int64_t> interface_nodes(const Layout& layout, const Skeleton& skeleton,
                                          std::string_view region_a, std::string_view region_b)
{
  std::vector<std::int64_t> nodes;
  for (const int side : interface_sides(layout, skeleton, region_a, region_b))
  {
    const std::vector<std::int32_t> numbers = side_numbers(skeleton, side);
    nodes.insert(nodes.end(), numbers.begin(), numbers.end());
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace blockfsi::block
