// Writes the quarter annulus 1 <= r <= 2 in each order as whole, in two pieces and as time series, for
// test_vtu.py.

#include "../unit/mesh/structured.hpp"
#include "mesh/tensor.hpp"
#include "output/series.hpp"
#include "output/vtu.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <span>
#include <string>
#include <vector>

using namespace blockfsi;

namespace
{

/// u^order is a polynomial of the full order in the cells, r and angle are linear in them.
struct NodalFields
{
  std::vector<double> radius;
  std::vector<double> power;
  std::vector<double> product;
};

NodalFields evaluate(const SampleMesh& sample)
{
  NodalFields fields;
  for (std::size_t node = 0; node < sample.mesh.node_count(); ++node)
  {
    const double x = sample.x[2 * node];
    const double y = sample.x[2 * node + 1];
    const double radius = std::hypot(x, y);
    fields.radius.push_back(radius);
    fields.power.push_back(std::pow(radius - 1.0, sample.mesh.order));
    fields.product.push_back(x * y);
  }
  return fields;
}

void write(const std::filesystem::path& path, const SampleMesh& sample)
{
  const NodalFields values = evaluate(sample);
  const std::vector<double> number(sample.mesh.cell_number.begin(), sample.mesh.cell_number.end());
  const std::vector<output::Field> fields = {{"radius", 1, values.radius},
                                             {"power", 1, values.power},
                                             {"product", 1, values.product},
                                             {"position", 2, sample.x}};
  const std::vector<output::CellField> cell_fields = {
      {"block", std::span<const std::int32_t>(sample.mesh.cell_block)},
      {"number", std::span<const double>(number)}};
  output::write_vtu(path, sample.mesh, sample.x, fields, cell_fields);
}

/// The share of one of two processes: the lower or upper rows of cells with just their nodes.
SampleMesh half(const SampleMesh& whole, int rank)
{
  SampleMesh result = whole;
  const std::size_t cells = whole.mesh.cell_count() / 2;
  const std::size_t entries = whole.mesh.cells.size() / 2;
  const auto cut = [rank](auto& values, std::size_t count) {
    values = {values.begin() + rank * count, values.begin() + (rank + 1) * count};
  };
  cut(result.mesh.cells, entries);
  cut(result.mesh.cell_block, cells);
  cut(result.mesh.cell_number, cells);
  std::vector<std::int32_t> local(whole.mesh.node_count(), -1);
  result.mesh.lattice.clear();
  result.x.clear();
  for (std::int32_t& node : result.mesh.cells)
  {
    if (local[node] < 0)
    {
      local[node] = static_cast<std::int32_t>(result.mesh.lattice.size());
      result.mesh.lattice.push_back(node);
      result.x.insert(result.x.end(), {whole.x[2 * node], whole.x[2 * node + 1]});
    }
    node = local[node];
  }
  result.mesh.runs.front().count = static_cast<std::int32_t>(cells);
  result.mesh.local_node_count = result.mesh.lattice.size();
  return result;
}

}  // namespace

int main(int argc, char** argv)
{
  if (argc != 2)
    return 2;
  const std::filesystem::path folder = argv[1];
  output::Series series(folder / "series.pvd");
  for (int order = 1; order <= mesh::max_order; ++order)
  {
    const SampleMesh sample = structured(
        order, 3, 6,
        [](double u, double v)
        {
          const double angle = 0.5 * std::numbers::pi * v;
          return std::array{(1.0 + u) * std::cos(angle), (1.0 + u) * std::sin(angle)};
        },
        true);
    const std::string name = fmt::format("order-{}.vtu", order);
    write(folder / name, sample);
    std::vector<std::string> pieces;
    for (int rank = 0; rank < 2; ++rank)
    {
      pieces.push_back(fmt::format("order-{}-rank-{}.vtu", order, rank));
      write(folder / pieces.back(), half(sample, rank));
    }
    const std::vector<output::Field> fields = {
        {"radius", 1, {}}, {"power", 1, {}}, {"product", 1, {}}, {"position", 2, {}}};
    const std::vector<output::CellField> cell_fields = {{"block", std::span<const std::int32_t>()},
                                                        {"number", std::span<const double>()}};
    output::write_pvtu(folder / fmt::format("order-{}.pvtu", order), pieces, fields, cell_fields);
    series.add(std::vector<output::Snapshot>{{0.1 * order, "annulus", name}});
  }
}
