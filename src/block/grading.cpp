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

/// Vinokur's two-sided distribution (1983) for slopes given as cell sizes on the unit edge, which its cells
/// meet only roughly: u(x) with sinh(δ) / δ = b (sin(δ) / δ for b < 1), t = u / (a + (1 - a) u).
struct Vinokur
{
  double a;
  double b;
  double delta = 0.0;

  Vinokur(int n, double first, double last)
      : a(std::sqrt(last / first)), b(1.0 / (n * std::sqrt(first * last)))
  {
    constexpr double tiny = 1e-8;
    if (b > 1.0)
      delta = bisect(tiny, 700.0, [this](double d) { return std::sinh(d) / d - b; });
    else
      delta = bisect(tiny, std::numbers::pi - tiny, [this](double d) { return b - std::sin(d) / d; });
  }

  /// [1 + tanh(δ (x - 1/2)) / tanh(δ / 2)] / 2 by the addition theorem, which keeps the digits of small u.
  double u(double x) const
  {
    if (std::abs(b - 1.0) < 1e-14)
      return x;
    if (b > 1.0)
      return std::sinh(delta * x) / (2.0 * std::sinh(0.5 * delta) * std::cosh(delta * (0.5 - x)));
    return std::sin(delta * x) / (2.0 * std::sin(0.5 * delta) * std::cos(delta * (0.5 - x)));
  }
  double from_start(double x) const { return u(x) / (a + (1.0 - a) * u(x)); }
  /// 1 - t at 1 - x.
  double from_end(double x) const { return a * u(x) / (1.0 - (1.0 - a) * u(x)); }
};

