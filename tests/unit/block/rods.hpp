#pragma once

#include "block/corner_graph.hpp"
#include "block/corner_motion.hpp"
#include "block/corner_samples.hpp"
#include "element/line.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

// A flap or a rod on the floor of a box, and blocks of fluid around it: the layouts of corners3d.md from
// plain arrays. Quadrilaterals in the plane of x and z, extruded over levels in y; those of the body are left
// out below its tip.
namespace blockfsi::block::testing
{

using Vector3 = Eigen::Vector3d;

struct Extrusion
{
  std::vector<std::array<double, 2>> points;  ///< x, z
  std::vector<std::array<int, 4>> quads;      ///< counter-clockwise
  std::vector<bool> body;                     ///< whether the quadrilateral belongs to the body below its tip
  std::set<std::pair<int, int>> arcs;         ///< sides that are arcs about the middle, as (smaller, larger)
  std::vector<double> levels;                 ///< y
  int tip = 1;                                ///< level of the tip
  std::array<double, 2> middle{};             ///< of the body
  Vector3 low = Vector3::Zero();              ///< of the box
  Vector3 high = Vector3::Ones();
  bool ends_held = true;  ///< corners at both ends in x stay; else they slide
  double thickness = 0.1;

  double height() const { return levels[tip]; }
};

/// Channel of 2 x 1 x 1 or narrower with a flap of 0.06 x 0.5 x 0.4: 98 blocks.
inline Extrusion flap_on_floor(bool narrow = false)
{
  const double side = narrow ? 0.04 : 0.15;
  const double above = narrow ? 0.05 : 0.2;
  Extrusion flap;
  flap.low = {0.0, 0.0, narrow ? 0.22 : 0.0};
  flap.high = {2.0, narrow ? 0.6 : 1.0, narrow ? 0.78 : 1.0};
  const std::array<double, 6> x = {0.0, 0.7, 0.97, 1.03, 1.3, 2.0};
  const std::array<double, 6> z = {flap.low[2], 0.3 - side, 0.3, 0.7, 0.7 + side, flap.high[2]};
  for (const double px : x)
    for (const double pz : z)
      flap.points.push_back({px, pz});
  for (int i = 0; i < 5; ++i)
    for (int k = 0; k < 5; ++k)
    {
      flap.quads.push_back({6 * i + k, 6 * (i + 1) + k, 6 * (i + 1) + k + 1, 6 * i + k + 1});
      flap.body.push_back(i == 2 && k == 2);
    }
  flap.levels = {0.0, 0.15, 0.5, 0.5 + above, flap.high[1]};
  flap.tip = 2;
  flap.middle = {1.0, 0.5};
  flap.thickness = 0.06;
  return flap;
}

/// Round rod of radius 0.1 and height 0.6 in a box of 1.5 x 1 x 1.5, an O-grid around it: 58 blocks.
inline Extrusion rod_on_floor()
{
  Extrusion rod;
  constexpr double c = 0.75;
  const double pi = std::acos(-1.0);
  std::array<int, 4> core{};
  std::array<int, 4> rim{};
  std::array<int, 4> box{};
  for (int n = 0; n < 4; ++n)
  {
    const double angle = (225.0 + 90.0 * n) * pi / 180.0;
    const auto add = [&](double radius)
    {
      rod.points.push_back({c + radius * std::cos(angle), c + radius * std::sin(angle)});
      return static_cast<int>(rod.points.size()) - 1;
    };
    core[n] = add(0.055);
    rim[n] = add(0.1);
    box[n] = add(0.25 * std::sqrt(2.0));
  }
  const auto add = [&](std::array<int, 4> quad, bool body)
  {
    rod.quads.push_back(quad);
    rod.body.push_back(body);
  };
  add(core, true);
  for (int n = 0; n < 4; ++n)
  {
    const int m = (n + 1) % 4;
    add({rim[n], rim[m], core[m], core[n]}, true);
    add({box[n], box[m], rim[m], rim[n]}, false);
    rod.arcs.insert(std::minmax(rim[n], rim[m]));
  }
  const std::array<double, 4> line = {0.0, 0.5, 1.0, 1.5};
  std::array<std::array<int, 4>, 4> grid{};
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k)
    {
      const bool inner = (i == 1 || i == 2) && (k == 1 || k == 2);
      if (inner)
        grid[i][k] = box[k == 1 ? i - 1 : 4 - i];
      else
      {
        grid[i][k] = static_cast<int>(rod.points.size());
        rod.points.push_back({line[i], line[k]});
      }
    }
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      if (i != 1 || k != 1)
        add({grid[i][k], grid[i + 1][k], grid[i + 1][k + 1], grid[i][k + 1]}, false);
  rod.levels = {0.0, 0.2, 0.6, 0.8, 1.0};
  rod.tip = 2;
  rod.middle = {c, c};
  rod.high = {1.5, 1.0, 1.5};
  rod.ends_held = false;
  rod.thickness = 0.1;
  return rod;
}

