#include "case/outline.hpp"

#include "block/topology.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace blockfsi::case_file
{

namespace
{

using Point = std::array<double, 2>;

double distance_to_segment(const Point& p, const Point& a, const Point& b)
{
  const double dx = b[0] - a[0];
  const double dy = b[1] - a[1];
  const double length2 = dx * dx + dy * dy;
  const double s = length2 > 0.0 ? ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length2 : 0.0;
  const double t = std::clamp(s, 0.0, 1.0);
  return std::hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
}

/// Inside by counting crossings, or so near to a side that the arc between its nodes may include the point.
bool polygon_contains(const std::vector<Point>& polygon, const Point& p)
{
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
  {
    const Point& a = polygon[i];
    const Point& b = polygon[j];
    if (distance_to_segment(p, a, b) <= 0.125 * std::hypot(b[0] - a[0], b[1] - a[1]))
      return true;
    if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]))
      inside = !inside;
  }
  return inside;
}

}  // namespace

Outline::Outline(const block::Layout& layout, const block::Skeleton& skeleton)
    : layout_(layout), skeleton_(skeleton)
{
  for (const block::Block& block : layout.blocks)
    if (!has_region(block.region))
      regions_.push_back(block.region);
}

bool Outline::has_region(std::string_view name) const
{
  return std::find(regions_.begin(), regions_.end(), name) != regions_.end();
}

bool Outline::between_regions(const block::PlacedEdge& edge) const
{
  return edge.blocks.size() == 2 &&
         layout_.blocks[edge.blocks[0]].region != layout_.blocks[edge.blocks[1]].region;
}

bool Outline::touches(const block::PlacedEdge& edge, std::string_view region) const
{
  return std::any_of(edge.blocks.begin(), edge.blocks.end(),
                     [&](int b) { return layout_.blocks[b].region == region; });
}

bool Outline::has_block_of(int side, std::string_view region) const
{
  const std::vector<int>& blocks = block::side_blocks(skeleton_, side);
  return std::any_of(blocks.begin(), blocks.end(), [&](int b) { return layout_.blocks[b].region == region; });
}

bool Outline::touches(std::size_t boundary, std::string_view region) const
{
  for (int side = 0; side < block::side_count(skeleton_); ++side)
    if (block::side_boundary(skeleton_, side) == static_cast<int>(boundary) && has_block_of(side, region))
    {
      const std::vector<int>& blocks = block::side_blocks(skeleton_, side);
      if (blocks.size() == 1 || layout_.blocks[blocks[0]].region == layout_.blocks[blocks[1]].region)
        return true;
    }
  return false;
}

bool Outline::neighbours(std::string_view a, std::string_view b) const
{
  for (int side = 0; side < block::side_count(skeleton_); ++side)
    if (has_block_of(side, a) && has_block_of(side, b))
      return true;
  return false;
}

Point Outline::node(std::int64_t number) const
{
  const auto k = static_cast<std::size_t>(number) * static_cast<std::size_t>(skeleton_.dim);
  return {skeleton_.x[k], skeleton_.x[k + 1]};
}

std::vector<Point> Outline::edge_nodes(const block::PlacedEdge& edge) const
{
  std::vector<Point> result = {node(edge.a)};
  for (std::int64_t k = 0; k < edge.count; ++k)
    result.push_back(node(edge.first + k));
  result.push_back(node(edge.b));
  return result;
}

std::vector<Point> Outline::boundary_nodes(std::string_view boundary) const
{
  std::vector<Point> result;
  for (const block::PlacedEdge& edge : skeleton_.edges)
    if (edge.boundary >= 0 && layout_.boundaries[edge.boundary].name == boundary)
    {
      const std::vector<Point> nodes = edge_nodes(edge);
      result.insert(result.end(), nodes.begin(), nodes.end());
    }
  return result;
}

std::vector<Point> Outline::region_corners(std::string_view region) const
{
  std::vector<Point> result;
  for (const block::Block& block : layout_.blocks)
    if (block.region == region)
      for (const int point : block.points)
        result.push_back(node(point));
  return result;
}

std::vector<Point> Outline::around(std::size_t block) const
{
  std::vector<Point> result;
  const std::vector<int>& corners = layout_.blocks[block].points;
  for (std::size_t side = 0; side < 4; ++side)
  {
    const block::PlacedEdge& edge = skeleton_.edges[skeleton_.block_edges[block][side]];
    std::vector<Point> nodes = edge_nodes(edge);
    // Counter-clockwise, each side goes from its own corner to the next one.
    if (edge.a != corners[side])
      std::reverse(nodes.begin(), nodes.end());
    result.insert(result.end(), nodes.begin(), nodes.end() - 1);
  }
  return result;
}

bool Outline::contains(std::string_view region, double x, double y) const
{
  for (std::size_t b = 0; b < layout_.blocks.size(); ++b)
    if (layout_.blocks[b].region == region && polygon_contains(around(b), {x, y}))
      return true;
  return false;
}

const block::PlacedEdge* Outline::oblique_edge(std::string_view boundary) const
{
  for (const block::PlacedEdge& edge : skeleton_.edges)
  {
    if (edge.boundary < 0 || layout_.boundaries[edge.boundary].name != boundary)
      continue;
    const std::vector<Point> nodes = edge_nodes(edge);
    const double size = std::hypot(nodes.back()[0] - nodes[0][0], nodes.back()[1] - nodes[0][1]);
    const auto constant = [&](std::size_t i)
    {
      return std::all_of(nodes.begin(), nodes.end(),
                         [&](const Point& p) { return std::abs(p[i] - nodes[0][i]) <= 1e-9 * size; });
    };
    if (!constant(0) && !constant(1))
      return &edge;
  }
  return nullptr;
}

}  // namespace blockfsi::case_file
