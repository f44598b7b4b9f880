#include "block/connect.hpp"

#include "block/blend.hpp"
#include "block/boundaries.hpp"
#include "block/reference.hpp"
#include "block/region.hpp"
#include "block/share.hpp"
#include "block/topology.hpp"

#include <algorithm>
#include <numeric>
#include <string>

namespace blockfsi::block
{

namespace
{

/// The names of the mesh boundaries that a side belongs to, seen from a region.
std::vector<std::string> names_of(const Layout& layout, const Skeleton& skeleton, const RegionCells& cells,
                                  int side)
{
  std::vector<std::string> names;
  const int boundary = side_boundary(skeleton, side);
  const std::vector<int>& blocks = side_blocks(skeleton, side);
  if (boundary >= 0)
    names.push_back(layout.boundaries[boundary].name);
  if (blocks.size() == 2 && cells.contains(blocks[0]) != cells.contains(blocks[1]))
    names.push_back(interface_name);
  return names;
}

/// Lists of sides of cells that grow with the sides of a block, for each side.
using Lists = std::vector<std::vector<std::vector<mesh::Side>*>>;

Lists lists_of(const Layout& layout, const Skeleton& skeleton, const RegionCells& cells, int block,
               mesh::Mesh& mesh)
{
  Lists lists;
  for (const int side : skeleton.block_sides[block])
  {
    lists.emplace_back();
    for (const std::string& name : names_of(layout, skeleton, cells, side))
      lists.back().push_back(&mesh.boundaries[name]);
  }
  return lists;
}

/// Makes room for the own cells, shape after shape.
void make_runs(const RegionCells& cells, const std::vector<BlockShare>& shares, mesh::Mesh& mesh)
{
  RegionCells::ShapeCounts counts{};
  for (const BlockShare& share : shares)
    add_counts(cells.cells(share.block), share.begin, share.end, counts);
  std::int64_t cell = 0;
  std::int64_t entry = 0;
  for (std::size_t shape = 0; shape < counts.size(); ++shape)
  {
    if (counts[shape] == 0)
      continue;
    const auto of = static_cast<element::Shape>(shape);
    mesh.runs.push_back(
        {of, static_cast<std::int32_t>(cell), static_cast<std::int32_t>(counts[shape]), entry});
    cell += counts[shape];
    entry += counts[shape] * element::lattice_size(of, mesh.order);
  }
  mesh.cells.resize(entry);
  mesh.cell_block.resize(cell);
}

/// Where the next cell of each shape goes.
struct Next
{
  std::array<std::int32_t, element::shape_count> cell{};
  std::array<std::int32_t*, element::shape_count> row{};
};

/// A side of a cell kind that lies on a boundary for some boxes of the row at hand.
struct Touch
{
  BlockCells::Boxes boxes;
  int side;
  const std::vector<std::vector<mesh::Side>*>* lists;
};

/// Writes the cells of a block.
class Writer
{
public:
  Writer(const RegionCells& cells, const BlockShare& share, const Lists& lists, bool with_numbers,
         mesh::Mesh& mesh, Next& next)
      : cells_(cells.cells(share.block)), lattice_(cells.lattice(share.block)), share_(share), lists_(lists),
        mesh_(mesh), next_(next), number_(cells.first_of_shape(share.block)), with_numbers_(with_numbers),
        stride_(lattice_.nodes.steps[0] + 1)
  {
    const std::size_t lines = static_cast<std::size_t>(mesh.order) + 1;
    numbers_.resize(stride_ * lines * (mesh.dim == 2 ? 1 : lines));
    for (const CellKind& kind : cells_.kinds())
    {
      std::vector<std::int32_t> offsets;
      for (const element::LatticePoint& node : kind.nodes)
        offsets.push_back(
            static_cast<std::int32_t>(node[0] + static_cast<std::int64_t>(stride_) * line(node[1], node[2])));
      offsets_.push_back(std::move(offsets));
    }
  }

