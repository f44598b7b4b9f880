#pragma once

#include "block/connect.hpp"
#include "block/layout.hpp"
#include "geometry/path.hpp"

#include <array>
#include <span>
#include <vector>

namespace blockfsi::block
{

/// Who touches whom in a layout, before anything is divided.
struct Topology
{
  int dim = 2;
  /// Ends and blocks of each edge; the direction is the user's where he speaks of the edge, else that of its
  /// first block.
  std::vector<PlacedEdge> edges;
  /// Corners, edges and blocks of each face in 3D, as its first block sees them.
  std::vector<PlacedFace> faces;
  std::vector<std::vector<int>> block_edges;  ///< as in Skeleton
  std::vector<std::vector<int>> block_sides;  ///< as in Skeleton
  std::vector<int> info;  ///< entry of Layout::edges that speaks of the edge, -1: none; shape (edge_count)
  std::vector<int>
      face_info;  ///< entry of Layout::faces that speaks of the face, -1: none; shape (face_count)
};

/// Sides of blocks are edges in 2D and faces in 3D; `Complex` is a Topology or a Skeleton.
template <typename Complex>
int side_count(const Complex& complex)
{
  return static_cast<int>(complex.dim == 2 ? complex.edges.size() : complex.faces.size());
}
template <typename Complex>
const std::vector<int>& side_blocks(const Complex& complex, int side)
{
  return complex.dim == 2 ? complex.edges[side].blocks : complex.faces[side].blocks;
}
template <typename Complex>
int side_boundary(const Complex& complex, int side)
{
  return complex.dim == 2 ? complex.edges[side].boundary : complex.faces[side].boundary;
}
/// The edges of a side; in 2D the side itself.
template <typename Complex>
std::vector<int> side_edges(const Complex& complex, int side)
{
  if (complex.dim == 2)
    return {side};
  const PlacedFace& face = complex.faces[side];
  return {face.edges.begin(), face.edges.begin() + element::corner_count(face.shape)};
}
/// The points of a side in their order round it.
template <typename Complex>
std::vector<int> side_points(const Complex& complex, int side)
{
  if (complex.dim == 2)
    return {complex.edges[side].a, complex.edges[side].b};
  const PlacedFace& face = complex.faces[side];
  return {face.points.begin(), face.points.begin() + element::corner_count(face.shape)};
}

/// First and last point of an edge of a block in the block's direction (element::edges).
std::array<int, 2> edge_ends(const Block& block, int edge);

/// The edge between two points in either direction, or -1.
int find_edge(std::span<const PlacedEdge> edges, int a, int b);
/// The face over these points in any order, or -1.
int find_face(std::span<const PlacedFace> faces, std::span<const int> points);

/// Finds the edges and faces of all blocks and what the user says of them. Throws Error for an order outside
/// 1..8, a point used by no block, two points at one place, a block with wrong or repeated points, one turned
/// inside out or degenerate at a corner, a side of more than two blocks, blocks on top of each other, two
/// entries for one edge or face, an entry that no block has, a curve that does not fit.
Topology make_topology(const Layout& layout);

/// The curve of an edge, made ready for many points. Refers to the layout, which must outlive it.
geometry::Path edge_path(const Layout& layout, const Topology& topology, int edge);

/// Whether an edge is the straight line between its points.
bool is_straight(const Layout& layout, const Topology& topology, int edge);

/// Length of an edge [m].
double edge_length(const Layout& layout, const Topology& topology, int edge);

/// Diagonal of the box around all points [m].
double layout_size(const Layout& layout);

}  // namespace blockfsi::block
