#pragma once

#include "element/shape.hpp"

#include <optional>

namespace blockfsi::output
{

/// Number of Gmsh's element of the full order, 1..8, of a shape (GmshDefines.h).
int gmsh_type(element::Shape shape, int order);

struct GmshType
{
  element::Shape shape = element::Shape::segment;
  int order = 1;
};

/// Shape and order of the elements of a number; none if it is not one of the above.
std::optional<GmshType> find_gmsh_type(int number);

/// Number of Gmsh's element that is a single point.
inline constexpr int gmsh_point = 15;

}  // namespace blockfsi::output
