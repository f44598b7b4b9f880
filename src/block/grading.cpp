#include "block/grading.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace blockfsi::block
{

namespace
{

constexpr double fit_tolerance = 1e-9;  ///< relative misfit of cells that must fill an edge exactly

template <typename Position>
std::vector<double> positions(int n, Position position)
{
  std::vector<double> t(n + 1, 0.0);
  for (int i = 1; i < n; ++i)
    t[i] = position(i);
  t[n] = 1.0;
  return t;
}

std::vector<double> uniform(int n)
{
  return positions(n, [n](int i) { return static_cast<double>(i) / n; });
}

/// Cells growing by the factor exp(z) from the start: t_i = (q^i - 1) / (q^n - 1) with q = exp(z).
std::vector<double> geometric(int n, double z)
{
  if (z == 0.0)
    return uniform(n);
  // A positive exponent could overflow: look from the other end, where the cells shrink.
  if (z > 0.0)
    return positions(n, [n, z](int i)
                     { return std::exp((i - n) * z) * std::expm1(-i * z) / std::expm1(-n * z); });
  return positions(n, [n, z](int i) { return std::expm1(i * z) / std::expm1(n * z); });
}

struct Value
{
  double value;
  double derivative;
};

/// ln of (q^n - 1) / (q - 1), the edge in units of its first cell, and its derivative by z = ln q.
Value log_sum(int n, double z)
{
  if (std::abs(z) * n < 1e-5)
  {
    const double curvature = (static_cast<double>(n) * n - 1.0) / 12.0;
    return {std::log(n) + 0.5 * z * ((n - 1) + curvature * z), 0.5 * (n - 1) + curvature * z};
  }
  return {std::log(std::expm1(n * z) / std::expm1(z)), -n / std::expm1(-n * z) + 1.0 / std::expm1(-z)};
}

/// z = ln q of the geometric cells whose first is `size` of the edge, 0 < size < 1, n >= 2.
/// Newton within a bracket that follows from bounds of the geometric sum: q^(n-1) < sum < 1 / (1 - q).
double growth(int n, double size)
{
  double low = size * n > 1.0 ? std::log1p(-size) : 0.0;
  double high = size * n < 1.0 ? -std::log(size) / (n - 1) : 0.0;
  double z = 0.5 * (low + high);
  for (int iteration = 0; iteration < 100; ++iteration)
  {
    const auto [value, derivative] = log_sum(n, z);
    const double excess = value + std::log(size);
    (excess > 0.0 ? high : low) = z;
    double next = z - excess / derivative;
    if (!(next >= low && next <= high))
      next = 0.5 * (low + high);
    const double change = std::abs(next - z);
    z = next;
    if (change <= 1e-15 * std::abs(z) + 1e-300)
      break;
  }
  return z;
}

std::vector<double> mirrored(const std::vector<double>& t)
{
  const int n = static_cast<int>(t.size()) - 1;
  return positions(n, [&t, n](int i) { return 1.0 - t[n - i]; });
}

void check_size(double size, double length)
{
  if (!(size > 0.0))
    throw Error(fmt::format("a cell size of {:.9g} m is asked for; it must be positive", size));
  if (!(size < length * (1.0 + fit_tolerance)))
    throw Error(fmt::format(
        "a cell of {:.9g} m is asked for on an edge of {:.9g} m; it must be shorter than the edge", size,
        length));
}

std::vector<double> first_cell(const FirstCell& grading, int n, double length)
{
  check_size(grading.size, length);
  const double size = grading.size / length;
  const bool whole = std::abs(size - 1.0) <= fit_tolerance;
  if ((n == 1) != whole)
    throw Error(
        n == 1 ? fmt::format("the only cell of an edge of {:.9g} m shall have {:.9g} m; give the edge more "
                             "cells or no grading",
                             length, grading.size)
               : fmt::format("the first of {} cells shall be as long as the edge ({:.9g} m); give it a "
                             "smaller size",
                             n, length));
  if (n == 1)
    return uniform(n);
  const std::vector<double> t = geometric(n, growth(n, size));
  return grading.at_end ? mirrored(t) : t;
}

/// Root of an ascending function in (low, high) by bisection.
template <typename Function>
double bisect(double low, double high, Function f)
{
  for (int iteration = 0; iteration < 200 && low < 0.5 * (low + high) && 0.5 * (low + high) < high;
       ++iteration)
  {
    const double middle = 0.5 * (low + high);
    (f(middle) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The symmetric stretching u(x) of Vinokur 1983 for sinh(delta) / delta = b (or sin(delta) / delta = b, b <
/// 1).
double stretch(double b, double delta, double x)
{
  if (b > 1.0)
    return 0.5 * (1.0 + std::tanh(delta * (x - 0.5)) / std::tanh(0.5 * delta));
  return 0.5 * (1.0 + std::tan(delta * (x - 0.5)) / std::tan(0.5 * delta));
}

/// Vinokur's two-sided distribution for slopes given as cell sizes on the unit edge: met only roughly.
std::vector<double> vinokur(int n, double first, double last)
{
  const double a = std::sqrt(last / first);
  const double b = 1.0 / (n * std::sqrt(first * last));
  constexpr double tiny = 1e-8;
  double delta = 0.0;
  if (b > 1.0)
    delta = bisect(tiny, 700.0, [b](double d) { return std::sinh(d) / d - b; });
  else
    delta = bisect(tiny, std::numbers::pi - tiny, [b](double d) { return b - std::sin(d) / d; });
  return positions(n,
                   [=](int i)
                   {
                     const double x = static_cast<double>(i) / n;
                     const double u = std::abs(b - 1.0) < 1e-14 ? x : stretch(b, delta, x);
                     return u / (a + (1.0 - a) * u);
                   });
}

/// Logarithms of the first and the last cell of a distribution.
std::array<double, 2> end_cells(const std::vector<double>& t)
{
  return {std::log(t[1]), std::log(1.0 - t[t.size() - 2])};
}

/// Corrects the slopes given to `vinokur` until both end cells have their sizes (fixed point, formulation.md
/// 3).
std::vector<double> two_sided_unit(int n, double first, double last)
{
  const std::array<double, 2> target{std::log(first), std::log(last)};
  std::array<double, 2> slope = target;
  // The last cell is a difference from 1, known to a rounding of 1 only.
  const double tolerance = 1e-12 + 1e-15 / last;
  for (int iteration = 0; iteration < 500; ++iteration)
  {
    std::vector<double> t = vinokur(n, std::exp(slope[0]), std::exp(slope[1]));
    const std::array<double, 2> cells = end_cells(t);
    const double miss = std::max(std::abs(cells[0] - target[0]), std::abs(cells[1] - target[1]));
    if (miss < tolerance)
      return t;
    for (int end = 0; end < 2; ++end)
      slope[end] -= 0.9 * (cells[end] - target[end]);
  }
  return {};
}

std::vector<double> two_sided(const TwoSided& grading, int n, double length)
{
  check_size(grading.first, length);
  check_size(grading.last, length);
  const double first = grading.first / length;
  const double last = grading.last / length;
  const double rest = 1.0 - first - last;
  if (n <= 2)
  {
    const bool fills = n == 1 ? std::abs(first - 1.0) + std::abs(last - 1.0) <= fit_tolerance
                              : std::abs(rest) <= fit_tolerance;
    if (!fills)
      throw Error(
          fmt::format("first and last cells of {:.9g} m and {:.9g} m do not fill an edge of {:.9g} m with {} "
                      "cell(s); give the edge at least 3 cells",
                      grading.first, grading.last, length, n));
    return positions(n, [first](int) { return first; });
  }
  if (rest <= fit_tolerance)
    throw Error(fmt::format(
        "first and last cells of {:.9g} m and {:.9g} m leave no room for the other {} cells of an "
        "edge of {:.9g} m; give smaller sizes",
        grading.first, grading.last, n - 2, length));
  std::vector<double> t = two_sided_unit(n, first, last);
  if (t.empty())
    throw Error(fmt::format(
        "no smooth distribution of {} cells on {:.9g} m starts with {:.9g} m and ends with {:.9g} "
        "m; bring the sizes nearer to {:.9g} m or change the number of cells",
        n, length, grading.first, grading.last, length / n));
  return t;
}

std::vector<double> by_ratio(const Geometric& grading, int n)
{
  if (!(grading.ratio > 0.0))
    throw Error(fmt::format("the ratio of neighbouring cells is {:.9g}; it must be positive", grading.ratio));
  return geometric(n, std::log(grading.ratio));
}

void check_ascending(const std::vector<double>& t)
{
  for (std::size_t i = 1; i < t.size(); ++i)
    if (!(t[i] > t[i - 1]))
      throw Error(
          fmt::format("the grading is so strong that cell {} of {} vanishes in double precision; bring the "
                      "sizes nearer to each other",
                      i, t.size() - 1));
}

}  // namespace

std::vector<double> parameters(const Grading& grading, int n, double length)
{
  if (n < 1)
    throw Error(fmt::format("an edge has {} cells; it needs at least 1", n));
  std::vector<double> t;
  if (std::holds_alternative<Uniform>(grading))
    t = uniform(n);
  else if (const auto* ratio = std::get_if<Geometric>(&grading))
    t = by_ratio(*ratio, n);
  else if (const auto* first = std::get_if<FirstCell>(&grading))
    t = first_cell(*first, n, length);
  else
    t = two_sided(std::get<TwoSided>(grading), n, length);
  check_ascending(t);
  return t;
}

Grading reversed(const Grading& grading)
{
  if (const auto* ratio = std::get_if<Geometric>(&grading))
    return Geometric{1.0 / ratio->ratio};
  if (const auto* first = std::get_if<FirstCell>(&grading))
    return FirstCell{first->size, !first->at_end};
  if (const auto* both = std::get_if<TwoSided>(&grading))
    return TwoSided{both->last, both->first};
  return grading;
}

}  // namespace blockfsi::block
