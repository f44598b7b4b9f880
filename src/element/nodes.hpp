#pragma once

#include "element/lattice.hpp"
#include "element/shape.hpp"

#include <array>
#include <vector>

namespace blockfsi::element
{

/// A point of a reference cell; coordinates that the shape does not have are 0.
using Point = std::array<double, 3>;

/// Largest order of a cell.
inline constexpr int largest_order = 8;

/// Reference points of the nodes of a cell of order 1..largest_order, in the order of its lattice. On edges
/// they are Gauss-Lobatto-Legendre points; a side of a cell carries the nodes of its own shape; so cells of
/// all shapes share nodes in any relative orientation.
///
/// Triangles and tetrahedra have recursive interpolatory nodes (Isaac 2020, "Recursive, parameter-free,
/// explicitly defined interpolation nodes for simplices"), which no permutation of corners changes;
/// quadrilaterals, hexahedra and prisms are products; the inside of a pyramid is blended from its triangles
/// (see docs/element.md). Throws Error for another order.
std::vector<Point> nodes(Shape shape, int order);

/// The same lattice with equal steps, as files of meshes mean it; order >= 1.
std::vector<Point> equispaced_nodes(Shape shape, int order);

}  // namespace blockfsi::element
