#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace blockfsi::geometry
{

/// Lengths of the pieces of a curve, from which the parameter of a share of the length is found.
struct LengthTable
{
  std::vector<double> parameter;  ///< where pieces meet, ascending from 0 to 1
  std::vector<double> length;     ///< of the curve up to there [m]
  std::vector<double> speed;      ///< |dx/du| there [m]

  double total() const { return length.back(); }
};

namespace detail
{

/// Gauss and Legendre's rule with 8 points on [0, 1] (Abramowitz & Stegun 1964, table 25.4).
inline constexpr std::array<double, 4> gauss_offset{
    0.183434642495649804939476142360, 0.525532409916328985817739049189, 0.796666477413626739591553936476,
    0.960289856497536231683560868569};
inline constexpr std::array<double, 4> gauss_weight{
    0.362683783378361982965150449277, 0.313706645877887287337962201987, 0.222381034453374470544355994426,
    0.101228536290376259152531354310};

/// Integral of the speed from u to v; exact for polynomials of degree 15.
template <typename Speed>
double integrate(const Speed& speed, double u, double v)
{
  const double middle = 0.5 * (u + v);
  const double half = 0.5 * (v - u);
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i)
    sum +=
        gauss_weight[i] * (speed(middle - half * gauss_offset[i]) + speed(middle + half * gauss_offset[i]));
  return half * sum;
}

template <typename Speed>
void measure_piece(const Speed& speed, double u, double v, double whole, double tolerance, int depth,
                   LengthTable& result)
{
  constexpr int deepest = 100;  // for ends where the speed has no bound, as of sqrt(t)
  constexpr std::size_t most_pieces = 2048;
  const double middle = 0.5 * (u + v);
  const double left = integrate(speed, u, middle);
  const double right = integrate(speed, middle, v);
  if (std::abs(left + right - whole) > tolerance && depth < deepest && result.parameter.size() < most_pieces)
  {
    measure_piece(speed, u, middle, left, tolerance, depth + 1, result);
    measure_piece(speed, middle, v, right, tolerance, depth + 1, result);
    return;
  }
  for (const auto& [end, length] : {std::array{middle, left}, std::array{v, right}})
  {
    result.parameter.push_back(end);
    result.length.push_back(result.total() + length);
    result.speed.push_back(speed(end));
  }
}

}  // namespace detail

/// Measures a curve by its speed |dx/du|, smooth between `breaks` (ascending from 0 to 1): pieces are halved
/// until both halves agree with the whole to 1e-14 of the curve. Not finite where the speed is not.
template <typename Speed>
LengthTable measure(const Speed& speed, std::span<const double> breaks)
{
  constexpr double precision = 1e-14;
  std::vector<double> rough;
  double total = 0.0;
  for (std::size_t i = 1; i < breaks.size(); ++i)
  {
    rough.push_back(detail::integrate(speed, breaks[i - 1], breaks[i]));
    total += rough.back();
  }
  LengthTable result{{0.0}, {0.0}, {speed(0.0)}};
  for (std::size_t i = 1; i < breaks.size(); ++i)
    detail::measure_piece(speed, breaks[i - 1], breaks[i], rough[i - 1], precision * total, 0, result);
  return result;
}

/// The parameter u up to which the curve has the share s of its length: Newton's method kept inside the piece
/// by bisection, to 1e-14 of the length.
template <typename Speed>
double parameter_at(const LengthTable& table, const Speed& speed, double s)
{
  constexpr int most_steps = 60;
  const double wanted = s * table.total();
  std::size_t piece = 1;
  for (std::size_t end = table.length.size() - 1; piece < end;)
  {
    const std::size_t middle = (piece + end) / 2;
    if (table.length[middle] < wanted)
      piece = middle + 1;
    else
      end = middle;
  }
  const double start = table.parameter[piece - 1];
  const double rest = wanted - table.length[piece - 1];
  double low = start;
  double high = table.parameter[piece];
  const double size = table.length[piece] - table.length[piece - 1];
  if (!(size > 0.0))
    return low;
  // Cubic in the length with the slopes du/ds = 1 / speed at both ends.
  const double q = rest / size;
  const double h = high - low;
  const double slope_low = table.speed[piece - 1] > 0.0 ? size / table.speed[piece - 1] : h;
  const double slope_high = table.speed[piece] > 0.0 ? size / table.speed[piece] : h;
  double u = low + q * q * (3.0 - 2.0 * q) * h + q * (1.0 - q) * ((1.0 - q) * slope_low - q * slope_high);
  if (!(u > low && u < high))
    u = low + q * h;
  for (int i = 0; i < most_steps; ++i)
  {
    const double miss = detail::integrate(speed, start, u) - rest;
    (miss > 0.0 ? high : low) = u;
    if (std::abs(miss) <= 1e-14 * table.total())
      break;
    const double next = u - miss / speed(u);
    u = next > low && next < high ? next : 0.5 * (low + high);
  }
  return u;
}

}  // namespace blockfsi::geometry
