#pragma once

#include "mesh/mesh.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace blockfsi::mesh
{

/// What cells are made of those of a mesh.
enum class Target : std::uint8_t
{
  same,                    ///< the same cells, of another order perhaps
  triangles,               ///< of each quadrilateral two, cut where the angles are better
  triangles_with_centres,  ///< of each quadrilateral four, about its middle
  quadrilaterals,          ///< of each triangle three, and of each quadrilateral four if there are triangles
  tetrahedra,              ///< of each hexahedron 5 or 6, prism 3, pyramid 2, without new corners
  hexahedra                ///< of each tetrahedron 4, prism 6, and of each hexahedron 8 if there are others
};

/// Moves a point x [m], shape (dim), of a boundary with this name to where the boundary really is.
using Projection = std::function<void(std::string_view boundary, std::span<double> x)>;

struct Conversion
{
  Target to = Target::same;
  int order = 0;  ///< of the new cells; 0: as before
  /// Called once for every node on a boundary that was not a node before; may be empty.
  Projection project;
};

/// A mesh made of another.
struct Converted
{
  Mesh mesh;
  std::vector<double> x;             ///< [m], shape (node_count, dim)
  std::vector<std::int32_t> parent;  ///< cell that each cell is a part of, shape (cell_count)
};

/// Cuts the cells of a whole mesh at coordinates x [m], shape (node_count, dim), into cells of another shape
/// or makes them anew of another order. New nodes lie where the polynomial of the old cell has them: corners
/// keep their coordinates bit for bit, and a boundary keeps its geometry up to what the new order can follow.
/// Cells share nodes exactly where they touch. Blocks, regions and boundaries are carried over; new cells
/// follow in the order of the old ones. A cell that is valid may have parts that are not, if it is curved
/// much: certify the result. Throws Error if the mesh is one process's share of a larger one, if it holds
/// cells that cannot be so converted, or for an order outside 1..max_order.
Converted convert(const Mesh& mesh, std::span<const double> x, const Conversion& conversion);

}  // namespace blockfsi::mesh
