#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace blockfsi::mesh
{

/// One side of a cell that lies on a boundary.
/// Sides of a quadrilateral: 0 at eta = 0, 1 at xi = 1, 2 at eta = 1, 3 at xi = 0.
struct Side
{
  std::int32_t cell = 0;
  std::int32_t side = 0;

  bool operator==(const Side&) const = default;
};

/// Connectivity of one process's share of a mesh of quadrilaterals of one order.
///
/// It holds the cells that the process owns and every node of these cells. Coordinates are kept apart, as
/// x [m], shape (node_count, dim), because they change in every coupling iteration and the connectivity never
/// does. The reference cell is the unit square; node (i, j) of a cell, 0 <= i, j <= order, is entry
/// i + j (order + 1) of its row and sits at the Gauss-Lobatto-Legendre points (xi_i, eta_j).
struct Mesh
{
  int dim = 2;
  int order = 1;

  /// Local nodes of each cell, shape (cell_count, (order + 1)^2).
  std::vector<std::int32_t> cells;
  /// Block that each cell comes from, shape (cell_count).
  std::vector<std::int32_t> cell_block;
  /// Number of each cell in the whole mesh, shape (cell_count).
  std::vector<std::int64_t> cell_number;
  /// Number of each node in the lattice of all blocks of the layout, shape (node_count), ascending.
  /// Meshes of different regions of one layout share these numbers on their common boundary.
  std::vector<std::int64_t> lattice;
  /// Process that owns each node, shape (node_count): the lowest one that has a cell at the node.
  std::vector<std::int32_t> owner;
  /// Sides of own cells on each named boundary; a name with no side on this process has an empty list.
  std::map<std::string, std::vector<Side>, std::less<>> boundaries;

  /// Over all processes.
  std::int64_t total_node_count = 0;
  std::int64_t total_cell_count = 0;

  int nodes_per_cell() const { return (order + 1) * (order + 1); }
  std::size_t cell_count() const { return cell_block.size(); }
  std::size_t node_count() const { return lattice.size(); }
  std::span<const std::int32_t> cell(std::size_t c) const
  {
    const auto n = static_cast<std::size_t>(nodes_per_cell());
    return std::span(cells).subspan(c * n, n);
  }
};

/// Position within a cell's row of node k (0..order) of a side, counted along increasing xi or eta.
int side_node(int order, int side, int k);

}  // namespace blockfsi::mesh
