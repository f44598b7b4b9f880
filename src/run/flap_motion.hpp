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
  rotation,  ///< bent near the root only, smoothly; the rest turns
  bending,   ///< constant curvature
  twist,     ///< about the centre line, linearly; in space only, as the next
  sideways   ///< constant curvature, in the direction in which the flap is wide
};

std::string_view name(FlapShape shape);

/// The shapes that blocks of a dimension can take.
std::vector<FlapShape> flap_shapes(int dim);

/// A flap whose centre line is bent without stretching and whose cross sections stay straight and
/// perpendicular to it (formulation.md chapter 9).
class FlapMotion
{
public:
  FlapMotion(const case_file::Prescribed& flap, FlapShape shape);

  /// Where a point of the flap goes when the centre line's tip has turned by an angle [rad].
  std::array<double, 3> position(const std::array<double, 3>& X, double angle) const;

  /// Displacements of points, X and result of shape (count, dim) [m].
  std::vector<double> displacement(std::span<const double> X, int dim, double angle) const;

private:
  using Vector = std::array<double, 3>;

  /// Angle of the centre line at s, the share of its length, for angle 1 at the tip.
  double profile(double s) const;
  /// The centre line at s in axes along the undeformed flap and across it.
  std::array<double, 2> centre(double s, double angle) const;

  Vector root_;
  Vector along_;   ///< from root to tip
  Vector across_;  ///< where the tip goes at first
  Vector axis_;    ///< about which it turns
  double length_;
  double bent_;  ///< share of the length in which a rotating flap is bent
  FlapShape shape_;
  std::vector<double> points_;
  std::vector<double> weights_;
};

}  // namespace blockfsi::run
