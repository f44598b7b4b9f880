#pragma once

#include "element/nodes.hpp"

#include <array>
#include <vector>

namespace blockfsi::element
{

inline constexpr std::array<Shape, 7> all_shapes = {
    Shape::segment,    Shape::triangle, Shape::quadrilateral, Shape::tetrahedron,
    Shape::hexahedron, Shape::prism,    Shape::pyramid};

/// Place in the cell of a point of a side of it.
inline Point on_side(Shape shape, int side, const Point& point)
{
  const SideShape& of = sides(shape)[side];
  const Point& a = corners(shape)[of.corners[0]];
  const Point& b = corners(shape)[of.corners[1]];
  const Point& c = of.shape == Shape::segment ? a : corners(shape)[of.corners[corner_count(of.shape) - 1]];
  Point result{};
  for (int d = 0; d < 3; ++d)
    result[d] = a[d] + point[0] * (b[d] - a[d]) + point[1] * (c[d] - a[d]);
  return result;
}

/// Points in the inside of a cell that lie on no line of symmetry.
inline std::vector<Point> inner_points(Shape shape)
{
  std::vector<Point> result;
  for (const Point& t : {Point{0.21, 0.37, 0.55}, Point{0.66, 0.83, 0.12}, Point{0.91, 0.07, 0.78}})
  {
    const bool peaked = shape == Shape::tetrahedron || shape == Shape::pyramid;
    const bool flat = shape == Shape::tetrahedron || shape == Shape::triangle || shape == Shape::prism;
    const double depth = peaked ? 1.0 - t[2] : 1.0;
    const double eta = t[1] * depth;
    const double xi = t[0] * (flat ? depth - eta : depth);
    result.push_back({xi, dimension(shape) > 1 ? eta : 0.0, dimension(shape) > 2 ? t[2] : 0.0});
  }
  return result;
}

}  // namespace blockfsi::element
