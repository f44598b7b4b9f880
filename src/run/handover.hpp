#pragma once

#include "fluid/conditions.hpp"
#include "mesh/quality.hpp"
#include "run/simulation.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace blockfsi::run
{

/// Integrals over a flow in its mesh.
struct FlowIntegrals
{
  double area = 0.0;                 ///< [m^2]
  std::array<double, 2> momentum{};  ///< [kg/s], for a depth of 1 m
  double outflow = 0.0;              ///< integral of div u: what the boundary lets out [m^2/s]
  double divergence = 0.0;           ///< L2 norm of div u over that of grad u [-]
};

/// What carrying a state to another layout did to it.
struct HandoverReport
{
  std::string failure;          ///< why the new layout cannot go on; empty if it can
  mesh::Quality quality;        ///< of the new mesh
  double velocity_error = 0.0;  ///< difference of the fields over the new mesh, relative, in the L2 norm
  double pressure_error = 0.0;
  FlowIntegrals before;
  FlowIntegrals after;
};

/// Carries the state of a simulation to one with other blocks of fluid around the same body. Nodes of the
/// body keep their values. The fluid's fields are projected at their full order, the velocity so that it
/// keeps its weak divergence (fem/projection.hpp); at boundaries it is what the new case prescribes, at the
/// interface what it was there.
class Handover
{
public:
  /// Finds out which nodes are the same; `to` has not moved yet. Throws Error, at the place given, if
  /// the bodies are not, or if a part is missing. All processes must call it together.
  Handover(const Simulation& from, const Simulation& to, const Location& where);

  /// Makes the state of `from` that of `to`, which goes on with the next step. All processes must call it
  /// together.
  [[nodiscard]] HandoverReport carry(const Simulation& from, Simulation& to) const;

private:
  output::Arrays body_of(const Simulation& from, const Simulation& to) const;
  bool project(const FluidSide& from, const FluidSide& to, output::Arrays& state,
               HandoverReport& report) const;

  std::vector<std::size_t>
      body_;  ///< number among the owned nodes of `from`, gathered, of each node of the body
  std::vector<std::size_t> interface_;  ///< the same for the places in the interface
  fluid::Conditions conditions_;        ///< of the flow in `to`
  std::vector<double> first_x_;         ///< nodes at which `to` evaluates its conditions
};

}  // namespace blockfsi::run
