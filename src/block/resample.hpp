#pragma once

#include "block/cells.hpp"
#include "block/plan.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::block
{

/// Takes the nodes of the cells of a lattice from one kind to another: warped ones (element::nodes) to those
/// at equal steps within each cell or back, by the cells' own polynomials.
class LatticeResampler
{
public:
  enum class Direction
  {
    to_equal_steps,
    to_warped
  };
  /// What is resampled: all directions, or only the first one (quadrilaterals) or two (prisms), which leaves
  /// the last as it is.
  LatticeResampler(const Grid& nodes, int order, int diagonal, Direction direction, bool keep_last);

  /// Values at nodes (i, j, k) of rows, from those of the whole lattice.
  ///   from, shape (size of the lattice, dim);  to: written at Row::node
  void apply(std::span<const BlockPlan::Row> rows, int dim, const double* from, double* to) const;

private:
  /// Weight of a node of the same cell.
  struct Term
  {
    element::LatticePoint offset{};  ///< from the cell's box, in steps of the lattice
    double weight = 0.0;
  };
  /// A cell that nodes with some remainders of their coordinates by the order may lie in.
  struct Candidate
  {
    element::LatticePoint box{};  ///< from the node's own box (coordinates divided by the order), 0 or -1
    std::size_t kind = 0;
    std::vector<Term> terms;
  };

  template <int dim>
  void apply_to_row(const BlockPlan::Row& row, const double* from, double* to) const;
  template <int dim>
  void apply_along(const Candidate& cell, const element::LatticePoint& first, int count, const double* from,
                   double* to) const;

  Grid nodes_;
  int order_;
  BlockCells cells_;
  /// In the order of BlockCells::find; shape (order, order, order) over the remainders, the first fastest.
  std::vector<std::vector<Candidate>> candidates_;
  std::vector<std::int64_t> row_begin_;  ///< index of (0, j, k) in the lattice
  std::vector<std::int32_t> level_begin_;
};

/// The resampling of a block of a shape with triangles: its sides to equal steps, its inside back.
class Resampling
{
public:
  Resampling(const Grid& nodes, int order, int diagonal);

  /// All inner rows, with the place in the lattice as Row::node.
  std::span<const BlockPlan::Row> lattice_rows() const { return rows_; }
  ///   from, to, shape (size of the side, dim)
  void side_to_equal_steps(int side, int dim, const double* from, double* to) const;
  ///   lattice, shape (size of the lattice, dim), at equal steps; x: rows are written
  void to_warped(std::span<const BlockPlan::Row> rows, int dim, const double* lattice, double* x) const;
  /// Writes the nodes of a side into the lattice.
  void scatter_side(int side, int dim, const double* from, double* lattice) const;

private:
  std::vector<BlockPlan::Row> rows_;
  LatticeResampler inside_;
  std::vector<LatticeResampler> sides_;
  std::vector<std::vector<BlockPlan::Row>> side_rows_;
  std::vector<std::vector<std::int32_t>> side_index_;  ///< place of each node of a side in the lattice
};

/// All rows of a lattice with the place in it as Row::node; `inner`: of the points on no side, counted from
/// 0.
std::vector<BlockPlan::Row> all_rows(const Grid& grid);
std::vector<BlockPlan::Row> inner_rows(const Grid& grid);

}  // namespace blockfsi::block
