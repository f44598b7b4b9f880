#include "command/picture.hpp"

#include "block/edge_lines.hpp"
#include "core/error.hpp"
#include "output/file.hpp"
#include "output/svg.hpp"
#include "output/vtu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace blockfsi::command
{

namespace
{

/// A circle in four edges is then off by less than 1e-6 of its radius.
constexpr int line_order = 3;
constexpr int line_pieces = 8;

std::string edge_name(const block::Skeleton& skeleton, const block::PlacedEdge& edge)
{
  return skeleton.point_names[edge.a] + " - " + skeleton.point_names[edge.b];
}

/// Entry of a name in a list, which gets it if it is not there.
int entry(std::vector<std::string>& names, const std::string& name)
{
  const auto found = std::find(names.begin(), names.end(), name);
  const auto at = static_cast<int>(found - names.begin());
  if (found == names.end())
    names.push_back(name);
  return at;
}

std::string svg(const block::Layout& layout, const block::Skeleton& skeleton,
                const std::vector<block::EdgeLine>& lines, const std::string& title)
{
  const auto flat = [](const std::vector<std::array<double, 3>>& points)
  {
    std::vector<std::array<double, 2>> result;
    result.reserve(points.size());
    for (const auto& [x, y, z] : points)
      result.push_back({x, y});
    return result;
  };
  output::BlockPicture picture;
  picture.title = title;
  for (const block::Point& point : layout.points)
    picture.points.push_back({point.name, {point.x[0], point.x[1]}});
  for (std::size_t e = 0; e < lines.size(); ++e)
  {
    const block::PlacedEdge& edge = skeleton.edges[e];
    const int boundary =
        edge.boundary < 0 ? -1 : entry(picture.boundaries, layout.boundaries[edge.boundary].name);
    picture.lines.push_back({edge_name(skeleton, edge), edge.divisions, boundary, lines[e].pieces,
                             flat(lines[e].x), flat(lines[e].cell_ends)});
  }
  for (std::size_t b = 0; b < layout.blocks.size(); ++b)
    picture.blocks.push_back(
        {layout.blocks[b].name, entry(picture.regions, layout.blocks[b].region), skeleton.block_edges[b]});
  return output::draw(picture);
}

void write_lines(const std::filesystem::path& path, const block::Skeleton& skeleton,
                 const std::vector<block::EdgeLine>& lines)
{
  mesh::Mesh mesh;
  mesh.dim = 3;
  mesh.order = line_order;
  std::vector<double> x;
  std::vector<std::int32_t> divisions;
  std::vector<std::int32_t> boundaries;
  std::vector<std::int32_t> block_counts;
  for (std::size_t e = 0; e < lines.size(); ++e)
  {
    const block::PlacedEdge& edge = skeleton.edges[e];
    mesh.block_names.push_back(edge_name(skeleton, edge));
    mesh.block_regions.emplace_back();
    const auto first = static_cast<std::int32_t>(x.size() / 3);
    for (const std::array<double, 3>& point : lines[e].x)
      x.insert(x.end(), point.begin(), point.end());
    for (int piece = 0; piece < lines[e].pieces; ++piece)
    {
      for (int i = 0; i <= line_order; ++i)
        mesh.cells.push_back(first + piece * line_order + i);
      mesh.cell_block.push_back(static_cast<std::int32_t>(e));
      divisions.push_back(edge.divisions);
      boundaries.push_back(edge.boundary);
      block_counts.push_back(static_cast<std::int32_t>(edge.blocks.size()));
    }
  }
  mesh.runs = {{element::Shape::segment, 0, static_cast<std::int32_t>(mesh.cell_count()), 0}};
  mesh.local_node_count = x.size() / 3;
  const std::vector<output::CellField> fields = {{"edge", std::span<const std::int32_t>(mesh.cell_block)},
                                                 {"divisions", std::span<const std::int32_t>(divisions)},
                                                 {"boundary", std::span<const std::int32_t>(boundaries)},
                                                 {"blocks", std::span<const std::int32_t>(block_counts)}};
  output::write_vtu(path, mesh, x, {}, fields, output::Names::kept);
}

}  // namespace

void check_picture_path(const std::filesystem::path& path, int dim)
{
  const std::string wanted = dim == 2 ? ".svg" : ".vtu";
  if (path.extension() != wanted)
    throw Error(fmt::format("the picture '{}' of blocks {} must end in {}", path.string(),
                            dim == 2 ? "in the plane" : "in space", wanted));
}

void draw_blocks(const std::filesystem::path& path, const block::Layout& layout,
                 const block::Skeleton& skeleton, const std::string& title)
{
  const std::vector<block::EdgeLine> lines = block::edge_lines(layout, skeleton, line_order, line_pieces);
  if (layout.dim == 2)
    output::replace_file(path, svg(layout, skeleton, lines, title));
  else
    write_lines(path, skeleton, lines);
}

}  // namespace blockfsi::command
