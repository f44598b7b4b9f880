#pragma once

#include "block/grid.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::block
{

/// One of the cells that start at a point o of the lattice of cell corners ("box" o).
struct CellKind
{
  element::Shape shape = element::Shape::quadrilateral;
  /// The cell's nodes (element/lattice.hpp) relative to `order` times o, in steps of the lattice of nodes.
  std::vector<element::LatticePoint> nodes;
  /// A row of boxes with m boxes has m - shorter of these cells, in its first boxes.
  int shorter = 0;
  /// Whether the last row of boxes of a level has them, too.
  bool in_last_row = true;
  /// Sides that lie on a side of the block if the box is far enough in its direction: on the left, front and
  /// bottom if the box's coordinate there is 0, else if the cell is the last one of its kind in that
  /// direction.
  struct OnWall
  {
    Wall wall = Wall::bottom;
    int side = 0;  ///< of the cell
    /// For right, back and top: the side lies on the wall if coordinates of the box + offset reach the end.
    int offset = 0;
  };
  std::vector<OnWall> walls;
};

/// The cells into which a block is divided (formulation.md 3): n^2 triangles, n m quadrilaterals, n^3
/// tetrahedra (upright ones, octahedra split into four and inverted ones), n m l hexahedra, n^2 m prisms,
/// pyramids and tetrahedra in a pyramid. They are numbered box by box, i fastest, then j, then k, within a
/// box in the order of the kinds.
class BlockCells
{
public:
  /// `cells` is the lattice of cell corners; `diagonal` 0, 1 or 2 splits the octahedra of a tetrahedron: it
  /// joins the corners o + e_diagonal and o + the other two.
  BlockCells(const Grid& cells, int order, int diagonal);

  std::int64_t count() const { return count_; }
  std::span<const CellKind> kinds() const { return kinds_; }
  int level_count() const { return levels_; }
  /// Rows of boxes of a level.
  int row_count(int k) const;
  /// Boxes of a row.
  int box_count(int j, int k) const;
  /// Number of cells of a kind in a row.
  int count_in_row(const CellKind& kind, int j, int k) const;
  /// Number of cells of a kind.
  std::int64_t count_of(const CellKind& kind) const;
  /// Number of the first cell of a row.
  std::int64_t row_begin(int j, int k) const { return row_begin_[row_index(j, k)]; }
  std::int64_t row_end(int j, int k) const { return row_begin_[row_index(j, k) + 1]; }

  /// A cell with a node: its box, its place among the kinds, the node's place in the cell.
  struct Found
  {
    element::LatticePoint box{};
    int kind = 0;
    int local = 0;
  };
  /// The lowest cell that has a node of the block.
  Found find(const element::LatticePoint& node) const;
  std::int64_t lowest_cell(const element::LatticePoint& node) const;
  /// Whether a side of a cell of some kind lies on its wall for boxes (j, k) of a row: those from `first` to
  /// `last`, empty if first > last.
  struct Boxes
  {
    int first = 0;
    int last = -1;
  };
  Boxes on_wall(const CellKind::OnWall& side, const CellKind& kind, int j, int k) const;

private:
  std::size_t row_index(int j, int k) const { return static_cast<std::size_t>(level_begin_[k]) + j; }
  std::int64_t number(int i, int j, int k, std::size_t kind) const;

  Grid cells_;
  int order_;
  int levels_;
  std::int64_t count_ = 0;
  std::vector<CellKind> kinds_;
  std::vector<std::int32_t> level_begin_;
  std::vector<std::int64_t> row_begin_;
  /// Place in the cell of the node at an offset within a box, -1: the cell does not have it; shape (kinds,
  /// (order + 1)^3).
  std::vector<std::int16_t> local_;
};

}  // namespace blockfsi::block
