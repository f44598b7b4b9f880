#pragma once

#include "block/connect.hpp"
#include "case/case.hpp"
#include "case/key.hpp"
#include "case/tree.hpp"

namespace blockfsi::case_file
{

/// What the layout shows before any solve. Throws Error at the key to blame for: a layout that `block`
/// refuses, a region without blocks or without physics, a boundary without a condition or a condition without
/// a boundary, slip on a boundary that is not along an axis, a formula that is not finite where it is used,
/// an enclosed fluid around a moving solid, regions that do not touch, probes outside of their region, forces
/// on unknown boundaries. Returns what it made of the layout.
block::Skeleton check(const Case& read, const Reading& reading, const Value& root);

}  // namespace blockfsi::case_file
