#include "output/vtk_types.hpp"

#include "core/error.hpp"
#include "element/lattice.hpp"
#include "element/nodes.hpp"
#include "output/node_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace blockfsi::output
{

namespace
{

using element::Shape;

constexpr int any_degree = 0;

struct Known
{
  int number;
  Shape shape;
  int degree;
};

/// Numbers of vtkCellType.h.
constexpr std::array<Known, 17> known_types{{{3, Shape::segment, 1},
                                             {5, Shape::triangle, 1},
                                             {9, Shape::quadrilateral, 1},
                                             {10, Shape::tetrahedron, 1},
                                             {12, Shape::hexahedron, 1},
                                             {13, Shape::prism, 1},
                                             {14, Shape::pyramid, 1},
                                             {21, Shape::segment, 2},
                                             {22, Shape::triangle, 2},
                                             {24, Shape::tetrahedron, 2},
                                             {28, Shape::quadrilateral, 2},
                                             {68, Shape::segment, any_degree},
                                             {69, Shape::triangle, any_degree},
                                             {70, Shape::quadrilateral, any_degree},
                                             {71, Shape::tetrahedron, any_degree},
                                             {72, Shape::hexahedron, any_degree},
                                             {73, Shape::prism, any_degree}}};

std::vector<std::int32_t> order_of(Shape shape, int degree)
{
  if (shape != Shape::pyramid)
    return vtk_order(shape, degree);
  return {0, 1, 3, 2, 4};  // only the linear one: its corners
}

}  // namespace

VtkType vtk_type(Shape shape, int order)
{
  const Shape written = shape == Shape::pyramid && order > 1 ? Shape::hexahedron : shape;
  const int degree = order == 1 ? 1 : any_degree;
  const auto* const found =
      std::find_if(known_types.begin(), known_types.end(),
                   [=](const Known& known) { return known.shape == written && known.degree == degree; });
  return {written, order, static_cast<std::uint8_t>(found->number), order_of(written, order)};
}

VtkType read_vtk_type(int number, std::int64_t node_count)
{
  const auto* const found = std::find_if(known_types.begin(), known_types.end(),
                                         [=](const Known& known) { return known.number == number; });
  if (found == known_types.end())
    throw Error(fmt::format("cells of VTK type {} are not supported; convert them to linear or Lagrange "
                            "triangles, quadrilaterals, tetrahedra, hexahedra, wedges or linear pyramids",
                            number));
  const int first = found->degree == any_degree ? 1 : found->degree;
  const int last = found->degree == any_degree ? element::largest_order : found->degree;
  for (int degree = first; degree <= last; ++degree)
    if (element::lattice_size(found->shape, degree) == node_count)
      return {found->shape, degree, static_cast<std::uint8_t>(number), order_of(found->shape, degree)};
  throw Error(fmt::format("a {} of VTK type {} cannot have {} nodes (orders up to {} in all directions)",
                          element::name(found->shape), number, node_count, element::largest_order));
}

}  // namespace blockfsi::output
