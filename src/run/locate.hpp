#pragma once

#include "mesh/mesh.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace blockfsi::run
{

/// A place in a mesh: its cell and the values of the cell's functions there.
struct Located
{
  std::size_t cell = 0;
  std::vector<double> shape;  ///< shape (nodes_per_cell)

  /// Value of a component of a nodal field of shape (node_count, stride).
  double value(const mesh::Mesh& mesh, std::span<const double> field, int stride, int component) const;
};

/// Finds a point among the cells of this process; nothing if it is in none. The answer does not depend on
/// `first`, the cell that is tried before all others: where cells meet, it is the one of least number.
/// Inverts the map of each cell whose box holds the point by Newton's method.
///   x [m], shape (node_count, 2).
std::optional<Located> locate(const mesh::Mesh& mesh, std::span<const double> x,
                              const std::array<double, 2>& point, std::size_t first = 0);

}  // namespace blockfsi::run
