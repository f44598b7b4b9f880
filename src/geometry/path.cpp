#include "geometry/path.hpp"

#include "geometry/arc.hpp"
#include "geometry/difference.hpp"
#include "geometry/lagrange.hpp"
#include "geometry/overloaded.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

namespace blockfsi::geometry
{

namespace
{

using raw::Line;
using raw::Polynomial;
using raw::Projected;
using raw::Turn;

/// Parameters proportional to the summed chords, from 0 to 1.
std::vector<double> chord_parameters(const std::vector<Point>& points)
{
  std::vector<double> parameters(points.size(), 0.0);
  for (std::size_t i = 1; i < points.size(); ++i)
    parameters[i] = parameters[i - 1] + distance(points[i - 1], points[i]);
  for (double& parameter : parameters)
    parameter /= parameters.back();
  parameters.back() = 1.0;
  return parameters;
}

/// From the smaller to the larger end, so that both directions compute the same.
Polynomial make_polynomial(const Through& through, const Point& a, const Point& b, bool reversed)
{
  Polynomial result;
  result.points = through.points;
  result.parameters = through.parameters;
  if (reversed)
  {
    std::reverse(result.points.begin(), result.points.end());
    std::reverse(result.parameters.begin(), result.parameters.end());
    for (double& parameter : result.parameters)
      parameter = 1.0 - parameter;
  }
  result.points.insert(result.points.begin(), a);
  result.points.push_back(b);
  if (through.parameters.empty())
    result.parameters = chord_parameters(result.points);
  else
  {
    result.parameters.insert(result.parameters.begin(), 0.0);
    result.parameters.push_back(1.0);
  }
  return result;
}

Point value(const Line& line, double u)
{
  return combine(1.0 - u, line.a, u, line.b);
}

Point slope(const Line& line, double)
{
  return subtract(line.b, line.a);
}

Point value(const Turn& turn, double u)
{
  const double angle = turn.start + u * turn.angle;
  return add(turn.center, combine(std::cos(angle), turn.first, std::sin(angle), turn.second));
}

Point slope(const Turn& turn, double u)
{
  const double angle = turn.start + u * turn.angle;
  return scaled(turn.angle, combine(-std::sin(angle), turn.first, std::cos(angle), turn.second));
}

Point value(const Polynomial& polynomial, double u)
{
  BasisValues N;
  lagrange(polynomial.parameters, u, N);
  Point x{};
  for (std::size_t i = 0; i < polynomial.points.size(); ++i)
    x = add_scaled(x, N.value[i], polynomial.points[i]);
  return x;
}

Point slope(const Polynomial& polynomial, double u)
{
  BasisValues N;
  lagrange(polynomial.parameters, u, N);
  Point x{};
  for (std::size_t i = 0; i < polynomial.points.size(); ++i)
    x = add_scaled(x, N.first[i], polynomial.points[i]);
  return x;
}

Point value(const Formula* formula, double u)
{
  return {formula->x[0](0.0, 0.0, 0.0, u), formula->x[1](0.0, 0.0, 0.0, u), formula->x[2](0.0, 0.0, 0.0, u)};
}

Point slope(const Formula* formula, double u)
{
  Point result{};
  for (std::size_t c = 0; c < 3; ++c)
    if (!formula->x[c].is_constant())
      result[c] = formula->x[c].derivatives(0.0, 0.0, 0.0, u).by[3];
  return result;
}

Point value(const Projected& projected, double u)
{
  return evaluate(projected.curve, projected.a, projected.b, u);
}

Point slope(const Projected& projected, double u)
{
  return differentiate([&](double t) { return value(projected, t); }, u);
}

Point value(const NurbsCurve* curve, double u)
{
  return evaluate(*curve, u);
}

Point slope(const NurbsCurve* curve, double u)
{
  return jet(*curve, u).first;
}

Point value(const NurbsPart& part, double u)
{
  return evaluate(*part.curve, part.parameter(u));
}

Point slope(const NurbsPart& part, double u)
{
  return scaled(part.to - part.from, jet(*part.curve, part.parameter(u)).first);
}

Point value(const Function* function, double u)
{
  return function->x(u);
}

Point slope(const Function* function, double u)
{
  return function->derivative ? function->derivative(u) : differentiate(function->x, u);
}

std::vector<double> equal_breaks(int pieces)
{
  std::vector<double> result;
  for (int i = 0; i <= pieces; ++i)
    result.push_back(static_cast<double>(i) / pieces);
  return result;
}

std::vector<double> breaks_of(const raw::Any& any)
{
  constexpr int pieces_of_formula = 16;  // so that no wiggle is missed
  return std::visit(Overloaded{[](const Turn&) { return equal_breaks(4); },
                               [](const Polynomial& p)
                               { return equal_breaks(static_cast<int>(p.points.size())); },
                               [](const NurbsCurve* curve) { return breaks(curve->knots); },
                               [](const NurbsPart& part) { return breaks(part); },
                               [](const auto&) { return equal_breaks(pieces_of_formula); }},
                    any);
}

template <typename Raw>
auto speed_of(const Raw& any)
{
  return [&any](double u) { return norm(slope(any, u)); };
}

/// The way to compute a curve from the smaller end a to the larger end b; curves with a direction of their
/// own keep it.
raw::Any make_raw(const Curve& curve, const Point& a, const Point& b, bool reversed)
{
  return std::visit(Overloaded{[&](const Segment&) -> raw::Any {
                                 return Line{a, b};
                               },
                               [&](const Arc& arc) -> raw::Any { return make_turn(arc, a, b, reversed); },
                               [&](const ArcThrough& arc) -> raw::Any { return make_turn(arc, a, b); },
                               [&](const Ellipse& ellipse) -> raw::Any { return make_turn(ellipse, a, b); },
                               [&](const Through& through) -> raw::Any
                               { return make_polynomial(through, a, b, reversed); },
                               [&](const OnLevelSet& c) -> raw::Any {
                                 return Projected{c.lengths || !c.by_length ? c : measured(c, a, b), a, b};
                               },
                               [](const Formula& formula) -> raw::Any { return &formula; },
                               [&](const Spline& spline) -> raw::Any
                               {
                                 if (spline.part)
                                   return part_between(spline.curve, a, b, spline.longer);
                                 return &spline.curve;
                               },
                               [](const Function& function) -> raw::Any { return &function; }},
                    curve);
}

/// Lengths that were measured from one end are not those from the other one.
bool is_measured(const Curve& curve)
{
  const auto* on_level_set = std::get_if<OnLevelSet>(&curve);
  return on_level_set && on_level_set->lengths;
}

bool has_own_direction(const Curve& curve)
{
  const auto* spline = std::get_if<Spline>(&curve);
  return std::holds_alternative<Formula>(curve) || (spline && !spline->part) ||
         std::holds_alternative<Function>(curve);
}

/// Whether t is the parameter of the curve itself, because that runs evenly or because the user wants so.
bool keeps_parameter(const Curve& curve)
{
  return std::visit(Overloaded{[](const Segment&) { return true; }, [](const Arc&) { return true; },
                               [](const ArcThrough&) { return true; }, [](const Ellipse&) { return false; },
                               [](const OnLevelSet&) { return true; },
                               [](const auto& other) { return other.speed == Speed::own; }},
                    curve);
}

double miss(const std::array<Point, 2>& ends, const Point& a, const Point& b)
{
  return std::max(distance(ends[0], a), distance(ends[1], b));
}

}  // namespace

Path::Path(const Curve& curve, const Point& a, const Point& b) : ends_{a, b}
{
  const bool directed = has_own_direction(curve);
  reversed_ = !directed && !is_measured(curve) && b < a;
  if (reversed_)
    std::swap(ends_[0], ends_[1]);
  raw_ = make_raw(curve, ends_[0], ends_[1], reversed_);
  own_ends_ = std::visit([](const auto& any) { return std::array{value(any, 0.0), value(any, 1.0)}; }, raw_);
  constexpr double clearly =
      1e-3;  // else the error of a curve that fits neither way would tell of the other one
  if (directed && miss(own_ends_, b, a) < clearly * miss(own_ends_, a, b))
  {
    reversed_ = true;
    std::swap(ends_[0], ends_[1]);
  }
  misfit_ = miss(own_ends_, ends_[0], ends_[1]);
  gaps_ = {subtract(ends_[0], own_ends_[0]), subtract(ends_[1], own_ends_[1])};
  if (std::holds_alternative<Line>(raw_))
    length_ = distance(a, b);
  else if (const auto* turn = std::get_if<Turn>(&raw_); turn && keeps_parameter(curve))
    length_ = norm(turn->first) * turn->angle;
  else if (const auto* projected = std::get_if<Projected>(&raw_))
    length_ = geometry::length(projected->curve, a, b);
  else
  {
    table_ = std::visit([&](const auto& any) { return measure(speed_of(any), breaks_of(raw_)); }, raw_);
    length_ = table_.total();
    if (keeps_parameter(curve))
      table_ = {};
  }
}

template <typename Raw>
Point Path::point(const Raw& any, double t) const
{
  const double s = reversed_ ? 1.0 - t : t;
  if (s == 0.0)
    return ends_[0];
  if (s == 1.0)
    return ends_[1];
  const double u = table_.parameter.empty() ? s : parameter_at(table_, speed_of(any), s);
  return add(value(any, u), combine(1.0 - s, gaps_[0], s, gaps_[1]));
}

Point Path::evaluate(double t) const
{
  return std::visit([&](const auto& any) { return point(any, t); }, raw_);
}

void Path::evaluate(std::span<const double> t, std::span<Point> x) const
{
  assert(t.size() == x.size());
  std::visit(
      [&](const auto& any)
      {
        for (std::size_t i = 0; i < t.size(); ++i)
          x[i] = point(any, t[i]);
      },
      raw_);
}

Point Path::derivative(double t) const
{
  const double s = reversed_ ? 1.0 - t : t;
  Point result = std::visit(
      [&](const auto& any)
      {
        if (table_.parameter.empty())
          return slope(any, s);
        const Point tangent = slope(any, parameter_at(table_, speed_of(any), s));
        const double speed = norm(tangent);
        return speed > 0.0 ? scaled(length_ / speed, tangent) : Point{};
      },
      raw_);
  result = add(result, subtract(gaps_[1], gaps_[0]));
  return reversed_ ? scaled(-1.0, result) : result;
}

}  // namespace blockfsi::geometry
