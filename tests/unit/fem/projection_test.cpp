#include "fem/projection.hpp"

#include "../mesh/structured.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace blockfsi;

namespace
{

using Values = std::vector<double>;
using Formula = std::function<Values(double x, double y)>;

/// Straight cells that are no parallelograms: each has all polynomials of its order.
std::array<double, 2> skew(double a, double b)
{
  return {a + 0.3 * a * b, b - 0.2 * a * b};
}

std::array<double, 2> curved(double a, double b)
{
  return {a + 0.2 * b * (1.0 - b) + 0.1 * a * b, b - 0.15 * a * a + 0.1 * a * b};
}

/// Names the four sides of the square that `structured` made.
SampleMesh with_boundary(SampleMesh sample, int columns, int rows, bool turned)
{
  std::vector<mesh::Side>& sides = sample.mesh.boundaries["all"];
  for (std::int32_t cell = 0; cell < columns * rows; ++cell)
  {
    // The cell's own axes are turned by so many quarters: its side 0 is then another one of the square's.
    const int quarters = turned ? cell % 4 : 0;
    const std::array<bool, 4> outer = {cell < columns, cell % columns == columns - 1,
                                       cell >= columns * (rows - 1), cell % columns == 0};
    for (int side = 0; side < 4; ++side)
      if (outer[(side + quarters) % 4])
        sides.push_back({cell, side});
  }
  return sample;
}

/// A mesh and the projection onto it.
struct Target
{
  Target(int order, int cells, const std::function<std::array<double, 2>(double, double)>& map,
         bool turned = false, int more_points = 4)
      : sample(with_boundary(structured(order, cells, cells, map, turned), cells, cells, turned)),
        numbering(sample.mesh.lattice, sample.mesh.owner),
        projection(sample.mesh, numbering, sample.x, sample.mesh.order + more_points)
  {
  }
  Target(const Target&) = delete;

  std::size_t node_count() const { return sample.mesh.node_count(); }

  Values at_points(const Formula& formula) const
  {
    const Values& x = projection.quadrature().x;
    Values result;
    for (std::size_t i = 0; i < x.size(); i += 2)
      for (const double value : formula(x[i], x[i + 1]))
        result.push_back(value);
    return result;
  }

  Values scalars(const Formula& formula, int components)
  {
    Values nodal(node_count() * components, NAN);
    REQUIRE(projection.scalars(at_points(formula), components, nodal) == linalg::Status::ok);
    return nodal;
  }

  /// The velocity of a formula, whose boundary values are given.
  Values velocity(const Formula& formula)
  {
    const auto at = [&](const std::array<double, 2>& x)
    {
      const Values u = formula(x[0], x[1]);
      return std::array{u[0], u[1]};
    };
    Values u(2 * node_count(), 0.0);
    for (std::size_t i = 0; i < u.size(); ++i)
      if (fixed()[3 * (i / 2) + i % 2] != 0)
        u[i] = at({sample.x[i - i % 2], sample.x[i - i % 2 + 1]})[i % 2];
    REQUIRE(projection.velocity(at_points(formula), at, fixed(), u) == linalg::Status::ok);
    return u;
  }

  /// The velocity is prescribed at three sides of the square; the right one is open.
  std::vector<std::uint8_t> fixed() const
  {
    std::vector<std::uint8_t> result(3 * node_count(), 0);
    const std::int64_t width = std::lround(std::sqrt(static_cast<double>(node_count())));
    for (std::size_t node = 0; node < node_count(); ++node)
    {
      const std::int64_t i = sample.mesh.lattice[node] % width;
      const std::int64_t j = sample.mesh.lattice[node] / width;
      if (i == 0 || j == 0 || j == width - 1)
        result[3 * node] = result[3 * node + 1] = 1;
    }
    return result;
  }

  /// Integral over the mesh of a value at each point.
  double integral(const std::function<double(std::size_t point)>& value) const
  {
    double sum = 0.0;
    for (std::size_t q = 0; q < projection.quadrature().weight.size(); ++q)
      sum += projection.quadrature().weight[q] * value(q);
    return sum;
  }

  /// L2 distance of a nodal field from a formula, whose further components are not looked at.
  double distance(const Values& nodal, int components, const Formula& formula)
  {
    const Values found = projection.values_at_points({nodal.data(), components});
    const Values& x = projection.quadrature().x;
    return std::sqrt(integral(
        [&](std::size_t q)
        {
          const Values wanted = formula(x[2 * q], x[2 * q + 1]);
          double square = 0.0;
          for (int c = 0; c < components; ++c)
            square += std::pow(found[3 * (q * components + c)] - wanted[c], 2);
          return square;
        }));
  }

