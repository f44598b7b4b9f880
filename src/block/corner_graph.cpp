#include "block/corner_graph.hpp"

#include <algorithm>

namespace blockfsi::block
{

std::vector<int> unknown_numbers(const CornerGraph& graph)
{
  std::vector<int> numbers = {0};
  for (const Corner& corner : graph.corners)
    numbers.push_back(numbers.back() + corner.freedom);
  return numbers;
}

void displace_corners(const CornerGraph& graph, const double* d, const double* y, double* U)
{
  const int dim = graph.dim;
  for (const Corner& corner : graph.corners)
  {
    std::fill_n(U, dim, 0.0);
    for (const Share& share : corner.led)
      for (int i = 0; i < dim; ++i)
        U[i] += share.weight * d[share.node * dim + i];
    for (int k = 0; k < corner.freedom; ++k, ++y)
      for (int i = 0; i < dim; ++i)
        U[i] += corner.direction[k][i] * *y;
    U += dim;
  }
}

}  // namespace blockfsi::block
