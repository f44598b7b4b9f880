#pragma once

#include "block/grid.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace blockfsi::block
{

class Resampling;
class TriangleNodes;

/// Where the nodes within one block, or within one face, sit.
struct BlockPlan
{
  Grid grid;                                     ///< lattice of all nodes of the block
  std::array<std::int32_t, 8> corners{};         ///< skeleton numbers
  std::vector<std::vector<std::int32_t>> sides;  ///< skeleton numbers of the nodes of each side, in its order

  /// Graded coordinate of the lattice lines along each direction, where it depends on nothing else, shapes
  /// (steps[d] + 1).
  std::array<std::vector<double>, 3> lines;
  /// Else the graded reference coordinates of the nodes of `rows` (of `resampling` if there is one), row
  /// after row, shape (nodes, dimension).
  std::vector<double> reference;
  /// Of shapes with triangles: graded coordinates of the nodes of each side in its own directions, shape
  /// (size of the side, dimension of the side).
  std::vector<std::vector<double>> side_reference;
  /// Of triangles at orders above 2: where their nodes take the edges.
  std::shared_ptr<const TriangleNodes> triangle_nodes;
  /// Of solid shapes with triangles at orders above 2: their maps are evaluated at equal steps within each
  /// cell.
  std::shared_ptr<const Resampling> resampling;

  /// Consecutive inner nodes of a row that are placed: (begin, j, k) .. (end - 1, j, k).
  struct Row
  {
    std::int32_t j = 0;
    std::int32_t k = 0;
    std::int32_t begin = 0;
    std::int32_t end = 0;
    std::int32_t node = 0;  ///< place of the first of them in the coordinates
  };
  std::vector<Row> rows;  ///< k slowest, then j
};

/// Where the nodes of one process's share of a mesh sit: what `place` needs. It grows with the skeleton,
/// where opposite edges of blocks are graded alike.
struct Plan
{
  int dim = 2;
  /// Local nodes that belong to the skeleton and their skeleton numbers; both empty where the first local
  /// nodes are the skeleton.
  std::vector<std::int32_t> skeleton_node;
  std::vector<std::int64_t> skeleton_number;
  bool whole_skeleton = false;
  std::vector<BlockPlan> blocks;
  /// Memory of `place`, so that it allocates nothing; two threads need a copy of the plan each.
  mutable std::vector<double> work;
};

}  // namespace blockfsi::block
