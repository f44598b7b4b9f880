#pragma once

#include "element/nodes.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::mesh
{

/// A corner of a part of a cell: the mean of some corners of the cell, one bit for each. One bit is a corner,
/// two the middle of an edge, those of a side its middle, all the middle of the cell.
using Mean = std::uint8_t;

/// A part of a cell.
struct CellPart
{
  element::Shape shape = element::Shape::triangle;
  std::array<Mean, element::max_corners> corners{};

  auto operator<=>(const CellPart&) const = default;
};

/// Reference coordinates of a corner of a part.
element::Point mean_point(element::Shape shape, Mean mean);

/// Mean of all corners of a cell, and of a side.
Mean all_corners(element::Shape shape);
Mean side_corners(element::Shape shape, int side);

/// The cell itself as its only part.
std::vector<CellPart> whole(element::Shape shape);

/// The triangle itself, or the two of a quadrilateral: cut from corner 0 to 2, or from 1 to 3.
std::vector<CellPart> two_triangles(bool from_first);
/// Four about the middle of a quadrilateral.
std::vector<CellPart> four_triangles();
/// Three of a triangle, four of a quadrilateral, about its middle: all edges are halved.
std::vector<CellPart> quadrilaterals(element::Shape shape);

/// Tetrahedra of a cell by the numbers of its corners, shape (corner_count), all different: quadrilaterals
/// are cut through their corner of the lowest number, so that neighbours agree (Dompierre, Labbe, Vallet and
/// Camarero 1999). 1 of a tetrahedron, 2 of a pyramid, 3 of a prism, 5 or 6 of a hexahedron.
std::vector<CellPart> tetrahedra(element::Shape shape, std::span<const std::int32_t> numbers);

/// Hexahedra of a cell about its middle: 4 of a tetrahedron, 6 of a prism, 8 of a hexahedron; all edges are
/// halved, and every side is cut as `quadrilaterals` does. None of a pyramid.
std::vector<CellPart> hexahedra(element::Shape shape);

}  // namespace blockfsi::mesh
