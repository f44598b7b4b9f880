#include "block/resample.hpp"

#include "block/kernel_row.hpp"
#include "block/numbering.hpp"
#include "core/lanes.hpp"
#include "element/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

namespace blockfsi::block
{

namespace
{

using element::LatticePoint;
using element::NodeKind;
using element::Shape;

/// Only solid blocks are resampled.
constexpr int dim = 3;

/// Weights below this are those of nodes that have none: cells have few nodes, and all weights are of size 1.
constexpr double rounding = 1e-13;

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
  int first = wanted.front().k;
  int last = wanted.back().k;
  if (nodes.shape != Shape::prism)  // every level of a prism stands for itself
  {
    first = (first - 1) / order * order;
    last = (last + order - 1) / order * order;
  }
  for (BlockPlan::Row row : all_rows(nodes))
    if (row.k >= first && row.k <= last)
    {
      row.node = 0;
      rows.push_back(row);
    }
  return rows;
}

/// Copies a point, or what two registers hold of it and the number behind.
template <int count>
void copy_numbers(const double* from, double* to)
{
  std::array<double, count> point;
  std::memcpy(point.data(), from, sizeof(point));
  std::memcpy(to, point.data(), sizeof(point));
}

/// Numbers of the widest copy that is made for a point before others follow it: one register.
constexpr int with_next = 4;

/// Copies every `step`th point to points that follow each other.
void gather_points(const double* from, std::ptrdiff_t step, std::ptrdiff_t count, double* to)
{
  for (; count > 1; --count, from += dim * step, to += dim)
    copy_numbers<with_next>(from, to);
  if (count == 1)
    copy_numbers<dim>(from, to);
}

/// Copies the nodes from `begin` to `end` of a row from runs that lie `width` points apart.
void join_runs(const double* runs, std::ptrdiff_t width, int order, int begin, int end, double* to)
{
  const std::ptrdiff_t run_size = dim * width;
  int run = begin % order;
  const double* box = runs + dim * (begin / order);
  for (int i = begin; i < end - 1; ++i, to += dim)
  {
    copy_numbers<with_next>(box + run * run_size, to);
    if (++run == order)
    {
      run = 0;
      box += dim;
    }
  }
  if (begin < end)
    copy_numbers<dim>(box + run * run_size, to);
}

/// The boxes with the nodes from `begin` to `end` of a row, for each of its runs.
struct Boxes
{
  Boxes(const BlockPlan::Row& row, int order)
      : first_(row.begin / order), first_run_(row.begin % order), end_(row.end / order),
        end_run_(row.end % order)
  {
  }
  int first(int run) const { return first_ + (run < first_run_ ? 1 : 0); }
  int end(int run) const { return end_ + (run < end_run_ ? 1 : 0); }
  int count(int run) const { return end(run) - first(run); }

private:
  int first_;
  int first_run_;
  int end_;
  int end_run_;
};

/// What registers may hold behind the numbers that they are used for.
constexpr std::ptrdiff_t spare = 2 * lane_count;

/// Sums of weight_q x[place_q] for some registers.
template <std::size_t count, typename Terms>
std::array<Lanes, count> weighted_sums(const Terms& terms, std::size_t parity, const double* x)
{
  std::array<Lanes, count> sum{};
  for (const auto& term : terms)
    for (std::size_t m = 0; m < count; ++m)
      sum[m] += term.weight * Load{}(x + dim * term.place[parity] + lane_count * m);
  return sum;
}

/// Writes sum_q weight_q x[place_q], shape (size); reads up to `spare` numbers more of each, and unless told
/// to write exactly these writes as many more.
template <typename Terms>
void add_up(const Terms& terms, std::size_t parity, const double* x, std::ptrdiff_t size, bool exactly,
            double* to)
{
  const auto write = [&]<std::size_t count>(std::ptrdiff_t from, std::integral_constant<std::size_t, count>)
  {
    const std::array<Lanes, count> sum = weighted_sums<count>(terms, parity, x + from);
    if (exactly)
      std::memcpy(to + from, sum.data(), std::min(sizeof(sum), sizeof(double) * (size - from)));
    else
      std::memcpy(to + from, sum.data(), sizeof(sum));
  };
  std::ptrdiff_t from = 0;
  for (; size - from > 4 * lane_count; from += 6 * lane_count)
    write(from, std::integral_constant<std::size_t, 6>{});
  if (size - from > 2 * lane_count)
    write(from, std::integral_constant<std::size_t, 4>{});
  else if (size - from > lane_count)
    write(from, std::integral_constant<std::size_t, 2>{});
  else if (size > from)
    write(from, std::integral_constant<std::size_t, 1>{});
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
      candidates_(static_cast<std::size_t>(order) * order * order), run_size_(nodes.steps[0] / order + 1),
      row_size_(order * run_size_), plane_size_(layered_ == 2 ? row_size_ * (nodes.steps[1] + 1) : row_size_)
{
  std::vector<std::vector<double>> weights;
  for (const CellKind& kind : cells_.kinds())
    weights.push_back(keep_last ? product_matrix(kind.shape, order, direction)
                                : matrix(kind.shape, order, direction));
  find_candidates(weights);
}

std::vector<LatticeResampler::Term> LatticeResampler::terms_of(const std::vector<LatticePoint>& all,
                                                               const LatticePoint& node,
                                                               const double* weights) const
{
  // Nodes between two layers take nothing from within either of them.
  const bool between_layers = node[layered_] % order_ == 0;
  std::vector<Term> terms;
  for (const LatticePoint& p : all)
  {
    const double weight = *weights++;
    if (std::abs(weight) < rounding || (between_layers && p[layered_] != node[layered_]))
      continue;
    const std::ptrdiff_t in_plane =
        (layered_ == 2 ? p[1] * row_size_ : 0) + p[0] % order_ * run_size_ + p[0] / order_;
    terms.push_back(
        {weight, {in_plane + p[layered_] * plane_size_, in_plane + (order_ - p[layered_]) * plane_size_}});
  }
  return terms;
}

void LatticeResampler::find_candidates(const std::vector<std::vector<double>>& weights)
{
  for (std::size_t remainders = 0; remainders < candidates_.size(); ++remainders)
  {
    const int at = static_cast<int>(remainders);
    const LatticePoint remainder{at % order_, at / order_ % order_, at / order_ / order_};
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
            const double* row =
                weights[q].data() + (found - all.begin()) * static_cast<std::ptrdiff_t>(all.size());
            candidates_[remainders].push_back({{i, j, k}, q, terms_of(all, local, row)});
          }
  }
}

std::ptrdiff_t LatticeResampler::row_place(int j, int k) const
{
  const int plane = layered_ == 2 ? k : j;
  const int in_layer = plane % order_;
  const int slot = plane / order_ % 2 == 0 ? in_layer : order_ - in_layer;
  return slot * plane_size_ + (layered_ == 2 ? j * row_size_ : 0);
}

/// Lanes are read and written past the last number of a layer and of a run.
std::size_t resampling_work(const LatticeResampler& resampler)
{
  const std::ptrdiff_t nodes = resampler.plane_size_ * (resampler.order_ + 1) + resampler.row_size_;
  return static_cast<std::size_t>(dim * nodes + 2 * spare);
}

ResampledRows::ResampledRows(const LatticeResampler& resampler, std::span<const BlockPlan::Row> wanted,
                             double* work, double* to)
    : by_(resampler), wanted_(wanted), layer_(work),
      runs_(work + dim * resampler.plane_size_ * (resampler.order_ + 1) + spare), to_(to)
{
  look_ahead();
}

void ResampledRows::look_ahead()
{
  if (wanted_.empty())
    return;
  const BlockPlan::Row& row = wanted_.front();
  const auto top = [&](int i) { return (i + by_.order_ - 1) / by_.order_ * by_.order_; };
  if (by_.layered_ == 2)
    complete_after_ = {top(row.k), row_count(by_.nodes_, top(row.k)) - 1};
  else
    complete_after_ = {row.k, top(row.j)};
}

void ResampledRows::add(const BlockPlan::Row& row, const double* x)
{
  double* to = layer_ + dim * by_.row_place(row.j, row.k);
  for (int run = 0; run < by_.order_; ++run, to += dim * by_.run_size_)
    gather_points(x + dim * run, by_.order_, Boxes(row, by_.order_).count(run), to);
  for (; !wanted_.empty() && std::pair(row.k, row.j) >= complete_after_; look_ahead())
  {
    write(wanted_.front());
    wanted_ = wanted_.subspan(1);
  }
}

/// The nodes in `count` cells of one kind that follow each other from a box on.
void ResampledRows::write_run(const LatticeResampler::Candidate& cell, const LatticePoint& box, int count,
                              bool exactly, double* to) const
{
  const std::ptrdiff_t row = by_.layered_ == 2 ? by_.order_ * box[1] * by_.row_size_ : 0;
  const double* from = layer_ + dim * (box[0] + row);
  const std::size_t parity = static_cast<std::size_t>(box[by_.layered_]) % 2;
  add_up(cell.terms, parity, from, dim * static_cast<std::ptrdiff_t>(count), exactly, to);
}

/// Each node lies in the first of its candidates that exists; along the row each of them exists for boxes
/// that follow each other, and those that an earlier one has are in their middle.
void ResampledRows::write(const BlockPlan::Row& row) const
{
  const int order = by_.order_;
  const int j = row.j / order;
  const int k = row.k / order;
  const Boxes boxes(row, order);
  const auto* candidates = &by_.candidates_[order * (row.j % order + order * (row.k % order))];
  double* to = runs_;
  for (int run = 0; run < order; ++run, to += dim * by_.run_size_)
  {
    const int first = boxes.first(run);
    const int end = boxes.end(run);
    int done_first = end;
    int done_end = first;
    for (const auto& cell : candidates[run])
    {
      const int cell_j = j + cell.box[1];
      const int cell_k = k + cell.box[2];
      if (cell_j < 0 || cell_k < 0 || cell_k >= by_.cells_.level_count() ||
          cell_j >= by_.cells_.row_count(cell_k))
        continue;
      const int low = std::max(first, -cell.box[0]);
      const int high =
          std::min(end, by_.cells_.count_in_row(by_.cells_.kinds()[cell.kind], cell_j, cell_k) - cell.box[0]);
      // What lies behind is written later, unless it is done.
      const auto write_boxes = [&](int from_box, int to_box)
      {
        if (from_box < to_box)
          write_run(cell, {from_box + cell.box[0], cell_j, cell_k}, to_box - from_box,
                    to_box <= done_first && done_first < done_end, to + dim * from_box);
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
      if (done_first <= first && done_end >= end)
        break;
    }
  }
  join_runs(runs_, by_.run_size_, order, row.begin, row.end,
            to_ + static_cast<std::ptrdiff_t>(dim) * row.node);
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

void Resampling::side_to_equal_steps(int side, const double* from, double* work, double* to) const
{
  ResampledRows rows(sides_[side], side_rows_[side], work, to);
  for (const BlockPlan::Row& row : side_rows_[side])
    rows.add(row, from + static_cast<std::ptrdiff_t>(dim) * row.node);
}

std::size_t Resampling::work_size() const
{
  std::size_t result = resampling_work(inside_);
  for (const LatticeResampler& side : sides_)
    result = std::max(result, resampling_work(side));
  return result;
}

}  // namespace blockfsi::block
