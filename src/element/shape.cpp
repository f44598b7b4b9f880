#include "element/shape.hpp"

namespace blockfsi::element
{

namespace
{

using Edge = std::array<std::int8_t, 2>;
using Corner = std::array<double, 3>;

constexpr std::array<Edge, 1> segment_edges{{{0, 1}}};
constexpr std::array<Edge, 3> triangle_edges{{{0, 1}, {1, 2}, {0, 2}}};
constexpr std::array<Edge, 4> quadrilateral_edges{{{0, 1}, {1, 2}, {3, 2}, {0, 3}}};
constexpr std::array<Edge, 6> tetrahedron_edges{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};
constexpr std::array<Edge, 12> hexahedron_edges{
    {{0, 1}, {1, 2}, {3, 2}, {0, 3}, {4, 5}, {5, 6}, {7, 6}, {4, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
constexpr std::array<Edge, 9> prism_edges{
    {{0, 1}, {1, 2}, {0, 2}, {3, 4}, {4, 5}, {3, 5}, {0, 3}, {1, 4}, {2, 5}}};
constexpr std::array<Edge, 8> pyramid_edges{{{0, 1}, {1, 2}, {3, 2}, {0, 3}, {0, 4}, {1, 4}, {2, 4}, {3, 4}}};

constexpr auto S = Shape::segment;
constexpr auto T = Shape::triangle;
constexpr auto Q = Shape::quadrilateral;

constexpr std::array<SideShape, 3> triangle_sides{{{S, {0, 1}, true}, {S, {1, 2}, true}, {S, {0, 2}, false}}};
constexpr std::array<SideShape, 4> quadrilateral_sides{
    {{S, {0, 1}, true}, {S, {1, 2}, true}, {S, {3, 2}, false}, {S, {0, 3}, false}}};
constexpr std::array<SideShape, 4> tetrahedron_sides{
    {{T, {0, 1, 2}, false}, {T, {0, 1, 3}, true}, {T, {1, 2, 3}, true}, {T, {0, 2, 3}, false}}};
constexpr std::array<SideShape, 6> hexahedron_sides{{{Q, {0, 1, 2, 3}, false},
                                                     {Q, {0, 1, 5, 4}, true},
                                                     {Q, {1, 2, 6, 5}, true},
                                                     {Q, {3, 2, 6, 7}, false},
                                                     {Q, {0, 3, 7, 4}, false},
                                                     {Q, {4, 5, 6, 7}, true}}};
constexpr std::array<SideShape, 5> prism_sides{{{T, {0, 1, 2}, false},
                                                {Q, {0, 1, 4, 3}, true},
                                                {Q, {1, 2, 5, 4}, true},
                                                {Q, {0, 2, 5, 3}, false},
                                                {T, {3, 4, 5}, true}}};
constexpr std::array<SideShape, 5> pyramid_sides{{{Q, {0, 1, 2, 3}, false},
                                                  {T, {0, 1, 4}, true},
                                                  {T, {1, 2, 4}, true},
                                                  {T, {3, 2, 4}, false},
                                                  {T, {0, 3, 4}, false}}};

constexpr std::array<Corner, 2> segment_corners{{{0, 0, 0}, {1, 0, 0}}};
constexpr std::array<Corner, 3> triangle_corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
constexpr std::array<Corner, 4> tetrahedron_corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr std::array<Corner, 8> hexahedron_corners{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
constexpr std::array<Corner, 6> prism_corners{
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};
constexpr std::array<Corner, 5> pyramid_corners{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}}};

}  // namespace

int dimension(Shape shape)
{
  switch (shape)
  {
  case Shape::segment:
    return 1;
  case Shape::triangle:
  case Shape::quadrilateral:
    return 2;
  default:
    return 3;
  }
}

int corner_count(Shape shape)
{
  return static_cast<int>(corners(shape).size());
}

std::span<const Edge> edges(Shape shape)
{
  switch (shape)
  {
  case Shape::segment:
    return segment_edges;
  case Shape::triangle:
    return triangle_edges;
  case Shape::quadrilateral:
    return quadrilateral_edges;
  case Shape::tetrahedron:
    return tetrahedron_edges;
  case Shape::hexahedron:
    return hexahedron_edges;
  case Shape::prism:
    return prism_edges;
  case Shape::pyramid:
    return pyramid_edges;
  }
  return {};
}

std::span<const SideShape> sides(Shape shape)
{
  switch (shape)
  {
  case Shape::segment:
    return {};
  case Shape::triangle:
    return triangle_sides;
  case Shape::quadrilateral:
    return quadrilateral_sides;
  case Shape::tetrahedron:
    return tetrahedron_sides;
  case Shape::hexahedron:
    return hexahedron_sides;
  case Shape::prism:
    return prism_sides;
  case Shape::pyramid:
    return pyramid_sides;
  }
  return {};
}

std::span<const Corner> corners(Shape shape)
{
  switch (shape)
  {
  case Shape::segment:
    return segment_corners;
  case Shape::triangle:
    return triangle_corners;
  case Shape::quadrilateral:
    return std::span(hexahedron_corners).first(4);
  case Shape::tetrahedron:
    return tetrahedron_corners;
  case Shape::hexahedron:
    return hexahedron_corners;
  case Shape::prism:
    return prism_corners;
  case Shape::pyramid:
    return pyramid_corners;
  }
  return {};
}

std::string_view name(Shape shape)
{
  constexpr std::array<std::string_view, shape_count> names = {
      "segment", "triangle", "quadrilateral", "tetrahedron", "hexahedron", "prism", "pyramid"};
  return names[static_cast<std::size_t>(shape)];
}

}  // namespace blockfsi::element
