#pragma once

#include "case/key.hpp"
#include "geometry/point.hpp"

#include <vector>

namespace blockfsi::case_file
{

/// A corner of blocks: [x, y], or a table { near, on, direction } for the point on one level set or two.
geometry::Point corner_point(const Value& value, Reading& reading);
std::vector<Section> point_sections();

}  // namespace blockfsi::case_file
