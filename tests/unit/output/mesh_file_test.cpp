#include "output/mesh_file.hpp"

#include "core/error.hpp"
#include "output/file.hpp"
#include "output/msh.hpp"
#include "output/vtu.hpp"
#include "sample_cells.hpp"
#include "temporary.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

using namespace blockfsi;
using element::Shape;

namespace
{

constexpr std::array shapes = {Shape::triangle,   Shape::quadrilateral, Shape::tetrahedron,
                               Shape::hexahedron, Shape::prism,         Shape::pyramid};

/// x^p and (x y, y, z) at the nodes, and a number per cell.
struct SampleFields
{
  explicit SampleFields(const CellSample& sample)
  {
    const int dim = sample.mesh.dim;
    for (std::size_t node = 0; node < sample.mesh.node_count(); ++node)
    {
      const double* x = &sample.x[node * dim];
      power.push_back(std::pow(x[0], sample.mesh.order));
      vector.insert(vector.end(), {x[0] * x[1], x[1], x[dim - 1]});
    }
    for (std::size_t c = 0; c < sample.mesh.cell_count(); ++c)
      number.push_back(0.5 * static_cast<double>(c));
    fields = {{"power", 1, power}, {"vector", 3, vector}};
    cell_fields = {{"block", std::span<const std::int32_t>(sample.mesh.cell_block)},
                   {"number", std::span<const double>(number)}};
  }

  std::vector<double> power;
  std::vector<double> vector;
  std::vector<double> number;
  std::vector<output::Field> fields;
  std::vector<output::CellField> cell_fields;
};

double difference(std::span<const double> a, std::span<const double> b)
{
  REQUIRE(a.size() == b.size());
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
    largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

/// Largest difference of a nodal field between the same nodes of the same cells of two meshes.
double difference_by_cell(const mesh::Mesh& a, std::span<const double> x, const mesh::Mesh& b,
                          std::span<const double> y, int components)
{
  REQUIRE(a.cells.size() == b.cells.size());
  double largest = 0.0;
  for (std::size_t k = 0; k < a.cells.size(); ++k)
    for (int d = 0; d < components; ++d)
      largest = std::max(largest, std::abs(x[std::size_t(a.cells[k]) * components + d] -
                                           y[std::size_t(b.cells[k]) * components + d]));
  return largest;
}

/// What any format keeps.
void check_same(const CellSample& sample, const SampleFields& fields, const output::ReadMesh& read)
{
  CHECK(read.mesh.dim == sample.mesh.dim);
  CHECK(read.mesh.order == sample.mesh.order);
  CHECK(read.mesh.node_count() == sample.mesh.node_count());
  CHECK(read.x.size() == sample.x.size());
  CHECK(read.mesh.total_cell_count == static_cast<std::int64_t>(sample.mesh.cell_count()));
  REQUIRE(read.mesh.runs == sample.mesh.runs);
  CHECK(read.mesh.cell_block == sample.mesh.cell_block);
  CHECK(read.mesh.block_names == sample.mesh.block_names);
  CHECK(read.mesh.block_regions == sample.mesh.block_regions);
  CHECK(difference_by_cell(sample.mesh, sample.x, read.mesh, read.x, sample.mesh.dim) < 1e-12);
  REQUIRE(read.fields.size() == 2);
  CHECK(read.fields[0].name == "power");
  const double scale = std::pow(4.0, sample.mesh.order);
  CHECK(difference_by_cell(sample.mesh, fields.power, read.mesh, read.fields[0].values, 1) < 1e-12 * scale);
  CHECK(difference_by_cell(sample.mesh, fields.vector, read.mesh, read.fields[1].values, 3) < 2e-11);
  REQUIRE(read.cell_fields.size() == 1);
  CHECK(difference(fields.number, read.cell_fields[0].values) == 0.0);
}

void check_boundaries(const mesh::Mesh& expected, const mesh::Mesh& read)
{
  REQUIRE(read.boundaries.size() == expected.boundaries.size());
  for (const auto& [name, sides] : expected.boundaries)
    CHECK(read.boundaries.at(name) == sides);
}

}  // namespace

TEST_CASE("a VTU file gives back mesh, boundaries and fields in every shape and order")
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.vtu";
  for (int order = 1; order <= element::largest_order; ++order)
    for (const Shape shape : shapes)
    {
      CAPTURE(order);
      CAPTURE(element::name(shape));
      const CellSample sample = sample_of(shape, order);
      const SampleFields fields(sample);
      output::write_mesh(path, sample.mesh, sample.x, fields.fields, fields.cell_fields);
      const output::ReadMesh read = output::read_mesh(path);
      check_same(sample, fields, read);
      check_boundaries(sample.mesh, read.mesh);
      if (shape != Shape::pyramid || order < 3)
        CHECK(read.mesh.cells == sample.mesh.cells);
    }
}

