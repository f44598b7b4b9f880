#include "output/signal.hpp"

#include "core/error.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

using namespace blockfsi;

namespace
{

constexpr double turn = 2.0 * std::numbers::pi;

struct Record
{
  std::vector<double> time;
  std::vector<double> value;

  output::Signal signal() const { return {time, value}; }
};

Record record(double begin, double end, double dt, const std::function<double(double)>& f)
{
  Record result;
  const int count = static_cast<int>(std::lround((end - begin) / dt));
  for (int k = 0; k <= count; ++k)
  {
    result.time.push_back(begin + k * dt);
    result.value.push_back(f(begin + k * dt));
  }
  return result;
}

}  // namespace

TEST_CASE("a sine about a mean gives its frequency, mean and amplitude though samples miss the extrema")
{
  // 20.7 samples per period: the samples next to an extremum are up to 1.2 % of the amplitude below it.
  const double frequency = 3.1;
  const Record r = record(0.0, 6.0, 1.0 / (20.7 * frequency),
                          [=](double t) { return 1.25 + 0.4 * std::sin(turn * frequency * t + 0.3); });
  const output::Clock clock = output::find_periods(r.signal());
  CHECK(clock.found);
  CHECK(clock.periods == 8);
  CHECK(clock.frequency == doctest::Approx(frequency).epsilon(1e-4));
  CHECK(clock.mean == doctest::Approx(1.25).epsilon(1e-3));
  const output::Statistics statistics = output::read_periods(r.signal(), clock);
  CHECK(statistics.periodic);
  CHECK(statistics.mean == doctest::Approx(1.25).epsilon(1e-4));
  CHECK(statistics.amplitude == doctest::Approx(0.4).epsilon(2e-3));
  CHECK(statistics.disagreement < 3e-3);
}

TEST_CASE("the parabola finds an extremum between samples to fourth order")
{
  double before = 0.0;
  for (const double dt : {0.1, 0.05, 0.025})
  {
    // The maximum at 1/4 lies a third of a step behind a sample.
    const Record r = record(0.25 - (40 + 1.0 / 3.0) * dt / 8.0, 0.45, dt / 8.0,
                            [](double t) { return std::sin(turn * t); });
    const output::Extremum greatest = output::find_extrema(r.signal()).greatest;
    const double error = std::abs(greatest.value - 1.0);
    if (before > 0.0)
      CHECK(std::log2(before / error) == doctest::Approx(4.0).epsilon(0.1));
    CHECK(greatest.time == doctest::Approx(0.25).epsilon(dt * dt));
    before = error;
  }
}

TEST_CASE("a parabola is read exactly, also from steps of different size")
{
  const std::vector<double> time = {0.0, 0.3, 0.7, 0.9, 1.6};
  std::vector<double> value;
  value.reserve(time.size());
  for (const double t : time)
    value.push_back(5.0 - 3.0 * (t - 0.77) * (t - 0.77));
  const output::Extremum greatest = output::find_extrema({time, value}).greatest;
  CHECK(greatest.time == doctest::Approx(0.77).epsilon(1e-13));
  CHECK(greatest.value == doctest::Approx(5.0).epsilon(1e-13));
}

TEST_CASE(
    "mean and amplitude are those of the extrema, not time averages, where a second harmonic bends the wave")
{
  // sin + cos(2.) / 4 over a turn: greatest 3/4 at the crest of the sine, where the slope is level and the
  // curvature -1 + 1 = 0; least -5/4 at its trough. Its time average is 0.
  const auto f = [](double t) { return 2.0 + std::sin(turn * t) + 0.25 * std::cos(2.0 * turn * t); };
  const Record r = record(0.0, 12.0, 0.002, f);
  const output::Clock clock = output::find_periods(r.signal());
  const output::Statistics statistics = output::read_periods(r.signal(), clock);
  CHECK(clock.frequency == doctest::Approx(1.0).epsilon(1e-6));
  CHECK(clock.mean == doctest::Approx(2.0).epsilon(1e-4));
  CHECK(statistics.maximum == doctest::Approx(2.75).epsilon(1e-6));
  CHECK(statistics.minimum == doctest::Approx(0.75).epsilon(1e-6));
  CHECK(statistics.mean == doctest::Approx(1.75).epsilon(1e-6));
  CHECK(statistics.amplitude == doctest::Approx(1.0).epsilon(1e-6));
}

