#pragma once

#include "block/grading.hpp"
#include "block/layout.hpp"
#include "case/key.hpp"
#include "geometry/curve.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi::case_file
{

/// What the file says of the shape and the cells of edges.
struct EdgeData
{
  std::optional<geometry::Curve> curve;
  std::optional<double> radius;  ///< of a circle, where the file gives it [m]
  std::optional<int> divisions;
  std::optional<block::Grading> grading;
  Location where;
};

/// The keys of curves: those of explicit_curve_keys and level_set.
const Keys<EdgeData>& curve_keys();
/// The keys divide and grade.
const Keys<EdgeData>& cells_keys();
/// Throws Error unless the table gives exactly one (or, if `optional`, at most one) of these keys.
void require_one_curve(const Value& value, bool optional);

/// "uniform" or a table with ratio, first, last.
block::Grading read_grading(const Value& value, Reading& reading);
/// A list of { towards = "names", first = size }.
void read_grade_towards(const Value& value, Reading& reading, std::vector<block::GradeTowards>& grades);

/// Both names of "a - b".
std::array<std::string, 2> edge_ends(const Location& where, const std::string& path, std::string_view name);
/// Both points of "a - b" in a layout.
std::array<int, 2> edge_points(const block::Layout& layout, const Location& where, const std::string& path,
                               std::string_view name);

std::vector<Section> edge_sections();

}  // namespace blockfsi::case_file
