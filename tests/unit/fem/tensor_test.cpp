#include "fem/tensor.hpp"

#include "element/line.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace blockfsi;

namespace
{

/// Numbers without pattern, different in each lane.
std::vector<Lanes> sample(int count, double seed)
{
  std::vector<Lanes> result(count);
  for (int i = 0; i < count; ++i)
    for (int lane = 0; lane < lane_count; ++lane)
      result[i][lane] = std::sin(seed + 1.7 * i + 0.9 * lane * lane);
  return result;
}

double difference(const Lanes& a, const Lanes& b)
{
  double largest = 0.0;
  for (int lane = 0; lane < lane_count; ++lane)
    largest = std::max(largest, std::abs(a[lane] - b[lane]));
  return largest;
}

/// sum_ij along_eta(r, j) along_xi(q, i) nodal(j, i), term by term.
Lanes dense(const fem::LineTable& table, const std::vector<double>& along_xi,
            const std::vector<double>& along_eta, const std::vector<Lanes>& nodal, int q, int r)
{
  Lanes sum{};
  for (int j = 0; j < table.nodes; ++j)
    for (int i = 0; i < table.nodes; ++i)
      sum += along_xi[q * table.nodes + i] * along_eta[r * table.nodes + j] * nodal[j * table.nodes + i];
  return sum;
}

}  // namespace

TEST_CASE("sum factorisation gives the values and all derivatives of the dense sum")
{
  for (int order = 1; order <= 8; ++order)
  {
    const fem::LineTable table = fem::make_line_table(order, order + 2);
    const int m = table.points;
    const std::vector<Lanes> nodal = sample(table.nodes * table.nodes, 0.3);
    std::vector<std::vector<Lanes>> out(6, std::vector<Lanes>(m * m));
    fem::interpolate(
        table, nodal.data(),
        {out[0].data(), out[1].data(), out[2].data(), out[3].data(), out[4].data(), out[5].data()});
    const std::vector<double>* along_xi[] = {&table.value,  &table.first, &table.value,
                                             &table.second, &table.first, &table.value};
    const std::vector<double>* along_eta[] = {&table.value, &table.value, &table.first,
                                              &table.value, &table.first, &table.second};
    double largest = 0.0;
    for (int k = 0; k < 6; ++k)
      for (int q = 0; q < m * m; ++q)
        largest = std::max(
            largest, difference(out[k][q], dense(table, *along_xi[k], *along_eta[k], nodal, q % m, q / m)));
    CHECK(largest < 1e-11);
  }
}

TEST_CASE("the first derivative along xi may be left out, the mixed one needs it")
{
  const fem::LineTable table = fem::make_line_table(3, 4);
  const std::vector<Lanes> nodal = sample(16, 1.0);
  std::vector<Lanes> alone(16);
  std::vector<Lanes> together(16);
  std::vector<Lanes> other(16);
  fem::interpolate(table, nodal.data(), {.eta = alone.data()});
  fem::interpolate(table, nodal.data(), {.value = other.data(), .xi = other.data(), .eta = together.data()});
  for (int q = 0; q < 16; ++q)
    CHECK(difference(alone[q], together[q]) == 0.0);
}

TEST_CASE("integration is the transpose of interpolation and adds to what is there")
{
  for (int order = 1; order <= 8; ++order)
  {
    const fem::LineTable table = fem::make_line_table(order, order + 2);
    const int n = table.nodes * table.nodes;
    const int m = table.points * table.points;
    const std::vector<Lanes> nodal = sample(n, 0.1);
    const std::vector<Lanes> factors[3] = {sample(m, 2.0), sample(m, 3.0), sample(m, 4.0)};
    std::vector<std::vector<Lanes>> out(3, std::vector<Lanes>(m));
    fem::interpolate(table, nodal.data(), {out[0].data(), out[1].data(), out[2].data()});
    std::vector<Lanes> residual(n, lanes(1.0));
    fem::integrate(table, factors[0].data(), factors[1].data(), factors[2].data(), residual.data());
    Lanes at_points{};
    for (int k = 0; k < 3; ++k)
      for (int q = 0; q < m; ++q)
        at_points += out[k][q] * factors[k][q];
    Lanes at_nodes{};
    for (int i = 0; i < n; ++i)
      at_nodes += nodal[i] * (residual[i] - 1.0);
    CHECK(difference(at_points, at_nodes) < 1e-10);
  }
}