TEST_CASE("drag with twice the frequency and unequal halves is read by the periods of the clock")
{
  // The two humps of a period reach 3 + 0.5 and 3 + 0.7, its two valleys about 3 - 0.6: counted by its own
  // upward crossings, the last period would hold only one of the humps.
  const auto drag = [](double t) { return 3.0 + 0.6 * std::sin(2.0 * turn * t) + 0.1 * std::sin(turn * t); };
  for (const double end : {10.0, 10.3, 10.6, 10.9})
  {
    const Record r = record(0.0, end, 0.001, drag);
    const Record lift = record(0.0, end, 0.001, [](double t) { return std::sin(turn * t + 0.4); });
    const output::Clock clock = output::find_periods(lift.signal());
    const output::Statistics statistics = output::read_periods(r.signal(), clock);
    double greatest = 0.0;
    double least = 10.0;
    for (int k = 0; k < 100000; ++k)
    {
      greatest = std::max(greatest, drag(k * 1e-5));
      least = std::min(least, drag(k * 1e-5));
    }
    CHECK(statistics.periodic);
    CHECK(statistics.maximum == doctest::Approx(greatest).epsilon(1e-7));
    CHECK(statistics.minimum == doctest::Approx(least).epsilon(1e-7));
  }
}

TEST_CASE("a record that starts late and steps that change their size give the same reading")
{
  const auto f = [](double t) { return -0.7 + 0.2 * std::sin(turn * 2.0 * t); };
  Record r = record(117.3, 124.0, 0.004, f);
  const Record fine = record(124.001, 128.0, 0.001, f);
  r.time.insert(r.time.end(), fine.time.begin(), fine.time.end());
  r.value.insert(r.value.end(), fine.value.begin(), fine.value.end());
  const output::Clock clock = output::find_periods(r.signal());
  const output::Statistics statistics = output::read_periods(r.signal(), clock);
  CHECK(statistics.periodic);
  CHECK(clock.frequency == doctest::Approx(2.0).epsilon(1e-5));
  CHECK(statistics.mean == doctest::Approx(-0.7).epsilon(1e-5));
  CHECK(statistics.amplitude == doctest::Approx(0.2).epsilon(1e-5));
}

TEST_CASE("a start-up transient of another mean does not disturb the reading of the end")
{
  const auto f = [](double t)
  { return std::sin(turn * t) * (1.0 - std::exp(-t)) + 6.0 * std::exp(-0.8 * t) + 0.5; };
  const Record r = record(0.0, 30.0, 0.005, f);
  const output::Clock clock = output::find_periods(r.signal());
  const output::Statistics statistics = output::read_periods(r.signal(), clock);
  CHECK(statistics.periodic);
  CHECK(clock.frequency == doctest::Approx(1.0).epsilon(1e-5));
  CHECK(statistics.mean == doctest::Approx(0.5).epsilon(1e-4));
  CHECK(statistics.amplitude == doctest::Approx(1.0).epsilon(1e-4));
}

TEST_CASE("a decaying oscillation is not periodic")
{
  for (const double decay : {0.02, 0.1, 0.5})
  {
    const Record r =
        record(0.0, 20.0, 0.01, [=](double t) { return 1.0 + std::exp(-decay * t) * std::sin(turn * t); });
    const output::Clock clock = output::find_periods(r.signal());
    CHECK_FALSE(output::read_periods(r.signal(), clock).periodic);
  }
}

