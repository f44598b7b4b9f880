#pragma once

#include "element/table.hpp"
#include "mesh/mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::output
{

/// Takes nodal fields to the other lattice of each cell: nodes of meshes are warped, those of files
/// equispaced.
class LatticeChange
{
public:
  /// The mesh must outlive this.
  LatticeChange(const mesh::Mesh& mesh, element::NodeKind from, element::NodeKind to);

  /// values has shape (node_count, components), the result (node_count, width) with zeros behind the
  /// components. A node gets the same value, up to rounding, from each of its cells, because on a side only
  /// the nodes of the side count and both lattices are symmetric.
  std::vector<double> operator()(std::span<const double> values, int components, int width) const;

private:
  const mesh::Mesh& mesh_;
  std::vector<std::vector<double>> maps_;  ///< one per run; none where both lattices are the same
};

/// How the cells of a pyramid of order p >= 2 become hexahedra whose top is collapsed to the apex. In X = xi
/// / (1 - zeta), Y = eta / (1 - zeta), zeta its functions are polynomials of degree p in each, so that
/// nothing is lost.
struct CollapsedPyramid
{
  explicit CollapsedPyramid(int order);

  int order = 2;
  /// What stands at each point of the hexahedron's lattice: a node of the pyramid's lattice, or -1 - m for
  /// extra point m.
  std::vector<std::int32_t> hexahedron;
  /// Points that the pyramid's lattice does not have, in the hexahedron's coordinates X, Y, zeta.
  std::vector<element::Point> extra;
};

}  // namespace blockfsi::output
