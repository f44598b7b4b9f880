#pragma once

#include "core/expression.hpp"
#include "geometry/nurbs.hpp"
#include "geometry/on_level_set.hpp"
#include "geometry/point.hpp"

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace blockfsi::geometry
{

/// What the parameter t from 0 to 1 of an edge means on a curve whose own parameter runs unevenly.
enum class Speed
{
  constant,  ///< the share of the length, so that gradings give true sizes
  own        ///< the curve's own parameter, as for high-order elements whose nodes it places
};

/// The straight line between the end points.
struct Segment
{
};

/// The circular arc between the end points about a centre.
/// The end points must be equally far from the centre (1e-9 relative).
struct Arc
{
  Point center{};
  bool longer = false;  ///< the longer way round, else the shorter one
  /// With an axis the arc turns about it, right-handed from the start to the end, by up to a whole turn;
  /// needed for half circles, where both ways are equally long.
  std::optional<Point> axis{};
};

/// The circular arc from the start through a point to the end.
struct ArcThrough
{
  Point point{};
};

/// The part of an ellipse between the end points: x = center + cos θ first + sin θ second, the shorter way in
/// θ.
struct Ellipse
{
  Point center{};
  Point first{1.0, 0.0, 0.0};   ///< vector of one half-axis (or of conjugate half-diameters) [m]
  Point second{0.0, 1.0, 0.0};  ///< vector of the other half-axis [m]
  bool longer = false;          ///< the longer way in θ
};

/// The curve of Lagrange's interpolation through the start, the given inner points and the end: a line
/// element of high order.
struct Through
{
  std::vector<Point> points;
  /// Parameters of the points, ascending between 0 and 1; empty: proportional to the length of the chords.
  std::vector<double> parameters{};
  Speed speed = Speed::constant;
};

/// x(t), y(t), z(t) for t from 0 to 1.
/// At both ends the formula must give the end points, in any order (1e-9 of the length of the edge).
struct Formula
{
  std::array<Expression, 3> x;
  Speed speed = Speed::constant;
};

/// Any function of t from 0 to 1, whose ends fit as those of a formula. Without a derivative this comes from
/// differences.
struct Function
{
  std::function<Point(double t)> x;
  std::function<Point(double t)> derivative{};
  Speed speed = Speed::constant;
};

/// A B-spline or NURBS curve, whose ends fit as those of a formula.
struct Spline
{
  NurbsCurve curve;
  Speed speed = Speed::constant;
  bool part =
      false;  ///< only the part between the end points, which lie on it (1e-6 of the length of the edge)
  bool longer = false;  ///< of the two parts of a closed curve
};

/// The geometry of an edge.
using Curve = std::variant<Segment, Arc, Through, Formula, OnLevelSet, ArcThrough, Ellipse, Spline, Function>;

/// Throws Error if the curve does not fit between a and b.
void check(const Curve& curve, const Point& a, const Point& b);

/// The point of the curve from a to b at t in [0, 1]; exactly a at 0 and b at 1. Where the curve's own ends
/// miss a and b, the miss is spread linearly over it. For many points of one curve use a Path.
Point evaluate(const Curve& curve, const Point& a, const Point& b, double t);

/// Length of the curve [m].
double length(const Curve& curve, const Point& a, const Point& b);

}  // namespace blockfsi::geometry
