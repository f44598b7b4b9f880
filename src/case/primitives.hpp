#pragma once

#include "case/key.hpp"
#include "geometry/level_set.hpp"

#include <vector>

namespace blockfsi::case_file
{

/// The level sets of the tables `sphere = { ... }` and so on in [geometry]; in the plane a sphere is a
/// circle, a box a rectangle and a plane a line.
geometry::LevelSet read_sphere(const Value& value, Reading& reading);
geometry::LevelSet read_cylinder(const Value& value, Reading& reading);
geometry::LevelSet read_box(const Value& value, Reading& reading);
geometry::LevelSet read_plane(const Value& value, Reading& reading);
geometry::LevelSet read_torus(const Value& value, Reading& reading);
std::vector<Section> primitive_sections();

}  // namespace blockfsi::case_file
