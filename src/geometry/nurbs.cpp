#include "geometry/nurbs.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <type_traits>

namespace blockfsi::geometry
{

namespace
{

/// Point and weight.
using Homogeneous = std::array<double, 4>;

void check_points(std::string_view what, const std::vector<Point>& points, const std::vector<double>& weights)
{
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i]))
      throw Error(fmt::format("{}: control point {} is {}; it must be finite", what, i + 1, text(points[i])));
  if (weights.empty())
    return;
  if (weights.size() != points.size())
    throw Error(fmt::format("{}: found {} weights for {} control points; each needs one", what,
                            weights.size(), points.size()));
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (!(weights[i] > 0.0) || !std::isfinite(weights[i]))
      throw Error(fmt::format("{}: weight {} is {:.9g}; it must be positive", what, i + 1, weights[i]));
}

/// The parameter of the knots for t from 0 to 1, exact at both ends.
double knot_parameter(std::span<const double> knots, double t)
{
  return (1.0 - t) * knots.front() + t * knots.back();
}

double knot_range(std::span<const double> knots)
{
  return knots.back() - knots.front();
}

void add(Homogeneous& sum, double factor, const Homogeneous& term)
{
  for (std::size_t c = 0; c < 4; ++c)
    sum[c] += factor * term[c];
}

void add(Homogeneous& sum, double factor, const Point& p)
{
  sum[0] += factor * p[0];
  sum[1] += factor * p[1];
  sum[2] += factor * p[2];
  sum[3] += factor;
}

Point project(const Homogeneous& a)
{
  const double inverse = 1.0 / a[3];
  return {a[0] * inverse, a[1] * inverse, a[2] * inverse};
}

Point head(const Homogeneous& a)
{
  return {a[0], a[1], a[2]};
}

/// (a' - w' x) / w
Point quotient_first(const Homogeneous& a, const Homogeneous& da, const Point& x)
{
  return scaled(1.0 / a[3], add_scaled(head(da), -da[3], x));
}

/// (a_uv - w_u x_v - w_v x_u - w_uv x) / w
Point quotient_second(const Homogeneous& a, const Homogeneous& a_uv, const Homogeneous& a_u,
                      const Homogeneous& a_v, const Point& x, const Point& x_u, const Point& x_v)
{
  Point sum = add_scaled(head(a_uv), -a_u[3], x_v);
  sum = add_scaled(sum, -a_v[3], x_u);
  return scaled(1.0 / a[3], add_scaled(sum, -a_uv[3], x));
}

/// sum_j N_j w_j (p_j, 1) over the control points from `first` on.
Homogeneous weighted_sum(const Point* points, const double* weights, int degree, const double* N)
{
  Homogeneous sum{};
  for (int j = 0; j <= degree; ++j)
    add(sum, weights ? N[j] * weights[j] : N[j], points[j]);
  return sum;
}

/// Calls `work` with the degree as a constant if it is a usual one, which lets the compiler unroll its loops,
/// else as it is.
template <typename Work>
void with_constant(int degree, const Work& work)
{
  switch (degree)
  {
  case 1:
    return work(std::integral_constant<int, 1>{});
  case 2:
    return work(std::integral_constant<int, 2>{});
  case 3:
    return work(std::integral_constant<int, 3>{});
  case 4:
    return work(std::integral_constant<int, 4>{});
  default:
    return work(degree);
  }
}

/// `degree` is that of the curve, as a number or as a constant.
template <typename Degree>
[[gnu::always_inline]] inline Point evaluate_in_span(const NurbsCurve& curve, Degree degree, double k,
                                                     int span)
{
  BasisValues N;
  basis<0>(curve.knots, degree, span, k, N);
  const Point* points = curve.points.data() + span - degree;
  if (curve.weights.empty())
  {
    Point x{};
    for (int j = 0; j <= degree; ++j)
      x = add_scaled(x, N.value[j], points[j]);
    return x;
  }
  const double* weights = curve.weights.data() + span - degree;
  return project(weighted_sum(points, weights, degree, N.value.data()));
}

