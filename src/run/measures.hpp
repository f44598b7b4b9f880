#pragma once

#include "mesh/quality.hpp"
#include "output/svg.hpp"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace blockfsi::run
{

/// A measure of a mesh that comparisons draw, with its column in quality.csv.
struct Measure
{
  std::string_view column;
  std::string_view label;
  double mesh::Quality::*of;
  std::optional<double> low;  ///< ends of its axis
  std::optional<double> high;
  bool is_logarithmic;
};

inline constexpr std::array<Measure, 5> measures = {
    {{"scaled_jacobian", "least scaled Jacobian", &mesh::Quality::scaled_jacobian, 0.0, 1.0, false},
     {"smallest_angle", "smallest angle between edges [degrees]", &mesh::Quality::smallest_angle, 0.0, 90.0,
      false},
     {"largest_angle", "largest angle between edges [degrees]", &mesh::Quality::largest_angle, 90.0, 180.0,
      false},
     {"smallest_change",
      "least Jacobian of the deformation gradient",
      &mesh::Quality::smallest_change,
      {},
      {},
      true},
     {"largest_change",
      "greatest Jacobian of the deformation gradient",
      &mesh::Quality::largest_change,
      {},
      {},
      true}}};

/// The part of the plane around some points [m], shape (count, 2), with room of some share of their extent on
/// all sides.
output::Window window_around(std::span<const double> points, double room);

/// The curve of a measure in a figure's axes: what leaves them is moved to their edge.
output::Figure figure_of(const Measure& measure, std::string title, std::string x_label,
                         std::vector<output::Curve> curves);

}  // namespace blockfsi::run
