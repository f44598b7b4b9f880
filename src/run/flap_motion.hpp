#pragma once

#include "case/case.hpp"

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace blockfsi::run
{

/// How a flap is bent in a sweep without a fluid: the angle of its centre line over its length.
enum class FlapShape
{
  rotation,  ///< bent in the first fifth only, smoothly; the rest turns
  bending    ///< constant curvature
};

inline constexpr std::array<FlapShape, 2> flap_shapes = {FlapShape::rotation, FlapShape::bending};

std::string_view name(FlapShape shape);

/// A flap whose centre line is bent without stretching and whose cross sections stay straight and
/// perpendicular to it (formulation.md chapter 9).
class FlapMotion
{
public:
  /// `root`, `tip`: ends of the straight centre line [m].
  FlapMotion(const std::array<double, 3>& root, const std::array<double, 3>& tip, FlapShape shape);

  /// Where a point of the flap goes when the centre line's tip has turned by an angle [rad].
  std::array<double, 2> position(const std::array<double, 2>& X, double angle) const;

  /// Displacements of points, X and result of shape (count, 2) [m].
  std::vector<double> displacement(std::span<const double> X, double angle) const;

private:
  /// Angle of the centre line at s, the share of its length, for angle 1 at the tip.
  double profile(double s) const;

  std::array<double, 2> root_;
  std::array<double, 2> along_{};
  double length_;
  FlapShape shape_;
  std::vector<double> points_;
  std::vector<double> weights_;
};

}  // namespace blockfsi::run
