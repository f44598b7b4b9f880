#pragma once

namespace blockfsi::block::testing
{

/// Number of allocations by operator new since the start of the program.
long allocation_count();

}  // namespace blockfsi::block::testing
