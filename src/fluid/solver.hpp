#pragma once

#include "core/timing.hpp"
#include "fem/cell_loop.hpp"
#include "fem/side_loop.hpp"
#include "fem/time.hpp"
#include "fluid/conditions.hpp"
#include "fluid/parameters.hpp"
#include "linalg/newton.hpp"
#include "linalg/numbering.hpp"
#include "mesh/mesh.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace blockfsi::fluid
{

/// The flow at one time. Arrays by local node.
struct State
{
  std::vector<double> u;         ///< velocity [m/s] at `time`, shape (node_count, 2)
  std::vector<double> change;    ///< of u over the last step, same shape
  std::vector<double> p;         ///< pressure [Pa] at `p_time`, shape (node_count)
  std::vector<double> p_before;  ///< pressure at `p_before_time`
  double time = 0.0;             ///< [s]
  double p_time = 0.0;
  double p_before_time = 0.0;

  /// Pressure at `time`, extrapolated from the last two, shape (node_count).
  std::vector<double> pressure_now() const;
};

/// Where the mesh is during a step.
struct MeshMotion
{
  std::span<const double> x;  ///< nodes where the integrals are taken [m], shape (node_count, 2)
  std::span<const double> w;  ///< mesh velocity [m/s], same shape
};

/// The stabilised finite element solution of the flow in one region.
///
/// The unknown of a step, z = (u_x, u_y, p) at t + theta step, has shape (node_count, 3). On the boundary
/// named "interface" the velocity is that of the mesh.
class Solver
{
public:
  /// `x`: initial nodes [m], shape (node_count, 2). The mesh and the numbering must outlive the solver.
  /// Throws Error for conditions that cannot be met (slip on a boundary that is not along an axis).
  Solver(const Parameters& parameters, const mesh::Mesh& mesh, const linalg::Numbering& numbering,
         std::span<const double> x, Timings& timings);

  /// The initial velocity and zero pressure.
  State initial() const;

  /// Extrapolated first guess of z.
  void guess(const fem::TimeStep& step, const State& old, std::span<double> z) const;

  /// Solves for z, starting from its present value; steady if step.step is 0.
  /// Throws Error if the flow is enclosed and the prescribed velocities bring in more than they let out.
  [[nodiscard]] linalg::NewtonReport solve(const fem::TimeStep& step, const State& old,
                                           const MeshMotion& motion, std::span<double> z);

  /// Residual of the momentum equation at all nodes, conditions not applied, shape (node_count, 3): at nodes
  /// of a boundary minus the force of the fluid on it [N/m]. Complete at owned nodes.
  std::vector<double> reaction(const fem::TimeStep& step, const State& old, const MeshMotion& motion,
                               std::span<const double> z);

  /// The state at the end of the step that z solves.
  State finish(const fem::TimeStep& step, const State& old, std::span<const double> z) const;

  std::int64_t unknown_count() const { return 3 * numbering_->total_count(); }

  /// What the factors at hand were made from: enough to make the same ones again.
  struct Linearisation
  {
    bool stale = true;
    fem::TimeStep step;
    std::vector<double> z;
    std::vector<double> x;
    std::vector<double> w;
    std::vector<double> u_old;
  };
  const Linearisation& linearisation() const { return linearisation_; }
  /// Makes the factors anew from a saved linearisation, bit for bit the same on one process.
  void restore(const Linearisation& linearisation);

private:
  struct Problem;

  void apply_conditions(const fem::TimeStep& step, const State& old, const MeshMotion& motion,
                        std::span<double> z) const;
  void check_balance(const fem::TimeStep& step, const MeshMotion& motion, std::span<const double> z);
  void compute_body_force(const fem::TimeStep& step, std::span<const double> x);

  Parameters parameters_;
  const mesh::Mesh* mesh_;
  const linalg::Numbering* numbering_;
  Timings* timings_;
  std::vector<double> x0_;
  fem::CellLoop cells_;
  fem::SideLoop sides_;
  Conditions conditions_;
  std::vector<double> body_force_;
  linalg::System system_;
  linalg::Factors factors_;
  Linearisation linearisation_;
};

}  // namespace blockfsi::fluid
