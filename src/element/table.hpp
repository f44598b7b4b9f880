#pragma once

#include "element/nodes.hpp"

#include <array>
#include <span>
#include <vector>

namespace blockfsi::element
{

/// Lagrange functions of the nodes of a cell at points of the reference cell. Every matrix is row-major,
/// shape (point_count, node_count): entry (q, n) is at q node_count + n.
struct CellTable
{
  int point_count = 0;
  int node_count = 0;
  std::vector<double> value;
  /// Along xi, eta, zeta; empty from the shape's dimension on, or if not asked for.
  std::array<std::vector<double>, 3> first;
  /// xx, yy, zz, xy, xz, yz; empty where a coordinate is not the shape's, or if not asked for.
  std::array<std::vector<double>, 6> second;
};

/// Which nodes the functions belong to.
enum class NodeKind
{
  warped,     ///< element::nodes, those of meshes
  equispaced  ///< element::equispaced_nodes, those of files
};

/// Lagrange functions of a cell of order 1..largest_order at points of the reference cell, with `derivatives`
/// = 0, 1 or 2. Points may lie outside but for pyramids above their apex. At the apex as in
/// element::orthonormal. Throws Error for another order.
CellTable tabulate(Shape shape, int order, std::span<const Point> points, int derivatives = 1,
                   NodeKind kind = NodeKind::warped);

/// A lattice of a cell: order and kind of its nodes.
struct Lattice
{
  int order = 1;
  NodeKind kind = NodeKind::warped;
};

/// Matrix that takes values at the nodes of one lattice to values of the same function at those of another,
/// row-major, shape (lattice_size(shape, to.order), lattice_size(shape, from.order)). Exact 0 and 1 where
/// nodes are at the same place. Lower orders interpolate.
std::vector<double> resample(Shape shape, Lattice from, Lattice to);

}  // namespace blockfsi::element
