#pragma once

#include "block/connect.hpp"

#include <string>
#include <vector>

namespace blockfsi::block
{

/// The cells along one edge as they came out, measured straight from corner to corner.
struct CellSizes
{
  std::string edge;       ///< "a - b"
  int count = 0;          ///< number of cells
  double first = 0.0;     ///< size of the cell at a [m]
  double last = 0.0;      ///< size of the cell at b [m]
  double smallest = 0.0;  ///< [m]
  double largest = 0.0;   ///< [m]
  double ratio = 1.0;     ///< the largest ratio of neighbouring cells, larger over smaller
};

/// The cells along every edge of a skeleton, in its order.
std::vector<CellSizes> cell_sizes(const Skeleton& skeleton);

/// A table with a line per edge, for people.
std::string table(const std::vector<CellSizes>& edges);

}  // namespace blockfsi::block
