#pragma once

#include "block/connect.hpp"
#include "block/layout.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace blockfsi::block
{

/// A flat piece of what blocks are made of: a point, a piece of an edge or of a face.
struct Tile
{
  enum class Of : std::uint8_t
  {
    point,
    edge,
    face
  };
  Of of = Of::face;
  int entity = 0;                      ///< point, edge or face that it is part of
  std::array<std::int32_t, 4> node{};  ///< of the skeleton, along the edge or round the face as that has them
  int count = 0;                       ///< of its nodes
  double curvature = 0.0;              ///< how far what it stands for is off at most, by the nodes around [m]
};

/// All points; then in the plane the outer edges; in space the inner edges, of which no outer face has a
/// part, and the outer faces. What is curved comes in up to 16 pieces a direction where its number of steps
/// allows that; a straight edge is one piece, and so is a face in one plane between straight edges.
std::vector<Tile> make_tiles(const Layout& layout, const Skeleton& skeleton);

}  // namespace blockfsi::block