/// Spans of both directions.
using Spans = std::array<int, 2>;

/// p and q are the degrees of the surface, as numbers or as constants.
template <typename P, typename Q>
[[gnu::always_inline]] inline Point evaluate_in_span(const NurbsSurface& surface, P p, Q q, double ku,
                                                     double kv, const Spans& spans)
{
  BasisValues M;
  BasisValues N;
  basis<0>(surface.knots[0], p, spans[0], ku, M);
  basis<0>(surface.knots[1], q, spans[1], kv, N);
  const std::size_t stride = surface.count(1);
  std::size_t first = (spans[0] - p) * stride + (spans[1] - q);
  if (surface.weights.empty())
  {
    Point x{};
    for (int i = 0; i <= p; ++i, first += stride)
    {
      Point row{};
      for (int j = 0; j <= q; ++j)
        row = add_scaled(row, N.value[j], surface.points[first + j]);
      x = add_scaled(x, M.value[i], row);
    }
    return x;
  }
  Homogeneous sum{};
  for (int i = 0; i <= p; ++i, first += stride)
    add(sum, M.value[i], weighted_sum(&surface.points[first], &surface.weights[first], q, N.value.data()));
  return project(sum);
}

}  // namespace

void check(std::string_view what, const NurbsCurve& curve)
{
  check_knots(what, curve.degree, curve.knots, curve.points.size());
  check_points(what, curve.points, curve.weights);
}

void check(std::string_view what, const NurbsSurface& surface)
{
  constexpr std::array<const char*, 2> names{"u", "v"};
  std::size_t needed = 1;
  for (int d = 0; d < 2; ++d)
  {
    const std::string along = fmt::format("{} along {}", what, names[d]);
    const int degree = surface.degrees[d];
    const std::size_t knots = surface.knots[d].size();
    const std::size_t points =
        degree >= 1 && knots > static_cast<std::size_t>(degree) ? knots - degree - 1 : 0;
    check_knots(along, degree, surface.knots[d], points);
    needed *= points;
  }
  if (surface.points.size() != needed)
    throw Error(fmt::format("{}: found {} control points; the knots and degrees need {} x {} = {}", what,
                            surface.points.size(), surface.count(0), surface.count(1), needed));
  check_points(what, surface.points, surface.weights);
}

Point evaluate(const NurbsCurve& curve, double t)
{
  Point x;
  evaluate(curve, std::span(&t, 1), std::span(&x, 1));
  return x;
}

void evaluate(const NurbsCurve& curve, std::span<const double> t, std::span<Point> x)
{
  assert(t.size() == x.size());
  with_constant(curve.degree,
                [&](auto degree)
                {
                  int span = degree;
                  for (std::size_t i = 0; i < t.size(); ++i)
                  {
                    const double k = knot_parameter(curve.knots, t[i]);
                    span = find_span(curve.knots, degree, k, span);
                    x[i] = evaluate_in_span(curve, degree, k, span);
                  }
                });
}

CurveJet jet(const NurbsCurve& curve, double t)
{
  const double k = knot_parameter(curve.knots, t);
  const double range = knot_range(curve.knots);
  const int span = find_span(curve.knots, curve.degree, k, 0);
  BasisValues N;
  basis<2>(curve.knots, curve.degree, span, k, N);
  const Point* points = curve.points.data() + span - curve.degree;
  const double* weights = curve.weights.empty() ? nullptr : curve.weights.data() + span - curve.degree;
  const Homogeneous a = weighted_sum(points, weights, curve.degree, N.value.data());
  const Homogeneous a_t = weighted_sum(points, weights, curve.degree, N.first.data());
  const Homogeneous a_tt = weighted_sum(points, weights, curve.degree, N.second.data());
  if (curve.weights.empty())
    return {head(a), scaled(range, head(a_t)), scaled(range * range, head(a_tt))};
  const Point x = project(a);
  const Point x_t = quotient_first(a, a_t, x);
  const Point x_tt = quotient_second(a, a_tt, a_t, a_t, x, x_t, x_t);
  return {x, scaled(range, x_t), scaled(range * range, x_tt)};
}

