// Kovasznay 1948: exact steady flow behind a grid at Re = 40 (ver_kovasznay of the reference data).

#include "support.hpp"

#include "fluid/solver.hpp"

#include <doctest/doctest.h>

#include <numbers>

using namespace blockfsi;

namespace
{

constexpr double viscosity = 1.0 / 40.0;
const double lambda = 20.0 - std::sqrt(400.0 + 4.0 * std::numbers::pi * std::numbers::pi);

verification::Vector exact(double x, double y)
{
  const double decay = std::exp(lambda * x);
  return {1.0 - decay * std::cos(2.0 * std::numbers::pi * y),
          lambda / (2.0 * std::numbers::pi) * decay * std::sin(2.0 * std::numbers::pi * y)};
}

fluid::Parameters parameters()
{
  const Constants constants = {{"l", lambda}};
  const std::array<std::string_view, 2> variables = {"x", "y"};
  const fluid::Velocity velocity{{Expression("1 - exp(l*x) * cos(2*pi*y)", constants, variables),
                                  Expression("l / (2*pi) * exp(l*x) * sin(2*pi*y)", constants, variables),
                                  0.0}};
  fluid::Parameters result;
  result.viscosity = viscosity;
  for (const char* name : {"left", "right", "bottom", "top"})
    result.boundaries.push_back({name, velocity, {}});
  result.newton.tolerance = 1e-11;
  return result;
}

double velocity_error(int order, int cells, double bend)
{
  const verification::Domain domain =
      verification::rectangle({-0.5, -0.5}, {1.0, 1.5}, cells, order, bend, "fluid");
  Timings timings;
  fluid::Solver solver(parameters(), domain.mesh(), domain.numbering, domain.x, timings);
  const fluid::State start = solver.initial();
  std::vector<double> z(3 * domain.mesh().node_count(), 0.0);
  const std::vector<double> w(2 * domain.mesh().node_count(), 0.0);
  const auto report = solver.solve({}, start, {domain.x, w}, z);
  REQUIRE(report.status == linalg::NewtonStatus::converged);
  return verification::error(domain.mesh(), domain.x, z, 3, exact);
}

}  // namespace

TEST_CASE("Kovasznay's flow converges in L2 at order p + 1 on straight and curved blocks")
{
  for (const double bend : {0.0, 0.12})
    for (int order = 1; order <= 4; ++order)
    {
      // Fine enough that the rates are asymptotic.
      const int coarse = order == 1 ? 16 : order == 2 ? 8 : order == 3 ? 6 : 4;
      const double first = velocity_error(order, coarse, bend);
      const double second = velocity_error(order, 2 * coarse, bend);
      const double rate = std::log2(first / second);
      MESSAGE("order " << order << ", bend " << bend << ": errors " << first << " " << second << ", rate "
                       << rate);
      CHECK(rate > order + 1 - 0.2);
    }
}
