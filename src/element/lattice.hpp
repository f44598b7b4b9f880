#pragma once

#include "element/shape.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::element
{

/// The lattice of nodes of a cell, or of a block, with n steps along each edge. Points (i, j, k), unused
/// coordinates 0, i fastest, then j, then k:
///   segment        0 <= i <= n
///   triangle       i + j <= n
///   quadrilateral  i, j <= n
///   tetrahedron    i + j + k <= n
///   hexahedron     i, j, k <= n
///   prism          i + j <= n, k <= n
///   pyramid        k <= n, i, j <= n - k
/// A cell of order p has its nodes at the points of the lattice with p steps, in this order.
using LatticePoint = std::array<int, 3>;

/// Number of points.
std::int64_t lattice_size(Shape shape, int n);
/// Number of points that lie on no side.
std::int64_t interior_size(Shape shape, int n);
/// Position of a point in the order above.
std::int64_t lattice_index(Shape shape, int n, LatticePoint point);
/// All points in their order, shape (lattice_size).
std::vector<LatticePoint> lattice_points(Shape shape, int n);
/// The points of a side in the order of the side's own lattice: entry m is the index in the cell's lattice of
/// the side's point m. Sides and their directions as in element::sides.
std::vector<std::int32_t> side_lattice(Shape shape, int n, int side);
/// The same for an edge of the cell, edges as in element::edges, from its first corner to its second.
std::vector<std::int32_t> edge_lattice(Shape shape, int n, int edge);

}  // namespace blockfsi::element
