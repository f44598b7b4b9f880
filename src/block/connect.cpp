#include "block/connect.hpp"

#include "block/boundaries.hpp"
#include "block/region.hpp"

#include <algorithm>
#include <string>

namespace blockfsi::block
{

namespace
{

/// A run of cells [begin, end) of one block, counted within the block.
struct Run
{
  int block;
  std::int64_t begin;
  std::int64_t end;
};

std::vector<Run> own_runs(const RegionCells& cells, Part part)
{
  const std::int64_t begin = cells.share_begin(part.rank, part.size);
  const std::int64_t end = cells.share_begin(part.rank + 1, part.size);
  std::vector<Run> runs;
  for (const int block : cells.blocks())
  {
    const std::int64_t first = cells.first_cell(block);
    const std::int64_t count = cells.lattice(block).cell_count();
    const Run run{block, std::max(begin - first, std::int64_t{0}), std::min(end - first, count)};
    if (run.begin < run.end)
      runs.push_back(run);
  }
  return runs;
}

/// Lattice numbers of the nodes of all own cells, shape (cell_count, (order + 1)^2).
std::vector<std::int64_t> own_rows(const RegionCells& cells, const std::vector<Run>& runs, int order)
{
  std::vector<std::int64_t> rows;
  for (const Run& run : runs)
  {
    const BlockLattice& lattice = cells.lattice(run.block);
    for (std::int64_t c = run.begin; c < run.end; ++c)
    {
      const int i0 = static_cast<int>(c % lattice.cells_along_u()) * order;
      const int j0 = static_cast<int>(c / lattice.cells_along_u()) * order;
      for (int j = 0; j <= order; ++j)
        for (int i = 0; i <= order; ++i)
          rows.push_back(lattice.number(i0 + i, j0 + j));
    }
  }
  return rows;
}

/// Numbers the nodes of the own cells locally, ascending by lattice number.
void number_nodes(const RegionCells& cells, const std::vector<std::int64_t>& rows, int size, mesh::Mesh& mesh)
{
  mesh.lattice = rows;
  std::sort(mesh.lattice.begin(), mesh.lattice.end());
  mesh.lattice.erase(std::unique(mesh.lattice.begin(), mesh.lattice.end()), mesh.lattice.end());
  for (const std::int64_t node : mesh.lattice)
    mesh.owner.push_back(cells.rank_of_cell(cells.lowest_cell(node), size));
  mesh.cells.reserve(rows.size());
  for (const std::int64_t node : rows)
  {
    const auto at = std::lower_bound(mesh.lattice.begin(), mesh.lattice.end(), node);
    mesh.cells.push_back(static_cast<std::int32_t>(at - mesh.lattice.begin()));
  }
}

/// The names of the mesh boundaries that an edge belongs to, seen from a region.
std::vector<std::string> names_of(const Layout& layout, const RegionCells& cells, const PlacedEdge& edge)
{
  std::vector<std::string> names;
  if (edge.boundary >= 0)
    names.push_back(layout.boundaries[edge.boundary].name);
  if (edge.blocks.size() == 2 && cells.contains(edge.blocks[0]) != cells.contains(edge.blocks[1]))
    names.push_back(interface_name);
  return names;
}

/// Enters all boundaries of the region, so that every process knows the same names.
void name_boundaries(const Layout& layout, const RegionCells& cells, mesh::Mesh& mesh)
{
  for (const int block : cells.blocks())
    for (const PlacedEdge* edge : cells.lattice(block).edges)
      for (const std::string& name : names_of(layout, cells, *edge))
        mesh.boundaries[name];
}

/// Sides of a block on which a cell lies.
std::vector<int> sides_of(const BlockLattice& lattice, std::int64_t cell)
{
  const std::int64_t i = cell % lattice.cells_along_u();
  const std::int64_t j = cell / lattice.cells_along_u();
  std::vector<int> sides;
  if (j == 0)
    sides.push_back(0);
  if (i == lattice.cells_along_u() - 1)
    sides.push_back(1);
  if (j == lattice.cells_along_v() - 1)
    sides.push_back(2);
  if (i == 0)
    sides.push_back(3);
  return sides;
}

void add_cells(const Layout& layout, const RegionCells& cells, const Run& run, mesh::Mesh& mesh)
{
  const BlockLattice& lattice = cells.lattice(run.block);
  std::array<std::vector<std::string>, 4> names;
  for (int side = 0; side < 4; ++side)
    names[side] = names_of(layout, cells, *lattice.edges[side]);
  for (std::int64_t c = run.begin; c < run.end; ++c)
  {
    const auto local = static_cast<std::int32_t>(mesh.cell_block.size());
    mesh.cell_block.push_back(run.block);
    mesh.cell_number.push_back(cells.first_cell(run.block) + c);
    for (const int side : sides_of(lattice, c))
      for (const std::string& name : names[side])
        mesh.boundaries[name].push_back({local, side});
  }
}

/// Graded parameter of node k of a side, along u or v.
double side_parameter(const Skeleton& skeleton, const BlockLattice& lattice, int side, int k)
{
  const double t = skeleton.parameter[lattice.side_number(side, k)];
  return lattice.forward[side] ? t : 1.0 - t;
}

/// What placing node (i, j) within a block takes. The graded coordinates are the fixed point of the blend of
/// the parameters on opposite sides, u = (1 - v) bottom + v top, v = (1 - u) left + u right (formulation.md
/// 3).
Plan::Inner inner_node(const Skeleton& skeleton, const BlockLattice& lattice, std::int32_t local, int i,
                       int j)
{
  const double bottom = side_parameter(skeleton, lattice, 0, i);
  const double right = side_parameter(skeleton, lattice, 1, j);
  const double top = side_parameter(skeleton, lattice, 2, i);
  const double left = side_parameter(skeleton, lattice, 3, j);
  const double determinant = 1.0 - (right - left) * (top - bottom);
  Plan::Inner inner{};
  inner.node = local;
  for (int side = 0; side < 4; ++side)
    inner.side[side] = static_cast<std::int32_t>(lattice.side_number(side, side % 2 == 0 ? i : j));
  inner.corner = lattice.points;
  inner.u = (bottom + left * (top - bottom)) / determinant;
  inner.v = (left + bottom * (right - left)) / determinant;
  return inner;
}

Plan make_plan(const Skeleton& skeleton, const RegionCells& cells, const mesh::Mesh& mesh)
{
  Plan plan;
  plan.dim = skeleton.dim;
  for (std::size_t n = 0; n < mesh.node_count(); ++n)
  {
    const auto local = static_cast<std::int32_t>(n);
    const std::int64_t node = mesh.lattice[n];
    if (node < skeleton.count)
    {
      plan.skeleton_node.push_back(local);
      plan.skeleton_number.push_back(node);
      continue;
    }
    const BlockLattice& lattice = cells.lattice(cells.block_of(node));
    const std::int64_t k = node - lattice.first_inner;
    const int i = static_cast<int>(k % (lattice.columns - 1)) + 1;
    const int j = static_cast<int>(k / (lattice.columns - 1)) + 1;
    plan.inner.push_back(inner_node(skeleton, lattice, local, i, j));
  }
  return plan;
}

}  // namespace

Connected connect(const Layout& layout, const Skeleton& skeleton, std::string_view region, Part part)
{
  const RegionCells cells(layout, skeleton, region);
  const std::vector<Run> runs = own_runs(cells, part);
  Connected connected;
  mesh::Mesh& mesh = connected.mesh;
  mesh.dim = skeleton.dim;
  mesh.order = skeleton.order;
  mesh.total_cell_count = cells.cell_count();
  mesh.total_node_count = cells.node_count();
  name_boundaries(layout, cells, mesh);
  for (const Run& run : runs)
    add_cells(layout, cells, run, mesh);
  number_nodes(cells, own_rows(cells, runs, skeleton.order), part.size, mesh);
  mesh.local_node_count = mesh.lattice.size();
  mesh.runs = {{element::Shape::quadrilateral, 0, static_cast<std::int32_t>(mesh.cell_count()), 0}};
  for (const Block& block : layout.blocks)
  {
    mesh.block_names.push_back(block.name);
    mesh.block_regions.push_back(block.region);
  }
  connected.plan = make_plan(skeleton, cells, mesh);
  return connected;
}

}  // namespace blockfsi::block
