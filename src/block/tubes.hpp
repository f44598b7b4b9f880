#pragma once

#include "block/grading.hpp"
#include "block/layout.hpp"
#include "geometry/level_set.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace blockfsi::block
{

/// A network of tubes, such as vessels: segments between nodes, up to three of which meet at a node.
///
/// Each section across a tube is a disc of four inner and eight outer quadrilaterals (an O-grid); the blocks
/// between sections are hexahedra. Where three tubes meet, three half discs share the diameter between the
/// two poles of the joint, and the section of each tube is made of two of them (Antiga, Ene-Iordache,
/// Caverni, Cornalba & Remuzzi 2002). Corners on the wall lie where rays from the node meet the level set,
/// faces on the wall are projected onto it. Ends are flat.
struct Tubes
{
  struct Node
  {
    std::string name;
    geometry::Point x{};  ///< [m]
  };
  struct Segment
  {
    int a = 0;
    int b = 0;
    /// Sections between the ends, as parameters along the segment, ascending in (0, 1).
    std::vector<double> sections;
  };

  std::string name;
  std::string region;
  std::vector<Node> nodes;
  std::vector<Segment> segments;
  geometry::LevelSet wall{Expression()};  ///< negative inside
  double reach = 0.0;  ///< rays that do not meet the wall within this length are an error [m]
  double core = 0.5;   ///< size of the inner square relative to the distance of the wall, in (0, 1)
  int around = 2;      ///< cells along each eighth of a section
  int radial = 4;      ///< cells between the inner square and the wall
  std::optional<Grading> radial_grading;  ///< from the inner square to the wall
  double axial_size = 0.0;                ///< cells along the tubes are about so long [m]
  Location where;
};

/// Adds the blocks of a network to a layout of dimension 3. Boundaries: "NAME wall" and, for each node with
/// one tube, its own name. Throws Error for a node that no segment or more than three segments touch, for
/// segments of no length, sections out of order, and rays that do not meet the wall (naming node and
/// direction).
void add(Layout& layout, const Tubes& tubes);

}  // namespace blockfsi::block
