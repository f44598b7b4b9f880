#pragma once

#include "element/lattice.hpp"
#include "element/shape.hpp"

#include <array>
#include <cstdint>

namespace blockfsi::block
{

/// The lattice of a block or of a side: as in element/lattice.hpp, but with a number of steps of its own in
/// each direction where the shape allows it (quadrilaterals, hexahedra; prisms along zeta). Its points (i, j,
/// k) are ordered with i fastest, then j, then k. A row is what has j and k in common, a level what has k.
struct Grid
{
  element::Shape shape = element::Shape::quadrilateral;
  /// Steps along xi, eta, zeta; equal where edges of a triangle or a pyramid couple them, 0 in unused
  /// directions.
  std::array<int, 3> steps{};
};

/// A side of a shape by where it lies; (i, j, k) are points of the lattice.
enum class Wall : std::uint8_t
{
  bottom,  ///< k = 0, its own coordinates are i and j
  front,   ///< j = 0, i and k
  right,   ///< i as large as possible, j and k
  back,    ///< j as large as possible (where that is a side), i and k
  left,    ///< i = 0, j and k
  top      ///< k as large as possible (where that is a side), i and j
};
inline constexpr int wall_count = 6;

/// Side of a shape (element::sides) at a wall, or -1 if the shape has none there.
int side_at(element::Shape shape, Wall wall);

int level_count(const Grid& grid);
/// Rows of the level k.
int row_count(const Grid& grid, int k);
/// Points of the row (j, k).
int row_length(const Grid& grid, int j, int k);
/// Number of points.
std::int64_t size(const Grid& grid);
/// Position of a point in the order.
std::int64_t index(const Grid& grid, const element::LatticePoint& point);
/// The lattice of the points on no side: its point (i, j, k) is the point (i + 1, j + 1, k + 1) of the given
/// one (in 2D (i + 1, j + 1, 0)). Without such points its size is 0.
Grid interior(const Grid& grid);
/// The lattice of a side, in the side's own directions.
Grid side_grid(const Grid& grid, int side);
/// A corner of the shape as a point of the lattice.
element::LatticePoint corner_point(const Grid& grid, int corner);
/// Direction of the lattice (a vector with one or two entries of size 1) that leads along an edge from the
/// first corner to the second, and the number of steps between them.
struct Way
{
  element::LatticePoint step{};
  int count = 0;
};
Way way_between(const Grid& grid, int from, int to);

}  // namespace blockfsi::block
