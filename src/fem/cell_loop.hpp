#pragma once

#include "core/dual.hpp"
#include "fem/cell_geometry.hpp"
#include "fem/point.hpp"
#include "fem/tensor.hpp"
#include "mesh/mesh.hpp"

#include <span>
#include <vector>

namespace blockfsi::fem
{

/// A field given at the nodes, shape (node_count, components).
struct NodalField
{
  const double* values = nullptr;
  int components = 1;
};

/// Where a loop takes its integrals.
struct Quadrature
{
  std::vector<double> x;       ///< points [m], shape (cell_count, points^2, 2)
  std::vector<double> weight;  ///< of each point, det J included [m^2], shape (cell_count, points^2)
};

/// Integrates weak forms over the cells of a mesh, eight cells at a time.
///
/// The physics is a function at a point (fem/point.hpp); mapping, interpolation, integration and scatter are
/// the same for all. Tangents come from the same function on dual numbers, hence are exact. After the first
/// call nothing is allocated.
class CellLoop
{
public:
  /// `points`: Gauss points along each direction. The mesh must outlive the loop.
  CellLoop(const mesh::Mesh& mesh, int points) : mesh_(&mesh), table_(make_line_table(mesh.order, points)) {}

  const LineTable& table() const { return table_; }
  const mesh::Mesh& mesh() const { return *mesh_; }

  /// Adds the residual of all cells.
  ///   x [m], shape (node_count, 2);  unknown, shape (node_count, P::unknowns);
  ///   data: fields with P::data components in all;  residual, same shape as unknown;
  ///   given: the components of data that no field has, at the quadrature points, shape
  ///   (cell_count, points^2, components).
  template <Physics P>
  void add_residual(const P& physics, std::span<const double> x, std::span<const double> unknown,
                    std::span<const NodalField> data, std::span<double> residual,
                    std::span<const double> given = {});

  /// Writes the derivative of every cell's residual with respect to its unknowns,
  /// shape (cell_count, n, n) with n = nodes_per_cell * P::unknowns.
  template <Physics P>
  void tangent(const P& physics, std::span<const double> x, std::span<const double> unknown,
               std::span<const NodalField> data, std::span<double> matrices);

  /// The points at which integrals are taken, and their weights.
  Quadrature quadrature(std::span<const double> x);
  /// Value and derivatives in x and y of each component at each point, shape (cell_count, points^2,
  /// components, 3).
  std::vector<double> values_at_points(std::span<const double> x, NodalField field);

private:
  template <class P>
  using Input = PointInput<Lanes, P::unknowns, P::curved, P::data>;

  std::size_t batch_count() const { return (mesh_->cell_count() + lane_count - 1) / lane_count; }
  /// Cell in a lane; the last batch repeats the last cell.
  std::size_t cell(std::size_t batch, int lane) const
  {
    return std::min(batch * lane_count + lane, mesh_->cell_count() - 1);
  }
  /// Lanes of a batch that hold cells of their own.
  int used(std::size_t batch) const
  {
    return static_cast<int>(std::min<std::size_t>(lane_count, mesh_->cell_count() - batch * lane_count));
  }

  void gather(std::size_t batch, NodalField field, Lanes* out) const;
  template <class P>
  void evaluate(std::size_t batch, std::span<const double> x, std::span<const double> unknown,
                std::span<const NodalField> data, std::span<const double> given = {});
  void tabulate(bool second_derivatives);
  template <class P>
  void contract(int trial);
  template <class P>
  void write_tangent(std::size_t batch, std::span<double> matrices);

  const mesh::Mesh* mesh_;
  LineTable table_;
  CellGeometry geometry_;
  std::vector<Lanes> nodal_;
  std::vector<Lanes> values_;
  std::vector<Lanes> factors_;
  std::vector<Lanes> contracted_;
  std::vector<Lanes> residual_;
};

}  // namespace blockfsi::fem

#include "fem/cell_loop.inl"
