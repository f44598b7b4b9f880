#include "mesh/mesh.hpp"

namespace blockfsi::mesh
{

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
