#pragma once

#include "element/lattice.hpp"
#include "element/shape.hpp"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace blockfsi::mesh
{

/// One side of a cell that lies on a boundary; sides as in element::sides.
struct Side
{
  std::int32_t cell = 0;
  std::int32_t side = 0;

  bool operator==(const Side&) const = default;
};

/// Consecutive cells of one shape.
struct CellRun
{
  element::Shape shape = element::Shape::quadrilateral;
  std::int32_t first = 0;  ///< its first cell
  std::int32_t count = 0;  ///< number of its cells
  std::int64_t entry = 0;  ///< where the nodes of its first cell begin in Mesh::cells

  bool operator==(const CellRun&) const = default;
};

/// Connectivity of one process's share of a mesh of cells of one order.
///
/// It holds the cells that the process owns and every node of these cells. Coordinates are kept apart, as
/// x [m], shape (node_count, dim), because they change in every coupling iteration and the connectivity never
/// does. Cells of all shapes of one dimension may be mixed; those of one shape follow each other in a run.
/// The nodes of a cell follow the lattice of its shape (element/lattice.hpp) and sit at the reference points
/// element::nodes(shape, order), Gauss-Lobatto-Legendre points on its edges: node (i, j) of a quadrilateral
/// is entry i + j (order + 1) of its row.
struct Mesh
{
  int dim = 2;
  int order = 1;

  /// Local nodes of each cell, run after run.
  std::vector<std::int32_t> cells;
  /// One entry per shape that occurs, at most one per shape; cells are numbered through the runs.
  std::vector<CellRun> runs;
  /// Block that each cell comes from, shape (cell_count).
  std::vector<std::int32_t> cell_block;
  /// Name and region of each block, shape (number of blocks).
  std::vector<std::string> block_names;
  std::vector<std::string> block_regions;
  /// Number of each cell in the whole mesh, shape (cell_count); empty: cell c has number c.
  std::vector<std::int64_t> cell_number;
  /// Number of nodes that the process holds.
  std::size_t local_node_count = 0;
  /// Number of each node in the lattice of all blocks of the layout, shape (node_count), ascending; empty:
  /// node n has number n. Meshes of different regions of one layout share these numbers on their common
  /// boundary.
  std::vector<std::int64_t> lattice;
  /// Process that owns each node, shape (node_count): the lowest one that has a cell at the node; empty: all
  /// are owned by process 0.
  std::vector<std::int32_t> owner;
  /// Sides of own cells on each named boundary; a name with no side on this process has an empty list.
  std::map<std::string, std::vector<Side>, std::less<>> boundaries;

  /// Over all processes.
  std::int64_t total_node_count = 0;
  std::int64_t total_cell_count = 0;

  std::size_t cell_count() const { return cell_block.size(); }
  std::size_t node_count() const { return local_node_count; }
  /// The run of a cell.
  const CellRun& run(std::size_t c) const
  {
    std::size_t r = 0;
    while (c >= static_cast<std::size_t>(runs[r].first) + runs[r].count)
      ++r;
    return runs[r];
  }
  element::Shape shape(std::size_t c) const { return run(c).shape; }
  /// Nodes of a cell.
  std::span<const std::int32_t> cell(std::size_t c) const
  {
    const CellRun& of = run(c);
    const auto n = static_cast<std::size_t>(element::lattice_size(of.shape, order));
    return std::span(cells).subspan(of.entry + (c - of.first) * n, n);
  }
  std::int64_t number_of_cell(std::size_t c) const
  {
    return cell_number.empty() ? static_cast<std::int64_t>(c) : cell_number[c];
  }
  int owner_of(std::int32_t node) const { return owner.empty() ? 0 : owner[node]; }
  /// Whether all cells are of this shape; true for a mesh without cells.
  bool is_all(element::Shape shape) const
  {
    return runs.empty() || (runs.size() == 1 && runs[0].shape == shape);
  }
  /// Nodes of each cell of a mesh of quadrilaterals.
  int nodes_per_cell() const { return (order + 1) * (order + 1); }
};

/// Shapes of the cells, each once. Throws Error if one has another dimension than the coordinates: what asks
/// for the sign of a Jacobian has none.
std::vector<element::Shape> shapes_of(const Mesh& mesh);

/// Position within a quadrilateral's row of node k (0..order) of a side, counted along increasing xi or eta.
int side_node(int order, int side, int k);

}  // namespace blockfsi::mesh