  void write()
  {
    for (int k = 0; k < cells_.level_count(); ++k)
      for (int j = 0; j < cells_.row_count(k); ++j)
      {
        if (cells_.row_end(j, k) <= share_.begin || cells_.row_begin(j, k) >= share_.end)
          skip_row(j, k);
        else
          write_row(j, k);
      }
  }

private:
  std::int64_t line(int dj, int dk) const { return dj + static_cast<std::int64_t>(mesh_.order + 1) * dk; }

  void skip_row(int j, int k)
  {
    for (const CellKind& kind : cells_.kinds())
      number_[static_cast<std::size_t>(kind.shape)] += cells_.count_in_row(kind, j, k);
  }

  /// Local numbers of the nodes in the rows of the lattice that the row of boxes touches.
  void read_lines(int j, int k)
  {
    const int p = mesh_.order;
    const int levels = mesh_.dim == 2 ? 0 : p;
    for (int dk = 0; dk <= levels; ++dk)
      for (int dj = 0; dj <= p; ++dj)
        if (p * j + dj < row_count(lattice_.nodes, p * k + dk))
          share_.read_row(lattice_, p * j + dj, p * k + dk, numbers_.data() + stride_ * line(dj, dk));
  }

  void find_touches(int j, int k)
  {
    touches_.assign(cells_.kinds().size(), {});
    for (std::size_t q = 0; q < touches_.size(); ++q)
      for (const CellKind::OnWall& wall : cells_.kinds()[q].walls)
      {
        const BlockCells::Boxes boxes = cells_.on_wall(wall, cells_.kinds()[q], j, k);
        const auto& lists = lists_[side_at(lattice_.nodes.shape, wall.wall)];
        if (boxes.first <= boxes.last && !lists.empty())
          touches_[q].push_back({boxes, wall.side, &lists});
      }
  }

  void write_row(int j, int k)
  {
    read_lines(j, k);
    find_touches(j, k);
    const auto kinds = cells_.kinds();
    std::array<int, 8> counts{};
    for (std::size_t q = 0; q < kinds.size(); ++q)
      counts[q] = cells_.count_in_row(kinds[q], j, k);
    std::int64_t cell = cells_.row_begin(j, k);
    for (int i = 0; i < cells_.box_count(j, k); ++i)
      for (std::size_t q = 0; q < kinds.size(); ++q)
      {
        if (i >= counts[q])
          continue;
        if (cell >= share_.begin && cell < share_.end)
          write_cell(q, i);
        ++number_[static_cast<std::size_t>(kinds[q].shape)];
        ++cell;
      }
  }

  void write_cell(std::size_t q, int i)
  {
    const auto shape = static_cast<std::size_t>(cells_.kinds()[q].shape);
    const std::int32_t* from = numbers_.data() + static_cast<std::ptrdiff_t>(i) * mesh_.order;
    std::int32_t* to = next_.row[shape];
    for (const std::int32_t offset : offsets_[q])
      *to++ = from[offset];
    next_.row[shape] = to;
    const std::int32_t local = next_.cell[shape]++;
    mesh_.cell_block[local] = share_.block;
    if (with_numbers_)
      mesh_.cell_number[local] = number_[shape];
    for (const Touch& touch : touches_[q])
      if (i >= touch.boxes.first && i <= touch.boxes.last)
        for (std::vector<mesh::Side>* list : *touch.lists)
          list->push_back({local, touch.side});
  }

