// Plane channel flow: forces on the sides as nodal reactions, open boundaries, and no ringing after a sudden
// start.

#include "support.hpp"

#include "fem/boundary.hpp"
#include "fluid/solver.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace blockfsi;
using verification::formula;

namespace
{

constexpr double viscosity = 0.05;
constexpr double length = 2.0;
constexpr double outlet_pressure = 3.0;

/// The flow u = 4 y (1 - y), p = outlet_pressure + 8 viscosity (length - x): its stress on a surface with
/// normal n.
verification::Vector exact_stress(const std::array<double, 2>& x, const std::array<double, 2>& n)
{
  const double pressure = outlet_pressure + 8.0 * viscosity * (length - x[0]);
  const double shear = viscosity * 4.0 * (1.0 - 2.0 * x[1]);
  return {-pressure * n[0] + shear * n[1], shear * n[0] - pressure * n[1]};
}

struct ExactStress
{
  static constexpr int unknowns = 3;
  static constexpr int data = 0;

  std::array<double, 3> operator()(const fem::SideInput<double, 3, 0>& in) const
  {
    const verification::Vector stress = exact_stress(in.x, in.normal);
    return {stress[0], stress[1], 0.0};
  }
};

fluid::Parameters channel(const fluid::Condition& outlet)
{
  fluid::Parameters result;
  result.density = 2.0;
  result.viscosity = viscosity;
  result.boundaries = {{"left", fluid::Velocity{{formula("4*y*(1 - y)"), 0.0, 0.0}}, {}},
                       {"bottom", fluid::Wall{}, {}},
                       {"top", fluid::Wall{}, {}},
                       {"right", outlet, {}}};
  result.newton.tolerance = 1e-12;
  return result;
}

/// Largest errors of a steady channel flow.
struct Errors
{
  double velocity = 0.0;
  double pressure = 0.0;
  double force = 0.0;  ///< of the reaction at a node of the walls and of the inlet
};

Errors channel_errors(int order, const fluid::Condition& outlet)
{
  const verification::Domain domain =
      verification::rectangle({0.0, 0.0}, {length, 1.0}, order > 4 ? 1 : 2, order, 0.0, "fluid");
  const mesh::Mesh& mesh = domain.mesh();
  Timings timings;
  fluid::Solver solver(channel(outlet), mesh, domain.numbering, domain.x, timings);
  const fluid::State start = solver.initial();
  const std::vector<double> w(2 * mesh.node_count(), 0.0);
  std::vector<double> z(3 * mesh.node_count(), 0.0);
  REQUIRE(solver.solve({}, start, {domain.x, w}, z).status == linalg::NewtonStatus::converged);

  std::vector<double> expected(z.size(), 0.0);
  fem::SideLoop sides(mesh, order + 2);
  for (const char* name : {"left", "bottom", "top"})
    sides.add_residual(ExactStress{}, mesh.boundaries.find(name)->second, domain.x, z, {}, expected);
  const std::vector<double> reaction = solver.reaction({}, start, {domain.x, w}, z);

  Errors result;
  for (std::size_t i = 0; i < mesh.node_count(); ++i)
  {
    const double x = domain.x[2 * i];
    const double y = domain.x[2 * i + 1];
    const double p = outlet_pressure + 8.0 * viscosity * (length - x);
    result.velocity =
        std::max({result.velocity, std::abs(z[3 * i] - 4.0 * y * (1.0 - y)), std::abs(z[3 * i + 1])});
    result.pressure = std::max(result.pressure, std::abs(z[3 * i + 2] - p));
    for (std::size_t c = 0; c < 2; ++c)
      result.force = std::max(result.force, std::abs(reaction[3 * i + c] - expected[3 * i + c]));
  }
  return result;
}

void check_exact(const Errors& errors)
{
  MESSAGE("errors: velocity " << errors.velocity << ", pressure " << errors.pressure << ", force "
                              << errors.force);
  CHECK(errors.velocity < 1e-11);
  CHECK(errors.pressure < 1e-11);
  CHECK(errors.force < 1e-11);
}

/// Force of a suddenly started channel flow on its walls along x over the steps of a theta scheme; the first
/// `start_up` steps are two backward Euler half steps each.
std::vector<double> starting_force(int steps, double step, double theta, int start_up)
{
  const verification::Domain domain = verification::rectangle({0.0, 0.0}, {length, 1.0}, 2, 4, 0.0, "fluid");
  const mesh::Mesh& mesh = domain.mesh();
  fluid::Parameters parameters = channel(fluid::Outflow{0.0});
  parameters.newton.tolerance = 1e-10;
  Timings timings;
  fluid::Solver solver(parameters, mesh, domain.numbering, domain.x, timings);
  fluid::State state = solver.initial();
  const std::vector<double> w(2 * mesh.node_count(), 0.0);
  std::vector<double> z(3 * mesh.node_count(), 0.0);
  const auto wall = fem::nodes_on(mesh, domain.numbering, "bottom");
  std::vector<double> force;
  const auto advance = [&](const fem::TimeStep& time)
  {
    solver.guess(time, state, z);
    REQUIRE(solver.solve(time, state, {domain.x, w}, z).status == linalg::NewtonStatus::converged);
    const std::vector<double> reaction = solver.reaction(time, state, {domain.x, w}, z);
    state = solver.finish(time, state, z);
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.node_count(); ++i)
      if (wall[i] != 0)
        sum -= reaction[3 * i];
    return sum;
  };
  for (int n = 0; n < steps; ++n)
    if (n < start_up)
    {
      advance({n * step, 0.5 * step, 1.0, 1.0});
      force.push_back(advance({(n + 0.5) * step, 0.5 * step, 1.0, 1.0}));
    }
    else
      force.push_back(advance({n * step, step, theta, 0.5}));
  return force;
}

