#include "output/signal.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace blockfsi::output
{

namespace
{

void check(const Signal& signal)
{
  if (signal.time.size() != signal.value.size())
    throw Error(fmt::format("a signal has {} times, but {} values", signal.time.size(), signal.value.size()));
}

/// Positions [first, last) of the samples with begin <= time <= end.
struct Range
{
  std::size_t first;
  std::size_t last;
};

Range samples_within(const Signal& signal, double begin, double end)
{
  const auto first = std::lower_bound(signal.time.begin(), signal.time.end(), begin);
  const auto last = std::upper_bound(first, signal.time.end(), end);
  return {static_cast<std::size_t>(first - signal.time.begin()),
          static_cast<std::size_t>(last - signal.time.begin())};
}

/// The signal between samples k and k + 1, linear.
double interpolate(const Signal& signal, std::size_t k, double time)
{
  const double fraction = (time - signal.time[k]) / (signal.time[k + 1] - signal.time[k]);
  return signal.value[k] + fraction * (signal.value[k + 1] - signal.value[k]);
}

/// Time average of the piecewise linear signal over [begin, end] within the record.
double time_average(const Signal& signal, double begin, double end)
{
  double integral = 0.0;
  for (std::size_t k = 0; k + 1 < signal.time.size(); ++k)
  {
    const double from = std::max(begin, signal.time[k]);
    const double to = std::min(end, signal.time[k + 1]);
    if (from < to)
      integral += 0.5 * (to - from) * (interpolate(signal, k, from) + interpolate(signal, k, to));
  }
  return integral / (end - begin);
}

double half_range(const Signal& signal, double begin, double end)
{
  const auto [first, last] = samples_within(signal, begin, end);
  const auto [least, greatest] =
      std::minmax_element(signal.value.begin() + first, signal.value.begin() + last);
  return first == last ? 0.0 : 0.5 * (*greatest - *least);
}

/// Times at which the signal rises through the mean, each after it has been below mean - margin.
std::vector<double> upward_crossings(const Signal& signal, double mean, double margin)
{
  std::vector<double> crossings;
  bool has_been_below = false;
  for (std::size_t k = 0; k + 1 < signal.time.size(); ++k)
  {
    const double before = signal.value[k];
    const double after = signal.value[k + 1];
    has_been_below = has_been_below || before < mean - margin;
    if (!has_been_below || before >= mean || after < mean)
      continue;
    const double fraction = (mean - before) / (after - before);
    crossings.push_back(signal.time[k] + fraction * (signal.time[k + 1] - signal.time[k]));
    has_been_below = false;
  }
  return crossings;
}

void look_for_crossings(const Signal& signal, const Reading& reading, double begin, double end, Clock& clock)
{
  clock.mean = time_average(signal, begin, end);
  clock.amplitude = half_range(signal, begin, end);
  clock.crossings = upward_crossings(signal, clock.mean, reading.hysteresis * clock.amplitude);
  clock.periods = std::min(reading.window, static_cast<int>(clock.crossings.size()) - 1);
}

/// Start of the n-th last period.
double period_begin(const Clock& clock, int n)
{
  return clock.crossings[clock.crossings.size() - 1 - n];
}

/// Vertex of the parabola through sample k and its neighbours, or the sample itself where that would leave
/// them.
Extremum refine(const Signal& signal, std::size_t k)
{
  const Extremum sample{signal.time[k], signal.value[k]};
  if (k == 0 || k + 1 == signal.time.size())
    return sample;
  const double left = signal.time[k] - signal.time[k - 1];
  const double right = signal.time[k + 1] - signal.time[k];
  const double rise_left = (signal.value[k] - signal.value[k - 1]) / left;
  const double rise_right = (signal.value[k + 1] - signal.value[k]) / right;
  const double curvature = (rise_right - rise_left) / (left + right);
  const double slope = rise_left + curvature * left;
  const double shift = -0.5 * slope / curvature;
  if (!(shift >= -left && shift <= right))
    return sample;
  return {signal.time[k] + shift, signal.value[k] + 0.5 * slope * shift};
}

}  // namespace

Clock find_periods(const Signal& signal, const Reading& reading)
{
  check(signal);
  Clock clock;
  if (signal.time.size() < 3)
    return clock;
  const double end = signal.time.back();
  // Before any period is known, the second half of the record stands for the last periods.
  look_for_crossings(signal, reading, 0.5 * (signal.time.front() + end), end, clock);
  for (int repetition = 0; repetition < 2 && clock.periods >= 1; ++repetition)
    look_for_crossings(signal, reading, period_begin(clock, clock.periods), period_begin(clock, 0), clock);
  if (clock.periods < 1)
    return clock;
  const double last = period_begin(clock, 0);
  const double period = (last - period_begin(clock, clock.periods)) / clock.periods;
  clock.frequency = 1.0 / period;
  // An oscillation that has died out, or that is rounding error on a steady value, is none.
  const bool lasts = end - last < 1.5 * period;
  const bool visible = clock.amplitude > 1e-10 * std::abs(clock.mean);
  clock.found = clock.periods >= reading.least && lasts && visible;
  return clock;
}

Extrema find_extrema(const Signal& signal, double begin, double end)
{
  check(signal);
  const auto [first, last] = samples_within(signal, begin, end);
  if (first == last)
    throw Error(fmt::format("a signal has no sample between the times {} and {}", begin, end));
  const auto [least, greatest] =
      std::minmax_element(signal.value.begin() + first, signal.value.begin() + last);
  return {refine(signal, static_cast<std::size_t>(greatest - signal.value.begin())),
          refine(signal, static_cast<std::size_t>(least - signal.value.begin()))};
}

Extrema find_extrema(const Signal& signal)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return find_extrema(signal, -infinity, infinity);
}

Statistics read_periods(const Signal& signal, const Clock& clock, const Reading& reading)
{
  check(signal);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Statistics result{false, nan, nan, nan, nan, nan};
  constexpr int compared = 3;
  const int count = std::max(compared, reading.averaged);
  if (!clock.found || static_cast<int>(clock.crossings.size()) <= count)
    return result;
  result.maximum = 0.0;
  result.minimum = 0.0;
  double smallest = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (int n = 1; n <= count; ++n)
  {
    const Extrema extrema = find_extrema(signal, period_begin(clock, n), period_begin(clock, n - 1));
    if (n <= reading.averaged)
    {
      result.maximum += extrema.greatest.value / reading.averaged;
      result.minimum += extrema.least.value / reading.averaged;
    }
    if (n <= compared)
    {
      const double amplitude = 0.5 * (extrema.greatest.value - extrema.least.value);
      smallest = std::min(smallest, amplitude);
      largest = std::max(largest, amplitude);
    }
  }
  result.mean = 0.5 * (result.maximum + result.minimum);
  result.amplitude = 0.5 * (result.maximum - result.minimum);
  result.disagreement = largest > 0.0 ? (largest - smallest) / largest : 0.0;
  result.periodic = result.disagreement <= reading.agreement;
  return result;
}

Steady read_steady(const Signal& signal)
{
  check(signal);
  if (signal.time.empty())
    throw Error("a signal has no samples; run the case first");
  Steady result{signal.value.back(), 0.0};
  const double from = signal.time.back() - 0.1 * (signal.time.back() - signal.time.front());
  const auto [first, last] = samples_within(signal, from, signal.time.back());
  for (std::size_t k = first; k < last; ++k)
    result.drift = std::max(result.drift, std::abs(signal.value[k] - result.value));
  return result;
}

}  // namespace blockfsi::output