TEST_CASE("a VTU file gives back mixed meshes")
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.vtu";
  for (const int dim : {2, 3})
    for (const int order : {1, 2, 3, 4, 7})
    {
      CAPTURE(dim);
      CAPTURE(order);
      const CellSample sample = mixed_sample(dim, order);
      const SampleFields fields(sample);
      output::write_mesh(path, sample.mesh, sample.x, fields.fields, fields.cell_fields);
      const output::ReadMesh read = output::read_mesh(path);
      check_same(sample, fields, read);
      check_boundaries(sample.mesh, read.mesh);
    }
}

namespace
{

/// Names of .msh files have no quotes.
CellSample without_quotes(CellSample sample)
{
  const auto clean = [](std::string name)
  {
    std::erase(name, '"');
    return name;
  };
  for (std::string& name : sample.mesh.block_names)
    name = clean(name);
  auto boundaries = std::exchange(sample.mesh.boundaries, {});
  for (const auto& [name, sides] : boundaries)
    sample.mesh.boundaries[clean(name)] = sides;
  return sample;
}

/// Sides of boundaries may come in another order: entities belong to blocks.
void check_boundary_sets(const mesh::Mesh& expected, const mesh::Mesh& read)
{
  REQUIRE(read.boundaries.size() == expected.boundaries.size());
  const auto before = [](const mesh::Side& a, const mesh::Side& b)
  { return std::pair(a.cell, a.side) < std::pair(b.cell, b.side); };
  for (const auto& [name, sides] : expected.boundaries)
  {
    std::vector<mesh::Side> a = sides;
    std::vector<mesh::Side> b = read.boundaries.at(name);
    std::sort(a.begin(), a.end(), before);
    std::sort(b.begin(), b.end(), before);
    CHECK(a == b);
  }
}

}  // namespace

TEST_CASE("a Gmsh file gives back mesh, boundaries and fields in every shape and order")
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.msh";
  for (int order = 1; order <= element::largest_order; ++order)
    for (const Shape shape : shapes)
      for (const auto encoding : {output::MshEncoding::binary, output::MshEncoding::text})
      {
        CAPTURE(order);
        CAPTURE(element::name(shape));
        const CellSample sample = without_quotes(sample_of(shape, order));
        const SampleFields fields(sample);
        output::write_msh(path, sample.mesh, sample.x, fields.fields, std::span(fields.cell_fields).last(1),
                          encoding);
        const output::ReadMesh read = output::read_mesh(path);
        check_same(sample, fields, read);
        check_boundary_sets(sample.mesh, read.mesh);
        CHECK(read.mesh.cells == sample.mesh.cells);
        if (order <= 2)
          CHECK(read.x == sample.x);
      }
}

TEST_CASE("a Gmsh file gives back mixed meshes")
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.msh";
  for (const int dim : {2, 3})
    for (const int order : {1, 2, 3, 5})
    {
      const CellSample sample = without_quotes(mixed_sample(dim, order));
      output::write_mesh(path, sample.mesh, sample.x);
      const output::ReadMesh read = output::read_mesh(path);
      CHECK(read.mesh.runs == sample.mesh.runs);
      CHECK(read.mesh.cells == sample.mesh.cells);
      CHECK(read.mesh.cell_block == sample.mesh.cell_block);
      CHECK(difference(read.x, sample.x) < 1e-12);
      check_boundary_sets(sample.mesh, read.mesh);
    }
}
