#pragma once

namespace blockfsi::testing
{

/// Number of allocations by operator new since the start of the program.
long allocation_count();

}  // namespace blockfsi::testing