/// The coarse blocks of an extrusion with the points of the interface that their samples need.
class ExtrudedBlocks
{
public:
  ExtrudedBlocks(const Extrusion& shape, int degree) : shape_(shape)
  {
    graph.dim = 3;
    graph.degree = degree;
    graph.thickness = shape.thickness;
    graph.size = shape.height();
    list_blocks();
    make_corners();
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      make_block(blocks_[b]);
    graph.interface_count = nodes.size();
  }

  CornerGraph graph;
  std::vector<Vector3> nodes;

private:
  /// A face of a block: at one end of a direction.
  using Face = std::pair<int, int>;

  struct Source
  {
    int quad;
    int level;
    std::vector<Face> faces;  ///< on the interface
  };

  using Key = std::array<long, 3>;

  static Key key(const Vector3& x)
  {
    return {std::lround(x[0] * 1e8), std::lround(x[1] * 1e8), std::lround(x[2] * 1e8)};
  }

  std::array<double, 2> side(int a, int b, double t) const
  {
    const auto& p = shape_.points[a];
    const auto& q = shape_.points[b];
    if (!shape_.arcs.count(std::minmax(a, b)))
      return {p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])};
    const double from = std::atan2(p[1] - shape_.middle[1], p[0] - shape_.middle[0]);
    double turn = std::atan2(q[1] - shape_.middle[1], q[0] - shape_.middle[0]) - from;
    turn = std::remainder(turn, 2.0 * std::acos(-1.0));
    const double radius = std::hypot(p[0] - shape_.middle[0], p[1] - shape_.middle[1]);
    return {shape_.middle[0] + radius * std::cos(from + t * turn),
            shape_.middle[1] + radius * std::sin(from + t * turn)};
  }

  /// First place of a point of a block.
  Vector3 first(const Source& source, const Vector3& r) const
  {
    const std::array<int, 4>& q = shape_.quads[source.quad];
    const double u = r[0];
    const double w = r[2];
    const auto bottom = side(q[0], q[1], u);
    const auto top = side(q[3], q[2], u);
    const auto left = side(q[0], q[3], w);
    const auto right = side(q[1], q[2], w);
    std::array<double, 2> x{};
    for (int i = 0; i < 2; ++i)
      x[i] = (1.0 - w) * bottom[i] + w * top[i] + (1.0 - u) * left[i] + u * right[i] -
             (1.0 - u) * (1.0 - w) * shape_.points[q[0]][i] - u * (1.0 - w) * shape_.points[q[1]][i] -
             u * w * shape_.points[q[2]][i] - (1.0 - u) * w * shape_.points[q[3]][i];
    const double low = shape_.levels[source.level];
    return {x[0], low + r[1] * (shape_.levels[source.level + 1] - low), x[1]};
  }

  void list_blocks()
  {
    std::map<std::pair<int, int>, int> sides;  // of the body's quadrilaterals, how often
    for (std::size_t q = 0; q < shape_.quads.size(); ++q)
      for (int k = 0; k < 4 && shape_.body[q]; ++k)
        ++sides[std::minmax(shape_.quads[q][k], shape_.quads[q][(k + 1) % 4])];
    const std::array<Face, 4> face_of_side = {{{2, 0}, {0, 1}, {2, 1}, {0, 0}}};
    for (int level = 0; level + 1 < static_cast<int>(shape_.levels.size()); ++level)
      for (std::size_t q = 0; q < shape_.quads.size(); ++q)
      {
        if (shape_.body[q] && level < shape_.tip)
          continue;
        Source source{static_cast<int>(q), level, {}};
        for (int k = 0; k < 4 && level < shape_.tip; ++k)
        {
          const auto at = sides.find(std::minmax(shape_.quads[q][k], shape_.quads[q][(k + 1) % 4]));
          if (at != sides.end() && at->second == 1)
            source.faces.push_back(face_of_side[k]);
        }
        if (shape_.body[q] && level == shape_.tip)
          source.faces.push_back({1, 0});
        blocks_.push_back(source);
        remember_interface(source);
      }
  }

  /// Middles of edges on the interface, its corners, and many of its points.
  void remember_interface(const Source& source)
  {
    for (const auto& [axis, end] : source.faces)
    {
      const int a = (axis + 1) % 3;
      const int b = (axis + 2) % 3;
      Vector3 r = Vector3::Constant(0.5);
      r[axis] = end;
      for (const int other : {a, b})
        for (const double place : {0.0, 1.0})
        {
          Vector3 middle = r;
          middle[other] = place;
          edges_.insert(key(first(source, middle)));
        }
      for (int i = 0; i <= 24; ++i)
        for (int k = 0; k <= 24; ++k)
        {
          r[a] = i / 24.0;
          r[b] = k / 24.0;
          cloud_.push_back(first(source, r));
          if (i % 24 == 0 && k % 24 == 0)
            interface_corners_.insert(key(cloud_.back()));
        }
    }
  }

  std::int32_t node(const Vector3& x)
  {
    const auto [at, added] = numbers_.try_emplace(key(x), static_cast<std::int32_t>(nodes.size()));
    if (added)
      nodes.push_back(x);
    return at->second;
  }

  void make_corners()
  {
    for (const double y : shape_.levels)
      for (const auto& [x, z] : shape_.points)
        graph.corners.emplace_back().x = {x, y, z};
    for (const Source& source : blocks_)
      for (const int c : corners(source))
        graph.corners[c].used = true;
    for (Corner& corner : graph.corners)
      if (corner.used)
        constrain(corner);
  }

  void constrain(Corner& corner)
  {
    const Vector3 x(corner.x[0], corner.x[1], corner.x[2]);
    if (interface_corners_.count(key(x)))
    {
      corner.led = {{node(x), 1.0}};
      return;
    }
    std::array<bool, 3> held{};
    for (int i = 0; i < 3; ++i)
      held[i] = x[i] == shape_.low[i] || x[i] == shape_.high[i];
    if (shape_.ends_held && held[0])
      return;
    for (int i = 0; i < 3; ++i)
      if (!held[i])
        corner.direction[corner.freedom++][i] = 1.0;
  }

  std::array<int, 8> corners(const Source& source) const
  {
    std::array<int, 8> result{};
    const std::array<int, 4>& q = shape_.quads[source.quad];
    for (int c = 0; c < 8; ++c)
    {
      const auto& r = element::corners(element::Shape::hexahedron)[c];
      const int u = r[0] == 1.0 ? 1 : 0;
      const int level = source.level + (r[1] == 1.0 ? 1 : 0);
      result[c] = level * static_cast<int>(shape_.points.size()) + q[r[2] == 1.0 ? 3 - u : u];
    }
    return result;
  }

  void make_block(const Source& source)
  {
    CoarseBlock block;
    block.shape = element::Shape::hexahedron;
    const std::array<int, 8> numbers = corners(source);
    block.corners.assign(numbers.begin(), numbers.end());
    const CornerSamples samples = corner_samples(block.shape, graph.degree);
    for (int s = 0; s < samples.count; ++s)
    {
      const Vector3 r(samples.point[s][0], samples.point[s][1], samples.point[s][2]);
      const Vector3 x = first(source, r);
      block.x.insert(block.x.end(), x.begin(), x.end());
      double least = std::numeric_limits<double>::infinity();
      for (const Vector3& other : cloud_)
        least = std::min(least, (other - x).squaredNorm());
      block.distance.push_back(std::sqrt(least));
      bend_faces(source, block, s, r);
      bend_edges(source, block, s, r);
    }
    graph.blocks.push_back(std::move(block));
  }

  static double ramp(const Vector3& r, int axis, int end) { return end ? r[axis] : 1.0 - r[axis]; }

  void bend_faces(const Source& source, CoarseBlock& block, int sample, const Vector3& r)
  {
    for (const auto& [axis, end] : source.faces)
    {
      Vector3 projected = r;
      projected[axis] = end;
      bend(source, block, sample, ramp(r, axis, end), projected);
    }
  }

  void bend_edges(const Source& source, CoarseBlock& block, int sample, const Vector3& r)
  {
    for (int along = 0; along < 3; ++along)
    {
      const int a = (along + 1) % 3;
      const int b = (along + 2) % 3;
      for (const int i : {0, 1})
        for (const int k : {0, 1})
        {
          Vector3 middle = Vector3::Constant(0.5);
          middle[a] = i;
          middle[b] = k;
          if (!edges_.count(key(first(source, middle))))
            continue;
          const auto open = [&](Face face)
          { return std::find(source.faces.begin(), source.faces.end(), face) == source.faces.end(); };
          const int count = (open({a, i}) ? 1 : 0) + (open({b, k}) ? 1 : 0) - 1;
          Vector3 projected = r;
          projected[a] = i;
          projected[b] = k;
          bend(source, block, sample, count * ramp(r, a, i) * ramp(r, b, k), projected);
        }
    }
  }

  /// weight (d - I d) at a point of the interface.
  void bend(const Source& source, CoarseBlock& block, int sample, double weight, const Vector3& r)
  {
    if (weight == 0.0)
      return;
    block.bends.push_back({sample, {node(first(source, r)), weight}});
    for (int c = 0; c < 8; ++c)
    {
      double basis = 1.0;
      for (int k = 0; k < 3; ++k)
        basis *= ramp(r, k, element::corners(element::Shape::hexahedron)[c][k] == 1.0 ? 1 : 0);
      if (basis != 0.0)
        block.bends.push_back({sample, {graph.corners[block.corners[c]].led.at(0).node, -weight * basis}});
    }
  }

  Extrusion shape_;
  std::vector<Source> blocks_;
  std::set<Key> edges_;
  std::set<Key> interface_corners_;
  std::vector<Vector3> cloud_;
  std::map<Key, std::int32_t> numbers_;
};

