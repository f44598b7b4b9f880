#pragma once

#include "element/quadrature.hpp"
#include "element/table.hpp"
#include "structured.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

/// A cell by its corners, as in element/shape.hpp.
struct CornerCell
{
  blockfsi::element::Shape shape;
  std::vector<int> corners;
};

/// Nodes of a side of a cell, in its own order.
inline std::vector<std::int32_t> side_nodes(const blockfsi::mesh::Mesh& mesh, blockfsi::mesh::Side side)
{
  std::vector<std::int32_t> nodes;
  for (const std::int32_t position :
       blockfsi::element::side_lattice(mesh.shape(side.cell), mesh.order, side.side))
    nodes.push_back(mesh.cell(side.cell)[position]);
  return nodes;
}

/// How many sides have each set of nodes.
inline std::map<std::vector<std::int32_t>, int> count_sides(const blockfsi::mesh::Mesh& mesh)
{
  std::map<std::vector<std::int32_t>, int> counts;
  for (std::int32_t c = 0; c < static_cast<std::int32_t>(mesh.cell_count()); ++c)
    for (std::int32_t s = 0; s < static_cast<std::int32_t>(blockfsi::element::sides(mesh.shape(c)).size());
         ++s)
    {
      std::vector<std::int32_t> nodes = side_nodes(mesh, {c, s});
      std::sort(nodes.begin(), nodes.end());
      ++counts[nodes];
    }
  return counts;
}

/// A mesh of order 1 of cells, those of one shape following each other; every cell is a block, all sides of
/// one cell only are the boundary "outer".
inline SampleMesh linear_mesh(int dim, const std::vector<std::array<double, 3>>& points,
                              const std::vector<CornerCell>& cells)
{
  using namespace blockfsi;
  SampleMesh sample;
  mesh::Mesh& made = sample.mesh;
  made.dim = dim;
  made.order = 1;
  for (const auto& point : points)
    sample.x.insert(sample.x.end(), point.begin(), point.begin() + dim);
  made.local_node_count = points.size();
  for (const CornerCell& cell : cells)
  {
    const auto number = static_cast<std::int32_t>(made.cell_block.size());
    if (made.runs.empty() || made.runs.back().shape != cell.shape)
      made.runs.push_back({cell.shape, number, 0, static_cast<std::int64_t>(made.cells.size())});
    ++made.runs.back().count;
    made.cell_block.push_back(number);
    made.block_names.push_back("block " + std::to_string(number));
    made.block_regions.push_back("fluid");
    for (const element::LatticePoint point : element::lattice_points(cell.shape, 1))
      for (std::size_t c = 0; c < cell.corners.size(); ++c)
      {
        const auto& corner = element::corners(cell.shape)[c];
        if (corner[0] == point[0] && corner[1] == point[1] && corner[2] == point[2])
          made.cells.push_back(cell.corners[c]);
      }
  }
  made.total_cell_count = static_cast<std::int64_t>(made.cell_count());
  made.total_node_count = static_cast<std::int64_t>(points.size());
  const auto counts = count_sides(made);
  for (std::int32_t c = 0; c < static_cast<std::int32_t>(made.cell_count()); ++c)
    for (std::int32_t s = 0; s < static_cast<std::int32_t>(element::sides(made.shape(c)).size()); ++s)
    {
      std::vector<std::int32_t> nodes = side_nodes(made, {c, s});
      std::sort(nodes.begin(), nodes.end());
      if (counts.at(nodes) == 1)
        made.boundaries["outer"].push_back({c, s});
    }
  return sample;
}