/// Largest |f[n] - 2 f[n - 1] + f[n - 2]| over some steps: four times the amplitude of an alternation.
double alternation(const std::vector<double>& force, std::size_t first, std::size_t last)
{
  double largest = 0.0;
  for (std::size_t n = first; n < last; ++n)
    largest = std::max(largest, std::abs(force[n] - 2.0 * force[n - 1] + force[n - 2]));
  return largest;
}

}  // namespace

TEST_CASE("a developed channel flow and the forces on its walls are exact with a do-nothing outflow")
{
  for (const int order : {2, 3, 4, 8})
    check_exact(channel_errors(order, fluid::Outflow{outlet_pressure}));
}

TEST_CASE("a developed channel flow and the forces on its walls are exact with its traction at the outlet")
{
  const Constants constants = {{"p", outlet_pressure}, {"mu", viscosity}};
  for (const int order : {2, 3, 4, 8})
    check_exact(channel_errors(
        order, fluid::Traction{{formula("-p", constants), formula("4*mu*(1 - 2*y)", constants), 0.0}}));
}

TEST_CASE("the force after a sudden start does not ring with start-up steps and damping")
{
  const double step = 0.2;
  const double decay = 5.0 * step;
  const std::vector<double> damped = starting_force(200, step, 0.5 + step / (4.0 * decay), 2);
  const std::vector<double> plain = starting_force(200, step, 0.5, 0);
  const double force = std::abs(damped.back());
  MESSAGE("force " << damped.back() << ", alternation after 5, 20, 190 steps: " << alternation(damped, 5, 10)
                   << " " << alternation(damped, 20, 25) << " " << alternation(damped, 190, 200)
                   << ", of the plain midpoint rule " << alternation(plain, 5, 10) << " "
                   << alternation(plain, 20, 25) << " " << alternation(plain, 190, 200));
  CHECK(alternation(damped, 20, 25) < 1e-5 * force);
  CHECK(alternation(damped, 190, 200) < 1e-9 * force);
  // What the measure is there to see.
  CHECK(alternation(plain, 190, 200) > 1e-4 * force);
}
