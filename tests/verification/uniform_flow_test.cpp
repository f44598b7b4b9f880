// Geometric conservation: a uniform flow does not notice that the mesh moves
// (ver_gcl_uniform_flow of the reference data).

#include "support.hpp"

#include "fluid/solver.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <numbers>

using namespace blockfsi;

namespace
{

constexpr verification::Vector stream = {1.0, 0.5};

fluid::Parameters parameters()
{
  fluid::Parameters result;
  result.viscosity = 0.01;
  result.initial_velocity = {stream[0], stream[1], 0.0};
  for (const char* name : {"left", "right", "bottom", "top"})
    result.boundaries.push_back({name, fluid::Velocity{{stream[0], stream[1], 0.0}}, {}});
  result.newton.tolerance = 1e-13;
  return result;
}

/// Largest deviations of the velocity from the stream and of the pressure from zero.
struct Deviation
{
  double u = 0.0;
  double p = 0.0;
};

/// In 100 steps on a moving mesh.
Deviation deviation(const verification::Domain& domain, double theta,
                    const std::function<std::vector<double>(double t)>& mesh_at)
{
  Timings timings;
  fluid::Solver solver(parameters(), domain.mesh(), domain.numbering, domain.x, timings);
  fluid::State state = solver.initial();
  const double step = 0.013;
  std::vector<double> z(3 * state.p.size());
  std::vector<double> start = mesh_at(0.0);
  Deviation largest;
  for (int n = 0; n < 100; ++n)
  {
    const fem::TimeStep time{n * step, step, theta, theta};
    const std::vector<double> end = mesh_at((n + 1) * step);
    const std::vector<double> x = verification::between(start, end, theta);
    const std::vector<double> w = verification::rate(start, end, step);
    solver.guess(time, state, z);
    const auto report = solver.solve(time, state, {x, w}, z);
    REQUIRE(report.status == linalg::NewtonStatus::converged);
    state = solver.finish(time, state, z);
    for (std::size_t i = 0; i < state.u.size(); ++i)
      largest.u = std::max(largest.u, std::abs(state.u[i] - stream[i % 2]));
    for (const double p : state.p)
      largest.p = std::max(largest.p, std::abs(p));
    start = end;
  }
  return largest;
}

}  // namespace

TEST_CASE("a uniform flow stays uniform while the mesh moves inside")
{
  for (const int order : {1, 2, 4, 6})
    for (const double theta : {0.5, 1.0})
    {
      const verification::Domain domain =
          verification::rectangle({0.0, 0.0}, {1.0, 1.0}, order > 2 ? 1 : 3, order, 0.0, "fluid");
      const Deviation error =
          deviation(domain, theta, [&](double t) { return verification::moved_inside(domain.x, 0.1, t); });
      MESSAGE("order " << order << ", theta " << theta << ": " << error.u << " " << error.p);
      CHECK(error.u < 1e-11);
      CHECK(error.p < 1e-11);
    }
}

TEST_CASE("a uniform flow stays uniform while blocks are meshed anew under a moving side")
{
  for (const int order : {1, 2, 4, 6})
  {
    const verification::Domain domain =
        verification::rectangle({0.0, 0.0}, {1.0, 1.0}, order > 2 ? 1 : 3, order, 0.05, "fluid");
    const auto mesh_at = [&](double t)
    {
      // The lines between the blocks follow the top in proportion to their height.
      std::vector<double> skeleton = domain.skeleton.x;
      for (std::size_t i = 0; i < skeleton.size(); i += 2)
      {
        const double X = skeleton[i];
        const double height = skeleton[i + 1];
        skeleton[i + 1] +=
            0.2 * std::sin(2.0 * std::numbers::pi * (X + t)) * std::sin(2.0 * std::numbers::pi * t) * height;
      }
      std::vector<double> x(domain.x.size());
      block::place(domain.connected.plan, skeleton, x);
      return x;
    };
    const Deviation error = deviation(domain, 0.5, mesh_at);
    MESSAGE("order " << order << ": " << error.u << " " << error.p);
    CHECK(error.u < 1e-11);
    CHECK(error.p < 1e-11);
  }
}
