// What passes between fluid and solid in a coupled step: force and work, and the volume of the fluid.

#include "support.hpp"
#include "whole_case.hpp"

#include <cmath>
#include <numeric>

using namespace blockfsi;

namespace
{

using Field = std::vector<double>;

double dot(std::span<const double> a, std::span<const double> b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

double norm(std::span<const double> a)
{
  return std::sqrt(dot(a, a));
}

Field difference(std::span<const double> a, std::span<const double> b)
{
  Field result(a.begin(), a.end());
  for (std::size_t i = 0; i < b.size(); ++i)
    result[i] -= b[i];
  return result;
}

Field copy(std::span<const double> values)
{
  return {values.begin(), values.end()};
}

/// The integral of n . u over a boundary, n being the outward normal.
double flux(const mesh::Mesh& mesh, std::span<const double> x, std::span<const double> u,
            std::string_view boundary)
{
  const element::Rule rule = element::gauss(mesh.order + 2);
  const element::Table table = element::lagrange(element::lobatto(mesh.order), rule.points);
  double sum = 0.0;
  for (const mesh::Side& side : mesh.boundaries.find(boundary)->second)
    for (int q = 0; q < table.point_count; ++q)
    {
      verification::Vector tangent{}, velocity{};
      for (int k = 0; k <= mesh.order; ++k)
      {
        const auto node =
            static_cast<std::size_t>(mesh.cell(side.cell)[mesh::side_node(mesh.order, side.side, k)]);
        for (std::size_t c = 0; c < 2; ++c)
        {
          tangent[c] += table.first[q * table.node_count + k] * x[2 * node + c];
          velocity[c] += table.value[q * table.node_count + k] * u[2 * node + c];
        }
      }
      // Nodes are counted along xi or eta: against the way round the cell on its third and fourth side.
      sum += (side.side < 2 ? 1.0 : -1.0) * rule.weights[q] *
             (velocity[0] * tangent[1] - velocity[1] * tangent[0]);
    }
  return sum;
}

/// The area that the boundaries enclose: half of the flux of x.
double area(const mesh::Mesh& mesh, std::span<const double> x)
{
  double sum = 0.0;
  for (const auto& [name, sides] : mesh.boundaries)
    sum += 0.5 * flux(mesh, x, x, name);
  return sum;
}

/// What flows in through all boundaries but the interface. Through slip walls, too: where they meet a
/// prescribed velocity their last node has that.
double inflow(const mesh::Mesh& mesh, std::span<const double> x, std::span<const double> u)
{
  double sum = 0.0;
  for (const auto& [name, sides] : mesh.boundaries)
    if (name != "interface")
      sum -= flux(mesh, x, u, name);
  return sum;
}

/// A flap that a strong flow bends in a few long steps.
run::Simulation flap(std::vector<std::string> settings)
{
  for (const char* setting :
       {"blocks.lattice.channel.divide.x=[2, 2, 4, 4]", "blocks.lattice.channel.divide.y=[2, 2, 1, 2, 2]",
        "time.step=0.02", "time.end=0.2", "time.start_up=0", "let.U=5", "fluid.newton.tolerance=1e-11"})
    settings.emplace_back(setting);
  return run::Simulation(verification::whole_case("wall-ramm-flap", settings));
}

const std::vector<std::vector<std::string>> variants = {
    {"blocks.order=2"},
    {"blocks.order=3"},
    {"blocks.order=2", "time.scheme='backward-euler'"},
    {"blocks.order=2", "solid.order=3"},
    {"blocks.order=3", "solid.order=2", "solid.divide=2"},
    {"blocks.order=2", "solid.divide=0.5"},
    {"blocks.order=2", "solid.divide=1.5", "time.scheme='backward-euler'"}};

std::string text(const std::vector<std::string>& settings)
{
  return std::accumulate(settings.begin(), settings.end(), std::string(),
                         [](const std::string& all, const std::string& one) { return all + one + " "; });
}

/// Over a run, the greatest growth of the fluid's volume in a step, and the greatest difference of that from
/// what flowed in [m^2].
struct Balance
{
  double growth = 0.0;
  double error = 0.0;
};

/// `inlet`: a boundary; also finds the greatest flow through it in a step. The velocity of a step is that at
/// t + theta step.
Balance balance(run::Simulation& simulation, double theta, std::string_view inlet, double& throughput)
{
  const run::FluidSide& fluid = *simulation.fluid();
  const mesh::Mesh& mesh = fluid.mesh();
  const double step = simulation.description().time.step;
  Field x = copy(fluid.x()), u = fluid.state().u;
  Balance result;
  throughput = 0.0;
  verification::finish(simulation,
                       [&]
                       {
                         const Field now = copy(fluid.x());
                         const Field velocity = verification::between(u, fluid.state().u, theta);
                         // In two dimensions the area grows exactly by the flux of the mesh velocity in the
                         // middle of the step.
                         const Field middle = verification::between(x, now, 0.5);
                         const double growth = area(mesh, now) - area(mesh, x);
                         result.growth = std::max(result.growth, std::abs(growth));
                         result.error =
                             std::max(result.error, std::abs(growth - step * inflow(mesh, middle, velocity)));
                         throughput =
                             std::max(throughput, step * std::abs(flux(mesh, middle, velocity, inlet)));
                         x = now;
                         u = fluid.state().u;
                       });
  return result;
}

constexpr double default_theta = 0.5 + 1.0 / 80.0;

}  // namespace

TEST_CASE("force and work of the fluid on the interface are those that the solid gets, in every step")
{
  for (const auto& settings : variants)
  {
    CAPTURE(text(settings));
    run::Simulation simulation = flap(settings);
    const run::FluidSide& fluid = *simulation.fluid();
    const run::SolidSide& solid = *simulation.solid();
    Field x = copy(fluid.x()), d = copy(simulation.interface_displacement());
    Field fluid_force(2 * fluid.interface().count()), solid_force(2 * solid.interface().count());
    double greatest_work = 0.0;
    verification::finish(simulation,
                         [&]
                         {
                           fluid.interface().gather(fluid.reaction(), 3, fluid_force);
                           solid.interface().gather(solid.load(), 2, solid_force);
                           for (std::size_t c = 0; c < 2; ++c)
                           {
                             double sum = 0.0;
                             for (std::size_t i = c; i < fluid_force.size(); i += 2)
                               sum += fluid_force[i];
                             for (std::size_t i = c; i < solid_force.size(); i += 2)
                               sum += solid_force[i];
                             CHECK(std::abs(sum) < 1e-13 * norm(fluid_force));
                           }
                           Field moved(fluid_force.size());
                           fluid.interface().gather(difference(fluid.x(), x), 2, moved);
                           const Field step = difference(simulation.interface_displacement(), d);
                           // The displacement of the fluid's nodes in a step is a difference of their places.
                           Field places(moved.size());
                           fluid.interface().gather(fluid.x(), 2, places);
                           const double scale = norm(fluid_force) * norm(moved);
                           const double rounding = norm(fluid_force) * 1e-16 * norm(places);
                           CHECK(std::abs(dot(fluid_force, moved) + dot(solid_force, step)) <
                                 1e-13 * scale + rounding);
                           greatest_work = std::max(greatest_work, std::abs(dot(solid_force, step)) / scale);
                           x = copy(fluid.x());
                           d = copy(simulation.interface_displacement());
                         });
    CHECK(greatest_work > 1e-3);
  }
}

TEST_CASE("what flows into the fluid is what its volume grows by, in every step")
{
  for (const auto& settings : variants)
  {
    CAPTURE(text(settings));
    run::Simulation simulation = flap(settings);
    const bool implicit = simulation.description().time.scheme == fem::Scheme::backward_euler;
    double throughput = 0.0;
    const Balance found = balance(simulation, implicit ? 1.0 : default_theta, "inlet", throughput);
    MESSAGE(text(settings) << ": greatest growth in a step " << found.growth / throughput
                           << " of the throughput, error " << found.error / throughput);
    CHECK(found.error < 1e-12 * throughput);
  }
}

TEST_CASE("what a piston displaces is what leaves the fluid, in every step")
{
  for (const bool implicit : {false, true})
  {
    run::Simulation simulation(verification::whole_case(
        "piston-nonlinear", {"time.start_up=0", "time.ringing_decay=0", "time.step=0.01", "time.end=0.5",
                             "fluid.newton.tolerance=1e-11",
                             implicit ? "time.scheme='backward-euler'" : "time.scheme='crank-nicolson'"}));
    double throughput = 0.0;
    const Balance found = balance(simulation, implicit ? 1.0 : default_theta, "outlet", throughput);
    MESSAGE("greatest growth in a step " << found.growth << " m^2, error " << found.error);
    CHECK(found.growth > 1e-3);
    CHECK(found.growth == doctest::Approx(throughput));
    CHECK(found.error < 1e-13);
  }
}
