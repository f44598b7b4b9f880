#include "linalg/newton.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

using namespace blockfsi;
using namespace blockfsi::linalg;

namespace
{

/// One equation f(z) = 0 with its derivative, for the second of two unknowns (the first is fixed: the
/// ordering PORD ends the program if there is but one); keeps a record of what Newton's method asks.
struct Equation
{
  std::function<double(double)> f;
  std::function<double(double)> slope;
  std::vector<double> asked;       ///< where f was evaluated
  std::vector<double> increments;  ///< sizes of all increments, taken or not
  std::vector<double> remembered;  ///< where factors were made

  void tangent(std::span<const double> z, std::span<double> matrices) const { matrices[3] = slope(z[1]); }
  void remember(std::span<const double> z) { remembered.push_back(z[1]); }
  void residual(std::span<const double> z, std::span<double> r)
  {
    asked.push_back(z[1]);
    r[1] = f(z[1]);
  }
  double size(std::span<const double> increment, std::span<const double>)
  {
    increments.push_back(std::abs(increment[1]));
    return increments.back();
  }
};

struct Case
{
  std::vector<std::int64_t> lattice = {0, 1};
  std::vector<std::int32_t> owner = {0, 0};
  std::vector<std::int32_t> cells = {0, 1};
  std::vector<std::uint8_t> fixed = {1, 0};
  Numbering numbering{lattice, owner};
  System system{numbering, 1, cells, 2, fixed, "test_"};
  Factors factors;
  Timings timings;
  NewtonLimits limits;

  NewtonReport solve(Equation& equation, double& z)
  {
    std::array<double, 2> unknowns = {0.0, z};
    const NewtonReport report = newton(limits, system, factors, equation, unknowns, timings);
    z = unknowns[1];
    return report;
  }
};

Equation square_root(double a)
{
  return {[a](double z) { return z * z - a; }, [](double z) { return 2.0 * z; }, {}, {}, {}};
}

}  // namespace

TEST_CASE("Newton's method with factors renewed in every iteration converges quadratically")
{
  Case test;
  test.limits.tolerance = 1e-14;
  test.limits.patience = 0.0;
  Equation equation = square_root(2.0);
  double z = 3.0;
  const NewtonReport report = test.solve(equation, z);
  CHECK(report.status == NewtonStatus::converged);
  CHECK(z == doctest::Approx(std::sqrt(2.0)).epsilon(1e-15));
  // The error is squared and divided by 2 z, and increments are errors but for higher order.
  const auto& size = equation.increments;
  for (std::size_t k = 2; k + 1 < size.size() && size[k] > 1e-7; ++k)
    CHECK(size[k] == doctest::Approx(size[k - 1] * size[k - 1] / (2.0 * std::sqrt(2.0))).epsilon(0.2));
  CHECK(report.iterations <= 7);
}

TEST_CASE("factors are kept within a solution and over solutions while increments shrink fast")
{
  Case test;
  test.limits.tolerance = 1e-10;
  test.limits.patience = 10.0;
  Equation equation = square_root(2.0);
  double z = 1.5;
  const NewtonReport first = test.solve(equation, z);
  CHECK(first.status == NewtonStatus::converged);
  CHECK(first.renewals == 1);
  CHECK(first.iterations > 2);
  CHECK(std::abs(z - std::sqrt(2.0)) < 1e-10);
  CHECK(!test.factors.stale);
  Equation next = square_root(2.1);
  const NewtonReport second = test.solve(next, z);
  CHECK(second.status == NewtonStatus::converged);
  CHECK(second.renewals == 0);
  CHECK(std::abs(z - std::sqrt(2.1)) < 1e-10);
}

TEST_CASE("factors are renewed where increments shrink slowly")
{
  Case test;
  Equation equation = square_root(2.0);
  double z = 4.0;
  const NewtonReport report = test.solve(equation, z);
  CHECK(report.status == NewtonStatus::converged);
  CHECK(report.renewals > 1);
  CHECK(report.renewals < report.iterations);
  CHECK(std::abs(z - std::sqrt(2.0)) < 1e-8);
}

TEST_CASE("an increment that grew with old factors is not taken")
{
  Case test;
  const auto cubic = [](double right)
  {
    return Equation{[right](double z) { return z + z * z * z - right; },
                    [](double z) { return 1.0 + 3.0 * z * z; },
                    {},
                    {},
                    {}};
  };
  Equation gentle = cubic(0.0);
  double z = 0.01;
  REQUIRE(test.solve(gentle, z).status == NewtonStatus::converged);
  REQUIRE(!test.factors.stale);
  Equation steep = cubic(30.0);
  const NewtonReport report = test.solve(steep, z);
  CHECK(report.status == NewtonStatus::converged);
  CHECK(z == doctest::Approx(3.0).epsilon(0.01));
  // The first increment, 30, is taken for want of a comparison; the next would lead to -27000.
  REQUIRE(steep.increments[1] > 1e4);
  CHECK(steep.asked[2] == steep.asked[1]);
  CHECK(steep.remembered[0] == steep.asked[1]);
  for (const double where : steep.asked)
    CHECK(std::abs(where) < 31.0);
}

TEST_CASE("increments that keep growing with fresh factors are reported as divergence")
{
  Case test;
  // The cube root: each increment leads to -2 z.
  Equation equation{[](double z) { return std::cbrt(z); },
                    [](double z) { return 1.0 / (3.0 * std::cbrt(z * z)); },
                    {},
                    {},
                    {}};
  double z = 1.0;
  const NewtonReport report = test.solve(equation, z);
  CHECK(report.status == NewtonStatus::diverged);
  CHECK(report.iterations < 10);
}

TEST_CASE("a residual that is not a number is reported as divergence and the factors are not used again")
{
  Case test;
  Equation equation{[](double) { return std::numeric_limits<double>::quiet_NaN(); },
                    [](double) { return 1.0; },
                    {},
                    {},
                    {}};
  double z = 1.0;
  CHECK(test.solve(equation, z).status == NewtonStatus::diverged);
  CHECK(test.factors.stale);
  CHECK(z == 1.0);
}

TEST_CASE("a zero tangent is reported as singular, and the next solution starts afresh")
{
  Case test;
  Equation flat{[](double) { return 1.0; }, [](double) { return 0.0; }, {}, {}, {}};
  double z = 1.0;
  CHECK(test.solve(flat, z).status == NewtonStatus::singular);
  Equation equation = square_root(2.0);
  const NewtonReport report = test.solve(equation, z);
  CHECK(report.status == NewtonStatus::converged);
  CHECK(report.renewals > 0);
}

TEST_CASE("too few iterations are reported")
{
  Case test;
  test.limits.iterations = 2;
  test.limits.tolerance = 1e-15;
  Equation equation = square_root(2.0);
  double z = 100.0;
  const NewtonReport report = test.solve(equation, z);
  CHECK(report.status == NewtonStatus::too_many_iterations);
  CHECK(report.iterations == 2);
  CHECK(test.factors.stale);
}