enum class Twist
{
  bend,   ///< about z, linear in the height
  root,   ///< about z, smoothly in the lowest part, the rest is straight
  twist,  ///< about y
  side    ///< about x
};

/// Where a body goes whose axis along y turns by an angle at its tip.
inline Vector3 bent_body(const Extrusion& shape, Twist kind, double angle, double share, const Vector3& X)
{
  const double height = shape.height();
  const auto frame = [&](double t)
  {
    const double q = std::clamp(t / share, 0.0, 1.0);
    const double turn = kind == Twist::root ? angle * (3.0 * q * q - 2.0 * q * q * q) : angle * t;
    const Vector3 axis = kind == Twist::twist
                             ? Vector3::UnitY()
                             : (kind == Twist::side ? Vector3::UnitX() : Vector3(0.0, 0.0, -1.0));
    return Eigen::AngleAxisd(turn, axis).toRotationMatrix().eval();
  };
  static const element::Rule rule = element::gauss(16);
  const double t = X[1] / height;
  const double kink = kind == Twist::root ? std::min(t, share) : t;
  Vector3 x(shape.middle[0], 0.0, shape.middle[1]);
  for (const auto& [a, b] : {std::pair{0.0, kink}, {kink, t}})
    for (std::size_t k = 0; k < rule.points.size(); ++k)
      x += rule.weights[k] * (b - a) * height * frame(a + (b - a) * rule.points[k]).col(1);
  return x + frame(t) * Vector3(X[0] - shape.middle[0], 0.0, X[2] - shape.middle[1]);
}

