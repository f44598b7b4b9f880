#pragma once

#include "element/line.hpp"
#include "mesh/mesh.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

/// A mesh with its coordinates, made without the block layer.
struct SampleMesh
{
  blockfsi::mesh::Mesh mesh;
  std::vector<double> x;
};

/// A map of the unit square to itself that makes waves of its inner lines.
inline std::array<double, 2> waves(double a, double b)
{
  const double wave = 0.06 * std::sin(2.0 * std::numbers::pi * a) * std::sin(2.0 * std::numbers::pi * b);
  return {a + wave, b - wave};
}

/// The unit square cut into columns by rows cells, every node moved by `map`; cell (i, j) has number
/// i + j columns, its row is its block. With `turned`, each cell's own axes are turned by a different number
/// of quarters, so that neighbours count their common side in opposite directions.
inline SampleMesh structured(int order, int columns, int rows,
                             const std::function<std::array<double, 2>(double, double)>& map,
                             bool turned = false)
{
  const std::vector<double> line = blockfsi::element::lobatto(order);
  const int width = columns * order + 1;
  const int height = rows * order + 1;
  SampleMesh sample;
  sample.mesh.order = order;
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i)
    {
      const int column = i / order;
      const int row = j / order;
      const auto [x, y] = map((column + line[i % order]) / columns, (row + line[j % order]) / rows);
      sample.x.insert(sample.x.end(), {x, y});
      sample.mesh.lattice.push_back(i + j * width);
    }
  sample.mesh.local_node_count = sample.mesh.lattice.size();
  sample.mesh.runs = {{blockfsi::element::Shape::quadrilateral, 0, columns * rows, 0}};
  sample.mesh.owner.assign(sample.mesh.lattice.size(), 0);
  for (int c = 0; c < columns * rows; ++c)
  {
    const int first = (c % columns) * order + (c / columns) * order * width;
    for (int j = 0; j <= order; ++j)
      for (int i = 0; i <= order; ++i)
      {
        int a = i;
        int b = j;
        for (int quarter = 0; turned && quarter < c % 4; ++quarter)
        {
          const int before = a;
          a = order - b;
          b = before;
        }
        sample.mesh.cells.push_back(first + a + b * width);
      }
    sample.mesh.cell_block.push_back(c / columns);
    sample.mesh.cell_number.push_back(c);
  }
  sample.mesh.total_cell_count = columns * rows;
  sample.mesh.total_node_count = width * height;
  return sample;
}
