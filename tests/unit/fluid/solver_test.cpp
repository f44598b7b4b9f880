#include "fluid/solver.hpp"

#include "../mesh/structured.hpp"
#include "fluid/conditions.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace blockfsi;

namespace
{

Expression formula(std::string_view text)
{
  const std::array<std::string_view, 3> variables = {"x", "y", "t"};
  return Expression(text, {}, variables);
}

/// A unit square of 3 x 3 cells with its four named sides.
struct Square
{
  SampleMesh sample;
  linalg::Numbering numbering;
  Timings timings;

  explicit Square(int order)
      : sample(structured(order, 3, 3,
                          [](double x, double y) {
                            return std::array{x, y};
                          }))
  {
    for (std::int32_t k = 0; k < 3; ++k)
    {
      sample.mesh.boundaries["bottom"].push_back({k, 0});
      sample.mesh.boundaries["right"].push_back({3 * k + 2, 1});
      sample.mesh.boundaries["top"].push_back({6 + k, 2});
      sample.mesh.boundaries["left"].push_back({3 * k, 3});
    }
    numbering = linalg::Numbering(sample.mesh.lattice, sample.mesh.owner);
  }

  std::size_t count() const { return sample.mesh.node_count(); }
  std::vector<double> zero() const { return std::vector<double>(2 * count(), 0.0); }
};

fluid::Parameters closed_box()
{
  fluid::Parameters result;
  for (const char* name : {"left", "right", "bottom", "top"})
    result.boundaries.push_back({name, fluid::Wall{}, {}});
  return result;
}

/// The condition at a node: kind by component, -1: free.
std::array<int, 2> kinds(const fluid::Conditions& conditions, std::int32_t node)
{
  std::array<int, 2> result = {-1, -1};
  for (const fluid::Prescribed& entry : conditions.prescribed)
    if (entry.node == node)
      result[entry.component] = static_cast<int>(entry.kind);
  return result;
}

}  // namespace

TEST_CASE("where boundaries meet a wall wins over the interface, that over a velocity, that over slip")
{
  Square square(1);  // nodes 4 x 4
  auto& boundaries = square.sample.mesh.boundaries;
  boundaries["interface"] = boundaries["bottom"];
  boundaries.erase("bottom");
  fluid::Parameters parameters;
  parameters.boundaries = {{"left", fluid::Wall{}, {}},
                           {"right", fluid::Velocity{{1.0, 0.0, 0.0}}, {}},
                           {"top", fluid::Slip{}, {}}};
  const auto conditions =
      fluid::find_conditions(parameters, square.sample.mesh, square.numbering, square.sample.x);
  const int zero = static_cast<int>(fluid::Prescribed::Kind::zero);
  const int expression = static_cast<int>(fluid::Prescribed::Kind::expression);
  const int interface = static_cast<int>(fluid::Prescribed::Kind::interface);
  CHECK(kinds(conditions, 0) == std::array{zero, zero});
  CHECK(kinds(conditions, 1) == std::array{interface, interface});
  CHECK(kinds(conditions, 3) == std::array{interface, interface});
  CHECK(kinds(conditions, 7) == std::array{expression, expression});
  CHECK(kinds(conditions, 15) == std::array{expression, expression});
  CHECK(kinds(conditions, 13) == std::array{-1, zero});
  CHECK(kinds(conditions, 5) == std::array{-1, -1});
  CHECK(conditions.enclosed);
}

TEST_CASE("an enclosed flow fixes one pressure, one with an outflow none")
{
  const Square square(2);
  const auto pressures = [&](const fluid::Parameters& parameters)
  {
    const auto conditions =
        fluid::find_conditions(parameters, square.sample.mesh, square.numbering, square.sample.x);
    const auto fixed = fluid::fixed_unknowns(conditions, square.sample.mesh);
    int count = 0;
    for (std::size_t i = 2; i < fixed.size(); i += 3)
      count += fixed[i];
    return count;
  };
  fluid::Parameters parameters = closed_box();
  CHECK(pressures(parameters) == 1);
  parameters.boundaries[1].condition = fluid::Outflow{};
  CHECK(pressures(parameters) == 0);
}

