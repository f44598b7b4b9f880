#include "fem/cell_loop.hpp"

#include "../mesh/structured.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace blockfsi;

namespace
{

/// Curved cells that elements of order 2 and more hold exactly; 11 cells are a batch and a part of one.
std::array<double, 2> bent(double x, double y)
{
  return {x + 0.2 * y * (1.0 - y) + 0.1 * x * y, y - 0.15 * x * x + 0.1 * x * y};
}

/// Integral of det J of `bent` over the unit square: (1 + 0.1 y)(1 + 0.1 x) - (0.2 - 0.4 y + 0.1 x)(0.1 y -
/// 0.3 x).
constexpr double bent_area =
    1.05 * 1.05 - (0.2 * (0.05 - 0.15) - 0.4 * (0.1 / 3.0 - 0.3 / 4.0) + 0.1 * (0.1 / 4.0 - 0.3 / 3.0));

/// A test function's factor of one: the area.
struct One
{
  static constexpr int unknowns = 1;
  static constexpr int curved = 0;
  static constexpr int data = 0;

  template <class S>
  void operator()(const fem::PointInput<S, 1, 0, 0>&, fem::PointOutput<S, 1>& out) const
  {
    out.value[0] = S(lanes(1.0));
    out.gradient[0] = {S(lanes(0.0)), S(lanes(0.0))};
  }
};

/// Square of the errors in gradient and second derivatives of u = 1 + x - 2 y + 3 x^2 - x y + 0.5 y^2,
/// whose first derivatives are given as data.
struct DerivativeErrors
{
  static constexpr int unknowns = 1;
  static constexpr int curved = 1;
  static constexpr int data = 2;

  template <class S>
  void operator()(const fem::PointInput<S, 1, 1, 2>& in, fem::PointOutput<S, 1>& out) const
  {
    const S errors[5] = {in.gradient[0][0] - in.data[0], in.gradient[0][1] - in.data[1],
                         in.second[0][0] - lanes(6.0), in.second[0][1] - lanes(-1.0),
                         in.second[0][2] - lanes(1.0)};
    out.value[0] = S(lanes(0.0));
    for (const S& error : errors)
      out.value[0] = out.value[0] + error * error;
    out.gradient[0] = {S(lanes(0.0)), S(lanes(0.0))};
  }
};

/// Two coupled unknowns, nonlinear in values, gradients and second derivatives.
struct Tangled
{
  static constexpr int unknowns = 2;
  static constexpr int curved = 1;
  static constexpr int data = 1;

  template <class S>
  void operator()(const fem::PointInput<S, 2, 1, 1>& in, fem::PointOutput<S, 2>& out) const
  {
    out.value[0] = in.value[0] * in.value[1] + in.second[0][0] * in.second[0][1];
    out.value[1] = in.gradient[1][0] * in.value[0] * in.data[0];
    out.gradient[0] = {in.second[0][2] * in.value[1], in.gradient[0][1] * in.gradient[1][0]};
    out.gradient[1] = {sqrt(in.value[0] * in.value[0] + in.metric[0]),
                       in.value[1] / (in.value[1] * in.value[1] + in.data[0])};
  }
};

double total(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

TEST_CASE("the residual of one sums up to the area of curved cells")
{
  for (int order = 2; order <= 8; ++order)
  {
    const SampleMesh sample = structured(order, 11, 1, bent, true);
    fem::CellLoop loop(sample.mesh, order + 2);
    std::vector<double> residual(sample.mesh.node_count(), 0.0);
    const std::vector<double> unknown(residual.size(), 0.0);
    loop.add_residual(One{}, sample.x, unknown, {}, residual);
    CHECK(total(residual) == doctest::Approx(bent_area).epsilon(1e-13));
  }
}

TEST_CASE("first and second derivatives of a quadratic function are exact on curved cells of order 4")
{
  const SampleMesh sample = structured(4, 3, 3, bent, true);
  fem::CellLoop loop(sample.mesh, 6);
  std::vector<double> u(sample.mesh.node_count());
  std::vector<double> gradient(2 * u.size());
  for (std::size_t i = 0; i < u.size(); ++i)
  {
    const double x = sample.x[2 * i];
    const double y = sample.x[2 * i + 1];
    u[i] = 1.0 + x - 2.0 * y + 3.0 * x * x - x * y + 0.5 * y * y;
    gradient[2 * i] = 1.0 + 6.0 * x - y;
    gradient[2 * i + 1] = -2.0 - x + y;
  }
  std::vector<double> residual(u.size(), 0.0);
  const std::array<fem::NodalField, 1> data = {{{gradient.data(), 2}}};
  loop.add_residual(DerivativeErrors{}, sample.x, u, data, residual);
  CHECK(total(residual) < 1e-20);
}

TEST_CASE("the tangent of curved cells is the derivative of the residual")
{
  for (int order = 1; order <= 4; ++order)
  {
    const SampleMesh sample = structured(order, 3, 3, bent, true);
    const mesh::Mesh& mesh = sample.mesh;
    fem::CellLoop loop(mesh, order + 2);
    const std::size_t size = 2 * mesh.node_count();
    std::vector<double> z(size);
    std::vector<double> direction(size);
    std::vector<double> data(mesh.node_count(), 1.5);
    for (std::size_t i = 0; i < size; ++i)
    {
      z[i] = 1.0 + 0.2 * std::sin(0.7 * static_cast<double>(i));
      direction[i] = std::cos(1.3 * static_cast<double>(i));
    }
    const std::array<fem::NodalField, 1> fields = {{{data.data(), 1}}};
    const auto residual = [&](double change)
    {
      std::vector<double> moved = z;
      for (std::size_t i = 0; i < size; ++i)
        moved[i] += change * direction[i];
      std::vector<double> result(size, 0.0);
      loop.add_residual(Tangled{}, sample.x, moved, fields, result);
      return result;
    };
    const std::size_t n = 2 * static_cast<std::size_t>(mesh.nodes_per_cell());
    std::vector<double> matrices(mesh.cell_count() * n * n);
    loop.tangent(Tangled{}, sample.x, z, fields, matrices);
    std::vector<double> product(size, 0.0);
    for (std::size_t c = 0; c < mesh.cell_count(); ++c)
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          product[2 * mesh.cell(c)[i / 2] + i % 2] +=
              matrices[(c * n + i) * n + j] * direction[2 * mesh.cell(c)[j / 2] + j % 2];
    const double h = 1e-3;
    const auto a = residual(h);
    const auto b = residual(-h);
    const auto c = residual(2.0 * h);
    const auto d = residual(-2.0 * h);
    double error = 0.0;
    double norm = 0.0;
    for (std::size_t i = 0; i < size; ++i)
    {
      error = std::max(error, std::abs(product[i] - (8.0 * (a[i] - b[i]) - (c[i] - d[i])) / (12.0 * h)));
      norm = std::max(norm, std::abs(product[i]));
    }
    CHECK(error < 1e-9 * norm);
  }
}
