#pragma once

#include "core/timing.hpp"
#include "fem/cell_loop.hpp"
#include "fem/side_loop.hpp"
#include "fem/time.hpp"
#include "linalg/newton.hpp"
#include "linalg/numbering.hpp"
#include "mesh/mesh.hpp"
#include "solid/material.hpp"
#include "solid/parameters.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace blockfsi::solid
{

/// The motion of the body at one time. Arrays by local node, shape (node_count, 2).
struct State
{
  std::vector<double> d;  ///< displacement [m]
  std::vector<double> v;  ///< velocity [m/s]
  double time = 0.0;      ///< [s]
};

/// The finite element solution of a total-Lagrangean St. Venant-Kirchhoff body.
///
/// In time: v1 = (d1 - d0) / (theta step) - (1 - theta) / theta v0 and
/// M (v1 - v0) / step + theta r(d1) + (1 - theta) r(d0) = load, the trapezoidal rule for theta = 1/2.
class Solver
{
public:
  /// `X`: nodes of the undeformed body [m], shape (node_count, 2). Mesh and numbering must outlive the
  /// solver.
  Solver(const Parameters& parameters, const mesh::Mesh& mesh, const linalg::Numbering& numbering,
         std::span<const double> X, Timings& timings);

  /// The undeformed body with its initial velocity.
  State initial() const;

  /// Displacement at the end of a step under nodal loads [N/m], shape (node_count, 2), that act at
  /// t + theta step; complete at owned nodes (other entries are ignored). `d` is the first guess and the
  /// result. Factors are kept as long as the step is the same.
  [[nodiscard]] linalg::NewtonReport advance(const fem::TimeStep& step, const State& old,
                                             std::span<const double> load, std::span<double> d);

  /// Static equilibrium under nodal loads, from the given guess; in load steps if the guess is zero.
  [[nodiscard]] linalg::NewtonReport solve_static(std::span<const double> load, std::span<double> d);

  /// The state at the end of a step with displacement d.
  State finish(const fem::TimeStep& step, const State& old, std::span<const double> d) const;

  std::int64_t unknown_count() const { return 2 * numbering_->total_count(); }

private:
  /// One prescribed displacement component of a node; no expression: zero.
  struct Prescribed
  {
    std::int32_t node;
    int component;
    Expression value;
  };
  struct Problem;

  static std::vector<Prescribed> find_prescribed(const Parameters& parameters, const mesh::Mesh& mesh,
                                                 const linalg::Numbering& numbering);
  std::vector<std::uint8_t> fixed() const;
  void apply_conditions(double time, double factor, std::span<double> d) const;
  void add_tractions(double time, double factor, std::span<double> residual);
  [[nodiscard]] linalg::NewtonReport solve(const Body& body, std::span<const double> origin,
                                           std::span<const double> constant, std::span<double> d);

  Parameters parameters_;
  const mesh::Mesh* mesh_;
  const linalg::Numbering* numbering_;
  Timings* timings_;
  std::vector<double> X_;
  fem::CellLoop cells_;
  fem::SideLoop sides_;
  std::vector<Prescribed> prescribed_;
  Lame material_;
  std::vector<double> body_force_;
  linalg::System system_;
  linalg::Factors factors_;
  fem::TimeStep factored_step_;
};

}  // namespace blockfsi::solid
