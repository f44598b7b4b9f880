#include "run/flap_motion.hpp"

#include "element/line.hpp"
#include "geometry/point.hpp"

#include <algorithm>
#include <cmath>

namespace blockfsi::run
{

std::string_view name(FlapShape shape)
{
  constexpr std::array<std::string_view, 4> names = {"rotation", "bending", "twist", "sideways"};
  return names[static_cast<std::size_t>(shape)];
}

std::vector<FlapShape> flap_shapes(int dim)
{
  if (dim == 2)
    return {FlapShape::rotation, FlapShape::bending};
  return {FlapShape::rotation, FlapShape::bending, FlapShape::twist, FlapShape::sideways};
}

FlapMotion::FlapMotion(const case_file::Prescribed& flap, FlapShape shape)
    : root_(flap.root), length_(geometry::distance(flap.root, flap.tip)), bent_(flap.bent), shape_(shape)
{
  along_ = geometry::scaled(1.0 / length_, geometry::subtract(flap.tip, flap.root));
  axis_ = geometry::scaled(1.0 / geometry::norm(flap.axis), flap.axis);
  across_ = geometry::cross(axis_, along_);
  if (shape == FlapShape::sideways)
    std::swap(axis_, across_);
  const element::Rule rule = element::gauss(16);
  points_ = rule.points;
  weights_ = rule.weights;
}

double FlapMotion::profile(double s) const
{
  s = std::max(s, 0.0);
  if (shape_ != FlapShape::rotation)
    return s;
  const double q = std::min(s / bent_, 1.0);
  return q * q * (3.0 - 2.0 * q);
}

std::array<double, 2> FlapMotion::centre(double s, double angle) const
{
  if (shape_ == FlapShape::twist)
    return {s * length_, 0.0};
  // The profile is smooth on either side of the bent share.
  std::array<double, 2> centre{};
  const double middle = std::min(s, bent_);
  for (const auto& [a, b] : {std::array{0.0, middle}, std::array{middle, s}})
    for (std::size_t q = 0; q < points_.size(); ++q)
    {
      const double theta = angle * profile(a + (b - a) * points_[q]);
      const double weight = weights_[q] * (b - a) * length_;
      centre[0] += weight * std::cos(theta);
      centre[1] += weight * std::sin(theta);
    }
  return centre;
}

std::array<double, 3> FlapMotion::position(const Vector& X, double angle) const
{
  using geometry::dot;
  const Vector from = geometry::subtract(X, root_);
  const double s = dot(from, along_) / length_;
  const double theta = angle * profile(s);
  const auto [ahead, aside] = centre(s, angle);
  const double height = dot(from, across_);
  const double width = dot(from, axis_);
  // The cross section in the axes across and about.
  const bool twists = shape_ == FlapShape::twist;
  const double x = ahead - (twists ? 0.0 : std::sin(theta) * height);
  const double y = aside + std::cos(theta) * height - (twists ? std::sin(theta) * width : 0.0);
  const double z = twists ? std::sin(theta) * height + std::cos(theta) * width : width;
  Vector result = geometry::add_scaled(root_, x, along_);
  result = geometry::add_scaled(result, y, across_);
  return geometry::add_scaled(result, z, axis_);
}

std::vector<double> FlapMotion::displacement(std::span<const double> X, int dim, double angle) const
{
  std::vector<double> result(X.size());
  for (std::size_t i = 0; i < X.size(); i += dim)
  {
    Vector from{};
    std::copy_n(X.begin() + static_cast<std::ptrdiff_t>(i), dim, from.begin());
    const Vector x = position(from, angle);
    for (int c = 0; c < dim; ++c)
      result[i + c] = x[c] - from[c];
  }
  return result;
}

}  // namespace blockfsi::run
