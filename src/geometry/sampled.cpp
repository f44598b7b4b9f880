#include "geometry/sampled.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace blockfsi::geometry
{

namespace
{

/// A line of numbers in an array, `stride` apart.
struct Row
{
  double* first;
  std::ptrdiff_t stride;
  double& operator[](std::ptrdiff_t i) const { return first[i * stride]; }
};

/// The n + 2 coefficients, from -1 to n, of the cubic spline through n >= 4 values: (c[i-1] + 4 c[i] +
/// c[i+1]) / 6 = f[i], with fourth differences of c that vanish about the second value from each end. That
/// fixes c[1] = f[1] - (f[0] - 2 f[1] + f[2]) / 6; those between follow from a tridiagonal system, those
/// outside from the conditions there.
void fit_row(const Row& f, std::ptrdiff_t n, const Row& c, std::vector<double>& factor)
{
  const auto near_end = [&f](std::ptrdiff_t i) { return f[i] - (f[i - 1] - 2.0 * f[i] + f[i + 1]) / 6.0; };
  c[1] = near_end(1);
  c[n - 2] = near_end(n - 2);
  double before = 0.0;
  for (std::ptrdiff_t i = 2; i < n - 2; ++i)
  {
    const double pivot = 4.0 - before;
    before = 1.0 / pivot;
    factor[i] = before;
    c[i] = (6.0 * f[i] - c[i - 1] - (i == n - 3 ? c[n - 2] : 0.0)) / pivot;
  }
  for (std::ptrdiff_t i = n - 4; i >= 2; --i)
    c[i] -= factor[i] * c[i + 1];
  c[0] = 6.0 * f[1] - 4.0 * c[1] - c[2];
  c[-1] = 6.0 * f[0] - 4.0 * c[0] - c[1];
  c[n - 1] = 6.0 * f[n - 2] - 4.0 * c[n - 2] - c[n - 3];
  c[n] = 6.0 * f[n - 1] - 4.0 * c[n - 1] - c[n - 2];
}

/// Coefficients of B-splines on the grid, with one more at each end of each direction.
struct Spline
{
  std::array<int, 3> count;  ///< of the samples
  std::array<int, 3> size;   ///< of the coefficients
  Point origin;
  Point spacing;
  std::vector<double> coefficients;
};

/// Fits along one direction: the array grows there by 2.
void fit_direction(Spline& spline, int direction)
{
  const int n = spline.count[direction];
  if (n == 1)
    return;
  std::array<int, 3> size = spline.size;
  size[direction] = n + 2;
  std::vector<double> result(static_cast<std::size_t>(size[0]) * size[1] * size[2]);
  std::array<std::ptrdiff_t, 3> from{1, spline.size[0],
                                     static_cast<std::ptrdiff_t>(spline.size[0]) * spline.size[1]};
  std::array<std::ptrdiff_t, 3> to{1, size[0], static_cast<std::ptrdiff_t>(size[0]) * size[1]};
  const int u = (direction + 1) % 3;
  const int v = (direction + 2) % 3;
  std::vector<double> factor(n);
  for (int j = 0; j < size[v]; ++j)
    for (int i = 0; i < size[u]; ++i)
      fit_row({spline.coefficients.data() + i * from[u] + j * from[v], from[direction]}, n,
              {result.data() + i * to[u] + j * to[v] + to[direction], to[direction]}, factor);
  spline.size = size;
  spline.coefficients = std::move(result);
}

/// Values and slopes of the four B-splines that are not 0 in a cell, at u in [0, 1] of it.
struct Basis
{
  std::ptrdiff_t first = 0;  ///< index of the first coefficient
  int count = 1;
  std::array<double, 4> value{1.0, 0.0, 0.0, 0.0};
  std::array<double, 4> slope{};
};

Basis basis(double position, int count, double spacing)
{
  if (count == 1)
    return {};
  Basis b;
  b.count = 4;
  b.first = std::clamp(static_cast<std::ptrdiff_t>(position), std::ptrdiff_t{0}, std::ptrdiff_t{count - 2});
  const double u = position - static_cast<double>(b.first);
  const double v = 1.0 - u;
  b.value = {v * v * v / 6.0, (4.0 - 6.0 * u * u + 3.0 * u * u * u) / 6.0,
             (4.0 - 6.0 * v * v + 3.0 * v * v * v) / 6.0, u * u * u / 6.0};
  b.slope = {-0.5 * v * v, 1.5 * u * u - 2.0 * u, 2.0 * v - 1.5 * v * v, 0.5 * u * u};
  for (double& slope : b.slope)
    slope /= spacing;
  return b;
}

/// The spline inside the grid; position in grid units.
Level inside(const Spline& spline, const Point& position)
{
  std::array<Basis, 3> b;
  for (std::size_t c = 0; c < 3; ++c)
    b[c] = basis(position[c], spline.count[c], spline.spacing[c]);
  Level level;
  for (int k = 0; k < b[2].count; ++k)
    for (int j = 0; j < b[1].count; ++j)
    {
      const double* row = spline.coefficients.data() +
                          ((b[2].first + k) * spline.size[1] + b[1].first + j) * spline.size[0] + b[0].first;
      double value = 0.0;
      double slope = 0.0;
      for (int i = 0; i < b[0].count; ++i)
      {
        value += b[0].value[i] * row[i];
        slope += b[0].slope[i] * row[i];
      }
      level.value += b[2].value[k] * b[1].value[j] * value;
      level.gradient[0] += b[2].value[k] * b[1].value[j] * slope;
      level.gradient[1] += b[2].value[k] * b[1].slope[j] * value;
      level.gradient[2] += b[2].slope[k] * b[1].value[j] * value;
    }
  return level;
}

Level evaluate(const Spline& spline, const Point& x)
{
  Point position{};
  Point beyond{};
  for (std::size_t c = 0; c < 3; ++c)
    if (spline.count[c] > 1)
    {
      const double free = (x[c] - spline.origin[c]) / spline.spacing[c];
      position[c] = free > 0.0 ? std::min(free, static_cast<double>(spline.count[c] - 1)) : 0.0;
      beyond[c] = (free - position[c]) * spline.spacing[c];
    }
  Level level = inside(spline, position);
  const double distance = norm(beyond);
  if (distance == 0.0)
    return level;
  level.value += distance;
  for (std::size_t c = 0; c < 3; ++c)
    if (beyond[c] != 0.0)
      level.gradient[c] = beyond[c] / distance;
  return level;
}

void check(const Samples& samples)
{
  std::size_t points = 1;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const int count = samples.count[c];
    if (count < 4 && !(c == 2 && count == 1))
      throw Error(fmt::format("the samples have {} points in {}; a cubic spline needs 4 or more{}", count,
                              "xyz"[c], c == 2 ? " (or 1 in the plane)" : ""));
    if (count > 1 && !(samples.spacing[c] > 0.0 && std::isfinite(samples.spacing[c])))
      throw Error(fmt::format("the spacing of the samples in {} is {:.9g} m; it must be positive", "xyz"[c],
                              samples.spacing[c]));
    if (!std::isfinite(samples.origin[c]))
      throw Error(fmt::format("the origin of the samples is not finite in {}", "xyz"[c]));
    points *= static_cast<std::size_t>(count);
  }
  if (samples.values.size() != points)
    throw Error(fmt::format("there are {} samples for a grid of {} x {} x {} = {} points",
                            samples.values.size(), samples.count[0], samples.count[1], samples.count[2],
                            points));
  const auto bad = std::find_if(samples.values.begin(), samples.values.end(),
                                [](double value) { return !std::isfinite(value); });
  if (bad != samples.values.end())
    throw Error(fmt::format("sample {} is not a finite number", bad - samples.values.begin() + 1));
}

}  // namespace

LevelSet sampled(const Samples& samples, const std::string& name)
{
  check(samples);
  Spline spline{samples.count, samples.count, samples.origin, samples.spacing, samples.values};
  for (int direction = 0; direction < 3; ++direction)
    fit_direction(spline, direction);
  const auto shared = std::make_shared<const Spline>(std::move(spline));
  return {name, [shared](const Point& x) { return evaluate(*shared, x); }};
}

}  // namespace blockfsi::geometry
