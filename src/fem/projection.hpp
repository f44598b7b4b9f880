#pragma once

#include "fem/cell_loop.hpp"
#include "linalg/numbering.hpp"
#include "linalg/system.hpp"
#include "mesh/mesh.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace blockfsi::fem
{

/// Finds the nodal fields of a mesh that are nearest, in the L2 norm, to fields known at its quadrature
/// points, such as those of another mesh. Functions of the mesh come out as they are. The mesh matrices are
/// consistent and solved directly, up to round-off.
class Projection
{
public:
  /// `points`: Gauss points along each direction. The mesh and the numbering must outlive the projection.
  ///   x [m], shape (node_count, 2).
  Projection(const mesh::Mesh& mesh, const linalg::Numbering& numbering, std::span<const double> x,
             int points);

  const Quadrature& quadrature() const { return quadrature_; }
  /// Value and derivatives of a nodal field at the points (CellLoop::values_at_points).
  std::vector<double> values_at_points(NodalField field) { return cells_.values_at_points(x_, field); }

  /// Each component alone: the integral of v (f_h - f) is 0 for all functions v of the mesh, so the integral
  /// of f is kept.
  ///   given: f at the points, shape (cell_count, points^2, components);
  ///   nodal: f_h, shape (node_count, components), written.
  [[nodiscard]] linalg::Status scalars(std::span<const double> given, int components,
                                       std::span<double> nodal);

  /// A velocity at a place [m/s].
  using Velocity = std::function<std::array<double, 2>(const std::array<double, 2>& x)>;

  /// Where `velocity` asks for the velocity at the boundary [m], shape (points, 2).
  std::vector<double> boundary_points();

  /// A velocity that keeps its divergence as well, in the weak sense: (u_h, s) with
  ///
  ///   (v, u_h - u) - (div v, s) = 0,
  ///   (q, div u_h) + (grad q, u) - <q, u n> + 1/2 (grad q, u_h - u + grad s) = 0
  ///
  /// for all v, q of the mesh, <> being the integral over its boundary. With q = 1: as much flows out as
  /// before. The last term keeps s stable at equal order; it is what the stabilisation of the pressure is in
  /// a very short step in time, whose pressure s / step would be. Without this the first steps behind a
  /// transfer have pressures of that size (Besier & Wollner 2012).
  ///   given: u at the points, shape (cell_count, points^2, 2);  at_boundary: u there;
  ///   fixed: nonzero where a velocity or s keeps its value, shape (node_count, 3), as in
  ///   fluid::fixed_unknowns;  u: u_h, shape (node_count, 2), in: its fixed values, out: all.
  [[nodiscard]] linalg::Status velocity(std::span<const double> given, const Velocity& at_boundary,
                                        std::span<const std::uint8_t> fixed, std::span<double> u);

private:
  void add_outflow(const Velocity& at_boundary, std::span<double> residual);

  const linalg::Numbering* numbering_;
  std::vector<double> x_;
  CellLoop cells_;
  Quadrature quadrature_;
};

}  // namespace blockfsi::fem
