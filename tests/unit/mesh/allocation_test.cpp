#include "../allocations.hpp"
#include "cells.hpp"
#include "mesh/quality.hpp"
#include "mesh/validity.hpp"

#include <doctest/doctest.h>

using namespace blockfsi;

TEST_CASE("measuring and certifying a mesh allocates nothing")
{
  for (const int order : {1, 4, 8})
  {
    SampleMesh sample = structured(order, 3, 3,
                                   [](double u, double v) {
                                     return std::array{u + 0.2 * v, v};
                                   });
    // One cell that must be subdivided, one that is turned over.
    sample.x[2 * sample.mesh.cell(1)[1] + 1] += 0.02 / order;
    sample.x[2 * sample.mesh.cell(8)[order]] -= 0.5;
    const mesh::QualityTables quality_tables(order);
    const mesh::ValidityTables validity_tables(order);
    const std::vector<double> first = mesh::sample_jacobian(quality_tables, sample.mesh, sample.x);
    std::vector<mesh::Verdict> verdicts(sample.mesh.cell_count());
    const long before = testing::allocation_count();
    const mesh::Quality quality = mesh::measure(quality_tables, sample.mesh, sample.x, first);
    const mesh::Validity validity = mesh::certify(validity_tables, sample.mesh, sample.x, verdicts);
    const long after = testing::allocation_count();
    CHECK(after == before);
    CHECK(quality.scaled_jacobian < 0.0);
    CHECK(validity.invalid > 0);
  }
}

TEST_CASE("measuring and certifying cells of every shape allocates nothing")
{
  for (const element::Shape shape : cell_shapes)
    for (const int order : {1, 3})
    {
      // A straight cell, one that must be subdivided or nearly so, and one that is turned over.
      const auto bent = [](double a) {
        return [a](const element::Point& p) -> element::Point {
          return {p[0] - a * p[0] * p[0], p[1], p[2]};
        };
      };
      const SampleMesh sample =
          separate_cells(shape, order,
                         {place_nodes(shape, order, bent(0.0)), place_nodes(shape, order, bent(0.499)),
                          place_nodes(shape, order,
                                      [](const element::Point& p) -> element::Point {
                                        return {-p[0], p[1], p[2]};
                                      })});
      const mesh::QualityTables quality_tables(sample.mesh);
      const mesh::ValidityTables validity_tables(sample.mesh);
      const std::vector<double> first = mesh::sample_jacobian(quality_tables, sample.mesh, sample.x);
      std::vector<mesh::Verdict> verdicts(3);
      std::vector<mesh::CellQuality> cells(3);
      const long before = testing::allocation_count();
      const mesh::Quality quality = mesh::measure(quality_tables, sample.mesh, sample.x, first);
      mesh::measure_cells(quality_tables, sample.mesh, sample.x, cells);
      const mesh::Validity validity = mesh::certify(validity_tables, sample.mesh, sample.x, verdicts);
      const long after = testing::allocation_count();
      CHECK(after == before);
      CHECK(quality.cell == 2);
      CHECK(cells[2].scaled_jacobian < 0.0);
      CHECK(validity.invalid == 1);
    }
}
