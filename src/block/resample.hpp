#pragma once

#include "block/cells.hpp"
#include "block/plan.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
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
  friend std::size_t resampling_work(const LatticeResampler& resampler);

  /// Weight of a node of the same cell.
  struct Term
  {
    double weight = 0.0;
    /// In layers with an even and with an odd number, counted from where the box begins in the lowest plane.
    std::array<std::ptrdiff_t, 2> place{};
  };
  /// A cell that nodes with some remainders of their coordinates by the order may lie in.
  struct Candidate
  {
    element::LatticePoint box{};  ///< from the node's own box (coordinates divided by the order), 0 or -1
    std::size_t kind = 0;
    std::vector<Term> terms;
  };

  void find_candidates(const std::vector<std::vector<double>>& weights);
  /// What a node of a cell takes from all of its nodes, given their weights.
  std::vector<Term> terms_of(const std::vector<element::LatticePoint>& all, const element::LatticePoint& node,
                             const double* weights) const;
  /// Place of the first node of a row in the memory of a layer of cells. The planes of even layers are kept
  /// upwards, those of odd ones downwards, so that the plane between two layers stays where it is.
  std::ptrdiff_t row_place(int j, int k) const;

  Grid nodes_;
  int order_;
  /// Direction in which layers of cells follow each other that have only the plane between them in common: 2
  /// of tetrahedra and pyramids, else 1. Planes are the levels, or the rows of each level.
  int layered_;
  BlockCells cells_;
  /// In the order of BlockCells::find; shape (order, order, order) over the remainders, the first fastest.
  std::vector<std::vector<Candidate>> candidates_;
  // Numbers of nodes that there is memory for:
  std::ptrdiff_t run_size_;
  std::ptrdiff_t row_size_;
  std::ptrdiff_t plane_size_;
};

/// Numbers that ResampledRows needs as working memory.
std::size_t resampling_work(const LatticeResampler& resampler);

/// Resamples a lattice that comes row by row, so that one layer of cells is kept, not the lattice.
class ResampledRows
{
public:
  ///   wanted: rows that are written at Row::node of `to`, ascending;  work, shape (resampling_work)
  ResampledRows(const LatticeResampler& resampler, std::span<const BlockPlan::Row> wanted, double* work,
                double* to);

  /// Takes a whole row, in ascending order; rows of layers without wanted rows may be left out. Writes the
  /// wanted rows all of whose cells are complete.
  ///   x, shape (length of the row, 3)
  void add(const BlockPlan::Row& row, const double* x);

private:
  /// Finds out after which row the first wanted one is complete.
  void look_ahead();
  void write(const BlockPlan::Row& row) const;
  void write_run(const LatticeResampler::Candidate& cell, const element::LatticePoint& box, int count,
                 bool exactly, double* to) const;

  const LatticeResampler& by_;
  std::span<const BlockPlan::Row> wanted_;
  std::pair<int, int> complete_after_;  ///< level and row
  double* layer_;
  double* runs_;
  double* to_;
};

/// The resampling of a tetrahedron, a prism or a pyramid: its sides to equal steps, its inside back.
class Resampling
{
public:
  ///   wanted: rows of the block that are placed, ascending
  Resampling(const Grid& nodes, int order, int diagonal, std::span<const BlockPlan::Row> wanted);

  /// The rows at equal steps that the wanted ones need, with 0 as Row::node.
  std::span<const BlockPlan::Row> lattice_rows() const { return rows_; }
  ///   from, to, shape (size of the side, 3);  work, shape (work_size)
  void side_to_equal_steps(int side, const double* from, double* work, double* to) const;
  const LatticeResampler& inside() const { return inside_; }
  std::size_t work_size() const;

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
