#pragma once

#include "block/move.hpp"
#include "motion/extension.hpp"
#include "motion/parameters.hpp"
#include "motion/regenerate.hpp"
#include "motion/report.hpp"

#include <span>
#include <variant>
#include <vector>

namespace blockfsi::motion
{

/// How the fluid mesh follows the interface: competing ways under one verb.
using Update = std::variant<Regenerate, Extension>;

/// `corners`: those of the blocks, for a mesh that is regenerated. Throws Error if a boundary that shall
/// slide does not run along an axis.
Update make_update(const Parameters& parameters, const Domain& domain, block::CornerMotion corners);

/// Coordinates of all local nodes for a displacement of the interface; all processes together.
///   displacement [m], shape (interface count, 2);  x [m], shape (node_count, 2), written.
[[nodiscard]] Report follow(Update& update, std::span<const double> displacement, std::span<double> x);

/// Tells an update with a memory that a step was accepted, with what `follow` gave last.
void accept(Update& update, std::span<const double> displacement, std::span<const double> x);

/// What the next mesh depends on besides the interface; empty for updates without a memory.
std::vector<double> memory(const Update& update);
/// Restores it. Throws Error if it belongs to another update or mesh.
void recall(Update& update, std::span<const double> memory);

}  // namespace blockfsi::motion
