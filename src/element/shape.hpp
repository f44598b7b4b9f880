#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace blockfsi::element
{

/// Shape of a reference cell, of a block and of a side of either.
///
/// Corners of the reference cells, all within the unit cube:
///   segment        (0) (1)
///   triangle       (0, 0) (1, 0) (0, 1)
///   quadrilateral  (0, 0) (1, 0) (1, 1) (0, 1)
///   tetrahedron    the triangle at zeta = 0, then (0, 0, 1)
///   hexahedron     the quadrilateral at zeta = 0, then the same at zeta = 1
///   prism          the triangle at zeta = 0, then the same at zeta = 1
///   pyramid        the quadrilateral at zeta = 0, then the apex (0, 0, 1); the level zeta is the square
///                  0 <= xi, eta <= 1 - zeta
enum class Shape : std::uint8_t
{
  segment,
  triangle,
  quadrilateral,
  tetrahedron,
  hexahedron,
  prism,
  pyramid
};

inline constexpr int shape_count = 7;
inline constexpr int max_corners = 8;
inline constexpr int max_edges = 12;
inline constexpr int max_sides = 6;

/// A side of a cell: an end of a segment, an edge in 2D, a face in 3D. Its own reference coordinates start at
/// corners[0]: the first runs to corners[1], the second to the last corner.
struct SideShape
{
  Shape shape = Shape::segment;
  std::array<std::int8_t, 4> corners{};  ///< corners of the cell, as many as the side has
  bool outward = true;  ///< whether corners turn counter-clockwise seen from outside (2D: cell on the left)
};

/// Dimension of the reference cell: 1, 2 or 3.
int dimension(Shape shape);
int corner_count(Shape shape);
/// Edges, each as its two corners in the direction of its own parameter; in 2D the sides in their order.
std::span<const std::array<std::int8_t, 2>> edges(Shape shape);
/// Sides: in 2D the edges; in 3D the bottom, then what stands on the edges of the bottom in their order, then
/// the top. Empty for a segment.
std::span<const SideShape> sides(Shape shape);
/// Reference coordinates of the corners, shape (corner_count), unused coordinates are 0.
std::span<const std::array<double, 3>> corners(Shape shape);
/// "triangle", "hexahedron", ...
std::string_view name(Shape shape);

}  // namespace blockfsi::element
