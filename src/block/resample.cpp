#include "block/resample.hpp"

#include "block/kernel_row.hpp"
#include "block/numbering.hpp"
#include "core/lanes.hpp"
#include "element/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

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

/// Direction in which layers of cells follow each other that have only the nodes between them in common.
int layered(Shape shape)
{
  return shape == Shape::tetrahedron || shape == Shape::pyramid ? 2 : 1;
}

/// The rows of all layers that have wanted ones.
std::vector<BlockPlan::Row> rows_of_layers(const Grid& nodes, int order,
                                           std::span<const BlockPlan::Row> wanted)
{
  std::vector<BlockPlan::Row> rows;
  if (wanted.empty())
    return rows;
  const auto place = [&](const BlockPlan::Row& row) { return nodes.steps[2] > 0 ? row.k : row.j; };
  int first = place(wanted.front());
  int last = place(wanted.back());
  if (nodes.shape != Shape::prism)  // every level of a prism stands for itself
  {
    first = (first - 1) / order * order;
    last = (last + order - 1) / order * order;
  }
  for (BlockPlan::Row row : all_rows(nodes))
    if (place(row) >= first && place(row) <= last)
    {
      row.node = 0;
      rows.push_back(row);
    }
  return rows;
}

/// Calls move(place in the runs, place in the row) for the nodes from `begin` to `end` of a row whose runs
/// have room for `width` nodes each; places are those of the first component, in the row counted from
/// `begin`.
template <typename Move>
void move_runs(int dim, int order, int width, int begin, int end, const Move& move)
{
  for (int remainder = 0; remainder < order; ++remainder)
  {
    const int first = std::max(0, (begin - remainder + order - 1) / order);
    std::ptrdiff_t in_run = static_cast<std::ptrdiff_t>(dim) * (remainder * width + first);
    const std::ptrdiff_t step = static_cast<std::ptrdiff_t>(dim) * order;
    const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(dim) * (end - begin);
    for (std::ptrdiff_t in_row = dim * (order * first + remainder - begin); in_row < size; in_row += step)
    {
      move(in_run, in_row);
      in_run += dim;
    }
  }
}

struct Source
{
  const double* x;
  double weight;
};

