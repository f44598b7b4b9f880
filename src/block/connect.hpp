#pragma once

#include "block/layout.hpp"
#include "core/part.hpp"
#include "mesh/mesh.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi::block
{

/// An edge between two points with everything that follows from the layout.
struct PlacedEdge
{
  int a = 0;                ///< point at parameter 0
  int b = 0;                ///< point at parameter 1
  int divisions = 0;        ///< cells along the edge
  std::int64_t first = 0;   ///< skeleton number of its first inner node; inner nodes follow from a to b
  std::int64_t count = 0;   ///< number of inner nodes: divisions * order - 1
  std::vector<int> blocks;  ///< the one or two blocks at it
  int boundary = -1;        ///< index into Layout::boundaries, -1: none
};

/// The lattice of all blocks: points, then inner nodes of edges, then inner nodes of blocks, numbered by
/// arithmetic. The nodes of points and edges are the skeleton; every process knows all of it.
struct Skeleton
{
  int dim = 2;
  int order = 1;
  std::vector<PlacedEdge> edges;
  /// For each block the edge on each side, shape (block_count, 4).
  std::vector<std::array<int, 4>> block_edges;
  /// Skeleton number of the first inner node of each block (they follow the skeleton), shape (block_count +
  /// 1).
  std::vector<std::int64_t> block_first;
  std::vector<std::string> point_names;  ///< for messages, shape (point_count)
  std::int64_t point_count = 0;
  std::int64_t count = 0;  ///< number of nodes of the skeleton
  /// Initial coordinates [m], shape (count, dim).
  std::vector<double> x;
  /// Graded parameter along its edge of each node of the skeleton, 0 for points, shape (count).
  std::vector<double> parameter;
};

/// Derives edges, division counts, gradings, boundaries and the initial skeleton from a layout.
/// Throws Error (with the place in the case file where known) for conflicting divisions (naming both edges
/// and the blocks between), a point used by no block, a block turned inside out, an edge shared by more than
/// two blocks, an edge in two boundaries, a boundary without edges, an outer edge in no boundary.
Skeleton make_skeleton(const Layout& layout);

/// Where the nodes of one process's share of a mesh sit: what `place` needs.
struct Plan
{
  int dim = 2;
  /// Local nodes that belong to the skeleton and their skeleton numbers.
  std::vector<std::int32_t> skeleton_node;
  std::vector<std::int64_t> skeleton_number;
  /// A local node inside a block: the skeleton nodes of the four sides in its row and column, the four
  /// corners, and the graded coordinates (u, v) of the transfinite map (formulation.md chapter 3).
  struct Inner
  {
    std::int32_t node;
    std::array<std::int32_t, 4> side;    ///< bottom (u, 0), right (1, v), top (u, 1), left (0, v)
    std::array<std::int32_t, 4> corner;  ///< points of the block
    double u;
    double v;
  };
  std::vector<Inner> inner;
};

/// A mesh of the blocks of one region (or of all blocks: region empty) with its plan.
struct Connected
{
  mesh::Mesh mesh;
  Plan plan;
};

/// Connectivity of this process's share of the cells of a region, made without communication.
/// Cells are numbered block by block, u fastest, the blocks of the region by the x of their centres (equal
/// ones in the order of the layout), so that the cuts are short in long domains; each process takes a
/// contiguous run of cells, all runs equally long to one. Takes memory and time for the own cells and for the
/// skeleton only. Boundaries of the mesh: the named ones of the layout that touch the region, and "interface"
/// for edges between this region and another if there are any; the same names on every process. Throws Error
/// if no block has this region.
Connected connect(const Layout& layout, const Skeleton& skeleton, std::string_view region, Part part);

/// Skeleton numbers of the nodes on all edges between two regions, ascending; the same on every process.
std::vector<std::int64_t> interface_nodes(const Layout& layout, const Skeleton& skeleton,
                                          std::string_view region_a, std::string_view region_b);

}  // namespace blockfsi::block
