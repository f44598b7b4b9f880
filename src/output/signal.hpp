#pragma once

#include <span>
#include <vector>

namespace blockfsi::output
{

// Reading of signals as validation.md, section 4, prescribes: periods are counted, not
// transformed, and extrema are those of the last full periods.

/// A quantity over time: times [s] ascending, values in any unit, shape (sample_count) each.
struct Signal
{
  std::span<const double> time;
  std::span<const double> value;
};

/// How periods are looked for and averaged.
struct Reading
{
  int window = 8;    ///< last periods that give mean, amplitude and frequency of the clock
  int least = 3;     ///< fewer periods are no periodic state
  int averaged = 1;  ///< last periods whose extrema are averaged
  double hysteresis =
      0.1;  ///< part of the amplitude by which the signal must fall below the mean between crossings
  double agreement = 0.02;  ///< relative difference allowed between the amplitudes of the last three periods
};

/// Flaps: five periods are asked for and averaged.
inline constexpr Reading flap_reading{.least = 5, .averaged = 5};

/// The periods of the signal that all signals of a run are read by.
struct Clock
{
  bool found = false;             ///< enough periods, up to the end of the record
  std::vector<double> crossings;  ///< times of upward crossings of the mean [s]
  double mean = 0.0;              ///< time average over the periods of the window
  double amplitude = 0.0;         ///< (max - min) / 2 in the window
  double frequency = 0.0;         ///< [Hz], over the periods of the window
  int periods = 0;                ///< how many these are
};

/// Counts the periods of a signal. Where there are none or too few, `found` is false. Throws Error if times
/// and values differ in number.
Clock find_periods(const Signal& signal, const Reading& reading = {});

/// An extremum between samples, by the parabola through the extreme sample and its neighbours.
struct Extremum
{
  double time = 0.0;
  double value = 0.0;
};

struct Extrema
{
  Extremum greatest;
  Extremum least;
};

/// Greatest and least value of the samples with begin <= time <= end, refined; at least one must be there.
Extrema find_extrema(const Signal& signal, double begin, double end);

/// Over the whole signal, which must not be empty: transient extrema.
Extrema find_extrema(const Signal& signal);

/// Statistics of a signal over the clock's last periods. Signals of twice the clock's frequency, such as
/// drag, are read over whole periods of the clock, so that halves that differ do not matter.
struct Statistics
{
  bool periodic = false;  ///< the clock was found and the last three periods agree in amplitude
  double maximum = 0.0;   ///< NaN here and below without periods
  double minimum = 0.0;
  double mean = 0.0;          ///< (max + min) / 2, not the time average
  double amplitude = 0.0;     ///< (max - min) / 2
  double disagreement = 0.0;  ///< largest relative difference of amplitude between the last three periods
};

/// Reads a signal by the periods of a clock. Throws Error if times and values differ in number.
Statistics read_periods(const Signal& signal, const Clock& clock, const Reading& reading = {});

/// End of a signal that should have become steady.
struct Steady
{
  double value = 0.0;  ///< the last sample
  double drift = 0.0;  ///< largest difference from it within the last tenth of the record
};

/// Last value of a signal, which must not be empty, and how steady it is.
Steady read_steady(const Signal& signal);

}  // namespace blockfsi::output
