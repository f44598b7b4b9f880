#include "block/blend.hpp"

#include "block/kernel.hpp"
#include "block/resample.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace blockfsi::block
{

namespace
{

using element::Shape;

/// Where a block's boundary lies in the working memory.
std::size_t boundary_size(const BlockPlan& plan)
{
  std::size_t nodes = 0;
  for (const auto& side : plan.sides)
    nodes += side.size();
  return nodes;
}

bool is_product(Shape shape)
{
  return shape == Shape::quadrilateral || shape == Shape::hexahedron;
}

/// Subtracts from the nodes of a side what the straight block has there, given the weights of its corners:
/// weights(r) for the graded coordinates r, shape (corners).
template <int dim, std::size_t corners, typename Weights>
void subtract_corners(const element::SideShape& side, const std::vector<double>& reference, int coordinates,
                      const std::array<std::array<double, dim>, 8>& corner, const Weights& weights, double* x)
{
  std::array<std::array<double, dim>, corners> at;
  for (std::size_t k = 0; k < corners; ++k)
    at[k] = corner[side.corners[k]];
  for (const double* r = reference.data(); r != reference.data() + reference.size();
       r += coordinates, x += dim)
  {
    const std::array<double, corners> w = weights(r);
    for (std::size_t k = 0; k < corners; ++k)
      for (int c = 0; c < dim; ++c)
        x[c] -= w[k] * at[k][c];
  }
}

/// Subtracts what the straight block has on a side, given the side's corners and the graded coordinates.
template <int dim>
void subtract_straight(const element::SideShape& side, const std::vector<double>& reference,
                       const std::array<std::array<double, dim>, 8>& corner, double* x)
{
  switch (side.shape)
  {
  case Shape::segment:
    return subtract_corners<dim, 2>(
        side, reference, 1, corner,
        [](const double* r) {
          return std::array{1.0 - r[0], r[0]};
        },
        x);
  case Shape::triangle:
    return subtract_corners<dim, 3>(
        side, reference, 2, corner,
        [](const double* r) {
          return std::array{1.0 - r[0] - r[1], r[0], r[1]};
        },
        x);
  default:
    return subtract_corners<dim, 4>(
        side, reference, 2, corner,
        [](const double* r) {
          return std::array{(1.0 - r[0]) * (1.0 - r[1]), r[0] * (1.0 - r[1]), r[0] * r[1],
                            (1.0 - r[0]) * r[1]};
        },
        x);
  }
}

template <int dim>
void place_rows(const BlockPlan& plan, std::span<const BlockPlan::Row> rows, const BoundaryData<dim>& at,
                double* x)
{
  if constexpr (dim == 3)
    switch (plan.grid.shape)
    {
    case Shape::hexahedron:
      return place_hexahedron(plan, rows, at, x);
    case Shape::prism:
      return place_prism(plan, rows, at, x);
    case Shape::tetrahedron:
      return place_tetrahedron(plan, rows, at, x);
    case Shape::pyramid:
      return place_pyramid(plan, rows, at, x);
    default:
      break;
    }
  if (plan.grid.shape == Shape::triangle)
    place_triangle(plan, rows, at, x);
  else
    place_quadrilateral(plan, rows, at, x);
}

/// Hands each row that a kernel has written on to be resampled.
struct Listener
{
  const double* x;
  ResampledRows* rows;

  static void take(void* self, const BlockPlan::Row& row)
  {
    const auto* listener = static_cast<const Listener*>(self);
    listener->rows->add(row, listener->x);
  }
};

/// Numbers of the longest row.
std::size_t row_size(const BlockPlan& plan, int dim)
{
  return static_cast<std::size_t>(dim) * (static_cast<std::size_t>(plan.grid.steps[0]) + 1);
}

/// Places a solid block at equal steps in each cell and takes its rows to warped nodes.
void place_resampled(const BlockPlan& plan, BoundaryData<3> boundary, double* x)
{
  double* row = boundary.work + kernel_work(plan, 3);
  ResampledRows rows(plan.resampling->inside(), plan.rows, row + row_size(plan, 3), x);
  Listener listener{row, &rows};
  boundary.written = &Listener::take;
  boundary.listener = &listener;
  place_rows<3>(plan, plan.resampling->lattice_rows(), boundary, row);
}

template <int dim>
void blend(const BlockPlan& plan, const double* skeleton_x, double* work, double* x)
{
  BoundaryData<dim> boundary;
  for (int k = 0; k < element::corner_count(plan.grid.shape); ++k)
    for (int c = 0; c < dim; ++c)
      boundary.corner[k][c] = skeleton_x[static_cast<std::ptrdiff_t>(dim) * plan.corners[k] + c];
  const Resampling* resampling = plan.resampling.get();
  const auto sides = element::sides(plan.grid.shape);
  double* spare = work + dim * boundary_size(plan);
  for (std::size_t side = 0; side < plan.sides.size(); ++side)
  {
    boundary.side[side] = work;
    double* to = resampling != nullptr ? spare : work;
    for (const std::int32_t node : plan.sides[side])
      for (int c = 0; c < dim; ++c)
        *to++ = skeleton_x[static_cast<std::ptrdiff_t>(dim) * node + c];
    if (resampling != nullptr)
      resampling->side_to_equal_steps(static_cast<int>(side), spare, to, work);
    if (!is_product(plan.grid.shape))
      subtract_straight<dim>(sides[side], plan.side_reference[side], boundary.corner, work);
    work += dim * plan.sides[side].size();
  }
  boundary.work = work;
  if constexpr (dim == 3)
    if (resampling != nullptr)
      return place_resampled(plan, boundary, x);
  place_rows<dim>(plan, plan.rows, boundary, x);
}

}  // namespace

std::size_t work_size(const BlockPlan& plan, int dim)
{
  std::size_t largest_side = 0;
  for (const auto& side : plan.sides)
    largest_side = std::max(largest_side, side.size());
  std::size_t after_sides = kernel_work(plan, dim);
  // Before the kernel runs, its memory serves to resample the sides.
  if (plan.resampling)
    after_sides = plan.resampling->work_size() +
                  std::max(after_sides + row_size(plan, dim), static_cast<std::size_t>(dim) * largest_side);
  return static_cast<std::size_t>(dim) * boundary_size(plan) + after_sides;
}

void blend(const BlockPlan& plan, int dim, const double* skeleton_x, double* work, double* x)
{
  if (plan.rows.empty())
    return;
  if (dim == 2)
    blend<2>(plan, skeleton_x, work, x);
  else
    blend<3>(plan, skeleton_x, work, x);
}

}  // namespace blockfsi::block
