#pragma once

#include "element/shape.hpp"

#include <cstdint>
#include <vector>

namespace blockfsi::output
{

// In which order files list the nodes of a cell of any order >= 1. Entry m of each answer is the index, in
// the lattice of the shape (element/lattice.hpp), of the file's node m.

/// VTK's Lagrange cells as of file version 2.2: corners, edges, faces, interior. Not for pyramids, which
/// VTK 9.1 does not have at orders above 1; throws Error for them.
std::vector<std::int32_t> vtk_order(element::Shape shape, int order);

/// Gmsh: corners, edges, faces, interior, where the inside of a face or of a cell is again listed like a cell
/// of lower order (Gmsh reference manual, "Node ordering"; the inside of a prism: each point of the triangle
/// with its column).
std::vector<std::int32_t> gmsh_order(element::Shape shape, int order);

}  // namespace blockfsi::output
