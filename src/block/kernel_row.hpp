#pragma once

#include "block/kernel.hpp"
#include "core/lanes.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

/// What the kernels share: rows of nodes are computed eight nodes at a time, component by component as they
/// lie in memory, with the weights of a node repeated for each of its components. What is the same along a
/// row is formed once. The value of a node does not depend on where its row begins, so that shares of a mesh
/// agree bit for bit.
namespace blockfsi::block
{

/// The components of a point, repeated for eight nodes.
template <int dim>
using Repeated = std::array<Lanes, dim>;

template <int dim>
Repeated<dim> repeated(const double* point)
{
  Repeated<dim> result;
  const auto lanes_from = [point]<std::size_t... lane>(std::size_t first, std::index_sequence<lane...>)
  {
    return Lanes{point[(first + lane) % dim]...};
  };
  for (std::size_t m = 0; m < dim; ++m)
    result[m] = lanes_from(lane_count * m, std::make_index_sequence<lane_count>{});
  return result;
}

/// Reads eight numbers.
struct Load
{
  Lanes operator()(const double* from) const
  {
    Lanes result;
    std::memcpy(&result, from, sizeof(Lanes));
    return result;
  }
};

/// Reads fewer than eight numbers; the others are 0.
struct LoadPart
{
  std::size_t count;
  Lanes operator()(const double* from) const
  {
    Lanes result{};
    std::memcpy(&result, from, count * sizeof(double));
    return result;
  }
};

/// Copies the points of a line from its last to its first.
inline void reverse_points(const double* from, std::ptrdiff_t count, int dim, double* to)
{
  for (std::ptrdiff_t i = 0; i < count; ++i)
    std::copy_n(from + dim * (count - 1 - i), dim, to + dim * i);
}

/// Writes numbers one after the other: value(load, t, m) gives the components t to t + 8 of a row (dim for
/// each node) by reading with `load`; m is their place in Repeated.
template <int dim, typename Value>
[[gnu::always_inline]] inline void write_nodes(std::ptrdiff_t node_count, double* out, const Value& value)
{
  constexpr std::ptrdiff_t tile = static_cast<std::ptrdiff_t>(dim) * lane_count;
  const std::ptrdiff_t size = dim * node_count;
  if (size < tile)
  {
    for (int m = 0; lane_count * m < size; ++m)
    {
      const auto count =
          static_cast<std::size_t>(std::min<std::ptrdiff_t>(size - lane_count * m, lane_count));
      const Lanes part = value(LoadPart{count}, lane_count * m, m);
      std::memcpy(out + lane_count * m, &part, count * sizeof(double));
    }
    return;
  }
  // The last eight nodes may overlap those before.
  for (std::ptrdiff_t at = 0;; at = std::min(at + tile, size - tile))
  {
    for (int m = 0; m < dim; ++m)
    {
      const Lanes part = value(Load{}, at + lane_count * m, m);
      std::memcpy(out + at + lane_count * m, &part, sizeof(Lanes));
    }
    if (at == size - tile)
      return;
  }
}

/// Writes a row of nodes by `write_nodes`.
template <int dim, typename Value>
[[gnu::always_inline]] inline void write_row(const BoundaryData<dim>& at, const BlockPlan::Row& row,
                                             double* x, const Value& value)
{
  write_nodes<dim>(row.end - row.begin, x + static_cast<std::ptrdiff_t>(dim) * row.node, value);
  if (at.written != nullptr)
    at.written(at.listener, row);
}

/// Graded coordinates of the nodes of one row: the first one, and the others where they differ along the row,
/// repeated for each component. `alike`: they depend on the lines of the lattice only.
template <bool alike>
struct RowCoordinates
{
  std::array<const double*, 3> along{};
  std::array<double, 3> fixed{};

  /// Coordinate d of the components from t on.
  template <int d, typename Loader>
  auto get(Loader load, std::ptrdiff_t t) const
  {
    if constexpr (alike && d > 0)
      return fixed[d];
    else
      return load(along[d] + t);
  }
};

/// The graded coordinates of all rows, one after the other.
template <int dim, bool alike>
class Coordinates
{
public:
  static constexpr bool are_alike = alike;

  Coordinates(const BlockPlan& plan, double* work)
      : plan_(plan), count_(static_cast<std::size_t>(element::dimension(plan.grid.shape))),
        stored_(plan.reference.data())
  {
    const std::ptrdiff_t length = plan.grid.steps[0] + 1;
    for (std::size_t d = 0; d < count_; ++d)
      buffer_[d] = work + static_cast<std::ptrdiff_t>(d) * dim * length;
    if constexpr (alike)
      for (std::ptrdiff_t i = 0; i < length; ++i)
        std::fill_n(buffer_[0] + dim * i, dim, plan.lines[0][i]);
  }

  /// Coordinates of the lines of the first direction, shape (steps + 1, dim); null where there are none.
  const double* first_line() const { return alike ? buffer_[0] : nullptr; }

  RowCoordinates<alike> next(const BlockPlan::Row& row)
  {
    RowCoordinates<alike> result;
    if constexpr (alike)
    {
      result.along[0] = buffer_[0] + static_cast<std::ptrdiff_t>(dim) * row.begin;
      result.fixed[1] = line(1)[row.j];
      if (count_ == 3)
        result.fixed[2] = line(2)[row.k];
    }
    else
    {
      for (std::size_t d = 0; d < count_; ++d)
        result.along[d] = buffer_[d];
      for (std::ptrdiff_t i = 0; i < row.end - row.begin; ++i)
        for (std::size_t d = 0; d < count_; ++d)
          std::fill_n(buffer_[d] + dim * i, dim, *stored_++);
    }
    return result;
  }

private:
  /// All directions of a triangle, a tetrahedron or a pyramid have the same line.
  const std::vector<double>& line(std::size_t d) const
  {
    return plan_.lines[d].empty() ? plan_.lines[0] : plan_.lines[d];
  }

  const BlockPlan& plan_;
  std::size_t count_;
  const double* stored_;
  std::array<double*, 3> buffer_{};
};

/// Numbers that `with_coordinates` needs as working memory.
inline std::size_t coordinate_work(const BlockPlan& plan, int dim)
{
  return static_cast<std::size_t>(element::dimension(plan.grid.shape) * dim) *
         (static_cast<std::size_t>(plan.grid.steps[0]) + 1);
}

/// Calls place(coordinates, rest) with the coordinates of a plan and the working memory behind theirs.
template <int dim, typename Place>
void with_coordinates(const BlockPlan& plan, double* work, const Place& place)
{
  double* rest = work + coordinate_work(plan, dim);
  if (!plan.lines[0].empty())
    place(Coordinates<dim, true>(plan, work), rest);
  else
    place(Coordinates<dim, false>(plan, work), rest);
}

}  // namespace blockfsi::block
