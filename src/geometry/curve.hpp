#pragma once

#include "core/expression.hpp"
#include "geometry/on_level_set.hpp"
#include "geometry/point.hpp"

#include <array>
#include <variant>
#include <vector>

namespace blockfsi::geometry
{

/// The straight line between the end points.
struct Segment
{
};

/// The circular arc between the end points about a centre, the shorter way round.
/// The end points must be equally far from the centre (1e-9 relative).
struct Arc
{
  Point center{};
};

/// The curve of Lagrange's interpolation through the start, the given inner points and the end.
/// Parameters of the points: proportional to the length of the chords.
struct Through
{
  std::vector<Point> points;
};

/// x(t), y(t) for t from 0 at the start to 1 at the end.
/// At both ends the formula must give the end points (1e-9 of the length of the edge).
struct Formula
{
  std::array<Expression, 3> x;
};

/// The geometry of an edge.
using Curve = std::variant<Segment, Arc, Through, Formula, OnLevelSet>;

/// Throws Error if the curve does not fit between a and b.
void check(const Curve& curve, const Point& a, const Point& b);

/// The point of the curve from a to b at parameter t in [0, 1]; exactly a at 0 and b at 1.
Point evaluate(const Curve& curve, const Point& a, const Point& b, double t);

/// Length of the curve [m].
double length(const Curve& curve, const Point& a, const Point& b);

}  // namespace blockfsi::geometry