/// Least det J / (|x_u| |x_v| |x_w|) over the samples of all blocks.
inline double least_scaled_jacobian(const ExtrudedBlocks& blocks, const std::vector<double>& d,
                                    const std::vector<double>& U)
{
  const CornerSamples samples = corner_samples(element::Shape::hexahedron, blocks.graph.degree);
  double least = 1.0;
  const int n = blocks.graph.degree + 1;
  const element::Table line = element::lagrange(element::lobatto(n - 1), element::lobatto(n - 1));
  std::vector<double> x;
  for (const CoarseBlock& block : blocks.graph.blocks)
  {
    x = block.x;
    for (int s = 0; s < samples.count; ++s)
      for (int c = 0; c < 8; ++c)
        for (int i = 0; i < 3; ++i)
          x[3 * s + i] += samples.basis[8 * s + c] * U[3 * block.corners[c] + i];
    for (const CoarseBlock::Bend& term : block.bends)
      for (int i = 0; i < 3; ++i)
        x[3 * term.sample + i] += term.share.weight * d[3 * term.share.node + i];
    const std::array<int, 3> stride = {n * n, n, 1};
    for (int s = 0; s < samples.count; ++s)
    {
      Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
      for (int axis = 0; axis < 3; ++axis)
      {
        const int here = s / stride[axis] % n;
        for (int m = 0; m < n; ++m)
          for (int i = 0; i < 3; ++i)
            J(i, axis) += line.first[here * n + m] * x[3 * (s + (m - here) * stride[axis]) + i];
      }
      least = std::min(least, J.determinant() / (J.col(0).norm() * J.col(1).norm() * J.col(2).norm()));
    }
  }
  return least;
}

