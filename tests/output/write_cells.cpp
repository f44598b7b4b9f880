// Writes curved meshes of every shape and order for test_cells.py: NAME-ORDER.vtu, NAME-ORDER.msh (text for
// odd orders) and in integrals.txt, one line each: name, order, measure of the mesh, integral of the field
// "product" and measure of each boundary.

#include "../unit/output/sample_cells.hpp"
#include "element/quadrature.hpp"
#include "element/table.hpp"
#include "output/mesh_file.hpp"
#include "output/msh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

using namespace blockfsi;

namespace
{

using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct TabulatedRule
{
  element::CellRule rule;
  element::CellTable table;
};

const TabulatedRule& rule_of(element::Shape shape, int order)
{
  static std::map<std::pair<element::Shape, int>, TabulatedRule> rules;
  TabulatedRule& of = rules[{shape, order}];
  if (of.rule.points.empty())
  {
    of.rule = element::quadrature(shape, 4 * order + (element::dimension(shape) == 3 ? 2 : 8));
    of.table = element::tabulate(shape, order, of.rule.points, 1);
  }
  return of;
}

/// Integral of a nodal function over a cell or side with these nodes, by a rule that is exact for cells and
/// converged for sides.
double integrate(element::Shape shape, int order, int dim, std::span<const double> x,
                 std::span<const std::int32_t> nodes, std::span<const double> values)
{
  const auto& [rule, table] = rule_of(shape, order);
  double sum = 0.0;
  for (int q = 0; q < table.point_count; ++q)
  {
    std::array<Vector, 3> tangent{};
    double value = 0.0;
    for (std::size_t k = 0; k < nodes.size(); ++k)
    {
      const std::size_t at = q * nodes.size() + k;
      value += values.empty() ? 0.0 : table.value[at] * values[nodes[k]];
      for (int t = 0; t < element::dimension(shape); ++t)
        for (int d = 0; d < dim; ++d)
          tangent[t][d] += table.first[t][at] * x[std::size_t(nodes[k]) * dim + d];
    }
    const Vector normal = cross(tangent[0], tangent[1]);
    const double measure = element::dimension(shape) == 3   ? dot(normal, tangent[2])
                           : element::dimension(shape) == 2 ? std::sqrt(dot(normal, normal))
                                                            : std::sqrt(dot(tangent[0], tangent[0]));
    sum += rule.weights[q] * measure * (values.empty() ? 1.0 : value);
  }
  return sum;
}

void write(const std::filesystem::path& folder, const std::string& name, CellSample sample,
           std::ostream& list)
{
  mesh::Mesh& mesh = sample.mesh;
  mesh.block_names = {"first", "second block"};
  mesh.boundaries.erase("none");
  auto renamed = mesh.boundaries.extract("outlet & \"more\"");
  renamed.key() = "outlet & more";
  mesh.boundaries.insert(std::move(renamed));
  std::vector<double> product;
  for (std::size_t node = 0; node < mesh.node_count(); ++node)
    product.push_back(sample.x[node * mesh.dim] * sample.x[node * mesh.dim + 1]);
  const std::vector<output::Field> fields = {{"product", 1, product}, {"position", mesh.dim, sample.x}};
  const std::string stem = fmt::format("{}-{}", name, mesh.order);
  output::write_mesh(folder / (stem + ".vtu"), mesh, sample.x, fields);
  const std::vector<output::CellField> cell_fields = {
      {"block", std::span<const std::int32_t>(mesh.cell_block)}};
  output::write_msh(folder / (stem + ".msh"), mesh, sample.x, fields, cell_fields,
                    mesh.order % 2 == 0 ? output::MshEncoding::binary : output::MshEncoding::text);
  double measure = 0.0;
  double integral = 0.0;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
  {
    measure += integrate(mesh.shape(c), mesh.order, mesh.dim, sample.x, mesh.cell(c), {});
    integral += integrate(mesh.shape(c), mesh.order, mesh.dim, sample.x, mesh.cell(c), product);
  }
  list << fmt::format("{};{};{};{};{}", name, mesh.order, mesh.dim, measure, integral);
  for (const auto& [boundary, sides] : mesh.boundaries)
  {
    double size = 0.0;
    for (const mesh::Side& side : sides)
    {
      const element::Shape shape = mesh.shape(side.cell);
      std::vector<std::int32_t> nodes;
      for (const std::int32_t at : element::side_lattice(shape, mesh.order, side.side))
        nodes.push_back(mesh.cell(side.cell)[at]);
      size += integrate(element::sides(shape)[side.side].shape, mesh.order, mesh.dim, sample.x, nodes, {});
    }
    list << fmt::format(";{};{}", boundary, size);
  }
  list << '\n';
}

}  // namespace

int main(int argc, char** argv)
{
  if (argc != 2)
    return 2;
  const std::filesystem::path folder = argv[1];
  std::ofstream list(folder / "integrals.txt");
  using element::Shape;
  for (int order = 1; order <= element::largest_order; ++order)
  {
    for (const Shape shape : {Shape::triangle, Shape::quadrilateral, Shape::tetrahedron, Shape::hexahedron,
                              Shape::prism, Shape::pyramid})
      write(folder, std::string(element::name(shape)), sample_of(shape, order), list);
    write(folder, "mixed2d", mixed_sample(2, order), list);
    write(folder, "mixed3d", mixed_sample(3, order), list);
  }
}
