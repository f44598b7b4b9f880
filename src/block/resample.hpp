#pragma once

#include "block/cells.hpp"
#include "block/plan.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::block
{

/// Takes the nodes of the cells of a lattice from one kind to another: warped ones (element::nodes) to those
/// at equal steps within each cell or back, by the cells' own polynomials.
///
/// Nodes that lie alike in their cells have the same weights. So a row is kept as `order` runs, those of the
/// nodes first, first + order, ..., and each run is a sum of others, eight numbers at a time.
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

private:
  friend class ResampledRows;

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
  /// Where a row is kept.
  struct Kept
  {
    std::int32_t begin = 0;  ///< place of its first node in the memory of a layer of cells
    std::int32_t width = 0;  ///< nodes of each run at most
  };

  void find_candidates(const std::vector<std::vector<double>>& weights);
  void lay_out_rows();
  const Kept& kept(int j, int k) const { return kept_[static_cast<std::size_t>(level_begin_[k]) + j]; }

  Grid nodes_;
  int order_;
  int layered_;  ///< direction in which cells lie in layers: 2 of tetrahedra and pyramids, else 1
  BlockCells cells_;
  /// In the order of BlockCells::find; shape (order, order, order) over the remainders, the first fastest.
  std::vector<std::vector<Candidate>> candidates_;
  std::vector<Kept> kept_;
  std::vector<std::int32_t> level_begin_;
  std::size_t layer_size_ = 0;  ///< nodes of the memory of a layer
  std::size_t row_size_ = 0;    ///< of the longest row
};

/// Resamples a lattice that comes row by row, so that one layer of cells is kept, not the lattice.
class ResampledRows
{
public:
  ///   wanted: rows that are written at Row::node of `to`, ascending;  work, shape (work_size)
  ResampledRows(const LatticeResampler& resampler, std::span<const BlockPlan::Row> wanted, int dim,
                double* work, double* to);
  static std::size_t work_size(const LatticeResampler& resampler, int dim);

  /// Takes a whole row, in ascending order; rows of layers without wanted rows may be left out. Writes the
  /// wanted rows all of whose cells are complete.
  ///   x, shape (length of the row, dim)
  void add(const BlockPlan::Row& row, const double* x);

private:
  bool is_complete(const BlockPlan::Row& wanted, const BlockPlan::Row& last) const;
  void write(const BlockPlan::Row& row) const;
  void write_run(const LatticeResampler::Candidate& cell, const element::LatticePoint& first, int count,
                 double* run) const;

  const LatticeResampler& by_;
  std::span<const BlockPlan::Row> wanted_;
  int dim_;
  double* layer_;
  double* runs_;
  double* to_;
};

/// The resampling of a block of a shape with triangles: its sides to equal steps, its inside back.
class Resampling
{
public:
  ///   wanted: rows of the block that are placed, ascending
  Resampling(const Grid& nodes, int order, int diagonal, std::span<const BlockPlan::Row> wanted);

  /// The rows at equal steps that the wanted ones need, with 0 as Row::node.
  std::span<const BlockPlan::Row> lattice_rows() const { return rows_; }
  ///   from, to, shape (size of the side, dim);  work, shape (work_size)
  void side_to_equal_steps(int side, int dim, const double* from, double* work, double* to) const;
  const LatticeResampler& inside() const { return inside_; }
  std::size_t work_size(int dim) const;

private:
  std::vector<BlockPlan::Row> rows_;
  LatticeResampler inside_;
  std::vector<LatticeResampler> sides_;
  std::vector<std::vector<BlockPlan::Row>> side_rows_;
};

/// All rows of a lattice with the place in it as Row::node; `inner`: of the points on no side, counted from
/// 0.
std::vector<BlockPlan::Row> all_rows(const Grid& grid);
std::vector<BlockPlan::Row> inner_rows(const Grid& grid);

}  // namespace blockfsi::block