  double outflow(const Values& u)
  {
    const Values values = projection.values_at_points({u.data(), 2});
    return integral([&](std::size_t q) { return values[6 * q + 1] + values[6 * q + 5]; });
  }

  SampleMesh sample;
  linalg::Numbering numbering;
  fem::Projection projection;
};

double largest_difference(const Target& target, const Values& nodal, int components, const Formula& formula)
{
  double result = 0.0;
  for (std::size_t node = 0; node < target.node_count(); ++node)
  {
    const Values wanted = formula(target.sample.x[2 * node], target.sample.x[2 * node + 1]);
    for (int c = 0; c < components; ++c)
      result = std::max(result, std::abs(nodal[components * node + c] - wanted[c]));
  }
  return result;
}

/// A velocity of polynomials of an order that has a divergence.
Formula polynomial_flow(int order)
{
  return [order](double x, double y) -> Values {
    return {1.0 + std::pow(x - 2.0 * y, order), std::pow(0.5 * x + y, order) - x};
  };
}

/// A smooth flow without divergence, of so many waves.
Formula whirl(double n)
{
  return [n](double x, double y) -> Values
  {
    return {3.0 * std::sin(2.0 * n * x) * std::cos(3.0 * n * y),
            -2.0 * std::cos(2.0 * n * x) * std::sin(3.0 * n * y)};
  };
}

/// Orders of convergence of an error in the number of cells.
double order_of(const std::function<double(int cells)>& error, int cells)
{
  return std::log2(error(cells) / error(2 * cells));
}

}  // namespace

TEST_CASE("polynomials of the mesh's order are projected exactly, and linear ones on curved cells")
{
  for (const int order : {1, 2, 3, 4, 6})
    for (const bool is_curved : {false, true})
    {
      Target target(order, 3, is_curved && order > 1 ? curved : skew, true);
      const int degree = is_curved ? 1 : order;
      const Formula flow = polynomial_flow(degree);
      CAPTURE(order);
      CAPTURE(is_curved);
      CHECK(largest_difference(target, target.scalars(flow, 2), 2, flow) < 1e-12);
      CHECK(largest_difference(target, target.velocity(flow), 2, flow) < 1e-12);
    }
}

TEST_CASE("what is prescribed at the boundary stays bit for bit")
{
  Target target(2, 3, curved);
  const Formula flow = whirl(1.0);
  const Values u = target.velocity(flow);
  const std::vector<std::uint8_t> fixed = target.fixed();
  for (std::size_t i = 0; i < u.size(); ++i)
    if (fixed[3 * (i / 2) + i % 2] != 0)
      CHECK(u[i] == flow(target.sample.x[i - i % 2], target.sample.x[i - i % 2 + 1])[i % 2]);
}

TEST_CASE("the error of a smooth function falls with the order of the mesh plus one")
{
  const Formula flow = whirl(1.0);
  for (const int order : {1, 2, 3, 4})
  {
    CAPTURE(order);
    const auto scalar = [&](int cells)
    {
      Target target(order, cells, order > 1 ? curved : skew);
      return target.distance(target.scalars(flow, 2), 2, flow);
    };
    const auto velocity = [&](int cells)
    {
      Target target(order, cells, order > 1 ? curved : skew);
      return target.distance(target.velocity(flow), 2, flow);
    };
    const int cells = order > 2 ? 6 : 10;
    CHECK(order_of(scalar, cells) > order + 0.85);
    CHECK(order_of(scalar, cells) < order + 1.3);
    CHECK(order_of(velocity, cells) > order + 0.85);
    CHECK(order_of(velocity, cells) < order + 1.5);
  }
}

TEST_CASE("the integral of a projected field is that of the field, however rough")
{
  Target target(3, 4, curved);
  const Formula rough = [](double x, double y) -> Values {
    return {std::abs(x - 0.4), x * x + y > 0.6 ? 1.0 : 0.0};
  };
  const Values given = target.at_points(rough);
  const Values found = target.projection.values_at_points({target.scalars(rough, 2).data(), 2});
  for (std::size_t c = 0; c < 2; ++c)
    CHECK(target.integral([&](std::size_t q) { return found[3 * (2 * q + c)]; }) ==
          doctest::Approx(target.integral([&](std::size_t q) { return given[2 * q + c]; })).epsilon(1e-13));
}

TEST_CASE("a projected velocity lets out what the given one does, which a plain projection does not")
{
  Target target(2, 3, curved);
  const Formula flow = whirl(3.0);
  CHECK(std::abs(target.outflow(target.velocity(flow))) < 1e-8);
  CHECK(std::abs(target.outflow(target.scalars(flow, 2))) > 1e-2);
}
