#include "coupling/partitioned.hpp"
#include "coupling/predictor.hpp"

#include "toy.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace blockfsi::coupling;
using test::AddedMass;
using test::Vector;

namespace
{

AddedMass loaded(std::size_t size, double mu_0)
{
  AddedMass problem(size, mu_0);
  problem.set_load(Vector(size, 1.0));
  return problem;
}

}  // namespace

TEST_CASE("the relative residual is measured by the displacement of the step")
{
  CHECK(relative_residual(Vector{10.0}, Vector{10.1}, Vector{9.6}, 0.0) == doctest::Approx(0.2));
}

TEST_CASE("the relative residual does not depend on how many nodes the interface has")
{
  const double coarse = relative_residual(Vector{0.9}, Vector{1.0}, Vector{1.0}, 0.5);
  const double fine = relative_residual(Vector(4, 0.9), Vector(4, 1.0), Vector(4, 1.0), 0.5);
  CHECK(coarse == doctest::Approx(0.2));
  CHECK(fine == doctest::Approx(coarse));
}

TEST_CASE("at rest a zero residual is zero and rounding is measured by the whole displacement")
{
  CHECK(relative_residual(Vector{0.0}, Vector{0.0}, Vector{0.0}, 0.0) == 0.0);
  CHECK(relative_residual(Vector{1.0}, Vector{1.0 + 1e-12}, Vector{1.0 + 1e-12}, 0.0) ==
        doctest::Approx(1e-6).epsilon(0.01));
}

TEST_CASE("the partitioned solution of a hard added-mass problem is the exact one")
{
  const AddedMass problem = loaded(50, 10.0);
  Acceleration acceleration({}, 50);
  Vector d(50, 0.0);
  const Report report = solve_partitioned(problem, acceleration, {.tolerance = 1e-9}, d, Vector(50, 0.0));
  CHECK(report.status == Status::converged);
  CHECK(report.residuals.size() == static_cast<std::size_t>(report.iterations));
  CHECK(report.residuals.back() <= 1e-9);
  CHECK(test::distance(d, problem.solution()) < 1e-7);
}

TEST_CASE("d is the input of the last evaluation")
{
  const AddedMass problem = loaded(20, 3.0);
  Acceleration acceleration({}, 20);
  Vector last_input;
  const auto evaluate = [&](std::span<const double> d, std::span<double> d_tilde)
  {
    last_input.assign(d.begin(), d.end());
    return problem(d, d_tilde);
  };
  Vector d(20, 0.0);
  for (const int iterations : {3, 50})
  {
    const Report report =
        solve_partitioned(evaluate, acceleration, {.iterations = iterations}, d, Vector(20, 0.0));
    CHECK((report.status == Status::converged) == (iterations == 50));
    CHECK(report.iterations <= iterations);
    CHECK(d == last_input);
  }
}

TEST_CASE("a system at rest converges at once and can start to move later")
{
  AddedMass problem(10, 5.0);
  Acceleration acceleration({}, 10);
  Vector d(10, 0.0);
  const Vector start(10, 0.0);
  for (int step = 0; step < 3; ++step)
    CHECK(solve_partitioned(problem, acceleration, {}, d, start).iterations == 1);
  CHECK(acceleration.history().V.empty());
  problem.set_load({1.0, 1.0});
  CHECK(solve_partitioned(problem, acceleration, {}, d, start).status == Status::converged);
}

TEST_CASE("a failing solver and a displacement that is no number are reported, not thrown")
{
  Acceleration acceleration({}, 1);
  Vector d = {0.0};
  const auto fails = [](std::span<const double>, std::span<double>) { return false; };
  CHECK(solve_partitioned(fails, acceleration, {}, d, Vector{0.0}).status == Status::solver_failed);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    const auto answers_bad = [bad](std::span<const double>, std::span<double> d_tilde)
    {
      std::fill(d_tilde.begin(), d_tilde.end(), bad);
      return true;
    };
    CHECK(solve_partitioned(answers_bad, acceleration, {}, d, Vector{0.0}).status == Status::diverged);
  }
}

TEST_CASE("a step that failed leaves the accelerator as it was for the next try")
{
  const AddedMass problem = loaded(12, 3.0);
  Acceleration acceleration({}, 12);
  Vector d(12, 0.0);
  REQUIRE(solve_partitioned(problem, acceleration, {}, d, Vector(12, 0.0)).status == Status::converged);
  const History before = acceleration.history();
  Vector e(12, 5.0);
  REQUIRE(solve_partitioned(problem, acceleration, {.tolerance = 1e-14, .iterations = 2}, e, d).status ==
          Status::too_many_iterations);
  acceleration.start_step();
  CHECK(acceleration.history() == before);
}

TEST_CASE("over a series of steps quasi-Newton with reuse needs few evaluations, fewer than Aitken")
{
  const auto mean = [](const Accelerator& method)
  {
    AddedMass problem(120, 3.0);
    Acceleration acceleration({.accelerator = method}, 120);
    Vector d(120, 0.0);
    Past past{{d}};
    int sum = 0;
    for (int step = 1; step <= 30; ++step)
    {
      const double t = 0.05 * step;
      problem.set_load({std::sin(3 * t), std::cos(2 * t), std::sin(t), 0.3 * std::sin(7 * t)});
      predict(1, past, 1.0, d);
      const Report report = solve_partitioned(problem, acceleration, {.tolerance = 1e-6}, d, past.d.front());
      CHECK(report.status == Status::converged);
      sum += step > 5 ? report.iterations : 0;
      remember(past, d, 1.0);
    }
    return sum / 25.0;
  };
  const double aitken = mean(Aitken{}), fresh = mean(IqnIls{.reuse = 0}), reused = mean(IqnIls{}),
               carried = mean(IqnImvj{});
  MESSAGE("evaluations per step: Aitken " << aitken << ", quasi-Newton " << fresh << ", with reuse " << reused
                                          << ", with a carried Jacobian " << carried);
  CHECK(fresh < aitken);
  CHECK(reused < 5.0);
  CHECK(carried < 5.0);
}
