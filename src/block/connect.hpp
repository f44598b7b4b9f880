#pragma once

#include "block/layout.hpp"
#include "block/plan.hpp"
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
  std::vector<int> blocks;  ///< the blocks at it, in 2D one or two
  int boundary = -1;        ///< index into Layout::boundaries, -1: none; 3D: the lowest of the faces at it
};

/// A face between three or four edges in 3D with everything that follows from the layout.
struct PlacedFace
{
  element::Shape shape = element::Shape::quadrilateral;
  std::array<int, 4> points{};     ///< corners, in the order of element::corners
  std::array<int, 4> edges{};      ///< in the order of element::edges
  std::array<int, 2> divisions{};  ///< cells along the first and the second coordinate
  std::int64_t first = 0;          ///< skeleton number of its first inner node; these have the order of its
                                   ///< lattice (block/grid.hpp)
  std::int64_t count = 0;          ///< number of inner nodes
  std::vector<int> blocks;         ///< the one or two blocks at it
  int boundary = -1;               ///< index into Layout::boundaries, -1: none
};

/// The lattice of all blocks: points, then inner nodes of edges, of faces and of blocks, numbered by
/// arithmetic. All but the last are the skeleton; every process knows all of it. A node that blocks share
/// exists once.
struct Skeleton
{
  int dim = 2;
  int order = 1;
  std::vector<PlacedEdge> edges;
  std::vector<PlacedFace> faces;  ///< 3D only
  /// For each block its edges in the order of element::edges, shape (block_count, number of edges).
  std::vector<std::vector<int>> block_edges;
  /// For each block its sides in the order of element::sides: in 2D edges, in 3D faces.
  std::vector<std::vector<int>> block_sides;
  /// Skeleton number of the first inner node of each block (they follow the skeleton), shape (block_count +
  /// 1).
  std::vector<std::int64_t> block_first;
  std::vector<std::string> point_names;  ///< for messages, shape (point_count)
  std::int64_t point_count = 0;
  std::int64_t count = 0;  ///< number of nodes of the skeleton
  /// Initial coordinates [m], shape (count, dim).
  std::vector<double> x;
  /// Graded parameter along its edge of each node on an edge, 0 for all others, shape (count).
  std::vector<double> parameter;
};

/// Derives edges, faces, division counts, gradings, boundaries and the initial skeleton from a layout:
/// points, then edges on their curves, then faces between their edges. Throws Error (with the place in the
/// case file where known) for whatever does not make sense, see `make_topology`, `divide`,
/// `assign_boundaries` and `distribute`.
Skeleton make_skeleton(const Layout& layout);

/// A mesh of the blocks of one region (or of all blocks: region empty) with its plan.
struct Connected
{
  mesh::Mesh mesh;
  Plan plan;
};

/// Connectivity of this process's share of the cells of a region, made without communication.
/// The blocks of the region follow each other by the x of their centres (equal ones in the order of the
/// layout), so that the cuts are short in long domains, the cells of a block with u fastest; each process
/// takes a contiguous run of these cells, all runs equally long to one. Cells of one shape are numbered in
/// this order, one shape after the other. Takes memory and time for the own cells and for the skeleton only.
/// For a single process `owner` and `cell_number` of the mesh are empty, and if it makes all blocks (region
/// empty) it has the numbers of the lattice as its own, so `lattice` is empty, too. Boundaries of the mesh:
/// the named ones of the layout that touch the region, and "interface" for sides between this region and
/// another if there are any; the same names on every process. Throws Error if no block has this region.
Connected connect(const Layout& layout, const Skeleton& skeleton, std::string_view region, Part part);

/// The sides (indices into the edges in 2D, the faces in 3D) between two regions, ascending.
std::vector<int> interface_sides(const Layout& layout, const Skeleton& skeleton, std::string_view region_a,
                                 std::string_view region_b);

/// Skeleton numbers of the nodes on all sides between two regions, ascending; the same on every process.
std::vector<std::int64_t> interface_nodes(const Layout& layout, const Skeleton& skeleton,
                                          std::string_view region_a, std::string_view region_b);

}  // namespace blockfsi::block
