#include "run/gathered.hpp"

#include "linalg/communicator.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

namespace blockfsi::run
{

namespace
{

/// Values of a nodal field cell by cell, shape (cell_count, nodes, components).
std::vector<double> by_cell(const mesh::Mesh& mesh, std::span<const double> field, int components)
{
  std::vector<double> result;
  result.reserve(mesh.cells.size() * components);
  for (const std::int32_t node : mesh.cells)
    for (int c = 0; c < components; ++c)
      result.push_back(field[static_cast<std::size_t>(node) * components + c]);
  return result;
}

}  // namespace

std::vector<double> gather_values(std::span<const double> mine)
{
  const std::vector<std::size_t> counts =
      linalg::gather(std::span<const std::size_t>(std::array{mine.size()}));
  const std::size_t most = *std::max_element(counts.begin(), counts.end());
  if (most == 0)
    return {};
  std::vector<double> padded(mine.begin(), mine.end());
  padded.resize(most, 0.0);
  const std::vector<double> all = linalg::gather(std::span<const double>(padded));
  std::vector<double> result;
  for (std::size_t rank = 0; rank < counts.size(); ++rank)
  {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(rank * most);
    result.insert(result.end(), first, first + static_cast<std::ptrdiff_t>(counts[rank]));
  }
  return result;
}

Gathered gather(const mesh::Mesh& mesh, std::span<const double> x, std::span<const double> field,
                int components)
{
  Gathered result;
  result.x = gather_values(by_cell(mesh, x, 2));
  result.field = gather_values(by_cell(mesh, field, components));
  const std::size_t node_count = result.x.size() / 2;
  const std::size_t cell_count = node_count / mesh.nodes_per_cell();
  result.mesh.order = mesh.order;
  result.mesh.cells.resize(node_count);
  std::iota(result.mesh.cells.begin(), result.mesh.cells.end(), 0);
  result.mesh.runs = {{element::Shape::quadrilateral, 0, static_cast<std::int32_t>(cell_count), 0}};
  result.mesh.cell_block.assign(cell_count, 0);
  result.mesh.local_node_count = node_count;
  return result;
}

}  // namespace blockfsi::run
