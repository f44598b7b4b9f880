#include "run/refused.hpp"

#include "output/file.hpp"
#include "output/svg.hpp"
#include "run/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace blockfsi::run
{

namespace
{

/// Share of the faulty block's extent that is shown around it.
constexpr double room = 0.75;

/// The cells of one block of a mesh, with the numbers of the nodes unchanged.
struct BlockCells
{
  mesh::Mesh mesh;
  std::vector<std::int32_t> faulty;
};

std::map<std::int32_t, BlockCells> by_block(const mesh::Mesh& all, std::int64_t faulty)
{
  std::map<std::int32_t, BlockCells> blocks;
  for (std::size_t c = 0; c < all.cell_count(); ++c)
  {
    BlockCells& block = blocks[all.cell_block[c]];
    const std::span<const std::int32_t> nodes = all.cell(c);
    mesh::Mesh& own = block.mesh;
    if (own.runs.empty())
    {
      own.order = all.order;
      own.local_node_count = all.local_node_count;
      own.runs.push_back({all.shape(c), 0, 0, 0});
    }
    if (all.number_of_cell(c) == faulty)
      block.faulty.push_back(static_cast<std::int32_t>(own.cell_count()));
    own.cells.insert(own.cells.end(), nodes.begin(), nodes.end());
    own.cell_block.push_back(all.cell_block[c]);
    ++own.runs.front().count;
  }
  return blocks;
}

/// Makes the sides that only one cell has a boundary, which pictures show heavier: the outline of the block.
void outline(mesh::Mesh& block)
{
  std::map<std::pair<std::int32_t, std::int32_t>, std::vector<mesh::Side>> sides;
  for (std::size_t c = 0; c < block.cell_count(); ++c)
    for (int side = 0; side < 4; ++side)
    {
      const std::span<const std::int32_t> nodes = block.cell(c);
      const std::int32_t a = nodes[mesh::side_node(block.order, side, 0)];
      const std::int32_t b = nodes[mesh::side_node(block.order, side, block.order)];
      sides[std::minmax(a, b)].push_back({static_cast<std::int32_t>(c), side});
    }
  for (const auto& [ends, cells] : sides)
    if (cells.size() == 1)
      block.boundaries["outline"].push_back(cells.front());
}

}  // namespace

void draw_refused(const std::filesystem::path& path, const Simulation& simulation, const RefusedMesh& refused)
{
  std::map<std::int32_t, BlockCells> blocks = by_block(simulation.fluid()->mesh(), refused.cell);
  output::Panel panel;
  std::vector<double> shown;
  for (auto& [number, block] : blocks)
  {
    if (block.mesh.is_all(element::Shape::quadrilateral))
      outline(block.mesh);
    panel.layers.push_back({&block.mesh, refused.x, false, block.faulty});
    if (!block.faulty.empty())
      for (const std::int32_t node : block.mesh.cells)
        shown.insert(shown.end(), {refused.x[2 * node], refused.x[2 * node + 1]});
  }
  if (shown.empty() ||
      !std::all_of(shown.begin(), shown.end(), [](double coordinate) { return std::isfinite(coordinate); }))
    return;
  const std::string title =
      fmt::format("Step {}: cell {} of {} is not valid", simulation.step() + 1, refused.cell,
                  simulation.description().layout.blocks[refused.block].name);
  output::replace_file(path, output::draw(std::span(&panel, 1), window_around(shown, room), 1, title));
}

}  // namespace blockfsi::run
