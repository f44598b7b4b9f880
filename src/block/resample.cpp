#include "block/resample.hpp"

#include "block/numbering.hpp"
#include "element/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace blockfsi::block
{

namespace
{

using element::LatticePoint;
using element::NodeKind;
using element::Shape;

/// Weights below this are those of nodes that have none: cells have few nodes, and all weights are of size 1.
constexpr double rounding = 1e-13;
/// Nodes of the largest cell that is resampled, a pyramid of order 8.
constexpr std::size_t max_terms = 285;

/// Whether the last direction of a shape is a product with the others.
Shape cross_section(Shape shape)
{
  return shape == Shape::prism ? Shape::triangle : Shape::segment;
}

std::vector<double> matrix(Shape shape, int order, LatticeResampler::Direction direction)
{
  const element::Lattice warped{order, NodeKind::warped};
  const element::Lattice equal{order, NodeKind::equispaced};
  return direction == LatticeResampler::Direction::to_warped ? element::resample(shape, equal, warped)
                                                             : element::resample(shape, warped, equal);
}

/// Matrix of the cross-section at each level of the last direction.
std::vector<double> product_matrix(Shape shape, int order, LatticeResampler::Direction direction)
{
  const std::vector<double> part = matrix(cross_section(shape), order, direction);
  const auto count = static_cast<std::size_t>(element::lattice_size(cross_section(shape), order));
  const std::size_t all = count * (static_cast<std::size_t>(order) + 1);
  std::vector<double> result(all * all, 0.0);
  for (std::size_t level = 0; level <= static_cast<std::size_t>(order); ++level)
    for (std::size_t a = 0; a < count; ++a)
      for (std::size_t b = 0; b < count; ++b)
        result[(level * count + a) * all + level * count + b] = part[a * count + b];
  return result;
}

/// Sides of a block of which only the first direction has triangles beside it.
bool keeps_last(Shape block, Shape side)
{
  return block == Shape::prism && side == Shape::quadrilateral;
}

Grid coarse(const Grid& nodes, int order)
{
  return {nodes.shape, {nodes.steps[0] / order, nodes.steps[1] / order, nodes.steps[2] / order}};
}

}  // namespace

std::vector<BlockPlan::Row> all_rows(const Grid& grid)
{
  std::vector<BlockPlan::Row> rows;
  std::int32_t node = 0;
  for (int k = 0; k < level_count(grid); ++k)
    for (int j = 0; j < row_count(grid, k); ++j)
    {
      const int length = row_length(grid, j, k);
      rows.push_back({j, k, 0, length, node});
      node += length;
    }
  return rows;
}

std::vector<BlockPlan::Row> inner_rows(const Grid& grid)
{
  std::vector<BlockPlan::Row> rows;
  const Grid inner = interior(grid);
  if (size(inner) == 0)
    return rows;
  const int flat = element::dimension(grid.shape) == 2 ? 0 : 1;
  const int levels = flat == 0 ? 1 : level_count(inner);
  for (int k = 0; k < levels; ++k)
    for (int j = 0; j < row_count(inner, k); ++j)
      rows.push_back({j + 1, k + flat, 1, row_length(inner, j, k) + 1,
                      static_cast<std::int32_t>(index(grid, {1, j + 1, k + flat}))});
  return rows;
}

LatticeResampler::LatticeResampler(const Grid& nodes, int order, int diagonal, Direction direction,
                                   bool keep_last)
    : nodes_(nodes), order_(order), cells_(coarse(nodes, order), order, diagonal),
      candidates_(static_cast<std::size_t>(order) * order * order)
{
  std::vector<std::vector<double>> weights;
  for (const CellKind& kind : cells_.kinds())
    weights.push_back(keep_last ? product_matrix(kind.shape, order, direction)
                                : matrix(kind.shape, order, direction));
  for (std::size_t remainders = 0; remainders < candidates_.size(); ++remainders)
  {
    const int at = static_cast<int>(remainders);
    const LatticePoint remainder{at % order, at / order % order, at / order / order};
    // Boxes before the node's own one have it only where it lies between them.
    for (int k = remainder[2] == 0 ? -1 : 0; k <= 0; ++k)
      for (int j = remainder[1] == 0 ? -1 : 0; j <= 0; ++j)
        for (int i = remainder[0] == 0 ? -1 : 0; i <= 0; ++i)
          for (std::size_t q = 0; q < weights.size(); ++q)
          {
            const std::vector<LatticePoint>& all = cells_.kinds()[q].nodes;
            const LatticePoint local{remainder[0] - order * i, remainder[1] - order * j,
                                     remainder[2] - order * k};
            const auto found = std::find(all.begin(), all.end(), local);
            if (found == all.end())
              continue;
            Candidate candidate{{i, j, k}, q, {}};
            const double* row =
                weights[q].data() + (found - all.begin()) * static_cast<std::ptrdiff_t>(all.size());
            for (std::size_t b = 0; b < all.size(); ++b)
              if (std::abs(row[b]) > rounding)
                candidate.terms.push_back({all[b], row[b]});
            candidates_[remainders].push_back(std::move(candidate));
          }
  }
  for (int k = 0; k < level_count(nodes); ++k)
  {
    level_begin_.push_back(static_cast<std::int32_t>(row_begin_.size()));
    for (int j = 0; j < row_count(nodes, k); ++j)
      row_begin_.push_back(index(nodes, {0, j, k}));
  }
}

/// Nodes first, first + order, ... along a row, `count` of them, which lie in cells of one kind.
template <int dim>
void LatticeResampler::apply_along(const Candidate& cell, const LatticePoint& first, int count,
                                   const double* from, double* to) const
{
  const LatticePoint box{first[0] / order_ + cell.box[0], first[1] / order_ + cell.box[1],
                         first[2] / order_ + cell.box[2]};
  struct Source
  {
    const double* x;
    double weight;
  };
  std::array<Source, max_terms> sources;
  for (std::size_t q = 0; q < cell.terms.size(); ++q)
  {
    const Term& term = cell.terms[q];
    const std::int64_t line =
        level_begin_[order_ * box[2] + term.offset[2]] + order_ * box[1] + term.offset[1];
    sources[q] = {from + dim * (row_begin_[line] + order_ * box[0] + term.offset[0]), term.weight};
  }
  const std::span<const Source> used(sources.data(), cell.terms.size());
  const std::ptrdiff_t step = static_cast<std::ptrdiff_t>(dim) * order_;
  for (std::ptrdiff_t at = 0; at < step * count; at += step)
  {
    std::array<double, dim> sum{};
    for (const Source& source : used)
      for (int c = 0; c < dim; ++c)
        sum[c] += source.weight * source.x[at + c];
    std::copy(sum.begin(), sum.end(), to + at);
  }
}

/// Each node lies in the first of its candidates that exists; along the row each of them exists for boxes
/// that follow each other, and those that an earlier one has are in their middle.
template <int dim>
void LatticeResampler::apply_to_row(const BlockPlan::Row& row, const double* from, double* to) const
{
  const int j = row.j / order_;
  const int k = row.k / order_;
  for (int remainder = 0; remainder < order_; ++remainder)
  {
    const int first = std::max(0, (row.begin - remainder + order_ - 1) / order_);
    const int end = (row.end - remainder + order_ - 1) / order_;
    int done_first = end;
    int done_end = first;
    const auto& candidates = candidates_[remainder + order_ * (row.j % order_ + order_ * (row.k % order_))];
    for (const Candidate& cell : candidates)
    {
      const int cell_j = j + cell.box[1];
      const int cell_k = k + cell.box[2];
      if (cell_j < 0 || cell_k < 0 || cell_k >= cells_.level_count() || cell_j >= cells_.row_count(cell_k))
        continue;
      const int low = std::max(first, -cell.box[0]);
      const int high =
          std::min(end, cells_.count_in_row(cells_.kinds()[cell.kind], cell_j, cell_k) - cell.box[0]);
      const auto write = [&](int from_box, int to_box)
      {
        if (from_box >= to_box)
          return;
        const int node = order_ * from_box + remainder;
        apply_along<dim>(cell, {node, row.j, row.k}, to_box - from_box, from,
                         to + static_cast<std::ptrdiff_t>(dim) * (row.node + node - row.begin));
      };
      if (low >= high)
        continue;
      if (done_first >= done_end)
        write(low, high);
      else
      {
        write(low, std::min(high, done_first));
        write(std::max(low, done_end), high);
      }
      done_first = std::min(done_first, low);
      done_end = std::max(done_end, high);
    }
  }
}

void LatticeResampler::apply(std::span<const BlockPlan::Row> rows, int dim, const double* from,
                             double* to) const
{
  for (const BlockPlan::Row& row : rows)
    if (dim == 2)
      apply_to_row<2>(row, from, to);
    else
      apply_to_row<3>(row, from, to);
}

Resampling::Resampling(const Grid& nodes, int order, int diagonal)
    : rows_(inner_rows(nodes)),
      inside_(nodes, order, diagonal, LatticeResampler::Direction::to_warped, nodes.shape == Shape::prism)
{
  for (int side = 0; side < static_cast<int>(element::sides(nodes.shape).size()); ++side)
  {
    const Grid grid = side_grid(nodes, side);
    sides_.emplace_back(grid, order, 0, LatticeResampler::Direction::to_equal_steps,
                        keeps_last(nodes.shape, grid.shape));
    side_rows_.push_back(all_rows(grid));
    const SideFrame frame = side_frame(nodes, side);
    std::vector<std::int32_t>& indices = side_index_.emplace_back();
    for (int t = 0; t < row_count(grid, 0); ++t)
      for (int s = 0; s < row_length(grid, t, 0); ++s)
        indices.push_back(static_cast<std::int32_t>(index(nodes, frame.at(s, t))));
  }
}

void Resampling::side_to_equal_steps(int side, int dim, const double* from, double* to) const
{
  sides_[side].apply(side_rows_[side], dim, from, to);
}

void Resampling::to_warped(std::span<const BlockPlan::Row> rows, int dim, const double* lattice,
                           double* x) const
{
  inside_.apply(rows, dim, lattice, x);
}

void Resampling::scatter_side(int side, int dim, const double* from, double* lattice) const
{
  for (const std::int32_t at : side_index_[side])
    for (int c = 0; c < dim; ++c)
      lattice[static_cast<std::ptrdiff_t>(dim) * at + c] = *from++;
}

}  // namespace blockfsi::block
