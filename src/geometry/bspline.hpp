#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace blockfsi::geometry
{

/// The largest degree of B-splines, that of common CAD kernels.
inline constexpr int max_degree = 25;

/// Throws Error unless the knots are those of a clamped B-spline of the degree with so many control points:
/// point_count + degree + 1 finite numbers that do not decrease, the first and the last degree + 1 times
/// each, the others at most degree times. `what` starts the message: "the B-spline".
void check_knots(std::string_view what, int degree, std::span<const double> knots, std::size_t point_count);

/// The clamped knots from 0 to 1 with equal spans.
std::vector<double> clamped_knots(int degree, std::size_t point_count);

/// The span s of t: knots[s] <= t < knots[s + 1], the last one that is not empty at the end. `guess` is tried
/// first.
inline int find_span(std::span<const double> knots, int degree, double t, int guess)
{
  const int last = static_cast<int>(knots.size()) - degree - 2;
  if (guess >= degree && guess <= last && knots[guess] <= t && t < knots[guess + 1])
    return guess;
  const auto above = std::upper_bound(knots.begin() + degree + 1, knots.begin() + last + 1, t);
  return static_cast<int>(above - knots.begin()) - 1;
}

/// Values of the degree + 1 basis functions that are not 0 in a span, and their derivatives.
struct BasisValues
{
  std::array<double, max_degree + 1> value;
  std::array<double, max_degree + 1> first;
  std::array<double, max_degree + 1> second;
};

namespace detail
{

/// From the functions of degree d - 1 to those of degree d (Cox, de Boor 1972).
inline void raise(const double* knots, int span, int d, double t, double* values)
{
  double saved = 0.0;
  for (int r = 0; r < d; ++r)
  {
    const double right = knots[span + r + 1] - t;
    const double left = t - knots[span + 1 - d + r];
    const double share = values[r] / (right + left);
    values[r] = saved + right * share;
    saved = left * share;
  }
  values[d] = saved;
}

/// Derivatives of the functions of degree d from the functions of degree d - 1: linear, so that it also takes
/// first derivatives to second ones.
inline void differentiate(const double* knots, int span, int d, const double* lower, double* derivatives)
{
  double before = 0.0;
  for (int j = 0; j < d; ++j)
  {
    const double quotient = d * lower[j] / (knots[span + j + 1] - knots[span - d + 1 + j]);
    derivatives[j] = before - quotient;
    before = quotient;
  }
  derivatives[d] = before;
}

}  // namespace detail

/// Basis functions with derivatives up to `count` (0, 1 or 2) with respect to t. Allocates nothing.
template <int count>
void basis(std::span<const double> knots, int degree, int span, double t, BasisValues& result)
{
  static_assert(count >= 0 && count <= 2);
  const double* k = knots.data();
  double* values = result.value.data();
  values[0] = 1.0;
  for (int d = 1; d <= degree; ++d)
  {
    if constexpr (count >= 2)
      if (d == degree - 1)
      {
        std::array<double, max_degree + 1> slope;
        detail::differentiate(k, span, d, values, slope.data());
        detail::differentiate(k, span, degree, slope.data(), result.second.data());
      }
    if constexpr (count >= 1)
      if (d == degree)
        detail::differentiate(k, span, d, values, result.first.data());
    detail::raise(k, span, d, t, values);
  }
  if constexpr (count >= 2)
    if (degree < 2)
      std::fill_n(result.second.begin(), degree + 1, 0.0);
}

}  // namespace blockfsi::geometry