TEST_CASE("slip on a slanted side is refused")
{
  Square square(1);
  square.sample.x[2 * 13 + 1] += 0.05;
  fluid::Parameters parameters = closed_box();
  parameters.boundaries[3].condition = fluid::Slip{};
  CHECK_THROWS_AS(fluid::find_conditions(parameters, square.sample.mesh, square.numbering, square.sample.x),
                  Error);
}

TEST_CASE("a fluid at rest under gravity takes the hydrostatic pressure")
{
  for (const double step : {0.0, 0.1})
  {
    Square square(2);
    fluid::Parameters parameters = closed_box();
    parameters.density = 1000.0;
    parameters.viscosity = 1.0;
    parameters.body_force = {0.0, -10.0, 0.0};
    fluid::Solver solver(parameters, square.sample.mesh, square.numbering, square.sample.x, square.timings);
    const fluid::State start = solver.initial();
    const std::vector<double> w = square.zero();
    std::vector<double> z(3 * square.count(), 0.0);
    const fem::TimeStep time{0.0, step, 1.0, 1.0};
    CHECK(solver.solve(time, start, {square.sample.x, w}, z).status == linalg::NewtonStatus::converged);
    for (std::size_t i = 0; i < square.count(); ++i)
    {
      CHECK(std::abs(z[3 * i]) + std::abs(z[3 * i + 1]) < 1e-8);
      CHECK(z[3 * i + 2] - z[2] ==
            doctest::Approx(-1e4 * square.sample.x[2 * i + 1]).epsilon(1e-9).scale(1e4));
    }
  }
}

TEST_CASE("a fluid at rest without forces stays at rest")
{
  Square square(2);
  fluid::Solver solver(closed_box(), square.sample.mesh, square.numbering, square.sample.x, square.timings);
  const fluid::State start = solver.initial();
  const std::vector<double> w = square.zero();
  std::vector<double> z(3 * square.count(), 0.0);
  CHECK(solver.solve({0.0, 0.1, 0.5, 0.5}, start, {square.sample.x, w}, z).status ==
        linalg::NewtonStatus::converged);
  for (const double value : z)
    CHECK(value == 0.0);
}

TEST_CASE("the body force acts where the nodes are, not where they were")
{
  Square square(2);
  fluid::Parameters parameters = closed_box();
  parameters.body_force = {formula("2*x"), 0.0, 0.0};  // balanced by p = x^2
  fluid::Solver solver(parameters, square.sample.mesh, square.numbering, square.sample.x, square.timings);
  const fluid::State start = solver.initial();
  const std::vector<double> w = square.zero();
  std::vector<double> x = square.sample.x;
  for (std::size_t i = 0; i < x.size(); i += 2)
    x[i] += 1.0;
  std::vector<double> z(3 * square.count(), 0.0);
  REQUIRE(solver.solve({0.0, 0.1, 1.0, 1.0}, start, {x, w}, z).status == linalg::NewtonStatus::converged);
  for (std::size_t i = 0; i < square.count(); ++i)
    CHECK(z[3 * i + 2] - z[2] == doctest::Approx(x[2 * i] * x[2 * i] - 1.0).epsilon(1e-9));
}

TEST_CASE(
    "an enclosed flow whose prescribed velocities do not balance is refused, one along its walls is not")
{
  Square square(2);
  fluid::Parameters parameters = closed_box();
  const std::vector<double> w = square.zero();
  const auto solve = [&](const Expression& along, const Expression& across)
  {
    parameters.boundaries[3].condition = fluid::Velocity{{along, across, 0.0}};
    fluid::Solver solver(parameters, square.sample.mesh, square.numbering, square.sample.x, square.timings);
    std::vector<double> z(3 * square.count(), 0.0);
    return solver.solve({0.0, 0.2, 1.0, 1.0}, solver.initial(), {square.sample.x, w}, z).status;
  };
  CHECK(solve(1.0, 0.0) == linalg::NewtonStatus::converged);
  CHECK_THROWS_WITH_AS(solve(0.0, 1.0), doctest::Contains("more flows out than in"), Error);
}

