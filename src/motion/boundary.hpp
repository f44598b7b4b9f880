#pragma once

#include "block/connect.hpp"
#include "linalg/numbering.hpp"
#include "mesh/mesh.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace blockfsi::motion
{

/// What is known of the displacement before any equation is solved.
struct Boundary
{
  /// A node of this process on the interface and its place there.
  struct Moving
  {
    std::int32_t node;
    std::int32_t index;
  };
  std::vector<Moving> moving;
  /// 1 for each prescribed displacement component, shape (node_count, 2): those of the interface and of all
  /// outer boundaries, except along boundaries that slide.
  std::vector<std::uint8_t> fixed;
};

/// `interface`: lattice numbers of the nodes that the solid moves, ascending. Throws Error if a boundary in
/// `slide` does not run along an axis. All processes must call it together.
Boundary find_boundary(const mesh::Mesh& mesh, const linalg::Numbering& numbering, std::span<const double> x,
                       std::span<const std::int64_t> interface, std::span<const std::string> slide);

/// Distance of each node to the interface in the first mesh [m], shape (node_count): to the lines through its
/// nodes. Infinite if there is none.
std::vector<double> distance_to_interface(const block::Skeleton& skeleton,
                                          std::span<const std::int64_t> interface, std::span<const double> x);

/// Distance of each node to the nearest of some points [m], shape (node_count); infinite without points.
std::vector<double> distance_to_points(std::span<const std::array<double, 3>> points,
                                       std::span<const double> x);

}  // namespace blockfsi::motion