  const BlockCells& cells_;
  const BlockLattice& lattice_;
  const BlockShare& share_;
  const Lists& lists_;
  mesh::Mesh& mesh_;
  Next& next_;
  RegionCells::ShapeCounts number_;
  bool with_numbers_;
  std::size_t stride_;
  std::vector<std::int32_t> numbers_;
  std::vector<std::vector<std::int32_t>> offsets_;
  std::vector<std::vector<Touch>> touches_;
};

void write_cells(const Layout& layout, const Skeleton& skeleton, const RegionCells& cells,
                 const std::vector<BlockShare>& shares, bool with_numbers, mesh::Mesh& mesh)
{
  make_runs(cells, shares, mesh);
  if (with_numbers)
    mesh.cell_number.resize(mesh.cell_block.size());
  Next next;
  for (const mesh::CellRun& run : mesh.runs)
  {
    next.cell[static_cast<std::size_t>(run.shape)] = run.first;
    next.row[static_cast<std::size_t>(run.shape)] = mesh.cells.data() + run.entry;
  }
  // Every process knows the same names.
  for (const int block : cells.blocks())
    lists_of(layout, skeleton, cells, block, mesh);
  for (const BlockShare& share : shares)
  {
    const Lists lists = lists_of(layout, skeleton, cells, share.block, mesh);
    Writer(cells, share, lists, with_numbers, mesh, next).write();
  }
  for (auto& [name, sides] : mesh.boundaries)
    std::sort(sides.begin(), sides.end(),
              [](const mesh::Side& a, const mesh::Side& b)
              { return std::pair(a.cell, a.side) < std::pair(b.cell, b.side); });
}

/// Graded parameters of the nodes on the edges of a block, in their directions in the block.
EdgeParameters edge_parameters(const Layout& layout, const Skeleton& skeleton, int block)
{
  EdgeParameters parameters;
  for (std::size_t e = 0; e < skeleton.block_edges[block].size(); ++e)
  {
    const PlacedEdge& edge = skeleton.edges[skeleton.block_edges[block][e]];
    parameters.push_back(
        directed_parameters(skeleton, edge, edge_ends(layout.blocks[block], static_cast<int>(e))[0]));
  }
  return parameters;
}

Plan make_plan(const Layout& layout, const Skeleton& skeleton, const RegionCells& cells,
               std::vector<BlockShare>& shares, const LocalSkeleton& local)
{
  Plan plan;
  plan.dim = skeleton.dim;
  plan.whole_skeleton = local.count == skeleton.count;
  if (!plan.whole_skeleton)
    for (std::int64_t number = 0; number < skeleton.count; ++number)
      if (local.node[number] >= 0)
      {
        plan.skeleton_node.push_back(local.node[number]);
        plan.skeleton_number.push_back(number);
      }
  std::size_t work = 0;
  for (BlockShare& share : shares)
  {
    const BlockLattice& lattice = cells.lattice(share.block);
    BlockPlan& block = plan.blocks.emplace_back();
    block.grid = lattice.nodes;
    std::copy(lattice.corners.begin(), lattice.corners.end(), block.corners.begin());
    block.sides = lattice.sides;
    block.rows = share.rows(lattice);
    set_reference(edge_parameters(layout, skeleton, share.block), skeleton.order, cells.diagonal(share.block),
                  block);
    work = std::max(work, work_size(block, skeleton.dim));
  }
  plan.work.resize(work);
  return plan;
}

}  // namespace

Connected connect(const Layout& layout, const Skeleton& skeleton, std::string_view region, Part part)
{
  const RegionCells cells(layout, skeleton, region);
  std::vector<BlockShare> shares = own_shares(cells, part);
  Connected connected;
  mesh::Mesh& mesh = connected.mesh;
  mesh.dim = skeleton.dim;
  mesh.order = skeleton.order;
  mesh.total_cell_count = cells.cell_count();
  mesh.total_node_count = cells.node_count();
  const LocalSkeleton local = number_nodes(skeleton, cells, shares);
  mesh.local_node_count = local.node_count;
  const bool identity = region.empty() && part.size == 1;
  if (!identity)
    name_nodes(skeleton, cells, shares, local, part, mesh);
  write_cells(layout, skeleton, cells, shares, part.size > 1, mesh);
  for (const Block& block : layout.blocks)
  {
    mesh.block_names.push_back(block.name);
    mesh.block_regions.push_back(block.region);
  }
  connected.plan = make_plan(layout, skeleton, cells, shares, local);
  return connected;
}

}  // namespace blockfsi::block
