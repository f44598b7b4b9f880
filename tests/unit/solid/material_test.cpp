#include "solid/material.hpp"

#include "../fluid/derivative.hpp"
#include "../mesh/structured.hpp"
#include "fem/cell_loop.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace blockfsi;

namespace
{

constexpr double young = 1.4;
constexpr double poisson = 0.4;

std::array<double, 2> bent(double x, double y)
{
  return {x + 0.2 * y * (1.0 - y) + 0.1 * x * y, y - 0.15 * x * x + 0.1 * x * y};
}

std::vector<double> waves(std::size_t count, double amplitude, double number)
{
  std::vector<double> result(count);
  for (std::size_t i = 0; i < count; ++i)
    result[i] = amplitude * std::sin(number * static_cast<double>(i));
  return result;
}

/// Residual of a body under a displacement.
std::vector<double> residual_of(fem::CellLoop& loop, const solid::Body& body, const std::vector<double>& X,
                                const std::vector<double>& d)
{
  const std::vector<double> zero(d.size(), 0.0);
  const std::array<fem::NodalField, 2> data = {{{zero.data(), 2}, {zero.data(), 2}}};
  std::vector<double> result(d.size(), 0.0);
  loop.add_residual(body, X, d, data, result);
  return result;
}

}  // namespace

TEST_CASE("Lame's constants obey their definitions, and plane stress has no stress across the plane")
{
  const solid::Lame strain = solid::lame(young, poisson, solid::Plane::strain);
  CHECK(strain.lambda == doctest::Approx(2.0));
  CHECK(strain.mu == doctest::Approx(0.5));
  const solid::Lame stress = solid::lame(young, poisson, solid::Plane::stress);
  CHECK(stress.mu == strain.mu);
  // E_33 = -lambda / (lambda + 2 mu) (E_11 + E_22) makes S_33 = 0.
  const double across = -strain.lambda / (strain.lambda + 2.0 * strain.mu);
  CHECK(stress.lambda == doctest::Approx(strain.lambda * (1.0 + across)));
  // Uniaxial: sigma_11 = E eps_11.
  const double lateral = -stress.lambda / (stress.lambda + 2.0 * stress.mu);
  CHECK(stress.lambda * (1.0 + lateral) + 2.0 * stress.mu == doctest::Approx(young));
}

TEST_CASE("the tangent of a body is the derivative of its residual, and is symmetric")
{
  for (const solid::Plane plane : {solid::Plane::strain, solid::Plane::stress})
    for (int order = 1; order <= 4; ++order)
      for (const double inertia : {0.0, 300.0})
      {
        const SampleMesh sample = structured(order, 3, 3, bent, true);
        const std::size_t size = 2 * sample.mesh.node_count();
        fem::CellLoop loop(sample.mesh, order + 2);
        const solid::Body body{solid::lame(young, poisson, plane), inertia, 1.5, inertia > 0.0 ? 0.55 : 1.0};
        const std::vector<double> d = waves(size, 0.05, 0.7);
        const std::vector<double> direction = waves(size, 0.1, 1.9);
        const std::vector<double> origin = waves(size, 0.1, 0.3);
        const std::vector<double> force = waves(size, 1.0, 0.2);
        const std::array<fem::NodalField, 2> data = {{{origin.data(), 2}, {force.data(), 2}}};
        const std::size_t n = 2 * static_cast<std::size_t>(sample.mesh.nodes_per_cell());
        std::vector<double> matrices(sample.mesh.cell_count() * n * n);
        loop.tangent(body, sample.x, d, data, matrices);
        const auto residual = [&](const std::vector<double>& at)
        {
          std::vector<double> result(size, 0.0);
          loop.add_residual(body, sample.x, at, data, result);
          return result;
        };
        CHECK(derivative_error(apply(sample.mesh, 2, matrices, direction), direction, d, residual) < 1e-9);
        double skew = 0.0;
        for (std::size_t c = 0; c < sample.mesh.cell_count(); ++c)
          for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < i; ++j)
              skew = std::max(skew, std::abs(matrices[(c * n + i) * n + j] - matrices[(c * n + j) * n + i]));
        CHECK(skew < 1e-12);
      }
}

TEST_CASE("a rigid motion, however large, meets no resistance")
{
  const SampleMesh sample = structured(3, 2, 2, bent, true);
  fem::CellLoop loop(sample.mesh, 5);
  const solid::Body body{solid::lame(young, poisson, solid::Plane::strain), 0.0, 0.0, 1.0};
  for (const double angle : {0.0, 0.3, 2.0, 3.1})
  {
    std::vector<double> d(sample.x.size());
    for (std::size_t i = 0; i < d.size(); i += 2)
    {
      d[i] = std::cos(angle) * sample.x[i] - std::sin(angle) * sample.x[i + 1] - sample.x[i] + 5.0;
      d[i + 1] = std::sin(angle) * sample.x[i] + std::cos(angle) * sample.x[i + 1] - sample.x[i + 1] - 7.0;
    }
    for (const double r : residual_of(loop, body, sample.x, d))
      CHECK(std::abs(r) < 1e-13);
  }
}

TEST_CASE("internal forces of any displacement have neither resultant nor moment about the deformed body")
{
  const SampleMesh sample = structured(3, 2, 2, bent, true);
  // They balance at each point, so the rule of integration need not be exact.
  fem::CellLoop loop(sample.mesh, 5);
  const solid::Body body{solid::lame(young, poisson, solid::Plane::strain), 0.0, 0.0, 1.0};
  const std::vector<double> d = waves(sample.x.size(), 0.05, 0.7);
  const std::vector<double> r = residual_of(loop, body, sample.x, d);
  std::array<double, 3> sums{};
  for (std::size_t i = 0; i < r.size(); i += 2)
  {
    sums[0] += r[i];
    sums[1] += r[i + 1];
    sums[2] += (sample.x[i] + d[i]) * r[i + 1] - (sample.x[i + 1] + d[i + 1]) * r[i];
  }
  for (const double total : sums)
    CHECK(std::abs(total) < 1e-13);
}

TEST_CASE("small strains are not lost to rounding")
{
  const SampleMesh sample = structured(1, 1, 1, [](double x, double y) { return std::array{x, y}; });
  fem::CellLoop loop(sample.mesh, 2);
  const solid::Body body{solid::lame(young, poisson, solid::Plane::strain), 0.0, 0.0, 1.0};
  const double strain = 1e-13;
  std::vector<double> d(sample.x.size(), 0.0);
  for (std::size_t i = 0; i < d.size(); i += 2)
    d[i] = strain * sample.x[i];
  // P_11 = (lambda + 2 mu) strain on two nodes of the right side.
  const std::vector<double> r = residual_of(loop, body, sample.x, d);
  CHECK(r[2] == doctest::Approx(1.5 * strain).epsilon(1e-10));
}
