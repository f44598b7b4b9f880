#pragma once

#include "core/part.hpp"

#include <cstdint>
#include <span>

namespace blockfsi::linalg
{

/// The share of this process: rank 0 of 1 where MPI was not started.
Part part();

/// Sum over all processes, entry by entry, in place.
void sum(std::span<double> values);
std::int64_t sum(std::int64_t value);
double maximum(double value);
double minimum(double value);
/// Whether the condition holds on any process.
bool any(bool condition);
/// Waits until all processes are here.
void barrier();

}  // namespace blockfsi::linalg
