#pragma once

#include "element/table.hpp"
#include "structured.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <vector>

inline constexpr std::array<blockfsi::element::Shape, 6> cell_shapes = {
    blockfsi::element::Shape::triangle,    blockfsi::element::Shape::quadrilateral,
    blockfsi::element::Shape::tetrahedron, blockfsi::element::Shape::hexahedron,
    blockfsi::element::Shape::prism,       blockfsi::element::Shape::pyramid};

using PointMap = std::function<blockfsi::element::Point(const blockfsi::element::Point&)>;

/// Coordinates of the nodes of a reference cell moved by `map`, shape (node_count, dim).
inline std::vector<double> place_nodes(blockfsi::element::Shape shape, int order, const PointMap& map)
{
  std::vector<double> x;
  for (const blockfsi::element::Point& node : blockfsi::element::nodes(shape, order))
  {
    const blockfsi::element::Point moved = map(node);
    x.insert(x.end(), moved.begin(), moved.begin() + blockfsi::element::dimension(shape));
  }
  return x;
}

/// A mesh of cells of one shape that share nothing, each with its own coordinates.
inline SampleMesh separate_cells(blockfsi::element::Shape shape, int order,
                                 const std::vector<std::vector<double>>& cells)
{
  SampleMesh sample;
  sample.mesh.dim = blockfsi::element::dimension(shape);
  sample.mesh.order = order;
  for (const std::vector<double>& x : cells)
    sample.x.insert(sample.x.end(), x.begin(), x.end());
  const std::size_t count = sample.x.size() / sample.mesh.dim;
  for (std::size_t n = 0; n < count; ++n)
    sample.mesh.cells.push_back(static_cast<std::int32_t>(n));
  sample.mesh.local_node_count = count;
  sample.mesh.runs = {{shape, 0, static_cast<std::int32_t>(cells.size()), 0}};
  sample.mesh.cell_block.assign(cells.size(), 0);
  sample.mesh.total_cell_count = static_cast<std::int64_t>(cells.size());
  sample.mesh.total_node_count = static_cast<std::int64_t>(count);
  return sample;
}

/// det J of a cell at each point of a table, by Lagrange functions.
inline std::vector<double> jacobians(const blockfsi::element::CellTable& table, int dim,
                                     const std::vector<double>& x)
{
  std::vector<double> result;
  for (int q = 0; q < table.point_count; ++q)
  {
    std::array<std::array<double, 3>, 3> j{};
    for (int d = 0; d < dim; ++d)
      for (int n = 0; n < table.node_count; ++n)
        for (int c = 0; c < dim; ++c)
          j[d][c] += table.first[d][q * table.node_count + n] * x[dim * n + c];
    if (dim == 2)
      j[2][2] = 1.0;
    result.push_back(j[0][0] * (j[1][1] * j[2][2] - j[1][2] * j[2][1]) -
                     j[0][1] * (j[1][0] * j[2][2] - j[1][2] * j[2][0]) +
                     j[0][2] * (j[1][0] * j[2][1] - j[1][1] * j[2][0]));
  }
  return result;
}
