#include "fem/projection.hpp"
#include "run/locate.hpp"

#include "../mesh/structured.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace blockfsi;

namespace
{

double integral(const SampleMesh& of, const std::vector<double>& nodal)
{
  fem::CellLoop cells(of.mesh, fem::max_line);
  const std::vector<double> weight = cells.quadrature(of.x).weight;
  const std::vector<double> value = cells.values_at_points(of.x, {nodal.data(), 1});
  double sum = 0.0;
  for (std::size_t q = 0; q < weight.size(); ++q)
    sum += weight[q] * value[3 * q];
  return sum;
}

}  // namespace

TEST_CASE("a projection across cells that cut each other keeps integrals better than values at nodes do")
{
  for (const int order : {1, 2, 3, 4})
  {
    const SampleMesh old = structured(order, 6, 6, waves);
    const SampleMesh next = structured(order, 7, 7, [](double a, double b) { return std::array{a, b}; });
    const linalg::Numbering numbering(next.mesh.lattice, next.mesh.owner);
    fem::Projection projection(next.mesh, numbering, next.x, std::min(order + 6, fem::max_line));
    run::Finder finder(old.mesh, old.x);
    double miss = 0.0;
    double miss_of_nodes = 0.0;
    // One integral may be right by chance.
    for (double phase = 0.0; phase < 6.0; phase += 0.7)
    {
      std::vector<double> field;
      for (std::size_t i = 0; i < old.x.size(); i += 2)
        field.push_back(2.0 + std::exp(2.0 * old.x[i]) * std::sin(6.0 * old.x[i + 1] + phase));
      const auto at = [&](const std::vector<double>& points)
      {
        std::vector<double> values;
        for (std::size_t i = 0; i < points.size(); i += 2)
          values.push_back(finder.find({points[i], points[i + 1]}).value(old.mesh, field, 1, 0));
        return values;
      };
      std::vector<double> projected(next.mesh.node_count());
      REQUIRE(projection.scalars(at(projection.quadrature().x), 1, projected) == linalg::Status::ok);
      miss += std::pow(integral(next, projected) / integral(old, field) - 1.0, 2);
      miss_of_nodes += std::pow(integral(next, at(next.x)) / integral(old, field) - 1.0, 2);
    }
    CAPTURE(order);
    CHECK(std::sqrt(miss) < 0.2 * std::sqrt(miss_of_nodes));
  }
}
