#pragma once

#include "mesh/mesh.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace blockfsi::run
{

/// A rectangle along the axes.
struct Box
{
  std::array<double, 2> low = {std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::infinity()};
  std::array<double, 2> high = {-std::numeric_limits<double>::infinity(),
                                -std::numeric_limits<double>::infinity()};
};

/// A place in a mesh: its cell and the values of the cell's functions there.
struct Located
{
  std::size_t cell = 0;
  std::vector<double> shape;  ///< shape (nodes_per_cell)
  /// How far the place is outside of the cell, in its unit square; 0 inside.
  double outside = 0.0;

  /// Value of a component of a nodal field of shape (node_count, stride).
  double value(const mesh::Mesh& mesh, std::span<const double> field, int stride, int component) const;
};

/// Finds a point among the cells of this process; nothing if it is in none. The answer does not depend on
/// `first`, the cell that is tried before all others: where cells meet, it is the one of least number.
/// Inverts the map of each cell whose box holds the point by Newton's method.
///   x [m], shape (node_count, 2).
std::optional<Located> locate(const mesh::Mesh& mesh, std::span<const double> x,
                              const std::array<double, 2>& point, std::size_t first = 0);

/// Finds many points among the cells of this process, by boxes and a grid over them.
class Finder
{
public:
  /// The mesh must outlive the finder.
  ///   x [m], shape (node_count, 2).
  Finder(const mesh::Mesh& mesh, std::span<const double> x);

  /// The place of a point as `locate` finds it. Curved boundaries of two meshes are not quite the same:
  /// beside the mesh the functions of the nearest cell go on, up to a tenth of the cell; farther away the
  /// nearest node answers.
  Located find(const std::array<double, 2>& point);
  /// The same, but nothing if it is farther away from all cells.
  std::optional<Located> find_near(const std::array<double, 2>& point);
  /// The nearest node; `outside` is its distance [m]. Takes time with each cell.
  /// Infinitely far away in an empty mesh.
  Located nearest_node(const std::array<double, 2>& point) const;

private:
  std::size_t bin(const std::array<double, 2>& point) const;
  std::optional<Located> among_near(const std::array<double, 2>& point) const;

  const mesh::Mesh* mesh_;
  std::vector<double> x_;
  std::vector<double> nodes_;
  std::vector<Box> boxes_;  ///< of the cells
  Box whole_;
  std::array<std::size_t, 2> bins_{};
  std::vector<std::vector<std::size_t>> cells_;  ///< whose boxes reach into each bin, ascending
  std::size_t last_ = 0;
};

}  // namespace blockfsi::run
