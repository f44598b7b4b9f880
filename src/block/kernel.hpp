#pragma once

#include "block/plan.hpp"

#include <array>
#include <span>

namespace blockfsi::block
{

/// Coordinates on the boundary of a block.
template <int dim>
struct BoundaryData
{
  /// Of the nodes of each side, in the order of its lattice, shape (size of the side, dim) [m]. For
  /// quadrilaterals and hexahedra the coordinates, for all others what they differ by from the block with
  /// straight edges.
  std::array<const double*, 6> side{};
  std::array<std::array<double, dim>, 8> corner{};  ///< coordinates [m]
  double* work = nullptr;                           ///< memory for `kernel_work` numbers
  /// Where given, called after each row is written, with `listener`.
  void (*written)(void* listener, const BlockPlan::Row& row) = nullptr;
  void* listener = nullptr;
};

/// Numbers that the kernels need as working memory besides the boundary.
std::size_t kernel_work(const BlockPlan& plan, int dim);

/// The transfinite maps of formulation.md 1: coordinates of the nodes in `rows`, in whose order
/// plan.reference is, written to x at Row::node. Rows may lie on the boundary.
template <int dim>
void place_quadrilateral(const BlockPlan& plan, std::span<const BlockPlan::Row> rows,
                         const BoundaryData<dim>& at, double* x);
template <int dim>
void place_triangle(const BlockPlan& plan, std::span<const BlockPlan::Row> rows, const BoundaryData<dim>& at,
                    double* x);
void place_hexahedron(const BlockPlan& plan, std::span<const BlockPlan::Row> rows, const BoundaryData<3>& at,
                      double* x);
void place_prism(const BlockPlan& plan, std::span<const BlockPlan::Row> rows, const BoundaryData<3>& at,
                 double* x);
void place_tetrahedron(const BlockPlan& plan, std::span<const BlockPlan::Row> rows, const BoundaryData<3>& at,
                       double* x);
void place_pyramid(const BlockPlan& plan, std::span<const BlockPlan::Row> rows, const BoundaryData<3>& at,
                   double* x);

/// Memory of the kernels besides that of the coordinates.
std::size_t triangle_work(const BlockPlan& plan, int dim);
std::size_t hexahedron_work(const BlockPlan& plan);
std::size_t prism_work(const BlockPlan& plan);
std::size_t tetrahedron_work(const BlockPlan& plan);
std::size_t pyramid_work(const BlockPlan& plan);

/// Where a row begins in the lattice of a triangle with n steps.
inline std::ptrdiff_t triangle_row(std::ptrdiff_t n, std::ptrdiff_t j)
{
  return j * (n + 1) - j * (j - 1) / 2;
}

}  // namespace blockfsi::block
