#include "geometry/convolution.hpp"

#include "core/error.hpp"
#include "element/line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace blockfsi::geometry
{

namespace
{

constexpr int far_points = 8;   ///< Gauss points on bones that are far away for their length
constexpr int arc_points = 12;  ///< Gauss points on each part of an arc

/// A straight bone.
struct Straight
{
  Point start;
  Point along;  ///< unit vector
  double length;
  double weight;  ///< at its start
  double slope;   ///< of the weight [1/m]
};

/// A point of an arc with its share of the integral.
struct Source
{
  Point at;
  double weight;
};

/// Integrals over τ from -x to L - x of powers of 1/Q and τ/Q with Q = A + s² τ².
struct Integrals
{
  double f2;  ///< ∫ 1/Q²
  double m2;  ///< ∫ τ/Q²
  double f3;  ///< ∫ 1/Q³
  double m3;  ///< ∫ τ/Q³
};

/// Closed forms, with the differences of their two ends taken such that nothing cancels near the bone.
Integrals closed_form(double a, double s, double begin, double length)
{
  const double end = begin + length;
  const double square = s * s;
  const double q1 = a + square * begin * begin;
  const double q2 = a + square * end * end;
  const double root = std::sqrt(a);
  const double angle = std::atan2(s * length / root, 1.0 + square * begin * end / a);
  const double product = q1 * q2;
  const double middle = length * (end + begin);
  Integrals result{};
  result.f2 = length * (a - square * begin * end) / (2.0 * a * product) + angle / (2.0 * s * a * root);
  result.m2 = middle / (2.0 * product);
  result.f3 = (end / (q2 * q2) - begin / (q1 * q1)) / (4.0 * a) + 0.75 / a * result.f2;
  result.m3 = middle * (q1 + q2) / (4.0 * product * product);
  return result;
}

/// Far beyond an end of the bone the closed forms cancel, and the integrands are smooth.
Integrals by_quadrature(double a, double s, double begin, double length)
{
  static const element::Rule rule = element::gauss(far_points);
  Integrals result{};
  for (std::size_t k = 0; k < rule.points.size(); ++k)
  {
    const double tau = begin + length * rule.points[k];
    const double q = a + s * s * tau * tau;
    const double f2 = length * rule.weights[k] / (q * q);
    result.f2 += f2;
    result.m2 += tau * f2;
    result.f3 += f2 / q;
    result.m3 += tau * f2 / q;
  }
  return result;
}

/// Adds the field of a straight bone: x and ρ are the coordinate of the point along the bone and its distance
/// from the bone's line; al + c τ is the weight.
void add_straight(const Straight& bone, double s, const Point& at, Level& sum)
{
  const Point from = subtract(at, bone.start);
  const double x = dot(from, bone.along);
  const Point across = add_scaled(from, -x, bone.along);
  const double a = 1.0 + s * s * dot(across, across);
  const double center = 0.5 * bone.length - x;
  const bool far = center * center + a / (s * s) > 6.25 * bone.length * bone.length;
  const Integrals i = far ? by_quadrature(a, s, -x, bone.length) : closed_form(a, s, -x, bone.length);
  const double al = bone.weight + bone.slope * x;
  const double c = bone.slope;
  const double square = s * s;
  sum.value += al * i.f2 + c * i.m2;
  const double by_x = 4.0 * square * (al * i.m3 + c * (i.f2 - a * i.f3) / square);
  const double by_rho_over_rho = -4.0 * square * (al * i.f3 + c * i.m3);
  sum.gradient = add(sum.gradient, combine(by_x, bone.along, by_rho_over_rho, across));
}

void add_source(const Source& source, double s, const Point& at, Level& sum)
{
  const Point from = subtract(at, source.at);
  const double q = 1.0 + s * s * dot(from, from);
  const double value = source.weight / (q * q);
  sum.value += value;
  sum.gradient = add_scaled(sum.gradient, -4.0 * s * s * value / q, from);
}

/// An arc from a point on its circle, turning in the plane of two vectors.
struct Arc
{
  Point center;
  Point first;   ///< from the centre to the start [m]
  Point second;  ///< as long, a quarter turn further
  double angle;  ///< to the end, 0 to 2 pi
};

Arc arc_through(const Point& start, const Point& middle, const Point& end)
{
  const Point u = subtract(middle, start);
  const Point v = subtract(end, start);
  const Point normal = cross(u, v);
  const double square = dot(normal, normal);
  // Centre of the circle about a triangle, as seen from one of its corners.
  const Point to_center =
      scaled(0.5 / square, combine(dot(v, v), cross(normal, u), dot(u, u), cross(v, normal)));
  Arc arc{};
  arc.center = add(start, to_center);
  arc.first = scaled(-1.0, to_center);
  arc.second = scaled(1.0 / std::sqrt(square), cross(normal, arc.first));
  const Point to_end = subtract(end, arc.center);
  arc.angle = std::atan2(dot(to_end, arc.second), dot(to_end, arc.first));
  if (arc.angle < 0.0)
    arc.angle += 2.0 * std::numbers::pi;
  return arc;
}

/// Gauss points on parts of the arc no longer than the kernel is wide: errors near 1e-15 of the field.
void add_arc(const Arc& arc, double weight_start, double weight_end, double s, std::vector<Source>& sources)
{
  static const element::Rule rule = element::gauss(arc_points);
  const double length = norm(arc.first) * arc.angle;
  const int parts = std::max(1, static_cast<int>(std::ceil(length * s)));
  for (int part = 0; part < parts; ++part)
    for (std::size_t k = 0; k < rule.points.size(); ++k)
    {
      const double t = (part + rule.points[k]) / parts;
      const Point from = combine(std::cos(t * arc.angle), arc.first, std::sin(t * arc.angle), arc.second);
      const double weight = (1.0 - t) * weight_start + t * weight_end;
      sources.push_back({add(arc.center, from), weight * rule.weights[k] * length / parts});
    }
}

void check_parameters(const Skeleton& skeleton)
{
  for (const auto& [name, value] :
       {std::pair{"sharpness", skeleton.sharpness}, {"threshold", skeleton.threshold}})
    if (!(value > 0.0 && std::isfinite(value)))
      throw Error(fmt::format("the {} of the skeleton is {:.9g}; it must be positive", name, value));
  if (skeleton.radii.size() != skeleton.nodes.size())
    throw Error(fmt::format("the skeleton has {} nodes but {} radii; each node needs one",
                            skeleton.nodes.size(), skeleton.radii.size()));
  for (std::size_t i = 0; i < skeleton.radii.size(); ++i)
    if (!(skeleton.radii[i] > 0.0 && std::isfinite(skeleton.radii[i])))
      throw Error(fmt::format("the radius of node {} of the skeleton is {:.9g} m; it must be positive", i + 1,
                              skeleton.radii[i]));
  if (skeleton.bones.empty())
    throw Error("the skeleton has no bones; join its nodes by at least one");
}

void check_bone(const Skeleton& skeleton, std::size_t index)
{
  const Bone& bone = skeleton.bones[index];
  const int count = static_cast<int>(skeleton.nodes.size());
  for (const int node : {bone.from, bone.to})
    if (node < 0 || node >= count)
      throw Error(fmt::format("bone {} of the skeleton names node {} of {}", index + 1, node + 1, count));
  const Point& start = skeleton.nodes[bone.from];
  const Point& end = skeleton.nodes[bone.to];
  const double length = distance(start, end);
  if (!(length > 0.0))
    throw Error(fmt::format("bone {} of the skeleton has no length; its nodes {} and {} are at one place",
                            index + 1, bone.from + 1, bone.to + 1));
  if (!bone.through)
    return;
  const Point bend = cross(subtract(*bone.through, start), subtract(end, start));
  if (!(norm(bend) > 1e-9 * length * std::max(length, distance(start, *bone.through))))
    throw Error(fmt::format("bone {} of the skeleton shall pass through a point on the straight line of its "
                            "ends; leave that point out",
                            index + 1));
}

}  // namespace

struct Convolution::Data
{
  double sharpness;
  double threshold;
  double mean_radius;
  std::vector<Straight> straight;
  std::vector<Source> sources;
};

Convolution::Convolution(const Skeleton& skeleton)
{
  check_parameters(skeleton);
  const double s = skeleton.sharpness;
  Data data{s, skeleton.threshold, 0.0, {}, {}};
  std::vector<double> weights;
  for (const double radius : skeleton.radii)
  {
    weights.push_back(2.0 * s * skeleton.threshold * std::pow(1.0 + s * s * radius * radius, 1.5) /
                      std::numbers::pi);
    data.mean_radius += radius / static_cast<double>(skeleton.radii.size());
  }
  for (std::size_t i = 0; i < skeleton.bones.size(); ++i)
  {
    check_bone(skeleton, i);
    const Bone& bone = skeleton.bones[i];
    const Point& start = skeleton.nodes[bone.from];
    const Point& end = skeleton.nodes[bone.to];
    const double from = weights[bone.from];
    const double to = weights[bone.to];
    const double length = distance(start, end);
    if (bone.through)
      add_arc(arc_through(start, *bone.through, end), from, to, s, data.sources);
    else
      data.straight.push_back(
          {start, scaled(1.0 / length, subtract(end, start)), length, from, (to - from) / length});
  }
  data_ = std::make_shared<const Data>(std::move(data));
}

Level Convolution::operator()(const Point& x) const
{
  Level sum;
  for (const Straight& bone : data_->straight)
    add_straight(bone, data_->sharpness, x, sum);
  for (const Source& source : data_->sources)
    add_source(source, data_->sharpness, x, sum);
  return sum;
}

double Convolution::threshold() const
{
  return data_->threshold;
}

double Convolution::mean_radius() const
{
  return data_->mean_radius;
}

LevelSet tube(const Convolution& field)
{
  return {"tube about a skeleton", [field](const Point& x)
          {
            const Level level = field(x);
            const double ratio = std::cbrt(field.threshold() / level.value);
            return Level{field.mean_radius() * (ratio - 1.0),
                         scaled(-field.mean_radius() * ratio / (3.0 * level.value), level.gradient)};
          }};
}

}  // namespace blockfsi::geometry
