#pragma once

#include "block/connect.hpp"
#include "block/layout.hpp"

#include <array>
#include <vector>

namespace blockfsi::block
{

/// An edge of blocks as a chain of polynomials, for pictures.
struct EdgeLine
{
  int pieces = 1;
  /// Gauss-Lobatto nodes of each piece, ends shared [m], shape (pieces * order + 1).
  std::vector<std::array<double, 3>> x;
  /// Where cells end, without the points of the blocks [m], shape (divisions - 1).
  std::vector<std::array<double, 3>> cell_ends;
};

/// Every edge of a skeleton of this layout on its own curve, in the order of the skeleton: straight edges in
/// one piece, others in `pieces` of equal length, each of this order. How fine the mesh is does not matter.
std::vector<EdgeLine> edge_lines(const Layout& layout, const Skeleton& skeleton, int order, int pieces);

}  // namespace blockfsi::block