/// Corrects the slopes given to Vinokur's distribution until both end cells have their sizes (fixed point on
/// the logarithms). Empty if that does not converge.
std::vector<double> two_sided_unit(int n, double first, double last)
{
  const std::array<double, 2> target{std::log(first), std::log(last)};
  std::array<double, 2> slope = target;
  for (int iteration = 0; iteration < 500; ++iteration)
  {
    const Vinokur distribution(n, std::exp(slope[0]), std::exp(slope[1]));
    const double cell = 1.0 / n;
    const std::array<double, 2> miss{std::log(distribution.from_start(cell)) - target[0],
                                     std::log(distribution.from_end(cell)) - target[1]};
    if (std::abs(miss[0]) < 1e-12 && std::abs(miss[1]) < 1e-12)
      return positions(n, [&](int i) { return distribution.from_start(static_cast<double>(i) / n); });
    for (int end = 0; end < 2; ++end)
      slope[end] -= 0.9 * miss[end];
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

/// Positions of OneSided for the given δ; δ < 0: with tan of -δ instead of tanh.
std::vector<double> one_sided_unit(int n, double delta)
{
  // 1 - tanh(δ (1 - x)) / tanh(δ) by the addition theorem, so that small first cells keep their digits.
  return positions(n,
                   [=](int i)
                   {
                     const double x = static_cast<double>(i) / n;
                     const double d = std::abs(delta);
                     if (d < 1e-8)
                       return x;
                     return delta > 0.0 ? std::sinh(d * x) / (std::sinh(d) * std::cosh(d * (1.0 - x)))
                                        : std::sin(d * x) / (std::sin(d) * std::cos(d * (1.0 - x)));
                   });
}

std::vector<double> one_sided(const OneSided& grading, int n, double length)
{
  check_size(grading.size, length);
  const double size = grading.size / length;
  if (n == 1)
    return first_cell({grading.size, grading.at_end}, n, length);
  // The first cell shrinks as δ grows; tan has a pole at pi / 2, where the other cells vanish.
  const double pole = 0.5 * std::numbers::pi * (1.0 - 1e-12);
  const auto first = [n](double delta) { return one_sided_unit(n, delta)[1]; };
  if (!(size < first(-pole)) || !(size > first(300.0)))
    throw Error(
        fmt::format("no {} cells on {:.9g} m that grow by a hyperbolic tangent start with {:.9g} m; bring "
                    "the size nearer to {:.9g} m",
                    n, length, grading.size, length / n));
  const double delta = bisect(-pole, 300.0, [&](double d) { return size - first(d); });
  const std::vector<double> t = one_sided_unit(n, delta);
  return grading.at_end ? mirrored(t) : t;
}

std::vector<double> cosine(int n)
{
  // sin² keeps the digits of the first cells, its complement the symmetry.
  return positions(n,
                   [n](int i)
                   {
                     const double angle = 0.5 * std::numbers::pi * std::min(i, n - i) / n;
                     const double t = std::sin(angle) * std::sin(angle);
                     return 2 * i == n ? 0.5 : (2 * i < n ? t : 1.0 - t);
                   });
}

void check_count(const char* what, std::size_t entries, std::size_t cells, int n)
{
  if (cells != static_cast<std::size_t>(n))
    throw Error(
        fmt::format("the list has {} {}, which make {} cells, but the edge has {}; change the list or the "
                    "number of cells",
                    entries, what, cells, n));
}

std::vector<double> listed_positions(const Positions& list, int n)
{
  const std::vector<double>& p = list.values;
  check_count("positions", p.size(), p.empty() ? 0 : p.size() - 1, n);
  for (std::size_t i = 1; i < p.size(); ++i)
    if (!(p[i] > p[i - 1]) || !std::isfinite(p[i] - p[i - 1]))
      throw Error(fmt::format("position {} of the list is {:.9g} after {:.9g}; positions must ascend", i + 1,
                              p[i], p[i - 1]));
  return positions(n, [&p](int i) { return (p[i] - p.front()) / (p.back() - p.front()); });
}

std::vector<double> listed_sizes(const Sizes& list, int n)
{
  check_count("sizes", list.values.size(), list.values.size(), n);
  std::vector<double> sums{0.0};
  for (std::size_t i = 0; i < list.values.size(); ++i)
  {
    if (!(list.values[i] > 0.0 && std::isfinite(list.values[i])))
      throw Error(
          fmt::format("size {} of the list is {:.9g}; sizes must be positive", i + 1, list.values[i]));
    sums.push_back(sums.back() + list.values[i]);
  }
  return positions(n, [&sums](int i) { return sums[i] / sums.back(); });
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
  struct Law
  {
    int n;
    double length;
    std::vector<double> operator()(const Uniform&) const { return uniform(n); }
    std::vector<double> operator()(const Geometric& grading) const { return by_ratio(grading, n); }
    std::vector<double> operator()(const FirstCell& grading) const { return first_cell(grading, n, length); }
    std::vector<double> operator()(const TwoSided& grading) const { return two_sided(grading, n, length); }
    std::vector<double> operator()(const OneSided& grading) const { return one_sided(grading, n, length); }
    std::vector<double> operator()(const Cosine&) const { return cosine(n); }
    std::vector<double> operator()(const Positions& grading) const { return listed_positions(grading, n); }
    std::vector<double> operator()(const Sizes& grading) const { return listed_sizes(grading, n); }
  };
  std::vector<double> t = std::visit(Law{n, length}, grading);
  check_ascending(t);
  return t;
}

Grading reversed(const Grading& grading)
{
  struct Reverse
  {
    Grading operator()(const Uniform& grading) const { return grading; }
    Grading operator()(const Geometric& grading) const { return Geometric{1.0 / grading.ratio}; }
    Grading operator()(const FirstCell& grading) const { return FirstCell{grading.size, !grading.at_end}; }
    Grading operator()(const TwoSided& grading) const { return TwoSided{grading.last, grading.first}; }
    Grading operator()(const OneSided& grading) const { return OneSided{grading.size, !grading.at_end}; }
    Grading operator()(const Cosine& grading) const { return grading; }
    Grading operator()(const Positions& grading) const
    {
      Positions result;
      for (auto p = grading.values.rbegin(); p != grading.values.rend(); ++p)
        result.values.push_back(-*p);
      return result;
    }
    Grading operator()(const Sizes& grading) const
    {
      return Sizes{{grading.values.rbegin(), grading.values.rend()}};
    }
  };
  return std::visit(Reverse{}, grading);
}

std::optional<int> cell_count(const Grading& grading)
{
  if (const auto* list = std::get_if<Positions>(&grading))
    return static_cast<int>(list->values.size()) - 1;
  if (const auto* list = std::get_if<Sizes>(&grading))
    return static_cast<int>(list->values.size());
  return std::nullopt;
}

}  // namespace blockfsi::block
