// The ways of accelerating the coupling on a flap that the flow bends.

#include "whole_case.hpp"

#include <cmath>

using namespace blockfsi;

namespace
{

struct Result
{
  std::vector<double> interface;  ///< displacement at the end [m]
  double iterations = 0.0;        ///< mean of the second half of the steps
};

Result flap(const std::string& accelerator)
{
  run::Simulation simulation(verification::whole_case(
      "wall-ramm-flap", {"blocks.order=2", "blocks.lattice.channel.divide.x=[2, 2, 4, 4]",
                         "blocks.lattice.channel.divide.y=[2, 2, 1, 2, 2]", "time.step=0.02", "time.end=0.8",
                         "coupling.tolerance=1e-6", "fluid.newton.tolerance=1e-9",
                         "coupling.accelerator={" + accelerator + "}"}));
  Result result;
  while (!simulation.finished())
  {
    const run::StepReport report = simulation.advance();
    REQUIRE_MESSAGE(report.ok, report.failure);
    if (2 * simulation.step() > simulation.step_count())
      result.iterations += 2.0 * report.coupling_iterations / static_cast<double>(simulation.step_count());
  }
  const auto d = simulation.interface_displacement();
  result.interface.assign(d.begin(), d.end());
  return result;
}

/// Norm of a - b relative to that of b.
double difference(const std::vector<double>& a, const std::vector<double>& b)
{
  double square = 0.0, size = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    square += (a[i] - b[i]) * (a[i] - b[i]);
    size += b[i] * b[i];
  }
  return std::sqrt(square / size);
}

}  // namespace

TEST_CASE("both quasi-Newton methods lead to the motion that Aitken's relaxation does, in fewer iterations")
{
  const Result aitken = flap("aitken={}");
  const Result ils = flap("iqn_ils={}");
  const Result imvj = flap("iqn_imvj={}");
  MESSAGE("iterations per step: Aitken " << aitken.iterations << ", IQN-ILS " << ils.iterations
                                         << ", IQN-IMVJ " << imvj.iterations << "; differences "
                                         << difference(ils.interface, aitken.interface) << " "
                                         << difference(imvj.interface, aitken.interface));
  CHECK(difference(ils.interface, aitken.interface) < 1e-4);
  CHECK(difference(imvj.interface, aitken.interface) < 1e-4);
  CHECK(ils.iterations < 0.8 * aitken.iterations);
  CHECK(imvj.iterations < 0.8 * aitken.iterations);
}

TEST_CASE("predictors of higher order save iterations, and the automatic one finds them")
{
  const auto iterations = [](const std::string& order)
  {
    run::Simulation simulation(
        verification::whole_case("piston-nonlinear", {"blocks.order=2", "time.step=2.5e-3", "time.end=0.25",
                                                      "coupling.predictor=" + order}));
    int sum = 0;
    while (!simulation.finished())
    {
      const run::StepReport report = simulation.advance();
      REQUIRE_MESSAGE(report.ok, report.failure);
      sum += report.coupling_iterations;
    }
    return sum;
  };
  const int zero = iterations("0"), one = iterations("1"), two = iterations("2"), four = iterations("4"),
            automatic = iterations("\"automatic\"");
  MESSAGE("iterations with predictors of order 0, 1, 2, 4, automatic: " << zero << " " << one << " " << two
                                                                        << " " << four << " " << automatic);
  CHECK(one < 0.9 * zero);
  CHECK(two < one);
  CHECK(automatic <= two);
}
