#pragma once

#include "block/grading.hpp"
#include "block/layout.hpp"
#include "geometry/point.hpp"

#include <optional>
#include <string>

namespace blockfsi::block
{

/// Blocks of the plane drawn along a vector: quadrilaterals become hexahedra, triangles prisms.
struct Extrusion
{
  std::string name;      ///< of the new piece; points "NAME ... 0" at the start and "NAME ... 1" at the end
  std::string of;        ///< of the piece that is extruded
  geometry::Point by{};  ///< [m]
  int divisions = 1;     ///< cells along the vector
  std::optional<Grading> grading;
  Location where;
};

/// Blocks of the plane turned about an axis in that plane. Quadrilaterals become hexahedra, those with a side
/// on the axis prisms (all sides of whose triangles have the same number of cells), triangles prisms.
struct Revolution
{
  std::string name;  ///< points "NAME ... k" at the k-th section
  std::string of;
  geometry::Point center{};  ///< a point of the axis [m]
  geometry::Point axis{0.0, 1.0, 0.0};
  double angle = 360.0;  ///< right-handed [degrees]; 360: all round
  int sectors = 4;       ///< blocks around
  int around = 4;        ///< cells along each of them
  Location where;
};

/// The blocks in space that a piece of blocks of the plane sweeps. Boundaries of the piece become boundaries
/// of the same names with NAME instead of the piece's; "NAME first" and "NAME last" are the piece at the
/// ends, unless it goes all round. Holes of lattices become the boundaries "NAME hole 1", .... Throws Error
/// where the vector lies in the plane, for blocks that touch the axis in a point or lie on both sides of it,
/// and for sectors of 180 degrees and more.
Layout extruded(const Layout& base, const Extrusion& extrusion);
Layout revolved(const Layout& base, const Revolution& revolution);

}  // namespace blockfsi::block
