#include "mesh/mesh.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace blockfsi::mesh
{

std::vector<element::Shape> shapes_of(const Mesh& mesh)
{
  std::vector<element::Shape> shapes;
  for (const CellRun& run : mesh.runs)
  {
    if (element::dimension(run.shape) != mesh.dim)
      throw Error(fmt::format("a mesh in {} dimensions has cells of the shape {}, whose Jacobian has no sign",
                              mesh.dim, element::name(run.shape)));
    if (std::find(shapes.begin(), shapes.end(), run.shape) == shapes.end())
      shapes.push_back(run.shape);
  }
  return shapes;
}

int side_node(int order, int side, int k)
{
  const int n = order + 1;
  switch (side)
  {
  case 0:
    return k;
  case 1:
    return order + k * n;
  case 2:
    return k + order * n;
  default:
    return k * n;
  }
}

}  // namespace blockfsi::mesh
