#pragma once

#include "block/connect.hpp"
#include "block/place.hpp"
#include "element/quadrature.hpp"
#include "element/table.hpp"
#include "geometry/point.hpp"
#include "mesh/mesh.hpp"

#include <span>
#include <string>
#include <vector>

namespace sample
{

namespace block = blockfsi::block;
namespace element = blockfsi::element;
namespace mesh = blockfsi::mesh;

/// A whole mesh with its coordinates.
struct Made
{
  mesh::Mesh mesh;
  std::vector<double> x;
};

inline Made make(const block::Layout& layout)
{
  const block::Skeleton skeleton = block::make_skeleton(layout);
  block::Connected connected = block::connect(layout, skeleton, "", {});
  std::vector<double> x = block::initial_nodes(connected, skeleton);
  return {std::move(connected.mesh), std::move(x)};
}

/// Tangents of cells of a shape at the points of a rule that integrates their Jacobian.
inline blockfsi::geometry::Point tangent(const element::CellTable& table, int q, int direction,
                                         std::span<const std::int32_t> nodes, const Made& made)
{
  blockfsi::geometry::Point t{};
  for (std::size_t n = 0; n < nodes.size(); ++n)
    for (int d = 0; d < made.mesh.dim; ++d)
      t[d] += table.first[direction][q * table.node_count + n] * made.x[nodes[n] * made.mesh.dim + d];
  return t;
}

/// Volume of a mesh of cells, in 2D its area: the integral of the Jacobian.
inline double volume(const Made& made)
{
  double sum = 0.0;
  for (const mesh::CellRun& run : made.mesh.runs)
  {
    const element::CellRule rule = element::quadrature(run.shape, 3 * made.mesh.order);
    const element::CellTable table = element::tabulate(run.shape, made.mesh.order, rule.points);
    for (int c = run.first; c < run.first + run.count; ++c)
      for (std::size_t q = 0; q < rule.weights.size(); ++q)
      {
        const int at = static_cast<int>(q);
        const auto u = tangent(table, at, 0, made.mesh.cell(c), made);
        const auto v = tangent(table, at, 1, made.mesh.cell(c), made);
        const double jacobian = made.mesh.dim == 2
                                    ? u[0] * v[1] - u[1] * v[0]
                                    : blockfsi::geometry::dot(tangent(table, at, 2, made.mesh.cell(c), made),
                                                              blockfsi::geometry::cross(u, v));
        sum += rule.weights[q] * jacobian;
      }
  }
  return sum;
}

/// Area of a boundary in space, in 2D its length.
inline double area(const Made& made, const std::string& boundary)
{
  double sum = 0.0;
  for (const mesh::Side& side : made.mesh.boundaries.at(boundary))
  {
    const element::Shape cell = made.mesh.shape(side.cell);
    const element::Shape shape = element::sides(cell)[side.side].shape;
    const auto local = element::side_lattice(cell, made.mesh.order, side.side);
    std::vector<std::int32_t> nodes;
    for (const std::int32_t n : local)
      nodes.push_back(made.mesh.cell(side.cell)[n]);
    const element::CellRule rule = element::quadrature(shape, 2 * made.mesh.order + 8);
    const element::CellTable table = element::tabulate(shape, made.mesh.order, rule.points);
    for (std::size_t q = 0; q < rule.weights.size(); ++q)
    {
      const auto u = tangent(table, static_cast<int>(q), 0, nodes, made);
      if (made.mesh.dim == 2)
        sum += rule.weights[q] * blockfsi::geometry::norm(u);
      else
        sum += rule.weights[q] * blockfsi::geometry::norm(blockfsi::geometry::cross(
                                     u, tangent(table, static_cast<int>(q), 1, nodes, made)));
    }
  }
  return sum;
}

}  // namespace sample
