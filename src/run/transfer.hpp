#pragma once

#include "mesh/quality.hpp"
#include "run/simulation.hpp"

#include <cstddef>
#include <vector>

namespace blockfsi::run
{

/// What carrying a state to another layout did to it.
struct TransferReport
{
  bool valid = true;            ///< whether every cell of the new mesh is proved valid
  mesh::Quality quality;        ///< of the new mesh
  double velocity_error = 0.0;  ///< difference of the fields over the new mesh, relative, in the L2 norm
  double pressure_error = 0.0;
};

/// Carries the state of a simulation to one with other blocks of fluid around the same body. Nodes of the
/// body keep their values; the fluid's fields are evaluated, at their full order, at the nodes of the new
/// mesh.
class Transfer
{
public:
  /// Finds out which nodes are the same. Throws Error, naming a node, if the bodies are not, or if a part is
  /// missing.
  Transfer(const Simulation& from, const Simulation& to);

  /// Makes the state of `from` that of `to`, which goes on with the steps of a start.
  TransferReport carry(const Simulation& from, Simulation& to) const;

private:
  std::vector<std::size_t> body_;       ///< node in `from` of each node of the body
  std::vector<std::size_t> interface_;  ///< the same for the places in the interface
};

}  // namespace blockfsi::run
