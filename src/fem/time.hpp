#pragma once

namespace blockfsi::fem
{

enum class Scheme
{
  steady,
  backward_euler,
  crank_nicolson
};

/// How a run advances in time.
struct TimeParameters
{
  Scheme scheme = Scheme::crank_nicolson;
  double end = 1.0;   ///< [s]
  double step = 0.1;  ///< [s]
  /// Steps at the start that are each done as two backward Euler half steps (Rannacher 1984).
  int start_up = 2;
  /// Time in which ringing from step to step falls by e [s]: theta = 1/2 + step / (4 ringing_decay). A fixed
  /// time keeps second order when the step is refined; 0 means 20 steps.
  double ringing_decay = 0.0;
  /// How often a step that fails is halved before the run ends.
  int cuts = 3;
};

/// One step from t to t + step: unknowns live at t + theta step, rates are differences over the step.
/// The geometry is taken at t + geometry step: at the midpoint the volume of a fluid in two dimensions
/// changes exactly by the flux through its boundary.
struct TimeStep
{
  double t = 0.0;
  double step = 0.0;
  double theta = 1.0;
  double geometry = 1.0;

  bool operator==(const TimeStep&) const = default;
};

}  // namespace blockfsi::fem