/// Volume (area) of a mesh.
inline double volume(const blockfsi::mesh::Mesh& mesh, const std::vector<double>& x)
{
  using namespace blockfsi;
  double sum = 0.0;
  for (const mesh::CellRun& run : mesh.runs)
  {
    const element::CellRule rule = element::quadrature(run.shape, mesh.dim * mesh.order + mesh.dim);
    const element::CellTable table = element::tabulate(run.shape, mesh.order, rule.points, 1);
    for (std::int32_t c = run.first; c < run.first + run.count; ++c)
      for (int q = 0; q < table.point_count; ++q)
      {
        std::array<std::array<double, 3>, 3> j{};
        j[2][2] = 1.0;
        for (int d = 0; d < mesh.dim; ++d)
          for (int k = 0; k < mesh.dim; ++k)
          {
            j[d][k] = 0.0;
            for (int n = 0; n < table.node_count; ++n)
              j[d][k] += table.first[d][q * table.node_count + n] * x[mesh.dim * mesh.cell(c)[n] + k];
          }
        sum += rule.weights[q] * (j[0][0] * (j[1][1] * j[2][2] - j[1][2] * j[2][1]) -
                                  j[0][1] * (j[1][0] * j[2][2] - j[1][2] * j[2][0]) +
                                  j[0][2] * (j[1][0] * j[2][1] - j[1][1] * j[2][0]));
      }
  }
  return sum;
}

/// Points (i, j, k) of a lattice of cubes, i fastest.
inline std::vector<std::array<double, 3>> cube_points(int nx, int ny, int nz)
{
  std::vector<std::array<double, 3>> points;
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i)
        points.push_back({1.0 * i, 1.0 * j, 1.0 * k});
  return points;
}

/// Corners of a cube of that lattice.
inline std::vector<int> cube_corners(int nx, int ny, int i, int j, int k)
{
  const auto at = [=](int a, int b, int c) { return i + a + (nx + 1) * (j + b + (ny + 1) * (k + c)); };
  return {at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0),
          at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)};
}

/// 2 x 2 x 2 cubes.
inline SampleMesh cubes()
{
  std::vector<CornerCell> cells;
  for (int c = 0; c < 8; ++c)
    cells.push_back({blockfsi::element::Shape::hexahedron, cube_corners(2, 2, c % 2, c / 2 % 2, c / 4)});
  return linear_mesh(3, cube_points(2, 2, 2), cells);
}

/// Three cubes in a row: a hexahedron, six pyramids about the middle, two prisms; and a tetrahedron on a
/// prism.
inline SampleMesh mixed_solids()
{
  using blockfsi::element::Shape;
  std::vector<std::array<double, 3>> points = cube_points(3, 1, 1);
  const std::vector<int> a = cube_corners(3, 1, 0, 0, 0);
  const std::vector<int> b = cube_corners(3, 1, 1, 0, 0);
  const std::vector<int> c = cube_corners(3, 1, 2, 0, 0);
  const int middle = static_cast<int>(points.size());
  points.push_back({1.5, 0.5, 0.5});
  const int peak = middle + 1;
  points.push_back({2.5, 0.4, 1.8});
  std::vector<CornerCell> cells = {{Shape::hexahedron, a}};
  // Bases counter-clockwise seen from the middle.
  for (const std::array<int, 4>& base :
       {std::array{0, 1, 2, 3}, {7, 6, 5, 4}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}})
    cells.push_back({Shape::pyramid, {b[base[0]], b[base[1]], b[base[2]], b[base[3]], middle}});
  cells.push_back({Shape::prism, {c[0], c[1], c[2], c[4], c[5], c[6]}});
  cells.push_back({Shape::prism, {c[0], c[2], c[3], c[4], c[6], c[7]}});
  cells.push_back({Shape::tetrahedron, {c[4], c[5], c[6], peak}});
  return linear_mesh(3, points, cells);
}

/// Two quadrilaterals and three triangles.
inline SampleMesh mixed_faces()
{
  using blockfsi::element::Shape;
  const std::vector<std::array<double, 3>> points = {{0, 0, 0}, {1, 0, 0},     {2, 0, 0},   {0, 1, 0},
                                                     {1, 1, 0}, {2.1, 1.1, 0}, {0.4, 2, 0}, {1.6, 1.9, 0}};
  return linear_mesh(2, points,
                     {{Shape::quadrilateral, {0, 1, 4, 3}},
                      {Shape::quadrilateral, {1, 2, 5, 4}},
                      {Shape::triangle, {3, 4, 6}},
                      {Shape::triangle, {4, 7, 6}},
                      {Shape::triangle, {4, 5, 7}}});
}
