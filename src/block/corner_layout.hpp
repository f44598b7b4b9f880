#pragma once

#include "block/connect.hpp"
#include "block/corner_graph.hpp"
#include "block/corner_motion.hpp"
#include "block/layout.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi::block
{

/// A corner that moves by a weighted sum of the displacements of other points.
struct Follow
{
  int point = 0;
  struct Leader
  {
    int point = 0;
    double weight = 1.0;
  };
  std::vector<Leader> leaders;
};

/// What the corners of the blocks of a region do.
struct CornerParameters
{
  CornerRule rule = CornerRule::automatic;
  std::vector<Follow> follows;  ///< led by the user
  /// Boundaries along which corners slide where they are straight; without a value none.
  std::optional<std::vector<std::string>> slide;
};

/// The interface nodes that lead each point: those on the interface and those with a rule, through chains of
/// rules; none for all others, which count as at rest. Shape (point_count). Throws Error if rules run in a
/// circle, move an interface point or name a point twice.
///   interface: skeleton numbers, ascending.
std::vector<std::vector<Share>> led_points(const Skeleton& skeleton, std::span<const std::int64_t> interface,
                                           const std::vector<Follow>& follows);

/// The blocks of a region as the rules for moving corners see them. Corners on the interface are led by it,
/// those with rules by their leaders; corners on boundaries stay, or slide along a straight line of the
/// boundaries named so; the others are free. Throws Error like led_points, and if a leader moves freely.
CornerGraph corner_graph(const Layout& layout, const Skeleton& skeleton, std::string_view region,
                         std::span<const std::int64_t> interface, const CornerParameters& parameters);

/// The corners of a region with their rule.
CornerMotion corner_motion(const Layout& layout, const Skeleton& skeleton, std::string_view region,
                           std::span<const std::int64_t> interface, const CornerParameters& parameters);

}  // namespace blockfsi::block
