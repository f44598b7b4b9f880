#pragma once

#include "block/connect.hpp"
#include "case/case.hpp"
#include "core/timing.hpp"
#include "coupling/interface.hpp"
#include "coupling/transfer.hpp"
#include "fluid/solver.hpp"
#include "linalg/numbering.hpp"
#include "mesh/quality.hpp"
#include "mesh/validity.hpp"
#include "motion/update.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace blockfsi::run
{

/// The flow of a run: its mesh, how that follows the interface, the solver, and the accepted state.
/// Not movable: its parts refer to each other.
class FluidSide
{
public:
  /// `interface`: skeleton numbers of the nodes that the solid moves; empty for a flow alone. `transfer`: how
  /// they hang on the solid's nodes there.
  FluidSide(const case_file::Case& description, const block::Skeleton& skeleton,
            const std::vector<std::int64_t>& interface, coupling::Transfer transfer, Timings& timings);
  FluidSide(const FluidSide&) = delete;
  FluidSide& operator=(const FluidSide&) = delete;

  /// Prepares a step from the accepted state.
  void begin(const fem::TimeStep& step);
  /// Moves the mesh to a displacement of the solid's interface at the end of the step [m], shape
  /// (transfer.solid_count, 2). Nothing may be solved on it if that failed or if certify_moved does not prove
  /// all cells valid.
  [[nodiscard]] motion::Report move(std::span<const double> displacement);
  /// Solves the flow on the mesh as it was moved.
  [[nodiscard]] linalg::NewtonReport solve();
  /// Force of the fluid on the solid's interface nodes [N/m], shape (transfer.solid_count, 2), written.
  void load(std::span<double> values);
  /// Makes the solved step the accepted state.
  void accept();

  const mesh::Mesh& mesh() const { return connected_.mesh; }
  const linalg::Numbering& numbering() const { return numbering_; }
  const coupling::Interface& interface() const { return interface_; }
  const fluid::State& state() const { return state_; }
  /// Accepted nodes [m], shape (node_count, 2).
  std::span<const double> x() const { return x_; }
  /// Nodes as last moved.
  std::span<const double> x_moved() const { return x_new_; }
  /// Reaction of the accepted step (fluid::Solver::reaction), shape (node_count, 3), at its own time.
  std::span<const double> reaction() const { return reaction_; }
  double reaction_time() const { return reaction_time_; }

  /// Quality over all processes of the mesh as last moved, and of the accepted one with proof.
  const mesh::Quality& quality() const { return quality_; }
  const mesh::Validity& certify() const;
  /// Of the mesh as last moved, and of that on which integrals are taken.
  mesh::Validity certify_moved();

  fluid::Solver& solver() { return solver_; }
  std::int64_t unknown_count() const { return solver_.unknown_count(); }

  /// What the next mesh depends on besides the interface.
  std::vector<double> mesh_memory() const { return motion::memory(motion_); }
  /// For a restart: the accepted state, and the displacement of the solid's interface and the memory of the
  /// mesh that belong to it. Throws Error if the memory is that of another way of moving.
  void restore(fluid::State state, std::span<const double> displacement, std::span<const double> mesh_memory);

private:
  void measure();
  fluid::MeshMotion mesh_motion() const { return {x_geometry_, w_}; }

  Timings* timings_;
  block::Connected connected_;
  linalg::Numbering numbering_;
  coupling::Interface interface_;
  coupling::Transfer transfer_;
  std::vector<double> x_;
  motion::Update motion_;
  std::vector<double> displacement_;  ///< of the fluid's interface nodes, as last moved
  std::vector<double> x_new_;
  std::vector<double> x_geometry_;
  std::vector<double> w_;
  fluid::Solver solver_;
  fluid::State state_;
  fem::TimeStep step_;
  std::vector<double> z_;
  std::vector<double> reaction_;
  double reaction_time_ = 0.0;
  bool reaction_known_ = false;
  mesh::QualityTables quality_tables_;
  mesh::ValidityTables validity_tables_;
  std::vector<double> first_jacobian_;
  mesh::Quality quality_;
  mutable std::optional<mesh::Validity> validity_;  ///< of the accepted mesh, once it is known
  std::optional<mesh::Validity> moved_validity_;    ///< of the mesh as last moved, once it is known
  bool has_moved_ = false;                          ///< since a mesh was accepted
};

}  // namespace blockfsi::run
