#include "block/cell_sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace blockfsi::block
{

namespace
{

/// Skeleton number of the i-th cell corner of an edge.
std::int64_t corner(const Skeleton& skeleton, const PlacedEdge& edge, int i)
{
  if (i == 0)
    return edge.a;
  return i == edge.divisions ? edge.b : edge.first + static_cast<std::int64_t>(i) * skeleton.order - 1;
}

double distance(const Skeleton& skeleton, std::int64_t p, std::int64_t q)
{
  double square = 0.0;
  for (int c = 0; c < skeleton.dim; ++c)
    square += std::pow(skeleton.x[p * skeleton.dim + c] - skeleton.x[q * skeleton.dim + c], 2);
  return std::sqrt(square);
}

}  // namespace

std::vector<CellSizes> cell_sizes(const Skeleton& skeleton)
{
  std::vector<CellSizes> result;
  for (const PlacedEdge& edge : skeleton.edges)
  {
    CellSizes cells{skeleton.point_names[edge.a] + " - " + skeleton.point_names[edge.b], edge.divisions};
    for (int i = 0; i < edge.divisions; ++i)
    {
      const double size = distance(skeleton, corner(skeleton, edge, i), corner(skeleton, edge, i + 1));
      if (i == 0)
        cells.first = cells.smallest = cells.largest = cells.last = size;
      cells.ratio = std::max({cells.ratio, size / cells.last, cells.last / size});
      cells.smallest = std::min(cells.smallest, size);
      cells.largest = std::max(cells.largest, size);
      cells.last = size;
    }
    result.push_back(std::move(cells));
  }
  return result;
}

std::string table(const std::vector<CellSizes>& edges)
{
  std::size_t width = 4;
  for (const CellSizes& cells : edges)
    width = std::max(width, cells.edge.size());
  std::string text = fmt::format("{:<{}}  {:>6}  {:>11}  {:>11}  {:>13}\n", "edge", width, "cells",
                                 "first [m]", "last [m]", "largest ratio");
  for (const CellSizes& cells : edges)
    text += fmt::format("{:<{}}  {:>6}  {:>11.4g}  {:>11.4g}  {:>13.3f}\n", cells.edge, width, cells.count,
                        cells.first, cells.last, cells.ratio);
  return text;
}

}  // namespace blockfsi::block
