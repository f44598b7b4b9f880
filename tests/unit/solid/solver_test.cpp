#include "solid/solver.hpp"

#include "../mesh/structured.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace blockfsi;

namespace
{

/// A bar of length 1 and height 1 / 4 fixed at its left end, of a material without lateral contraction.
struct Bar
{
  SampleMesh sample;
  linalg::Numbering numbering;
  solid::Parameters parameters;
  Timings timings;

  explicit Bar(int order)
      : sample(structured(order, 4, 1,
                          [](double x, double y) {
                            return std::array{x, 0.25 * y};
                          }))
  {
    sample.mesh.boundaries["left"] = {{0, 3}};
    sample.mesh.boundaries["right"] = {{3, 1}};
    for (std::int32_t k = 0; k < 4; ++k)
    {
      sample.mesh.boundaries["bottom"].push_back({k, 0});
      sample.mesh.boundaries["top"].push_back({k, 2});
    }
    numbering = linalg::Numbering(sample.mesh.lattice, sample.mesh.owner);
    parameters.density = 2.0;
    parameters.young = 8.0;
    parameters.poisson = 0.0;
    parameters.boundaries = {{"left", solid::Fixed{}, {}},
                             {"right", solid::Traction{}, {}},
                             {"bottom", solid::Traction{}, {}},
                             {"top", solid::Traction{}, {}}};
  }

  solid::Solver solver() { return {parameters, sample.mesh, numbering, sample.x, timings}; }
  std::vector<double> zero() const { return std::vector<double>(2 * sample.mesh.node_count(), 0.0); }
};

/// Solves for the bar at rest, which must become `stretch` times as long and keep its width.
void check_uniform_stretch(Bar& bar, double stretch)
{
  solid::Solver solver = bar.solver();
  std::vector<double> d = bar.zero();
  REQUIRE(solver.solve_static(bar.zero(), d).status == linalg::NewtonStatus::converged);
  for (std::size_t i = 0; i < d.size(); i += 2)
  {
    CHECK(d[i] == doctest::Approx((stretch - 1.0) * bar.sample.x[i]).epsilon(1e-10));
    CHECK(std::abs(d[i + 1]) < 1e-12);
  }
}

}  // namespace

TEST_CASE("a bar under a dead traction stretches as St. Venant and Kirchhoff say")
{
  Bar bar(2);
  const double stretch = 1.2;
  bar.parameters.boundaries[1].condition =
      solid::Traction{{0.5 * bar.parameters.young * stretch * (stretch * stretch - 1.0), 0.0, 0.0}};
  check_uniform_stretch(bar, stretch);
}

TEST_CASE("between walls along which it slips a bar is stretched by its modulus for uniaxial strain")
{
  Bar bar(2);
  bar.parameters.poisson = 0.3;
  const solid::Lame lame = solid::lame(bar.parameters.young, 0.3, solid::Plane::strain);
  const double stretch = 1.2;
  bar.parameters.boundaries[1].condition =
      solid::Traction{{0.5 * (lame.lambda + 2.0 * lame.mu) * stretch * (stretch * stretch - 1.0), 0.0, 0.0}};
  const solid::Displacement slips{{}, {true, false, false}};
  bar.parameters.boundaries[2].condition = slips;
  bar.parameters.boundaries[3].condition = slips;
  check_uniform_stretch(bar, stretch);
}

TEST_CASE("a fixed end holds a bar in both directions, also where it slips along another boundary")
{
  Bar bar(1);
  bar.parameters.boundaries[2].condition = solid::Displacement{{}, {true, false, false}};
  bar.parameters.body_force = {3.0, 0.0, 0.0};
  solid::Solver solver = bar.solver();
  std::vector<double> d = bar.zero();
  REQUIRE(solver.solve_static(bar.zero(), d).status == linalg::NewtonStatus::converged);
  CHECK(d[2 * bar.sample.mesh.cell(0)[0]] == 0.0);
  CHECK(d[2 * bar.sample.mesh.cell(3)[1]] > 0.01);
}

TEST_CASE("a free body with an initial velocity flies on with it")
{
  Bar bar(2);
  bar.parameters.boundaries[0].condition = solid::Traction{};
  bar.parameters.initial_velocity = {0.5, -2.0, 0.0};
  solid::Solver solver = bar.solver();
  const solid::State start = solver.initial();
  std::vector<double> d = bar.zero();
  REQUIRE(solver.advance({0.0, 0.1, 0.5, 0.5}, start, bar.zero(), d).status ==
          linalg::NewtonStatus::converged);
  for (std::size_t i = 0; i < d.size(); i += 2)
  {
    CHECK(d[i] == doctest::Approx(0.05));
    CHECK(d[i + 1] == doctest::Approx(-0.2));
  }
}

