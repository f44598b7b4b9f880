#include "run/flap_motion.hpp"

#include "element/line.hpp"

#include <algorithm>
#include <cmath>

namespace blockfsi::run
{

namespace
{

/// Share of the length in which a rotating flap is bent.
constexpr double bent_share = 0.2;

}  // namespace

std::string_view name(FlapShape shape)
{
  return shape == FlapShape::rotation ? "rotation" : "bending";
}

FlapMotion::FlapMotion(const std::array<double, 3>& root, const std::array<double, 3>& tip, FlapShape shape)
    : root_{root[0], root[1]}, length_(std::hypot(tip[0] - root[0], tip[1] - root[1])), shape_(shape)
{
  along_ = {(tip[0] - root[0]) / length_, (tip[1] - root[1]) / length_};
  const element::Rule rule = element::gauss(16);
  points_ = rule.points;
  weights_ = rule.weights;
}

double FlapMotion::profile(double s) const
{
  s = std::max(s, 0.0);
  if (shape_ == FlapShape::bending)
    return s;
  const double q = std::min(s / bent_share, 1.0);
  return q * q * (3.0 - 2.0 * q);
}

std::array<double, 2> FlapMotion::position(const std::array<double, 2>& X, double angle) const
{
  const std::array<double, 2> from = {X[0] - root_[0], X[1] - root_[1]};
  const double s = (from[0] * along_[0] + from[1] * along_[1]) / length_;
  const double height = from[1] * along_[0] - from[0] * along_[1];
  // The centre line in axes along the undeformed flap and across it; the profile is smooth on either side of
  // the bent share.
  std::array<double, 2> centre{};
  const double middle = std::min(s, bent_share);
  for (const auto& [a, b] : {std::array{0.0, middle}, std::array{middle, s}})
    for (std::size_t q = 0; q < points_.size(); ++q)
    {
      const double theta = angle * profile(a + (b - a) * points_[q]);
      const double weight = weights_[q] * (b - a) * length_;
      centre[0] += weight * std::cos(theta);
      centre[1] += weight * std::sin(theta);
    }
  const double theta = angle * profile(s);
  const double x = centre[0] - std::sin(theta) * height;
  const double y = centre[1] + std::cos(theta) * height;
  return {root_[0] + along_[0] * x - along_[1] * y, root_[1] + along_[1] * x + along_[0] * y};
}

std::vector<double> FlapMotion::displacement(std::span<const double> X, double angle) const
{
  std::vector<double> result(X.size());
  for (std::size_t i = 0; i < X.size(); i += 2)
  {
    const std::array<double, 2> x = position({X[i], X[i + 1]}, angle);
    result[i] = x[0] - X[i];
    result[i + 1] = x[1] - X[i + 1];
  }
  return result;
}

}  // namespace blockfsi::run