/// Displacements of the interface points of some blocks.
inline std::vector<double> body_displacement(const ExtrudedBlocks& blocks, const Extrusion& shape, Twist kind,
                                             double degrees, double share)
{
  std::vector<double> d;
  for (const Vector3& X : blocks.nodes)
  {
    const Vector3 u = bent_body(shape, kind, degrees * std::acos(-1.0) / 180.0, share, X) - X;
    d.insert(d.end(), u.begin(), u.end());
  }
  return d;
}

/// The largest angle [degrees] up to which all blocks stay valid at their samples, in steps.
struct BodySweep
{
  double last = 0.0;
  std::map<double, double> scaled_jacobian;
  int iterations = 0;
};

inline BodySweep sweep(const Extrusion& shape, CornerMotion& motion, const ExtrudedBlocks& rule,
                       const ExtrudedBlocks& check, Twist kind, double step, double end, double share = 0.3)
{
  BodySweep result;
  std::vector<double> U(3 * rule.graph.corners.size());
  for (double angle = step; angle <= end + 1e-9; angle += step)
  {
    const std::vector<double> d = body_displacement(rule, shape, kind, angle, share);
    result.iterations += motion.follow(d, U).iterations;
    result.scaled_jacobian[angle] =
        least_scaled_jacobian(check, body_displacement(check, shape, kind, angle, share), U);
    if (!(result.scaled_jacobian[angle] > 0.0))
      break;
    result.last = angle;
  }
  return result;
}

}  // namespace blockfsi::block::testing
