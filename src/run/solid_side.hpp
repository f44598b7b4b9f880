#pragma once

#include "block/connect.hpp"
#include "core/timing.hpp"
#include "coupling/interface.hpp"
#include "linalg/numbering.hpp"
#include "solid/solver.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::run
{

/// The body of a run: its mesh, the solver, and the accepted state.
/// Not movable: its parts refer to each other.
class SolidSide
{
public:
  SolidSide(const block::Layout& layout, const block::Skeleton& skeleton, const solid::Parameters& parameters,
            const std::vector<std::int64_t>& interface, Timings& timings);
  SolidSide(const SolidSide&) = delete;
  SolidSide& operator=(const SolidSide&) = delete;

  /// Prepares a step from the accepted state; static if step.step is 0.
  void begin(const fem::TimeStep& step);
  /// Solves for the displacement under loads at the interface [N/m], shape (interface count, 2).
  [[nodiscard]] linalg::NewtonReport solve(std::span<const double> load);
  /// Displacement of the interface as last solved [m], shape (interface count, 2), written.
  void displacement(std::span<double> values) const;
  void accept();

  const mesh::Mesh& mesh() const { return connected_.mesh; }
  const linalg::Numbering& numbering() const { return numbering_; }
  const coupling::Interface& interface() const { return interface_; }
  const solid::State& state() const { return state_; }
  /// Loads at the nodes as last solved [N/m], shape (node_count, 2).
  std::span<const double> load() const { return load_; }
  /// Nodes of the undeformed body [m], shape (node_count, 2).
  std::span<const double> X() const { return X_; }
  solid::Solver& solver() { return solver_; }
  std::int64_t unknown_count() const { return solver_.unknown_count(); }

  void restore(solid::State state) { state_ = std::move(state); }

private:
  block::Connected connected_;
  linalg::Numbering numbering_;
  coupling::Interface interface_;
  std::vector<double> X_;
  solid::Solver solver_;
  solid::State state_;
  fem::TimeStep step_;
  std::vector<double> d_;
  std::vector<double> load_;
};

}  // namespace blockfsi::run