Point evaluate(const NurbsSurface& surface, double u, double v)
{
  Point x;
  evaluate(surface, std::span(&u, 1), std::span(&v, 1), std::span(&x, 1));
  return x;
}

void evaluate(const NurbsSurface& surface, std::span<const double> u, std::span<const double> v,
              std::span<Point> x)
{
  assert(u.size() == x.size() && v.size() == x.size());
  const auto work = [&](auto p, auto q)
  {
    Spans spans = surface.degrees;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      const double ku = knot_parameter(surface.knots[0], u[i]);
      const double kv = knot_parameter(surface.knots[1], v[i]);
      spans = {find_span(surface.knots[0], p, ku, spans[0]), find_span(surface.knots[1], q, kv, spans[1])};
      x[i] = evaluate_in_span(surface, p, q, ku, kv, spans);
    }
  };
  if (surface.degrees[0] == surface.degrees[1])
    with_constant(surface.degrees[0], [&](auto degree) { work(degree, degree); });
  else
    work(surface.degrees[0], surface.degrees[1]);
}

SurfaceJet jet(const NurbsSurface& surface, double u, double v)
{
  const auto [p, q] = surface.degrees;
  const double ku = knot_parameter(surface.knots[0], u);
  const double kv = knot_parameter(surface.knots[1], v);
  const int su = find_span(surface.knots[0], p, ku, 0);
  const int sv = find_span(surface.knots[1], q, kv, 0);
  BasisValues M;
  BasisValues N;
  basis<2>(surface.knots[0], p, su, ku, M);
  basis<2>(surface.knots[1], q, sv, kv, N);
  const std::size_t stride = surface.count(1);
  std::size_t first = (su - p) * stride + (sv - q);
  Homogeneous a{}, a_u{}, a_v{}, a_uu{}, a_uv{}, a_vv{};
  for (int i = 0; i <= p; ++i, first += stride)
  {
    const Point* points = &surface.points[first];
    const double* weights = surface.weights.empty() ? nullptr : &surface.weights[first];
    const Homogeneous row = weighted_sum(points, weights, q, N.value.data());
    const Homogeneous row_v = weighted_sum(points, weights, q, N.first.data());
    const Homogeneous row_vv = weighted_sum(points, weights, q, N.second.data());
    add(a, M.value[i], row);
    add(a_u, M.first[i], row);
    add(a_uu, M.second[i], row);
    add(a_v, M.value[i], row_v);
    add(a_uv, M.first[i], row_v);
    add(a_vv, M.value[i], row_vv);
  }
  const double ru = knot_range(surface.knots[0]);
  const double rv = knot_range(surface.knots[1]);
  if (surface.weights.empty())
    return {head(a),
            scaled(ru, head(a_u)),
            scaled(rv, head(a_v)),
            scaled(ru * ru, head(a_uu)),
            scaled(ru * rv, head(a_uv)),
            scaled(rv * rv, head(a_vv))};
  const Point x = project(a);
  const Point x_u = quotient_first(a, a_u, x);
  const Point x_v = quotient_first(a, a_v, x);
  const Point x_uu = quotient_second(a, a_uu, a_u, a_u, x, x_u, x_u);
  const Point x_uv = quotient_second(a, a_uv, a_u, a_v, x, x_u, x_v);
  const Point x_vv = quotient_second(a, a_vv, a_v, a_v, x, x_v, x_v);
  return {x,
          scaled(ru, x_u),
          scaled(rv, x_v),
          scaled(ru * ru, x_uu),
          scaled(ru * rv, x_uv),
          scaled(rv * rv, x_vv)};
}

std::vector<double> breaks(std::span<const double> knots)
{
  std::vector<double> result;
  for (const double knot : knots)
  {
    const double t = (knot - knots.front()) / knot_range(knots);
    if (result.empty() || t > result.back())
      result.push_back(t);
  }
  return result;
}

}  // namespace blockfsi::geometry
