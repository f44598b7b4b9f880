#include "geometry/curve.hpp"

#include "core/error.hpp"
#include "element/line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace blockfsi::geometry
{

namespace
{

constexpr double fit_tolerance = 1e-9;  ///< relative misfit that the user's rounded numbers may have

template <typename... Functions>
struct Overloaded : Functions...
{
  using Functions::operator()...;
};
template <typename... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

/// Angle at `center` between a and b, 0..pi; atan2 is accurate for small and for flat angles.
double opening_angle(const Point& center, const Point& a, const Point& b)
{
  const Point r = subtract(a, center);
  const Point s = subtract(b, center);
  return std::atan2(norm(cross(r, s)), dot(r, s));
}

/// Start, inner points, end.
std::vector<Point> all_points(const Through& through, const Point& a, const Point& b)
{
  std::vector<Point> points{a};
  points.insert(points.end(), through.points.begin(), through.points.end());
  points.push_back(b);
  return points;
}

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

Point evaluate_arc(const Arc& arc, const Point& a, const Point& b, double t)
{
  const double angle = opening_angle(arc.center, a, b);
  const double from_a = std::sin((1.0 - t) * angle) / std::sin(angle);
  const double from_b = std::sin(t * angle) / std::sin(angle);
  const Point radius = combine(from_a, subtract(a, arc.center), from_b, subtract(b, arc.center));
  return combine(1.0, arc.center, 1.0, radius);
}

Point evaluate_through(const Through& through, const Point& a, const Point& b, double t)
{
  const std::vector<Point> points = all_points(through, a, b);
  const element::Table table = element::lagrange(chord_parameters(points), std::span(&t, 1));
  Point x{};
  for (std::size_t i = 0; i < points.size(); ++i)
    x = combine(1.0, x, table.value[i], points[i]);
  return x;
}

Point evaluate_formula(const Formula& formula, double t)
{
  Point x{};
  for (std::size_t c = 0; c < 3; ++c)
    x[c] = formula.x[c](0.0, 0.0, 0.0, t);
  return x;
}

/// Length of the polygon through n + 1 points of the curve.
double polygon_length(const Curve& curve, const Point& a, const Point& b, int n)
{
  double sum = 0.0;
  Point before = a;
  for (int i = 1; i <= n; ++i)
  {
    const Point next = evaluate(curve, a, b, static_cast<double>(i) / n);
    sum += distance(before, next);
    before = next;
  }
  return sum;
}

/// Polygons of 32, 64, ... chords, extrapolated in the square of the step (Romberg): error h^10 on smooth
/// curves.
double extrapolated_length(const Curve& curve, const Point& a, const Point& b)
{
  constexpr int levels = 5;
  std::array<double, levels> row{};
  for (int level = 0; level < levels; ++level)
  {
    double coarser = row[0];
    row[0] = polygon_length(curve, a, b, 32 << level);
    double factor = 1.0;
    for (int k = 1; k <= level; ++k)
    {
      factor *= 4.0;
      const double improved = row[k - 1] + (row[k - 1] - coarser) / (factor - 1.0);
      coarser = row[k];
      row[k] = improved;
    }
  }
  return row[levels - 1];
}

void check_arc(const Arc& arc, const Point& a, const Point& b)
{
  const double radius_a = distance(a, arc.center);
  const double radius_b = distance(b, arc.center);
  const double radius = std::max(radius_a, radius_b);
  if (!(std::abs(radius_a - radius_b) <= fit_tolerance * radius))
    throw Error(
        fmt::format("the arc's end points {} and {} are {:.12g} m and {:.12g} m away from its centre {}; "
                    "both must have the same distance, so correct the centre or an end point",
                    text(a), text(b), radius_a, radius_b, text(arc.center)));
  if (std::sin(opening_angle(arc.center, a, b)) < fit_tolerance)
    throw Error(
        fmt::format("the arc from {} to {} about {} is half a circle, so its shorter way round is not "
                    "defined; split the edge by a point on the arc or give the curve as a formula",
                    text(a), text(b), text(arc.center)));
}

void check_through(const Through& through, const Point& a, const Point& b)
{
  const std::vector<Point> points = all_points(through, a, b);
  for (std::size_t i = 1; i < points.size(); ++i)
    if (!(distance(points[i - 1], points[i]) > 0.0))
      throw Error(
          fmt::format("the curve passes through {} twice in a row; each of its points, the ends included, "
                      "must differ from the one before",
                      text(points[i])));
}

void check_formula(const Formula& formula, const Point& a, const Point& b)
{
  const double size = length(formula, a, b);
  for (const double t : {0.0, 1.0})
  {
    const Point& wanted = t == 0.0 ? a : b;
    const Point found = evaluate_formula(formula, t);
    if (!(distance(found, wanted) <= fit_tolerance * size))
      throw Error(
          fmt::format("the formula of the curve gives {} at t = {} but the edge {} at {}; correct the "
                      "formula, the point or the order of the edge's points",
                      text(found), t, t == 0.0 ? "starts" : "ends", text(wanted)));
  }
  if (!std::isfinite(size))
    throw Error("the formula of the curve has no finite value somewhere between t = 0 and t = 1");
}

}  // namespace

void check(const Curve& curve, const Point& a, const Point& b)
{
  if (a == b)
    throw Error(fmt::format("the edge starts and ends at {}; an edge needs two different ends", text(a)));
  std::visit(Overloaded{[](const Segment&) {}, [&](const Arc& arc) { check_arc(arc, a, b); },
                        [&](const Through& through) { check_through(through, a, b); },
                        [&](const Formula& formula) { check_formula(formula, a, b); },
                        [&](const OnLevelSet& on_level_set) { check(on_level_set, a, b); }},
             curve);
}

Point evaluate(const Curve& curve, const Point& a, const Point& b, double t)
{
  if (t == 0.0)
    return a;
  if (t == 1.0)
    return b;
  return std::visit(Overloaded{[&](const Segment&) { return combine(1.0 - t, a, t, b); },
                               [&](const Arc& arc) { return evaluate_arc(arc, a, b, t); },
                               [&](const Through& through) { return evaluate_through(through, a, b, t); },
                               [&](const Formula& formula) { return evaluate_formula(formula, t); },
                               [&](const OnLevelSet& on_level_set)
                               { return evaluate(on_level_set, a, b, t); }},
                    curve);
}

double length(const Curve& curve, const Point& a, const Point& b)
{
  if (std::holds_alternative<Segment>(curve))
    return distance(a, b);
  if (const auto* arc = std::get_if<Arc>(&curve))
    return distance(a, arc->center) * opening_angle(arc->center, a, b);
  if (const auto* on_level_set = std::get_if<OnLevelSet>(&curve))
    return (on_level_set->lengths ? *on_level_set : measured(*on_level_set, a, b)).lengths->length();
  return extrapolated_length(curve, a, b);
}

}  // namespace blockfsi::geometry
