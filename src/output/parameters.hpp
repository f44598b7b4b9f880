#pragma once

#include "core/error.hpp"

#include <array>
#include <string>
#include <vector>

namespace blockfsi::output
{

/// A quantity followed at a point: "displacement" of the solid particle that starts there, "velocity" or
/// "pressure" of the fluid at the place.
struct Probe
{
  std::string name;
  std::array<double, 3> at{};  ///< [m]
  std::string of;
  Location where;
};

/// Force of the fluid on the sum of some boundaries and, by the name of the solid's region, of the interface.
struct Force
{
  std::string name;
  std::vector<std::string> on;
  Location where;
};

struct Parameters
{
  std::string directory;       ///< empty: results/ beside the case file
  double every = 0.0;          ///< simulated time between field files [s]; 0: only the last state
  int checkpoint_every = 100;  ///< steps
  std::vector<Probe> probes;
  std::vector<Force> forces;
};

}  // namespace blockfsi::output
