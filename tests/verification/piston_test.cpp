// A plug of incompressible fluid on an elastic bar: exact frequency with added mass, and large motions
// (ver_fsi_piston_linear and ver_fsi_piston_nonlinear of the reference data).

#include "whole_case.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

using namespace blockfsi;

namespace
{

/// The bar's end and the mean number of coupling iterations over a whole run.
struct Swing
{
  std::vector<double> time, end;
  double iterations = 0.0;
};

Swing finished(const std::string& name, const std::vector<std::string>& settings, double height)
{
  run::Simulation simulation(verification::whole_case(name, settings));
  Swing result;
  result.time = {0.0};
  result.end = {0.0};
  while (!simulation.finished())
  {
    const run::StepReport report = simulation.advance();
    REQUIRE_MESSAGE(report.ok, report.failure);
    result.iterations += report.coupling_iterations;
    const run::SolidSide& solid = *simulation.solid();
    result.time.push_back(simulation.time());
    result.end.push_back(verification::at(solid.mesh(), solid.X(), solid.state().d, {1.0, 0.5 * height})[0]);
  }
  result.iterations /= static_cast<double>(result.time.size() - 1);
  return result;
}

/// Angular frequency from the times at which the signal, 0 at the start, rises through 0.
double angular_frequency(const Swing& bar)
{
  double last = 0.0;
  int periods = 0;
  for (std::size_t i = 1; i + 1 < bar.end.size(); ++i)
    if (bar.end[i] < 0.0 && bar.end[i + 1] >= 0.0)
    {
      const double part = bar.end[i] / (bar.end[i] - bar.end[i + 1]);
      last = bar.time[i] + part * (bar.time[i + 1] - bar.time[i]);
      ++periods;
    }
  REQUIRE(periods > 0);
  return 2.0 * std::numbers::pi * periods / last;
}

double end_of_bar(double step, double end)
{
  return finished("piston-nonlinear", {fmt::format("time.step={}", step), fmt::format("time.end={}", end)},
                  0.25)
      .end.back();
}

}  // namespace

TEST_CASE(
    "a plug of fluid as heavy as the bar, and ten times as heavy, lowers its frequency as added mass does")
{
  // xi tan xi = 1 / m
  for (const auto& [m, xi] : {std::pair{1.0, 0.86033358901938}, std::pair{10.0, 0.31105284820028}})
  {
    const double period = 2.0 * std::numbers::pi / xi;
    // The trapezoidal rule lengthens the period by (omega step)^2 / 12, here 2e-5.
    const Swing result =
        finished("piston-linear",
                 {fmt::format("let.m={}", m), fmt::format("let.xi={}", xi),
                  fmt::format("time.step={}", period / 400), fmt::format("time.end={}", 2.05 * period)},
                 0.5);
    const double error = angular_frequency(result) / xi - 1.0;
    MESSAGE("mass ratio " << m << ": relative error of the frequency " << error << ", coupling iterations "
                          << result.iterations);
    CHECK(std::abs(error) < 1e-4);
    CHECK(result.iterations < 4.0);
  }
}

TEST_CASE("a bar that pushes fluid far to and fro moves as the equation in one dimension says")
{
  // Spectral elements in space, Dormand & Prince of order 8 in time: good to 1e-9.
  CHECK(std::abs(end_of_bar(2.5e-3, 0.5) / -0.17435511278 - 1.0) < 1e-3);
}

TEST_CASE("the motion of a bar with fluid is of second order in time")
{
  const double exact = -0.17435511278;
  const double coarse = std::abs(end_of_bar(5e-3, 0.5) - exact);
  const double fine = std::abs(end_of_bar(2.5e-3, 0.5) - exact);
  MESSAGE("errors " << coarse << " " << fine << ", order " << std::log2(coarse / fine));
  CHECK(std::abs(std::log2(coarse / fine) - 2.0) < 0.2);
}
