#include "mesh/tensor.hpp"

#include "core/error.hpp"
#include "element/line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace blockfsi::mesh
{

void apply(const LineMap& along_xi, const LineMap& along_eta, std::span<const double> values,
           std::span<double> result)
{
  const int width = along_xi.rows;
  std::array<double, (max_order + 1) * (max_order + 1)> half;
  for (int j = 0; j < along_eta.columns; ++j)
  {
    double* const row = &half[j * width];
    std::fill_n(row, width, 0.0);
    for (int i = 0; i < along_xi.columns; ++i)
    {
      const double value = values[i + j * along_xi.columns];
      const double* const column = &along_xi.entries[i * width];
      for (int q = 0; q < width; ++q)
        row[q] += column[q] * value;
    }
  }
  for (int r = 0; r < along_eta.rows; ++r)
  {
    double* const row = &result[r * width];
    std::fill_n(row, width, 0.0);
    for (int j = 0; j < along_eta.columns; ++j)
    {
      const double factor = along_eta.entries[r + j * along_eta.rows];
      for (int q = 0; q < width; ++q)
        row[q] += factor * half[q + j * width];
    }
  }
}

LineMaps lagrange_maps(std::span<const double> nodes, std::span<const double> points)
{
  const element::Table table = element::lagrange(nodes, points);
  const int rows = table.point_count;
  const int columns = table.node_count;
  LineMap value{rows, columns, std::vector<double>(rows * columns)};
  LineMap derivative = value;
  for (int q = 0; q < rows; ++q)
    for (int i = 0; i < columns; ++i)
    {
      value.entries[q + i * rows] = table.value[q * columns + i];
      derivative.entries[q + i * rows] = table.first[q * columns + i];
    }
  return {std::move(value), std::move(derivative)};
}

void check_order(int order)
{
  if (order < 1 || order > max_order)
    throw Error(fmt::format("the order of the mesh is {}; choose an order from 1 to {}", order, max_order));
}

}  // namespace blockfsi::mesh