TEST_CASE("the velocity of a step is that at its time, and its end follows from both ends")
{
  Square square(2);
  fluid::Parameters parameters = closed_box();
  parameters.boundaries[3].condition = fluid::Velocity{{formula("t"), 0.0, 0.0}};
  fluid::Solver solver(parameters, square.sample.mesh, square.numbering, square.sample.x, square.timings);
  const fluid::State start = solver.initial();
  const std::vector<double> w = square.zero();
  std::vector<double> z(3 * square.count(), 0.0);
  const fem::TimeStep time{0.0, 0.2, 0.6, 0.5};
  REQUIRE(solver.solve(time, start, {square.sample.x, w}, z).status == linalg::NewtonStatus::converged);
  const fluid::State end = solver.finish(time, start, z);
  const std::size_t top = square.count() - 3;
  CHECK(z[3 * top] == doctest::Approx(0.6 * 0.2));
  CHECK(end.u[2 * top] == doctest::Approx(0.2));
  CHECK(end.time == doctest::Approx(0.2));
  CHECK(end.p_time == doctest::Approx(0.12));
  for (std::size_t i = 0; i < 2 * square.count(); ++i)
    CHECK(0.6 * end.u[i] + 0.4 * start.u[i] == doctest::Approx(z[3 * (i / 2) + i % 2]));
}

TEST_CASE(
    "the pressure at the end of a step is extrapolated from two, but not from the unknown one at the start")
{
  Square square(1);
  fluid::Solver solver(closed_box(), square.sample.mesh, square.numbering, square.sample.x, square.timings);
  const fluid::State start = solver.initial();
  std::vector<double> z(3 * square.count(), 0.0);
  for (std::size_t i = 0; i < square.count(); ++i)
    z[3 * i + 2] = 4.0;
  const fluid::State first = solver.finish({0.0, 0.2, 0.5, 0.5}, start, z);
  for (const double p : first.pressure_now())
    CHECK(p == doctest::Approx(4.0));
  for (std::size_t i = 0; i < square.count(); ++i)
    z[3 * i + 2] = 6.0;
  const fluid::State second = solver.finish({0.2, 0.2, 0.5, 0.5}, first, z);
  for (const double p : second.pressure_now())
    CHECK(p == doctest::Approx(7.0));
}

TEST_CASE("factors restored from a saved linearisation give the same next solution bit for bit")
{
  fluid::Parameters parameters = closed_box();
  parameters.boundaries[3].condition = fluid::Velocity{{formula("x*(1 - x)*t"), 0.0, 0.0}};
  parameters.viscosity = 0.01;
  Square square(2);
  const std::vector<double> w = square.zero();
  fluid::Solver solver(parameters, square.sample.mesh, square.numbering, square.sample.x, square.timings);
  fluid::State state = solver.initial();
  std::vector<double> z(3 * square.count(), 0.0);
  for (int n = 0; n < 3; ++n)
  {
    const fem::TimeStep time{0.2 * n, 0.2, 0.5, 0.5};
    solver.guess(time, state, z);
    REQUIRE(solver.solve(time, state, {square.sample.x, w}, z).status == linalg::NewtonStatus::converged);
    state = solver.finish(time, state, z);
  }
  fluid::Solver other(parameters, square.sample.mesh, square.numbering, square.sample.x, square.timings);
  other.restore(solver.linearisation());
  const fem::TimeStep time{0.6, 0.2, 0.5, 0.5};
  std::vector<double> again(z.size());
  solver.guess(time, state, z);
  other.guess(time, state, again);
  REQUIRE(solver.solve(time, state, {square.sample.x, w}, z).status == linalg::NewtonStatus::converged);
  REQUIRE(other.solve(time, state, {square.sample.x, w}, again).status == linalg::NewtonStatus::converged);
  CHECK(z == again);
}