TEST_CASE("nodal loads act as a traction with the same resultant does")
{
  Bar bar(1);
  bar.parameters.young = 1e4;
  const double force = 3.0;
  solid::Solver loaded = bar.solver();
  std::vector<double> load = bar.zero();
  std::vector<double> d = bar.zero();
  for (std::size_t i = 0; i < load.size(); i += 2)
    if (bar.sample.x[i] == 1.0)
      load[i] = 0.5 * force;
  REQUIRE(loaded.solve_static(load, d).status == linalg::NewtonStatus::converged);
  bar.parameters.boundaries[1].condition = solid::Traction{{force / 0.25, 0.0, 0.0}};
  solid::Solver pulled = bar.solver();
  std::vector<double> other = bar.zero();
  REQUIRE(pulled.solve_static(bar.zero(), other).status == linalg::NewtonStatus::converged);
  for (std::size_t i = 0; i < d.size(); ++i)
    CHECK(d[i] == doctest::Approx(other[i]).epsilon(1e-9));
}

TEST_CASE("a body without loads stays at rest")
{
  Bar bar(2);
  solid::Solver solver = bar.solver();
  std::vector<double> d = bar.zero();
  CHECK(solver.solve_static(bar.zero(), d).status == linalg::NewtonStatus::converged);
  CHECK(solver.advance({0.0, 0.1, 0.5, 0.5}, solver.initial(), bar.zero(), d).status ==
        linalg::NewtonStatus::converged);
  for (const double value : d)
    CHECK(value == 0.0);
}

TEST_CASE("a fixed boundary wins over a prescribed displacement where they meet")
{
  Bar bar(1);
  bar.parameters.boundaries[3].condition = solid::Displacement{{0.0, 0.01, 0.0}};
  solid::Solver solver = bar.solver();
  std::vector<double> d = bar.zero();
  REQUIRE(solver.solve_static(bar.zero(), d).status == linalg::NewtonStatus::converged);
  for (std::size_t i = 0; i < d.size(); i += 2)
    if (bar.sample.x[i + 1] == 0.25)
      CHECK(d[i + 1] == (bar.sample.x[i] == 0.0 ? 0.0 : 0.01));
}

TEST_CASE("velocity and displacement of a step obey the theta scheme")
{
  Bar bar(1);
  const solid::Solver solver = bar.solver();
  solid::State old = solver.initial();
  std::vector<double> d = old.d;
  for (std::size_t i = 0; i < d.size(); ++i)
  {
    old.d[i] = 0.1 * static_cast<double>(i);
    old.v[i] = std::sin(static_cast<double>(i));
    d[i] = old.d[i] + 0.01 * std::cos(static_cast<double>(i));
  }
  const solid::State state = solver.finish({1.0, 0.2, 0.6, 0.5}, old, d);
  CHECK(state.time == doctest::Approx(1.2));
  for (std::size_t i = 0; i < d.size(); ++i)
    CHECK(d[i] - old.d[i] == doctest::Approx(0.2 * (0.6 * state.v[i] + 0.4 * old.v[i])));
}

TEST_CASE("the midpoint rule keeps the energy of a bar that swings a little, backward Euler loses it")
{
  // Longitudinal standing wave sin(pi x / 2) with c = sqrt(E / rho) = 2.
  const double amplitude = 1e-4;
  const auto after_a_period = [&](double theta)
  {
    Bar bar(3);
    solid::Solver solver = bar.solver();
    solid::State state = solver.initial();
    for (std::size_t i = 0; i < state.d.size(); i += 2)
      state.d[i] = amplitude * std::sin(0.5 * std::numbers::pi * bar.sample.x[i]);
    std::vector<double> d = state.d;
    const double step = 2.0 / 40.0;  // a period is 4 L / c = 2
    for (int n = 0; n < 40; ++n)
    {
      const fem::TimeStep time{n * step, step, theta, theta};
      REQUIRE(solver.advance(time, state, bar.zero(), d).status == linalg::NewtonStatus::converged);
      state = solver.finish(time, state, d);
    }
    double tip = 0.0;
    double tip_velocity = 0.0;
    for (std::size_t i = 0; i < d.size(); i += 2)
      if (bar.sample.x[i] == 1.0)
      {
        tip = state.d[i];
        tip_velocity = state.v[i];
      }
    return std::hypot(tip, tip_velocity / std::numbers::pi) / amplitude;
  };
  CHECK(after_a_period(0.5) == doctest::Approx(1.0).epsilon(0.005));
  CHECK(after_a_period(1.0) < 0.7);
}

TEST_CASE("a solver that has solved nothing yet gives the same next displacement bit for bit")
{
  Bar bar(2);
  const std::array<std::string_view, 1> time_only = {"t"};
  bar.parameters.boundaries[1].condition =
      solid::Traction{{0.0, Expression("0.1*sin(3*t)", {}, time_only), 0.0}};
  solid::Solver solver = bar.solver();
  solid::State state = solver.initial();
  std::vector<double> d = state.d;
  for (int n = 0; n < 4; ++n)
  {
    const fem::TimeStep time{0.1 * n, 0.1, 0.55, 0.5};
    REQUIRE(solver.advance(time, state, bar.zero(), d).status == linalg::NewtonStatus::converged);
    state = solver.finish(time, state, d);
  }
  solid::Solver other = bar.solver();
  std::vector<double> again = d;
  const fem::TimeStep time{0.4, 0.1, 0.55, 0.5};
  REQUIRE(solver.advance(time, state, bar.zero(), d).status == linalg::NewtonStatus::converged);
  REQUIRE(other.advance(time, state, bar.zero(), again).status == linalg::NewtonStatus::converged);
  CHECK(d == again);
}
