#pragma once

#include "element/shape.hpp"

#include <cstdint>
#include <vector>

namespace blockfsi::output
{

/// A cell as VTK knows it.
struct VtkType
{
  element::Shape shape = element::Shape::quadrilateral;  ///< whose lattice `order` refers to
  int degree = 1;
  std::uint8_t number = 0;
  std::vector<std::int32_t> order;  ///< index in the lattice of each of the file's nodes
};

/// The type that cells are written as: linear cells at order 1, Lagrange cells above; pyramids of order 2 and
/// more as hexahedra.
VtkType vtk_type(element::Shape shape, int order);

/// The type of a cell that is read. Throws Error if it is none of the linear cells, quadratic cells of the
/// full order or Lagrange cells, or if it cannot have that many nodes.
VtkType read_vtk_type(int number, std::int64_t node_count);

}  // namespace blockfsi::output
