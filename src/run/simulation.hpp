#pragma once

#include "case/case.hpp"
#include "core/timing.hpp"
#include "coupling/accelerator.hpp"
#include "coupling/partitioned.hpp"
#include "coupling/predictor.hpp"
#include "output/checkpoint.hpp"
#include "run/fluid_side.hpp"
#include "run/solid_side.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi::run
{

/// A mesh on which nothing was solved, because one of its cells is not proved valid.
struct RefusedMesh
{
  std::int64_t cell = -1;  ///< in the whole mesh
  std::int32_t block = -1;
  std::vector<double> x;  ///< [m], shape (node_count, 2)
};

/// How a step went. A failed step leaves the simulation as it was.
struct StepReport
{
  bool ok = true;
  std::string failure;  ///< what failed last, where and when; also of a step that was cut and then went well
  int pieces = 1;       ///< in which the step was done or tried last
  std::optional<RefusedMesh> refused;  ///< the mesh if that is what failed last
  int coupling_iterations = 0;         ///< 0 without coupling
  int fluid_iterations = 0;            ///< Newton iterations, all coupling iterations together
  int solid_iterations = 0;
  int renewals = 0;       ///< factorisations
  mesh::Quality quality;  ///< of the accepted fluid mesh
  bool certified = true;  ///< every cell proved valid
};

/// A case under way: one step after the other, flow, body or both.
class Simulation
{
public:
  explicit Simulation(const case_file::Case& description);
  ~Simulation();

  /// Number of steps of the whole run; 1 if steady.
  std::int64_t step_count() const;
  std::int64_t step() const { return step_; }
  double time() const { return time_; }
  bool finished() const { return step_ >= step_count(); }

  /// Does the next step. One that fails is tried again in two, four, ... equal pieces, as often as the case
  /// allows.
  StepReport advance();

  const FluidSide* fluid() const { return fluid_.get(); }
  const SolidSide* solid() const { return solid_.get(); }
  const block::Skeleton& skeleton() const { return skeleton_; }
  /// First positions of the solid's nodes on the interface [m], shape (solid interface count, 2).
  std::span<const double> interface_points() const { return interface_points_; }
  const case_file::Case& description() const { return case_; }
  Timings& timings() { return timings_; }
  std::int64_t unknown_count() const;
  /// Accepted displacement of the solid's interface that the fluid has followed [m], shape (solid interface
  /// count, 2).
  std::span<const double> interface_displacement() const { return past_.d.front(); }

  /// Everything that the next step depends on, for this process.
  output::Arrays save() const;
  /// Continues from it, also with another length of step. Throws Error if it belongs to another case.
  void restore(const output::Arrays& arrays);

private:
  std::vector<fem::TimeStep> substeps(int pieces) const;
  bool try_pieces(int pieces, StepReport& report);
  bool substep(const fem::TimeStep& step, StepReport& report);
  bool couple(const fem::TimeStep& step, StepReport& report);
  bool evaluate(std::span<const double> d, std::span<double> answer, StepReport& report);
  bool accept_mesh(StepReport& report);
  bool solve_fluid(StepReport& report);
  bool solve_solid(std::span<const double> load, StepReport& report);
  bool account(std::string_view what, const linalg::NewtonReport& solved, int& iterations,
               StepReport& report) const;
  std::string when() const;

  case_file::Case case_;
  Timings timings_;
  block::Skeleton skeleton_;
  std::vector<double> interface_points_;
  std::vector<double> solid_skeleton_x_;  ///< empty where the solid shares the skeleton
  std::unique_ptr<FluidSide> fluid_;
  std::unique_ptr<SolidSide> solid_;
  std::unique_ptr<coupling::Acceleration> acceleration_;
  std::int64_t step_ = 0;
  double time_ = 0.0;
  /// Where the present length of step began: not at the start if a restart changed it.
  std::int64_t start_step_ = 0;
  double start_time_ = 0.0;
  coupling::Past past_;  ///< of the interface, accepted (sub)steps
};

}  // namespace blockfsi::run
