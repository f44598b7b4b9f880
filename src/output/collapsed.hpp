#pragma once

#include "output/draft.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::output
{

/// Whether a hexahedron, its points in the order of the lattice, has its whole top at one point, as pyramids
/// of order `degree` are written for VTK.
bool is_collapsed(std::span<const std::int32_t> points, int degree);

/// A pyramid that a file holds as collapsed hexahedron.
struct Collapsed
{
  std::vector<std::int32_t> points;  ///< of the hexahedron, in the order of its lattice
  std::int32_t block = 0;
  std::int64_t number = 0;
};

/// Adds these pyramids to the draft, whose other cells must be there. Points inside of triangles are those of
/// the cell on the other side, if there is one, and otherwise new ones, as those inside the pyramid; fields
/// get values there.
void add_collapsed(Draft& draft, std::span<const Collapsed> pyramids);

}  // namespace blockfsi::output
