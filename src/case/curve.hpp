#pragma once

#include "case/edge.hpp"

#include <vector>

namespace blockfsi::case_file
{

/// The keys of curves that are given point by point or by a formula: circle, ellipse, through, bspline,
/// nurbs, formula, step and iges.
const Keys<EdgeData>& explicit_curve_keys();
/// The tables of these keys.
std::vector<Section> explicit_curve_sections();

}  // namespace blockfsi::case_file
