#include "coupling/transfer.hpp"

#include <doctest/doctest.h>

#include <numeric>
#include <random>

using namespace blockfsi::coupling;
using Vector = std::vector<double>;

namespace
{

/// Seven nodes of a fluid between four of a solid, with weights of both signs that sum up to 1 in each row.
Transfer seven_of_four()
{
  std::vector<std::int32_t> row_begin = {0}, column;
  Vector weight;
  for (int i = 0; i < 7; ++i)
  {
    const double xi = i / 6.0;
    const double second = 4.0 * xi * (1.0 - xi), third = -0.3 * xi;
    const Vector row = {1.0 - xi - second - third, second, third, xi};
    for (std::int32_t k = 0; k < 4; ++k)
    {
      column.push_back(k);
      weight.push_back(row[k]);
    }
    row_begin.push_back(static_cast<std::int32_t>(column.size()));
  }
  return {row_begin, column, weight, 4};
}

Vector random(std::size_t size, unsigned seed)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  Vector result(size);
  for (double& value : result)
    value = normal(generator);
  return result;
}

double dot(const Vector& a, const Vector& b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

double resultant(const Vector& f, std::size_t component)
{
  double sum = 0.0;
  for (std::size_t i = component; i < f.size(); i += 2)
    sum += f[i];
  return sum;
}

}  // namespace

TEST_CASE("virtual work is the same on both sides of an interface for any load and displacement")
{
  const Transfer transfer = seven_of_four();
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    const Vector d = random(8, seed), f = random(14, 100 + seed);
    Vector d_fluid(14), f_solid(8);
    transfer.to_fluid(d, d_fluid);
    transfer.to_solid(f, f_solid);
    CHECK(dot(f, d_fluid) == doctest::Approx(dot(f_solid, d)).epsilon(1e-13));
  }
}

TEST_CASE("the resultant of a load and the displacement of a rigid translation pass an interface unchanged")
{
  const Transfer transfer = seven_of_four();
  const Vector f = random(14, 1);
  Vector f_solid(8), d_fluid(14);
  transfer.to_solid(f, f_solid);
  for (const std::size_t c : {0u, 1u})
    CHECK(resultant(f_solid, c) == doctest::Approx(resultant(f, c)).epsilon(1e-13));
  transfer.to_fluid(Vector{3, -1, 3, -1, 3, -1, 3, -1}, d_fluid);
  for (std::size_t i = 0; i < d_fluid.size(); ++i)
    CHECK(d_fluid[i] == doctest::Approx(i % 2 == 0 ? 3.0 : -1.0).epsilon(1e-14));
}

TEST_CASE("interfaces that share their nodes exchange values bit for bit")
{
  const Transfer transfer(5);
  CHECK(transfer.fluid_count() == 5);
  CHECK(transfer.solid_count() == 5);
  const Vector values = random(10, 3);
  Vector there(10), back(10);
  transfer.to_fluid(values, there);
  transfer.to_solid(there, back);
  CHECK(there == values);
  CHECK(back == values);
}
