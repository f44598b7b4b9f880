#include "block/resample.hpp"

#include "block/numbering.hpp"
#include "element/table.hpp"

namespace blockfsi::block
{

namespace
{

using element::LatticePoint;
using element::NodeKind;
using element::Shape;

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
    : nodes_(nodes), order_(order), cells_(coarse(nodes, order), order, diagonal)
{
  for (const CellKind& kind : cells_.kinds())
  {
    const std::vector<double> weights =
        keep_last ? product_matrix(kind.shape, order, direction) : matrix(kind.shape, order, direction);
    const std::size_t count = kind.nodes.size();
    std::vector<std::vector<Term>>& terms = terms_.emplace_back(count);
    for (std::size_t a = 0; a < count; ++a)
      for (std::size_t b = 0; b < count; ++b)
        if (weights[a * count + b] != 0.0)
          terms[a].push_back({kind.nodes[b], weights[a * count + b]});
  }
  for (int k = 0; k < level_count(nodes); ++k)
  {
    level_begin_.push_back(static_cast<std::int32_t>(row_begin_.size()));
    for (int j = 0; j < row_count(nodes, k); ++j)
      row_begin_.push_back(index(nodes, {0, j, k}));
  }
}

void LatticeResampler::apply(std::span<const BlockPlan::Row> rows, int dim, const double* from,
                             double* to) const
{
  for (const BlockPlan::Row& row : rows)
  {
    double* out = to + static_cast<std::ptrdiff_t>(dim) * row.node;
    for (int i = row.begin; i < row.end; ++i, out += dim)
    {
      const BlockCells::Found cell = cells_.find({i, row.j, row.k});
      for (int c = 0; c < dim; ++c)
        out[c] = 0.0;
      for (const Term& term : terms_[cell.kind][cell.local])
      {
        const std::int64_t line =
            level_begin_[order_ * cell.box[2] + term.offset[2]] + order_ * cell.box[1] + term.offset[1];
        const double* x = from + dim * (row_begin_[line] + order_ * cell.box[0] + term.offset[0]);
        for (int c = 0; c < dim; ++c)
          out[c] += term.weight * x[c];
      }
    }
  }
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
