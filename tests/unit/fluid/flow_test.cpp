#include "fluid/flow.hpp"

#include "../mesh/structured.hpp"
#include "derivative.hpp"
#include "fem/cell_loop.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <span>

using namespace blockfsi;

namespace
{

std::array<double, 2> bent(double x, double y)
{
  return {x + 0.2 * y * (1.0 - y) + 0.1 * x * y, y - 0.15 * x * x + 0.1 * x * y};
}

std::vector<double> waves(std::size_t count, double mean, double amplitude, double number)
{
  std::vector<double> result(count);
  for (std::size_t i = 0; i < count; ++i)
    result[i] = mean + amplitude * std::sin(number * static_cast<double>(i));
  return result;
}

fluid::Flow flow(int order, double step)
{
  return {.density = 1.3,
          .viscosity = 0.07,
          .rate = step > 0.0 ? 2.0 / step : 0.0,
          .step_frequency = step > 0.0 ? 2.0 / step : 0.0,
          .order = order,
          .inverse_constant = fluid::inverse_constant(order)};
}

/// The sides of one row of cells along the bottom and top of a structured mesh.
std::vector<mesh::Side> bottom_and_top(std::int32_t columns, std::int32_t rows)
{
  std::vector<mesh::Side> sides;
  for (std::int32_t i = 0; i < columns; ++i)
  {
    sides.push_back({i, 0});
    sides.push_back({i + columns * (rows - 1), 2});
  }
  return sides;
}

}  // namespace

TEST_CASE("the tangent of the flow is the derivative of its residual on curved moving cells")
{
  for (int order = 1; order <= 4; ++order)
    for (const double step : {0.0, 0.05})
    {
      const SampleMesh sample = structured(order, 3, 3, bent, true);
      const std::size_t count = sample.mesh.node_count();
      fem::CellLoop loop(sample.mesh, order + 2);
      const std::vector<double> z = waves(3 * count, 1.0, 0.3, 0.7);
      const std::vector<double> direction = waves(3 * count, 0.0, 1.0, 1.9);
      const std::vector<double> old = waves(2 * count, 0.9, 0.2, 1.1);
      const std::vector<double> w = waves(2 * count, 0.2, 0.4, 0.5);
      const std::vector<double> force = waves(2 * count, 0.3, 0.1, 0.3);
      const std::array<fem::NodalField, 3> data = {{{old.data(), 2}, {w.data(), 2}, {force.data(), 2}}};
      const std::size_t n = 3 * static_cast<std::size_t>(sample.mesh.nodes_per_cell());
      std::vector<double> matrices(sample.mesh.cell_count() * n * n);
      loop.tangent(flow(order, step), sample.x, z, data, matrices);
      const auto residual = [&](const std::vector<double>& at)
      {
        std::vector<double> result(at.size(), 0.0);
        loop.add_residual(flow(order, step), sample.x, at, data, result);
        return result;
      };
      CHECK(derivative_error(apply(sample.mesh, 3, matrices, direction), direction, z, residual) < 1e-8);
    }
}

TEST_CASE("the tangent of an open boundary is the derivative of its residual, with outflow and backflow")
{
  const SampleMesh sample = structured(3, 3, 2, bent);
  const std::size_t count = sample.mesh.node_count();
  fem::SideLoop loop(sample.mesh, 5);
  const std::vector<mesh::Side> sides = bottom_and_top(3, 2);
  const std::vector<double> direction = waves(3 * count, 0.0, 1.0, 1.9);
  const std::vector<double> w = waves(2 * count, 0.1, 0.1, 0.5);
  const std::array<fem::NodalField, 1> data = {{{w.data(), 2}}};
  const auto nothing = [](const std::array<double, 2>& x, const std::array<double, 2>& normal) {
    return std::array<double, 2>{x[0] * normal[0], 2.0 + x[1]};
  };
  for (const double sign : {1.0, -1.0})  // upwards: in below, out above
    for (const bool do_nothing : {false, true})
    {
      const fluid::OpenBoundary open{
          .density = 1.3, .viscosity = 0.07, .backflow = 0.8, .do_nothing = do_nothing, .traction = nothing};
      const std::vector<double> z = waves(3 * count, 2.0 * sign, 0.3, 0.7);
      const std::size_t n = 3 * static_cast<std::size_t>(sample.mesh.nodes_per_cell());
      std::vector<double> matrices(sample.mesh.cell_count() * n * n, 0.0);
      loop.add_tangent(open, sides, sample.x, z, data, matrices);
      const auto residual = [&](const std::vector<double>& at)
      {
        std::vector<double> result(at.size(), 0.0);
        loop.add_residual(open, sides, sample.x, at, data, result);
        return result;
      };
      CHECK(derivative_error(apply(sample.mesh, 3, matrices, direction), direction, z, residual) < 1e-10);
    }
}

