#include "block/corner_graph.hpp"

#include "geometry/point.hpp"

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

std::vector<std::array<double, 3>> complement(std::span<const std::array<double, 3>> base, int dim)
{
  std::vector<geometry::Point> all(base.begin(), base.end());
  for (int axis = 0; axis < dim && static_cast<int>(all.size()) < dim; ++axis)
  {
    geometry::Point candidate{};
    candidate[axis] = 1.0;
    for (const geometry::Point& other : all)
      candidate = geometry::add_scaled(candidate, -geometry::dot(other, candidate), other);
    // The largest remainder of the axes is at least 1 / sqrt(dim); smaller ones come in for a later axis.
    if (const double size = geometry::norm(candidate); size > 0.5)
      all.push_back(geometry::scaled(1.0 / size, candidate));
  }
  return {all.begin() + static_cast<std::ptrdiff_t>(base.size()), all.end()};
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
