#pragma once

#include "geometry/curve.hpp"
#include "geometry/length_table.hpp"
#include "geometry/nurbs_part.hpp"

#include <span>
#include <variant>
#include <vector>

namespace blockfsi::geometry
{

/// The ways in which points of curves are computed, each for u from 0 to 1.
namespace raw
{

struct Line
{
  Point a{};
  Point b{};
};

/// x = center + cos θ first + sin θ second, θ = start + u angle.
struct Turn
{
  Point center{};
  Point first{};
  Point second{};
  double start = 0.0;
  double angle = 0.0;
};

struct Polynomial
{
  std::vector<double> parameters;
  std::vector<Point> points;
};

/// An edge on a level set with its length measured.
struct Projected
{
  OnLevelSet curve;
  Point a{};
  Point b{};
};

using Any = std::variant<Line, Turn, Polynomial, Projected, const Formula*, const NurbsCurve*, NurbsPart,
                         const Function*>;

}  // namespace raw

/// A curve from a to b made ready for many points: its direction found, its length measured where its own
/// parameter runs unevenly. Refers to the curve, which must outlive it.
class Path
{
public:
  /// The curve must fit between a and b (see `check`).
  Path(const Curve& curve, const Point& a, const Point& b);

  double length() const { return length_; }
  /// The point at t; exactly a at 0 and b at 1. From b to a on the same curve, the point at 1 - t is the same
  /// bit for bit, if 1 - t is exact.
  Point evaluate(double t) const;
  /// Points at many parameters, shapes (t.size()). Allocates nothing.
  void evaluate(std::span<const double> t, std::span<Point> x) const;
  /// dx/dt; |dx/dt| is the length unless the curve keeps its own speed.
  Point derivative(double t) const;
  /// How far the ends of the curve miss a and b [m].
  double misfit() const { return misfit_; }
  /// The curve's own point at u = 0 (a) or 1 (b), as a to b see it.
  const Point& own_end(int end) const { return own_ends_[reversed_ ? 1 - end : end]; }

private:
  template <typename Raw>
  Point point(const Raw& raw, double t) const;

  raw::Any raw_;
  std::array<Point, 2> ends_{};      ///< a and b in the curve's own direction
  std::array<Point, 2> own_ends_{};  ///< of the curve
  std::array<Point, 2> gaps_{};      ///< from own to wanted ends
  LengthTable table_;                ///< empty where t is the curve's parameter
  bool reversed_ = false;
  double length_ = 0.0;
  double misfit_ = 0.0;
};

}  // namespace blockfsi::geometry