/// Writes sum_q weight_q x_q, shape (size); reads up to seven numbers more of each.
void add_up(std::span<const Source> sources, std::ptrdiff_t size, double* to)
{
  constexpr std::size_t at_once = 4;
  constexpr std::ptrdiff_t tile = at_once * lane_count;
  std::ptrdiff_t t = 0;
  for (; t + tile <= size; t += tile)
  {
    std::array<Lanes, at_once> sum{};
    for (const Source& source : sources)
      for (std::size_t m = 0; m < at_once; ++m)
        sum[m] += source.weight * Load{}(source.x + t + lane_count * m);
    std::memcpy(to + t, sum.data(), sizeof(sum));
  }
  for (; t < size; t += lane_count)
  {
    Lanes sum{};
    for (const Source& source : sources)
      sum += source.weight * Load{}(source.x + t);
    std::memcpy(to + t, &sum, sizeof(double) * std::min<std::ptrdiff_t>(size - t, lane_count));
  }
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
    : nodes_(nodes), order_(order), layered_(layered(nodes.shape)),
      cells_(coarse(nodes, order), order, diagonal),
      candidates_(static_cast<std::size_t>(order) * order * order)
{
  std::vector<std::vector<double>> weights;
  for (const CellKind& kind : cells_.kinds())
    weights.push_back(keep_last ? product_matrix(kind.shape, order, direction)
                                : matrix(kind.shape, order, direction));
  find_candidates(weights);
  lay_out_rows();
}

void LatticeResampler::find_candidates(const std::vector<std::vector<double>>& weights)
{
  for (std::size_t remainders = 0; remainders < candidates_.size(); ++remainders)
  {
    const int at = static_cast<int>(remainders);
    const LatticePoint remainder{at % order_, at / order_ % order_, at / order_ / order_};
    const bool between_layers = remainder[layered_] == 0;
    // Boxes before the node's own one have it only where it lies between them.
    for (int k = remainder[2] == 0 ? -1 : 0; k <= 0; ++k)
      for (int j = remainder[1] == 0 ? -1 : 0; j <= 0; ++j)
        for (int i = remainder[0] == 0 ? -1 : 0; i <= 0; ++i)
          for (std::size_t q = 0; q < weights.size(); ++q)
          {
            const std::vector<LatticePoint>& all = cells_.kinds()[q].nodes;
            const LatticePoint local{remainder[0] - order_ * i, remainder[1] - order_ * j,
                                     remainder[2] - order_ * k};
            const auto found = std::find(all.begin(), all.end(), local);
            if (found == all.end())
              continue;
            Candidate candidate{{i, j, k}, q, {}};
            const double* row =
                weights[q].data() + (found - all.begin()) * static_cast<std::ptrdiff_t>(all.size());
            // Nodes between two layers take nothing from within either of them.
            for (std::size_t b = 0; b < all.size(); ++b)
              if (std::abs(row[b]) > rounding && !(between_layers && all[b][layered_] != local[layered_]))
                candidate.terms.push_back({all[b], row[b]});
            candidates_[remainders].push_back(std::move(candidate));
          }
  }
}

/// Of the levels, or rows of a level, one layer of cells has order + 1: each takes the memory of the one that
/// lies order + 1 before it.
void LatticeResampler::lay_out_rows()
{
  const auto width = [&](int j, int k) { return (row_length(nodes_, j, k) + order_ - 1) / order_; };
  std::int32_t row_size = 0;
  std::int32_t level_size = 0;
  for (int k = 0; k < level_count(nodes_); ++k)
  {
    std::int32_t sum = 0;
    for (int j = 0; j < row_count(nodes_, k); ++j)
    {
      row_size = std::max(row_size, order_ * width(j, k));
      sum += order_ * width(j, k);
    }
    level_size = std::max(level_size, sum);
  }
  for (int k = 0; k < level_count(nodes_); ++k)
  {
    level_begin_.push_back(static_cast<std::int32_t>(kept_.size()));
    std::int32_t place = k % (order_ + 1) * level_size;
    for (int j = 0; j < row_count(nodes_, k); ++j)
    {
      kept_.push_back({layered_ == 2 ? place : j % (order_ + 1) * row_size, width(j, k)});
      place += order_ * width(j, k);
    }
  }
  row_size_ = static_cast<std::size_t>(row_size);
  layer_size_ = static_cast<std::size_t>(layered_ == 2 ? level_size : row_size) *
                (static_cast<std::size_t>(order_) + 1);
}

ResampledRows::ResampledRows(const LatticeResampler& resampler, std::span<const BlockPlan::Row> wanted,
                             int dim, double* work, double* to)
    : by_(resampler), wanted_(wanted), dim_(dim), layer_(work),
      runs_(work + dim * resampler.layer_size_ + lane_count), to_(to)
{
}

/// Lanes are read past the last number of a layer.
std::size_t ResampledRows::work_size(const LatticeResampler& resampler, int dim)
{
  return static_cast<std::size_t>(dim) * (resampler.layer_size_ + resampler.row_size_) + lane_count;
}

bool ResampledRows::is_complete(const BlockPlan::Row& wanted, const BlockPlan::Row& last) const
{
  const auto top = [&](int i) { return (i + by_.order_ - 1) / by_.order_ * by_.order_; };
  if (by_.layered_ == 2)
    return std::pair(top(wanted.k), row_count(by_.nodes_, top(wanted.k)) - 1) <= std::pair(last.k, last.j);
  return std::pair(wanted.k, top(wanted.j)) <= std::pair(last.k, last.j);
}

void ResampledRows::add(const BlockPlan::Row& row, const double* x)
{
  const LatticeResampler::Kept& kept = by_.kept(row.j, row.k);
  move_runs(dim_, by_.order_, kept.width, 0, row_length(by_.nodes_, row.j, row.k),
            [&](std::ptrdiff_t in_run, std::ptrdiff_t in_row)
            { std::copy_n(x + in_row, dim_, layer_ + dim_ * kept.begin + in_run); });
  for (; !wanted_.empty() && is_complete(wanted_.front(), row); wanted_ = wanted_.subspan(1))
    write(wanted_.front());
}

/// Nodes first, first + order, ... along a row, `count` of them, which lie in cells of one kind.
void ResampledRows::write_run(const LatticeResampler::Candidate& cell, const LatticePoint& first, int count,
                              double* run) const
{
  const int order = by_.order_;
  const LatticePoint box{first[0] / order + cell.box[0], first[1] / order + cell.box[1],
                         first[2] / order + cell.box[2]};
  std::array<Source, max_terms> sources;
  for (std::size_t q = 0; q < cell.terms.size(); ++q)
  {
    const LatticeResampler::Term& term = cell.terms[q];
    const LatticeResampler::Kept& row =
        by_.kept(order * box[1] + term.offset[1], order * box[2] + term.offset[2]);
    const int i = order * box[0] + term.offset[0];
    sources[q] = {layer_ +
                      static_cast<std::ptrdiff_t>(dim_) * (row.begin + i % order * row.width + i / order),
                  term.weight};
  }
  add_up({sources.data(), cell.terms.size()}, static_cast<std::ptrdiff_t>(dim_) * count, run);
}

/// Each node lies in the first of its candidates that exists; along the row each of them exists for boxes
/// that follow each other, and those that an earlier one has are in their middle.
void ResampledRows::write(const BlockPlan::Row& row) const
{
  const int order = by_.order_;
  const int j = row.j / order;
  const int k = row.k / order;
  const int width = by_.kept(row.j, row.k).width;
  for (int remainder = 0; remainder < order; ++remainder)
  {
    const int first = std::max(0, (row.begin - remainder + order - 1) / order);
    const int end = (row.end - remainder + order - 1) / order;
    int done_first = end;
    int done_end = first;
    for (const auto& cell : by_.candidates_[remainder + order * (row.j % order + order * (row.k % order))])
    {
      const int cell_j = j + cell.box[1];
      const int cell_k = k + cell.box[2];
      if (cell_j < 0 || cell_k < 0 || cell_k >= by_.cells_.level_count() ||
          cell_j >= by_.cells_.row_count(cell_k))
        continue;
      const int low = std::max(first, -cell.box[0]);
      const int high =
          std::min(end, by_.cells_.count_in_row(by_.cells_.kinds()[cell.kind], cell_j, cell_k) - cell.box[0]);
      const auto write_boxes = [&](int from_box, int to_box)
      {
        if (from_box < to_box)
          write_run(cell, {order * from_box + remainder, row.j, row.k}, to_box - from_box,
                    runs_ + static_cast<std::ptrdiff_t>(dim_) * (remainder * width + from_box));
      };
      if (low >= high)
        continue;
      if (done_first >= done_end)
        write_boxes(low, high);
      else
      {
        write_boxes(low, std::min(high, done_first));
        write_boxes(std::max(low, done_end), high);
      }
      done_first = std::min(done_first, low);
      done_end = std::max(done_end, high);
    }
  }
  double* to = to_ + static_cast<std::ptrdiff_t>(dim_) * row.node;
  move_runs(dim_, order, width, row.begin, row.end,
            [&](std::ptrdiff_t in_run, std::ptrdiff_t in_row)
            { std::copy_n(runs_ + in_run, dim_, to + in_row); });
}

Resampling::Resampling(const Grid& nodes, int order, int diagonal, std::span<const BlockPlan::Row> wanted)
    : inside_(nodes, order, diagonal, LatticeResampler::Direction::to_warped, nodes.shape == Shape::prism)
{
  rows_ = rows_of_layers(nodes, order, wanted);
  for (int side = 0; side < static_cast<int>(element::sides(nodes.shape).size()); ++side)
  {
    const Grid grid = side_grid(nodes, side);
    sides_.emplace_back(grid, order, 0, LatticeResampler::Direction::to_equal_steps,
                        keeps_last(nodes.shape, grid.shape));
    side_rows_.push_back(all_rows(grid));
  }
}

void Resampling::side_to_equal_steps(int side, int dim, const double* from, double* work, double* to) const
{
  ResampledRows rows(sides_[side], side_rows_[side], dim, work, to);
  for (const BlockPlan::Row& row : side_rows_[side])
    rows.add(row, from + static_cast<std::ptrdiff_t>(dim) * row.node);
}

std::size_t Resampling::work_size(int dim) const
{
  std::size_t result = ResampledRows::work_size(inside_, dim);
  for (const LatticeResampler& side : sides_)
    result = std::max(result, ResampledRows::work_size(side, dim));
  return result;
}

}  // namespace blockfsi::block
