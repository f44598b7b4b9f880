#pragma once

#include "mesh/mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::coupling
{

/// The nodes that one mesh shares with the other across the interface. Every process knows the whole
/// interface; both meshes come from the same blocks, so node i of one is node i of the other.
class Interface
{
public:
  /// `numbers`: lattice numbers of the interface nodes, ascending, the same on all processes.
  Interface(std::span<const std::int64_t> numbers, const mesh::Mesh& mesh);

  std::size_t count() const { return count_; }

  /// Values at the interface from a nodal field of shape (node_count, stride), of which the first two
  /// components are taken; complete on all processes. `values`: shape (count, 2), written.
  void gather(std::span<const double> field, int stride, std::span<double> values) const;

  /// Puts values at the interface, shape (count, 2), into a nodal field of shape (node_count, 2).
  void scatter(std::span<const double> values, std::span<double> field) const;

private:
  struct Pair
  {
    std::int32_t node;
    std::int32_t index;
  };
  std::size_t count_;
  std::vector<Pair> local_;
  std::vector<Pair> owned_;
};

}  // namespace blockfsi::coupling
