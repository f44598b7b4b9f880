#include "output/draft.hpp"

#include "core/error.hpp"
#include "element/nodes.hpp"
#include "output/lattice_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace blockfsi::output
{

namespace
{

constexpr std::int32_t unused = -1;

/// Throws unless every cell has points that exist, none of them twice.
void check_cells(const Draft& draft)
{
  const auto point_count = static_cast<std::int64_t>(draft.point_count());
  std::vector<std::int64_t> seen(draft.point_count(), -1);
  std::int64_t cell = 0;
  for (const DraftCells& list : draft.cells)
  {
    const auto n = static_cast<std::size_t>(element::lattice_size(list.shape, draft.order));
    for (std::size_t c = 0; c < list.number.size(); ++c, ++cell)
      for (std::size_t k = 0; k < n; ++k)
      {
        const std::int32_t point = list.points[c * n + k];
        if (point < 0 || point >= point_count)
          throw Error(fmt::format("cell {} has the node {}, but there are {} points", list.number[c], point,
                                  point_count));
        if (seen[point] == cell)
          throw Error(fmt::format("cell {} has the node {} twice; a {} of order {} needs {} different ones",
                                  list.number[c], point, element::name(list.shape), draft.order, n));
        seen[point] = cell;
      }
  }
}

int common_dimension(const Draft& draft)
{
  if (draft.cells.empty())
    throw Error("there are no cells of two or three dimensions");
  const int dim = element::dimension(draft.cells.front().shape);
  for (const DraftCells& list : draft.cells)
    if (element::dimension(list.shape) != dim)
      throw Error(fmt::format("there are cells of {} and of {} dimensions (cell {}); a mesh has cells of one "
                              "dimension",
                              dim, element::dimension(list.shape), list.number.front()));
  if (dim < 2)
    throw Error("there are no cells of two or three dimensions");
  return dim;
}

/// Number of the node at each point, in their order.
std::vector<std::int32_t> number_nodes(const Draft& draft, std::size_t& node_count)
{
  std::vector<std::int32_t> node(draft.point_count(), unused);
  for (const DraftCells& list : draft.cells)
    for (const std::int32_t point : list.points)
      node[point] = 0;
  std::int32_t count = 0;
  for (std::int32_t& number : node)
    if (number != unused)
      number = count++;
  node_count = static_cast<std::size_t>(count);
  return node;
}

/// Values at the points that are nodes, the first `width` of `components` each.
std::vector<double> at_nodes(std::span<const double> values, std::size_t components, std::size_t width,
                             std::span<const std::int32_t> node)
{
  std::vector<double> result;
  for (std::size_t point = 0; point < node.size(); ++point)
    if (node[point] != unused)
      result.insert(result.end(), values.begin() + point * components,
                    values.begin() + point * components + width);
  return result;
}

void check_plane(const Draft& draft, std::span<const std::int32_t> node)
{
  double size = 0.0;
  for (std::size_t point = 0; point < node.size(); ++point)
    if (node[point] != unused)
      size = std::max({size, std::abs(draft.points[3 * point]), std::abs(draft.points[3 * point + 1])});
  for (std::size_t point = 0; point < node.size(); ++point)
    if (node[point] != unused && !(std::abs(draft.points[3 * point + 2]) <= 1e-9 * size))
      throw Error(fmt::format("point {} has z = {}, but cells of two dimensions must lie in the plane z = 0",
                              point, draft.points[3 * point + 2]));
}

void check_finite(const Draft& draft, std::span<const std::int32_t> node)
{
  constexpr double largest = 1e150;  // squares of it are still numbers
  for (std::size_t point = 0; point < node.size(); ++point)
    for (std::size_t d = 0; d < 3; ++d)
      if (node[point] != unused && !(std::abs(draft.points[3 * point + d]) <= largest))
        throw Error(fmt::format("point {} has the coordinate {}, which is no place in space", point,
                                draft.points[3 * point + d]));
}

void add_cells(mesh::Mesh& mesh, const DraftCells& list, std::span<const std::int32_t> node)
{
  mesh.runs.push_back({list.shape, static_cast<std::int32_t>(mesh.cell_count()),
                       static_cast<std::int32_t>(list.number.size()),
                       static_cast<std::int64_t>(mesh.cells.size())});
  for (const std::int32_t point : list.points)
    mesh.cells.push_back(node[point]);
  mesh.cell_block.insert(mesh.cell_block.end(), list.block.begin(), list.block.end());
}

/// Cell of the mesh of each cell of the file.
std::vector<std::int32_t> number_cells(const Draft& draft)
{
  std::vector<std::int32_t> cell;
  std::int32_t next = 0;
  for (const DraftCells& list : draft.cells)
    for (const std::int64_t number : list.number)
    {
      if (static_cast<std::size_t>(number) >= cell.size())
        cell.resize(number + 1, unused);
      cell[number] = next++;
    }
  return cell;
}

void add_boundaries(mesh::Mesh& mesh, const Draft& draft, std::span<const std::int32_t> cell)
{
  for (const auto& [name, sides] : draft.boundaries)
  {
    std::vector<mesh::Side>& result = mesh.boundaries[name];
    for (const mesh::Side& side : sides)
    {
      if (side.cell < 0 || static_cast<std::size_t>(side.cell) >= cell.size() || cell[side.cell] == unused)
        throw Error(fmt::format("boundary '{}' has a side of cell {}, which there is not", name, side.cell));
      const element::Shape shape = mesh.shape(cell[side.cell]);
      if (side.side < 0 || static_cast<std::size_t>(side.side) >= element::sides(shape).size())
        throw Error(fmt::format("boundary '{}' has side {} of cell {}, but a {} has {} sides", name,
                                side.side, side.cell, element::name(shape), element::sides(shape).size()));
      result.push_back({cell[side.cell], side.side});
    }
    std::vector<mesh::Side> sorted = result;
    const auto before = [](const mesh::Side& a, const mesh::Side& b)
    { return std::pair(a.cell, a.side) < std::pair(b.cell, b.side); };
    std::sort(sorted.begin(), sorted.end(), before);
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
      throw Error(fmt::format("boundary '{}' has a side twice", name));
  }
}

/// Fields per cell in the order of the mesh.
ReadField reorder(const ReadField& field, std::span<const std::int32_t> cell, std::size_t cell_count)
{
  ReadField result{field.name, field.components, std::vector<double>(cell_count * field.components)};
  for (std::size_t number = 0; number < cell.size(); ++number)
    if (cell[number] != unused)
      std::copy_n(field.values.begin() + number * field.components, field.components,
                  result.values.begin() + std::size_t(cell[number]) * field.components);
  return result;
}

}  // namespace

DraftCells& Draft::cells_of(element::Shape shape)
{
  const auto found =
      std::find_if(cells.begin(), cells.end(), [=](const DraftCells& list) { return list.shape == shape; });
  return found != cells.end() ? *found : cells.emplace_back(DraftCells{shape, {}, {}, {}});
}

ReadMesh assemble(Draft draft)
{
  const int dim = common_dimension(draft);
  check_cells(draft);
  ReadMesh result;
  mesh::Mesh& mesh = result.mesh;
  const std::vector<std::int32_t> node = number_nodes(draft, mesh.local_node_count);
  check_finite(draft, node);
  if (dim == 2)
    check_plane(draft, node);
  mesh.dim = dim;
  mesh.order = draft.order;
  for (const DraftCells& list : draft.cells)
    add_cells(mesh, list, node);
  mesh.total_node_count = static_cast<std::int64_t>(mesh.node_count());
  mesh.total_cell_count = static_cast<std::int64_t>(mesh.cell_count());
  mesh.block_names = std::move(draft.block_names);
  mesh.block_regions = std::move(draft.block_regions);

  const std::vector<std::int32_t> cell = number_cells(draft);
  add_boundaries(mesh, draft, cell);
  for (const ReadField& field : draft.cell_fields)
    result.cell_fields.push_back(reorder(field, cell, mesh.cell_count()));

  const LatticeChange change(mesh, element::NodeKind::equispaced, element::NodeKind::warped);
  result.x = change(at_nodes(draft.points, 3, dim, node), dim, dim);
  for (ReadField& field : draft.fields)
  {
    const std::vector<double> values = at_nodes(field.values, field.components, field.components, node);
    result.fields.push_back(
        {std::move(field.name), field.components, change(values, field.components, field.components)});
  }
  return result;
}

}  // namespace blockfsi::output
