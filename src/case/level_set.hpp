#pragma once

#include "case/key.hpp"
#include "geometry/level_set.hpp"
#include "geometry/point.hpp"

#include <vector>

namespace blockfsi::case_file
{

/// A point or a direction in the plane or in space: a list of two or three numbers.
geometry::Point point_in_space(const Value& value, const Constants& constants);

/// The level set that a text means: the name of one in [geometry], wherever it stands there, or a formula in
/// x, y, z.
geometry::LevelSet level_set(const Value& value, Reading& reading);

/// One level set or a list of two.
std::vector<geometry::LevelSet> one_or_two_level_sets(const Value& value, Reading& reading);

/// Reads the level sets of [geometry]. `value` must live as long as the reading.
void read_geometry(const Value& value, Reading& reading);
std::vector<Section> geometry_sections();

}  // namespace blockfsi::case_file
