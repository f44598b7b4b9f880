#include "block/kernel.hpp"

#include "block/kernel_row.hpp"
#include "block/triangle_nodes.hpp"
#include "element/nodes.hpp"

#include <cstddef>
#include <utility>

namespace blockfsi::block
{

namespace
{

/// Nodes after which rows take the edges alike again: 1 where the edges have nodes for all.
std::ptrdiff_t period(const BlockPlan& plan)
{
  return plan.triangle_nodes ? plan.triangle_nodes->order() : 1;
}

/// What the rows with one remainder of their number by the period take along the edges of a triangle, shapes
/// (n + 1, dim): at u and, counted from where their boxes begin, at u + v.
struct AlongEdges
{
  const double* first01 = nullptr;
  const double* sum01 = nullptr;
  const double* sum02 = nullptr;
  const double* rest21 = nullptr;
  const double* u = nullptr;  ///< graded coordinate, repeated for each component; null if not of lines

  /// The same from where a row begins in numbers, with boxes that begin at `box` across.
  AlongEdges from(std::ptrdiff_t begin, std::ptrdiff_t box) const
  {
    return {first01 + begin, sum01 + begin + box, sum02 + begin + box, rest21 + begin,
            u == nullptr ? nullptr : u + begin};
  }
};

/// A point of an edge and a corner, repeated.
template <int dim>
Repeated<dim> sum(const double* point, const std::array<double, dim>& corner)
{
  std::array<double, dim> x = corner;
  for (int c = 0; c < dim; ++c)
    x[c] += point[c];
  return repeated<dim>(x.data());
}

/// `AlongEdges` for each remainder.
template <int dim>
class TriangleEdges
{
public:
  ///   u: graded coordinate of the lines, shape (n + 1, dim), or null;  memory, shape (size)
  TriangleEdges(const BlockPlan& plan, const BoundaryData<dim>& at, const double* u, double* memory)
      : nodes_(plan.triangle_nodes.get()), n_(plan.grid.steps[0]), memory_(memory)
  {
    double* e21 = next();
    reverse_points(at.side[1], n_ + 1, dim, e21);
    rows_[0] = {at.side[0], at.side[0], at.side[2], e21, u};
    for (std::ptrdiff_t row = 1; row < period(plan); ++row)
    {
      const auto along = [&](Coordinate coordinate, const double* edge)
      {
        double* to = next();
        nodes_->along_row<dim>(coordinate, row, edge, n_, to);
        return to;
      };
      rows_[row] = {along(Coordinate::u, at.side[0]), along(Coordinate::sum, at.side[0]),
                    along(Coordinate::sum, at.side[2]), along(Coordinate::u, e21),
                    u == nullptr ? nullptr : along(Coordinate::u, u)};
    }
  }

  const AlongEdges& row(std::ptrdiff_t remainder) const { return rows_[remainder]; }

  static std::size_t size(const BlockPlan& plan)
  {
    return static_cast<std::size_t>(dim * (plan.grid.steps[0] + 1) * (5 * period(plan) - 4));
  }

private:
  using Coordinate = TriangleNodes::Coordinate;

  double* next() { return std::exchange(memory_, memory_ + dim * (n_ + 1)); }

  const TriangleNodes* nodes_;
  std::ptrdiff_t n_;
  double* memory_;
  std::array<AlongEdges, element::largest_order> rows_;
};

/// What an edge gives across a row of nodes: one point of it, or as many as a box has nodes, again and again.
template <int dim>
class AcrossEdge
{
public:
  ///   memory, shape (size)
  AcrossEdge(const BlockPlan& plan, double* memory)
      : nodes_(plan.triangle_nodes.get()), count_(dim * period(plan)), points_(memory)
  {
  }

  static std::size_t size(const BlockPlan& plan) { return dim * period(plan) + lane_count; }

  /// Sets the points of a row that is not the first in its boxes.
  ///   edge: nodes from where the boxes begin
  void set(const BlockPlan::Row& row, const double* edge, const std::array<double, dim>& added)
  {
    nodes_->across<dim>(row.j % nodes_->order(), edge, points_);
    for (std::ptrdiff_t i = 0; i < count_; ++i)
      points_[i] += added[i % dim];
    for (std::ptrdiff_t i = 0; i < lane_count; ++i)
      points_[count_ + i] = points_[i % count_];
    begin_ = dim * row.begin;
  }

