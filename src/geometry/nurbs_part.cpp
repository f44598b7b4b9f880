#include "geometry/nurbs_part.hpp"

#include "geometry/length_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace blockfsi::geometry
{

namespace
{

constexpr double rounding = 1e-12;

double square_to(const NurbsCurve& curve, double t, const Point& x)
{
  const Point d = subtract(evaluate(curve, t), x);
  return dot(d, d);
}

double newton(const NurbsCurve& curve, double t, const Point& x)
{
  constexpr int iterations = 60;
  for (int i = 0; i < iterations; ++i)
  {
    const CurveJet c = jet(curve, t);
    const Point d = subtract(c.x, x);
    const double metric = dot(c.first, c.first);
    const double curvature = metric + dot(d, c.second);
    if (!(metric > 0.0))
      return t;
    const double step = -dot(d, c.first) / (curvature > rounding * metric ? curvature : metric);
    double share = 1.0;
    double next = std::clamp(t + step, 0.0, 1.0);
    while (square_to(curve, next, x) > dot(d, d) && share > 1e-6)
    {
      share *= 0.5;
      next = std::clamp(t + share * step, 0.0, 1.0);
    }
    const bool last = std::abs(next - t) <= 1e-15;
    t = next;
    if (last)
      break;
  }
  return t;
}

double length_of(const NurbsPart& part)
{
  const auto speed = [&](double u)
  { return std::abs(part.to - part.from) * norm(jet(*part.curve, part.parameter(u)).first); };
  return measure(speed, breaks(part)).total();
}

bool is_closed(const NurbsCurve& curve)
{
  double size = 0.0;
  for (const Point& p : curve.points)
    size = std::max(size, distance(p, curve.points.front()));
  return distance(curve.points.front(), curve.points.back()) <= 1e-9 * size;
}

}  // namespace

double NurbsPart::parameter(double u) const
{
  const double t = (1.0 - u) * from + u * to;
  return t < 0.0 ? t + 1.0 : t > 1.0 ? t - 1.0 : t;
}

double closest_parameter(const NurbsCurve& curve, const Point& x)
{
  const std::vector<double> at = breaks(curve.knots);
  const int samples = 4 * (curve.degree + 1);
  double best = 0.0;
  double smallest = square_to(curve, 0.0, x);
  for (std::size_t i = 1; i < at.size(); ++i)
    for (int k = 1; k <= samples; ++k)
    {
      const double t = k == samples ? at[i] : at[i - 1] + (at[i] - at[i - 1]) * k / samples;
      if (const double square = square_to(curve, t, x); square < smallest)
      {
        smallest = square;
        best = t;
      }
    }
  return newton(curve, best, x);
}

NurbsPart part_between(const NurbsCurve& curve, const Point& a, const Point& b, bool longer)
{
  const NurbsPart inside{&curve, closest_parameter(curve, a), closest_parameter(curve, b)};
  if (!is_closed(curve))
    return inside;
  // The seam may be meant as either end of the parameters.
  const NurbsPart around{&curve, inside.from, inside.from < inside.to ? inside.to - 1.0 : inside.to + 1.0};
  return (length_of(around) < length_of(inside)) != longer ? around : inside;
}

std::vector<double> breaks(const NurbsPart& part)
{
  std::vector<double> result{0.0};
  std::vector<double> inner;
  for (const double t : breaks(part.curve->knots))
    for (const double turned : {t - 1.0, t, t + 1.0})
      if (const double u = (turned - part.from) / (part.to - part.from); u > rounding && u < 1.0 - rounding)
        inner.push_back(u);
  std::sort(inner.begin(), inner.end());
  for (const double u : inner)
    if (u > result.back() + rounding)
      result.push_back(u);
  result.push_back(1.0);
  return result;
}

}  // namespace blockfsi::geometry