TEST_CASE("a growing oscillation is not periodic")
{
  const Record r = record(0.0, 20.0, 0.01, [](double t) { return std::exp(0.05 * t) * std::sin(turn * t); });
  CHECK_FALSE(output::read_periods(r.signal(), output::find_periods(r.signal())).periodic);
}

TEST_CASE("an oscillation that stopped before the end, a constant and rounding error are not periodic")
{
  const Record stopped =
      record(0.0, 30.0, 0.01, [](double t) { return t < 20.0 ? std::sin(turn * t) : 0.0; });
  const Record constant = record(0.0, 10.0, 0.01, [](double) { return 4.2; });
  const Record rounding = record(0.0, 10.0, 0.01, [](double t) { return 4.2 + 1e-14 * std::sin(turn * t); });
  for (const Record& r : {stopped, constant, rounding})
  {
    const output::Clock clock = output::find_periods(r.signal());
    CHECK_FALSE(clock.found);
    const output::Statistics statistics = output::read_periods(r.signal(), clock);
    CHECK_FALSE(statistics.periodic);
    CHECK(std::isnan(statistics.mean));
  }
}

TEST_CASE("ripple smaller than a tenth of the amplitude adds no periods")
{
  const auto f = [](double t) { return std::sin(turn * t) + 0.08 * std::sin(37.0 * turn * t); };
  const Record r = record(0.0, 15.0, 0.001, f);
  const output::Clock clock = output::find_periods(r.signal());
  CHECK(clock.frequency == doctest::Approx(1.0).epsilon(2e-3));
  CHECK(clock.crossings.size() <= 15);
}

TEST_CASE("a flap needs five periods and is averaged over the last five")
{
  const Record few = record(0.0, 4.9, 0.01, [](double t) { return std::sin(turn * t + 0.2); });
  CHECK(output::find_periods(few.signal()).found);
  CHECK_FALSE(output::find_periods(few.signal(), output::flap_reading).found);

  // The amplitude alternates by 1 % from period to period, 3 of the last 5 being the larger ones.
  const auto f = [](double t)
  { return (static_cast<int>(std::floor(t)) % 2 == 0 ? 1.0 : 0.99) * std::sin(turn * t); };
  const Record r = record(0.0, 15.25, 0.001, f);
  const output::Clock clock = output::find_periods(r.signal(), output::flap_reading);
  const output::Statistics statistics = output::read_periods(r.signal(), clock, output::flap_reading);
  CHECK(statistics.periodic);
  CHECK(statistics.disagreement == doctest::Approx(0.01).epsilon(1e-3));
  CHECK(statistics.amplitude == doctest::Approx((3 * 1.0 + 2 * 0.99) / 5.0).epsilon(1e-5));
}

TEST_CASE("transient extrema are those of the whole record, at its ends as they are")
{
  const Record r = record(0.0, 3.0, 0.01, [](double t) { return t * std::exp(-2.0 * t); });
  const output::Extrema extrema = output::find_extrema(r.signal());
  CHECK(extrema.greatest.time == doctest::Approx(0.5).epsilon(1e-3));
  CHECK(extrema.greatest.value == doctest::Approx(0.5 * std::exp(-1.0)).epsilon(1e-7));
  CHECK(extrema.least.time == 0.0);
  CHECK(extrema.least.value == 0.0);
}

TEST_CASE("a steady signal is read by its last value, with the drift of its last tenth")
{
  const Record r = record(0.0, 10.0, 0.01, [](double t) { return 5.0 + std::exp(-3.0 * t); });
  const output::Steady steady = output::read_steady(r.signal());
  CHECK(steady.value == r.value.back());
  CHECK(steady.drift == doctest::Approx(std::exp(-27.0)).epsilon(0.05));
}

TEST_CASE("times and values of different number are refused")
{
  const std::vector<double> time = {0.0, 1.0};
  const std::vector<double> value = {0.0};
  CHECK_THROWS_WITH_AS(output::find_periods({time, value}), "a signal has 2 times, but 1 values", Error);
  CHECK_THROWS_AS(output::read_steady({}), Error);
}
