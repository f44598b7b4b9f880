#pragma once

#include <span>
#include <vector>

namespace blockfsi::run
{

/// The values of all processes, in the order of ranks; known to each. All must call it together.
std::vector<double> gather_values(std::span<const double> mine);

}  // namespace blockfsi::run