  template <typename Loader>
  Lanes get(Loader load, std::ptrdiff_t t) const
  {
    return load(points_ + static_cast<std::uint32_t>(begin_ + t) % static_cast<std::uint32_t>(count_));
  }

private:
  const TriangleNodes* nodes_;
  std::ptrdiff_t count_;
  std::ptrdiff_t begin_ = 0;
  double* points_;
};

}  // namespace

/// The straight triangle and the parallel form sum_i w_i (E_ij(w_j) + E_ik(w_k)) of the differences E along
/// its edges (0, 1), (1, 2), (0, 2), which takes the three at u and u + v, v and 1 - u, v and u + v.
template <int dim>
void place_triangle(const BlockPlan& plan, std::span<const BlockPlan::Row> rows, const BoundaryData<dim>& at,
                    double* x)
{
  const auto place = [&](auto coordinates, double* work)
  {
    constexpr bool alike = decltype(coordinates)::are_alike;
    const std::ptrdiff_t box_size = period(plan);
    const TriangleEdges<dim> edges(plan, at, coordinates.first_line(), work);
    work += TriangleEdges<dim>::size(plan);
    const std::ptrdiff_t size = AcrossEdge<dim>::size(plan);
    AcrossEdge<dim> across0(plan, work);
    AcrossEdge<dim> across1(plan, work + size);
    AcrossEdge<dim> across_line(plan, work + 2 * size);
    const Repeated<dim> corner2 = repeated<dim>(at.corner[2].data());
    for (const BlockPlan::Row& row : rows)
    {
      const RowCoordinates<alike> r = coordinates.next(row);
      const std::ptrdiff_t in_box = row.j % box_size;
      const std::ptrdiff_t box = static_cast<std::ptrdiff_t>(dim) * (row.j - in_box);
      const std::ptrdiff_t begin = static_cast<std::ptrdiff_t>(dim) * row.begin;
      const AlongEdges along = edges.row(in_box).from(begin, box);
      const auto blend = [&](auto load, std::ptrdiff_t t, int m, const Lanes& u, const auto& v,
                             const Lanes& point0, const Lanes& point1) -> Lanes
      {
        return (1.0 - v - u) * (load(along.first01 + t) + point0) + u * (load(along.sum01 + t) + point1) +
               v * (load(along.sum02 + t) + load(along.rest21 + t) + corner2[m]);
      };
      if (in_box == 0)
      {
        const Repeated<dim> point0 = sum<dim>(at.side[2] + box, at.corner[0]);
        const Repeated<dim> point1 = sum<dim>(at.side[1] + box, at.corner[1]);
        write_row<dim>(at, row, x,
                       [&](auto load, std::ptrdiff_t t, int m) {
                         return blend(load, t, m, r.template get<0>(load, t), r.template get<1>(load, t),
                                      point0[m], point1[m]);
                       });
        continue;
      }
      across0.set(row, at.side[2] + box, at.corner[0]);
      across1.set(row, at.side[1] + box, at.corner[1]);
      if constexpr (alike)
        across_line.set(row, coordinates.first_line() + box, {});
      const auto value = [&](auto load, std::ptrdiff_t t, int m) -> Lanes
      {
        const Lanes point0 = across0.get(load, t);
        const Lanes point1 = across1.get(load, t);
        if constexpr (alike)
          return blend(load, t, m, load(along.u + t), across_line.get(load, t), point0, point1);
        else
          return blend(load, t, m, r.template get<0>(load, t), r.template get<1>(load, t), point0, point1);
      };
      write_row<dim>(at, row, x, value);
    }
  };
  with_coordinates<dim>(plan, at.work, place);
}

template void place_triangle<2>(const BlockPlan&, std::span<const BlockPlan::Row>, const BoundaryData<2>&,
                                double*);
template void place_triangle<3>(const BlockPlan&, std::span<const BlockPlan::Row>, const BoundaryData<3>&,
                                double*);

std::size_t triangle_work(const BlockPlan& plan, int dim)
{
  return dim == 2 ? TriangleEdges<2>::size(plan) + 3 * AcrossEdge<2>::size(plan)
                  : TriangleEdges<3>::size(plan) + 3 * AcrossEdge<3>::size(plan);
}

}  // namespace blockfsi::block
