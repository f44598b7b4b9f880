// Cells much thinner than the height of their curved edges, where nodes on chords would fold them.

#include "../../../benchmarks/domain.hpp"

#include "mesh/convert.hpp"
#include "mesh/validity.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

using namespace blockfsi;

namespace
{

mesh::Validity certify(const mesh::Mesh& mesh, std::span<const double> x)
{
  return mesh::certify(mesh::ValidityTables(mesh), mesh, x);
}

mesh::Validity validity(const block::Layout& layout)
{
  const benchmarks::Domain domain(layout);
  return certify(domain.mesh(), domain.x);
}

mesh::Validity validity(const block::Layout& layout, mesh::Target target)
{
  const benchmarks::Domain domain(layout);
  const mesh::Converted cut = mesh::convert(domain.mesh(), domain.x, {target, 0, {}});
  return certify(cut.mesh, cut.x);
}

}  // namespace

TEST_CASE("quadrilaterals around a hole are proved valid at a size ratio of 10000")
{
  for (const int order : {2, 4})
  {
    const mesh::Validity found =
        validity(benchmarks::square_with_hole(order, 22, benchmarks::size_ratio(22, 1e4)));
    CHECK(found.all_valid());
    CHECK(found.valid == 1936);
  }
}

TEST_CASE("hexahedra of a tube are proved valid at a size ratio of 1000")
{
  for (const int order : {2, 4})
    for (const int cells : {10, 22})
    {
      const mesh::Validity found =
          validity(benchmarks::quarter_tube(order, cells, benchmarks::size_ratio(cells, 1e3)));
      CHECK(found.all_valid());
      CHECK(found.valid == cells * cells * cells);
    }
}

TEST_CASE("triangles around a hole are proved valid at a size ratio of 1000")
{
  for (const int order : {2, 4})
  {
    const mesh::Validity found = validity(
        benchmarks::square_with_hole(order, 16, benchmarks::size_ratio(16, 1e3)), mesh::Target::triangles);
    CHECK(found.all_valid());
    CHECK(found.valid == 2048);
  }
}

TEST_CASE("tetrahedra of a tube are proved valid at a size ratio of 20")
{
  for (const int order : {2, 4})
  {
    const mesh::Validity found = validity(benchmarks::quarter_tube(order, 6, benchmarks::size_ratio(6, 20.0)),
                                          mesh::Target::tetrahedra);
    CHECK(found.all_valid());
    CHECK(found.valid == 1296);
  }
}

TEST_CASE("the square folds where inner nodes of the first layer lie on chords")
{
  benchmarks::Domain domain(benchmarks::square_with_hole(2, 22, benchmarks::size_ratio(22, 1e4)));
  const mesh::Mesh& mesh = domain.mesh();
  const auto at = [&](int cell, int node)
  { return domain.x.data() + std::ptrdiff_t{2} * mesh.cell(cell)[node]; };
  std::vector<int> first_layer;
  for (int cell = 0; cell < static_cast<int>(mesh.cell_count()); ++cell)
    if (std::abs(std::hypot(at(cell, 0)[0], at(cell, 0)[1]) - 0.5) < 1e-12)
    {
      for (int d = 0; d < 2; ++d)
        at(cell, 5)[d] = 0.5 * (at(cell, 2)[d] + at(cell, 8)[d]);
      first_layer.push_back(cell);
    }
  CHECK(first_layer.size() == 88);
  std::vector<mesh::Verdict> verdicts(mesh.cell_count());
  CHECK_FALSE(mesh::certify(mesh::ValidityTables(mesh), mesh, domain.x, verdicts).all_valid());
  for (const int cell : first_layer)
    CHECK(verdicts[cell] == mesh::Verdict::invalid);
}
