#pragma once

#include "case/key.hpp"
#include "geometry/level_set.hpp"

#include <vector>

namespace blockfsi::case_file
{

/// The level set of a tube about a skeleton of lines and arcs, `convolution = { nodes, segments, arcs, ...
/// }`.
geometry::LevelSet read_convolution(const Value& value, Reading& reading);
std::vector<Section> skeleton_sections();

}  // namespace blockfsi::case_file
