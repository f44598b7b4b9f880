// Oscillating shear of a fluid layer on an elastic layer (ver_fsi_shear_layers of the reference data).

#include "support.hpp"
#include "whole_case.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>

using namespace blockfsi;

namespace
{

using Complex = std::complex<double>;
constexpr Complex i(0.0, 1.0);

// The data of the case, for a velocity of 0.01 m/s at the top.
constexpr double omega = 2.0;
constexpr double viscosity = 0.1;
constexpr double amplitude = 2.490382008256359e-4;
constexpr double wave = 2.0;  // omega sqrt(density / G)

double exact_displacement(double y, double t)
{
  return amplitude * std::sin(wave * y) * std::sin(omega * t);
}

double exact_velocity(double y, double t)
{
  const Complex A = -i * amplitude;
  const Complex k = std::sqrt(i * omega / viscosity);
  const Complex B = wave * A * std::cos(wave) / (viscosity * k);
  const Complex C = i * omega * A * std::sin(wave);
  return std::real((B * std::sinh(k * (y - 1.0)) + C * std::cosh(k * (y - 1.0))) * std::exp(i * omega * t));
}

struct Layers
{
  int order = 3;
  int cells = 4;  ///< across each layer
  int steps = 20;
  double end = 0.5;         ///< [s]
  double amplitude = 1.0;   ///< relative to the case
  double tolerance = 1e-6;  ///< of the coupling
  std::vector<std::string> more = {};
};

std::unique_ptr<run::Simulation> finished(const Layers& layers)
{
  std::vector<std::string> settings = layers.more;
  for (const std::string& setting :
       {fmt::format("blocks.order={}", layers.order),
        fmt::format("blocks.lattice.layers.divide.y=[{0}, {0}]", layers.cells),
        fmt::format("time.step={}", layers.end / layers.steps), fmt::format("time.end={}", layers.end),
        fmt::format("let.a={}", layers.amplitude * amplitude),
        fmt::format("coupling.tolerance={}", layers.tolerance), std::string("fluid.newton.tolerance=1e-11")})
    settings.push_back(setting);
  auto simulation = std::make_unique<run::Simulation>(verification::whole_case("shear-layers", settings));
  verification::finish(*simulation);
  return simulation;
}

/// L2 norms of the differences of u and d to given functions.
struct Errors
{
  double u = 0.0;
  double d = 0.0;
};

template <typename Velocity, typename Displacement>
Errors errors(const run::Simulation& simulation, Velocity velocity, Displacement displacement)
{
  const run::FluidSide& fluid = *simulation.fluid();
  const run::SolidSide& solid = *simulation.solid();
  const std::vector<double> x(fluid.x().begin(), fluid.x().end());
  const std::vector<double> X(solid.X().begin(), solid.X().end());
  return {verification::error(fluid.mesh(), x, fluid.state().u, 2, velocity),
          verification::error(solid.mesh(), X, solid.state().d, 2, displacement)};
}

/// L2 norms along the line x = middle of the differences of two runs.
Errors along_the_middle(const run::Simulation& one, const run::Simulation& other, double middle)
{
  const element::Rule rule = element::gauss(6);
  constexpr int pieces = 24;
  Errors squares;
  for (int piece = 0; piece < pieces; ++piece)
    for (std::size_t q = 0; q < rule.points.size(); ++q)
    {
      const double y = (piece + rule.points[q]) / pieces, weight = rule.weights[q] / pieces;
      const auto d = [&](const run::Simulation& of) {
        return verification::at(of.solid()->mesh(), of.solid()->X(), of.solid()->state().d, {middle, y})[0];
      };
      const auto u = [&](const run::Simulation& of)
      {
        return verification::at(of.fluid()->mesh(), of.fluid()->x(), of.fluid()->state().u,
                                {middle, 1.0 + y})[0];
      };
      squares.d += weight * std::pow(d(one) - d(other), 2);
      squares.u += weight * std::pow(u(one) - u(other), 2);
    }
  return {std::sqrt(squares.u), std::sqrt(squares.d)};
}

}  // namespace

TEST_CASE("oscillating layers of fluid and solid are of second order in time")
{
  // Small against the exact solution, which is that of a linear solid, are the normal stresses of St. Venant
  // and Kirchhoff: they grow with the square of the amplitude.
  const auto of_steps = [](int steps)
  {
    const Layers layers{.order = 6, .cells = 2, .steps = steps, .end = 1.0, .amplitude = 0.1};
    const double t = layers.end;
    const auto exact = [&](auto function)
    {
      return [=, &layers](double, double y) {
        return verification::Vector{layers.amplitude * function(y, t), 0.0};
      };
    };
    return errors(*finished(layers), exact(exact_velocity), exact(exact_displacement));
  };
  const Errors coarse = of_steps(20), fine = of_steps(40);
  MESSAGE("errors of u " << coarse.u << " " << fine.u << ", order " << std::log2(coarse.u / fine.u)
                         << "; of d " << coarse.d << " " << fine.d << ", order "
                         << std::log2(coarse.d / fine.d));
  CHECK(std::abs(std::log2(coarse.u / fine.u) - 2.0) < 0.15);
  CHECK(std::abs(std::log2(coarse.d / fine.d) - 2.0) < 0.15);
}

TEST_CASE("coupled layers of fluid and solid are of order p + 1 in space")
{
  // Compared with order 8 in as many steps, so that the error in time drops out, along the middle of long
  // layers: at their open sides the stabilisation of the pressure disturbs a flow that does not end there.
  // Ringing is damped: the start in time leaves layers at the interface, thin and of an amplitude of 1e-7 of
  // the velocity, that cells of order 4 which are large for all else do not resolve.
  const auto of_order = [](int order, int cells)
  {
    return finished(
        {.order = order,
         .cells = cells,
         .tolerance = 1e-8,
         .more = {"let.L=12", "time.ringing_decay=0.025", "blocks.lattice.layers.divide.x=[12]"}});
  };
  const auto best = of_order(8, 4);
  for (int order = 1; order <= 4; ++order)
  {
    const int cells = std::array{8, 8, 6, 6}[order - 1];
    const Errors coarse = along_the_middle(*of_order(order, cells), *best, 6.0);
    const Errors fine = along_the_middle(*of_order(order, 2 * cells), *best, 6.0);
    MESSAGE("order " << order << ": errors of u " << coarse.u << " " << fine.u << ", rate "
                     << std::log2(coarse.u / fine.u) << "; of d " << coarse.d << " " << fine.d << ", rate "
                     << std::log2(coarse.d / fine.d));
    CHECK(std::log2(coarse.u / fine.u) > order + 1 - 0.15);
    CHECK(std::log2(coarse.d / fine.d) > order + 1 - 0.15);
  }
}
