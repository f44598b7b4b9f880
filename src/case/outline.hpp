#pragma once

#include "block/connect.hpp"
#include "block/layout.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi::case_file
{

/// What the checks ask of the blocks: which edges, regions and boundaries touch each other.
class Outline
{
public:
  /// Both must outlive the outline.
  Outline(const block::Layout& layout, const block::Skeleton& skeleton);

  /// Names of all regions in the order of their first block.
  const std::vector<std::string>& regions() const { return regions_; }
  bool has_region(std::string_view name) const;
  /// Whether an edge separates blocks of different regions.
  bool between_regions(const block::PlacedEdge& edge) const;
  /// Whether a block of the region lies at the edge.
  bool touches(const block::PlacedEdge& edge, std::string_view region) const;
  /// Whether a boundary has an outer side at a block of the region.
  bool touches(std::size_t boundary, std::string_view region) const;
  /// Whether two regions share a side.
  bool neighbours(std::string_view a, std::string_view b) const;
  /// Points [m] where a condition on a boundary is evaluated: all its initial nodes.
  std::vector<std::array<double, 2>> boundary_nodes(std::string_view boundary) const;
  /// Corners [m] of the blocks of a region.
  std::vector<std::array<double, 2>> region_corners(std::string_view region) const;
  /// Whether a point lies in the region, give or take an eighth of the distance of two nodes where sides are
  /// curved.
  bool contains(std::string_view region, double x, double y) const;
  /// An edge of the boundary that is not parallel to an axis, or nullptr.
  const block::PlacedEdge* oblique_edge(std::string_view boundary) const;

private:
  bool has_block_of(int side, std::string_view region) const;
  std::array<double, 2> node(std::int64_t number) const;
  std::vector<std::array<double, 2>> edge_nodes(const block::PlacedEdge& edge) const;
  std::vector<std::array<double, 2>> around(std::size_t block) const;

  const block::Layout& layout_;
  const block::Skeleton& skeleton_;
  std::vector<std::string> regions_;
};

}  // namespace blockfsi::case_file
