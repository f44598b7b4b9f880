#include "output/msh_types.hpp"

#include "element/nodes.hpp"

#include <array>

namespace blockfsi::output
{

namespace
{

/// By shape and order.
constexpr std::array<std::array<int, element::largest_order>, element::shape_count> types{{
    {1, 8, 26, 27, 28, 62, 63, 64},         // segment
    {2, 9, 21, 23, 25, 42, 43, 44},         // triangle
    {3, 10, 36, 37, 38, 47, 48, 49},        // quadrilateral
    {4, 11, 29, 30, 31, 71, 72, 73},        // tetrahedron
    {5, 12, 92, 93, 94, 95, 96, 97},        // hexahedron
    {6, 13, 90, 91, 106, 107, 108, 109},    // prism
    {7, 14, 118, 119, 120, 121, 122, 123},  // pyramid
}};

}  // namespace

int gmsh_type(element::Shape shape, int order)
{
  return types[static_cast<std::size_t>(shape)][order - 1];
}

std::optional<GmshType> find_gmsh_type(int number)
{
  for (std::size_t shape = 0; shape < types.size(); ++shape)
    for (std::size_t k = 0; k < types[shape].size(); ++k)
      if (types[shape][k] == number)
        return GmshType{static_cast<element::Shape>(shape), static_cast<int>(k) + 1};
  return std::nullopt;
}

}  // namespace blockfsi::output