TEST_CASE("backflow is resisted with the kinetic energy that it brings, outflow is not")
{
  const SampleMesh sample = structured(2, 1, 1, [](double x, double y) { return std::array{x, y}; });
  const std::size_t count = sample.mesh.node_count();
  fem::SideLoop loop(sample.mesh, 4);
  const std::array<mesh::Side, 1> top = {{{0, 2}}};
  std::vector<double> w(2 * count, 0.0);
  const std::array<fem::NodalField, 1> data = {{{w.data(), 2}}};
  const fluid::OpenBoundary open{.density = 2.0,
                                 .viscosity = 0.0,
                                 .backflow = 0.5,
                                 .do_nothing = false,
                                 .traction = [](const auto&, const auto&) {
                                   return std::array{0.0, 0.0};
                                 }};
  for (const double v : {3.0, -3.0})
  {
    std::vector<double> z(3 * count, 0.0);
    for (std::size_t i = 0; i < count; ++i)
      z[3 * i + 1] = v;
    std::vector<double> residual(z.size(), 0.0);
    loop.add_residual(open, top, sample.x, z, data, residual);
    double power = 0.0;
    for (std::size_t i = 0; i < count; ++i)
      power += residual[3 * i + 1] * v;
    // rho / 2 |u . n| |u|^2 on a side of length 1.
    CHECK(power == doctest::Approx(v < 0.0 ? 27.0 : 0.0));
  }
}

TEST_CASE(
    "the momentum residuals of all nodes add up to the change of momentum and the transport through cells")
{
  const SampleMesh sample = structured(4, 3, 3, bent, true);
  const std::size_t count = sample.mesh.node_count();
  fem::CellLoop loop(sample.mesh, 8);
  // u = (x, 2 y), at rest before, w = (1, 0), f = (0, -3): rho (rate u + (u - w) . grad u - f) integrated.
  std::vector<double> z(3 * count);
  std::vector<double> old(2 * count, 0.0);
  std::vector<double> w(2 * count);
  std::vector<double> force(2 * count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = sample.x[2 * i];
    const double y = sample.x[2 * i + 1];
    z[3 * i] = x;
    z[3 * i + 1] = 2.0 * y;
    z[3 * i + 2] = x * y;
    w[2 * i] = 1.0;
    force[2 * i + 1] = -3.0;
  }
  const std::array<fem::NodalField, 3> data = {{{old.data(), 2}, {w.data(), 2}, {force.data(), 2}}};
  std::vector<double> residual(z.size(), 0.0);
  const fluid::Flow physics = flow(4, 0.1);
  loop.add_residual(physics, sample.x, z, data, residual);
  std::array<double, 3> sums{};
  for (std::size_t i = 0; i < residual.size(); ++i)
    sums[i % 3] += residual[i];

  // Moments of the bent square by quadrature.
  std::array<double, 3> moments{};  // of 1, x, y
  const element::Rule rule = element::gauss(6);
  for (std::size_t q = 0; q < rule.points.size(); ++q)
    for (std::size_t r = 0; r < rule.points.size(); ++r)
    {
      const double a = rule.points[q];
      const double b = rule.points[r];
      const double det = (1.0 + 0.1 * b) * (1.0 + 0.1 * a) - (0.2 - 0.4 * b + 0.1 * a) * (0.1 * b - 0.3 * a);
      const double weight = rule.weights[q] * rule.weights[r] * det;
      moments[0] += weight;
      moments[1] += weight * bent(a, b)[0];
      moments[2] += weight * bent(a, b)[1];
    }
  CHECK(sums[0] == doctest::Approx(1.3 * (20.0 * moments[1] + moments[1] - moments[0])));
  CHECK(sums[1] == doctest::Approx(1.3 * (40.0 * moments[2] + 4.0 * moments[2] + 3.0 * moments[0])));
  CHECK(sums[2] == doctest::Approx(3.0 * moments[0]));
}

TEST_CASE("a linear shear flow with its pressure leaves no residual inside curved cells")
{
  const SampleMesh sample = structured(3, 3, 3, bent, true);
  const std::size_t count = sample.mesh.node_count();
  fem::CellLoop loop(sample.mesh, 5);
  // u = (y, 0) moves no momentum; the body force 5 along x is balanced by the pressure 5 rho x.
  std::vector<double> z(3 * count, 0.0);
  std::vector<double> old(2 * count, 0.0);
  std::vector<double> force(2 * count, 0.0);
  for (std::size_t i = 0; i < count; ++i)
  {
    z[3 * i] = old[2 * i] = sample.x[2 * i + 1];
    z[3 * i + 2] = 1.3 * 5.0 * sample.x[2 * i];
    force[2 * i] = 5.0;
  }
  const std::vector<double> w(2 * count, 0.0);
  const std::array<fem::NodalField, 3> data = {{{old.data(), 2}, {w.data(), 2}, {force.data(), 2}}};
  std::vector<double> residual(z.size(), 0.0);
  loop.add_residual(flow(3, 0.1), sample.x, z, data, residual);
  const int width = 10;
  for (int j = 1; j < width - 1; ++j)
    for (int i = 1; i < width - 1; ++i)
      for (int c = 0; c < 3; ++c)
        CHECK(std::abs(residual[3 * (i + j * width) + c]) < 1e-12);
}
