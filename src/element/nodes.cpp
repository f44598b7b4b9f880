#include "element/nodes.hpp"

#include "core/error.hpp"
#include "element/line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <span>

namespace blockfsi::element
{

namespace
{

/// Steps from the sides of a simplex, and barycentric coordinates, of which the first dimension + 1 count.
using Steps = std::array<int, 4>;
using Barycentric = std::array<double, 4>;

Barycentric simplex_node(std::span<const double> line, int corners, const Steps& steps);

/// Node of the side opposite to a corner, seen from the whole simplex.
Barycentric side_node(std::span<const double> line, int corners, const Steps& steps, int corner)
{
  Steps others{};
  for (int c = 0, k = 0; c < corners; ++c)
    if (c != corner)
      others[k++] = steps[c];
  const Barycentric of_side = simplex_node(line, corners - 1, others);
  Barycentric result{};
  for (int c = 0, k = 0; c < corners; ++c)
    if (c != corner)
      result[c] = of_side[k++];
  return result;
}

/// The mean of the nodes that the sides have for the remaining steps, weighted by the line's node at the sum
/// of these steps (Isaac 2020), for descending steps.
Barycentric sorted_node(std::span<const double> line, int corners, const Steps& steps)
{
  const int n = std::accumulate(steps.begin(), steps.begin() + corners, 0);
  Barycentric sum{};
  double weights = 0.0;
  for (int c = 0; c < corners; ++c)
  {
    // The line of a side has fewer steps where the point is away from the side.
    const std::vector<double> below = lobatto(std::max(n - steps[c], 1));
    const double weight = line[n - steps[c]];
    if (steps[c] == n)
      continue;
    const Barycentric of_side = side_node(below, corners, steps, c);
    for (int k = 0; k < corners; ++k)
      sum[k] += weight * of_side[k];
    weights += weight;
  }
  for (int k = 0; k < corners; ++k)
    sum[k] /= weights;
  // Equal steps mean equal coordinates: rounding must not tell the corners apart.
  for (int begin = 0, end = 0; begin < corners; begin = end)
  {
    double total = 0.0;
    for (end = begin; end < corners && steps[end] == steps[begin]; ++end)
      total += sum[end];
    std::fill(sum.begin() + begin, sum.begin() + end, total / (end - begin));
  }
  return sum;
}

/// Node of a simplex with line.size() - 1 steps: computed for descending steps, so that every permutation of
/// the corners gives the same numbers.
Barycentric simplex_node(std::span<const double> line, int corners, const Steps& steps)
{
  if (corners == 1)
    return {1.0};
  if (corners == 2)
    return {line[steps[0]], line[steps[1]]};
  // On a side the node is the side's own, bit for bit.
  for (int c = 0; c < corners; ++c)
    if (steps[c] == 0)
      return side_node(line, corners, steps, c);
  std::array<int, 4> order = {0, 1, 2, 3};
  std::stable_sort(order.begin(), order.begin() + corners, [&](int a, int b) { return steps[a] > steps[b]; });
  Steps sorted{};
  for (int c = 0; c < corners; ++c)
    sorted[c] = steps[order[c]];
  const Barycentric node = sorted_node(line, corners, sorted);
  Barycentric result{};
  for (int c = 0; c < corners; ++c)
    result[order[c]] = node[c];
  return result;
}

Point triangle_node(std::span<const double> line, int i, int j)
{
  const int n = static_cast<int>(line.size()) - 1;
  const Barycentric node = simplex_node(line, 3, {n - i - j, i, j});
  return {node[1], node[2], 0.0};
}

/// On a level k of the lattice the height of an inner node is the mean of its heights on the triangles in
/// both directions; its place within the square of that height is the one that the triangles have. The mean
/// gives a Lebesgue constant of 10 at order 8, the transfinite sum (less the height on the edges) one of 20.
Point pyramid_node(std::span<const double> line, int i, int j, int k)
{
  const int n = static_cast<int>(line.size()) - 1;
  if (k == n)
    return {0.0, 0.0, 1.0};
  if (k == 0)
    return {line[i], line[j], 0.0};
  const int m = n - k;
  const Point along_xi = triangle_node(line, i, k);
  const Point along_eta = triangle_node(line, j, k);
  // On a triangle its own numbers, bit for bit.
  if (j == 0)
    return {along_xi[0], 0.0, along_xi[1]};
  if (i == 0)
    return {0.0, along_eta[0], along_eta[1]};
  const double height = i == m ? along_eta[1] : j == m ? along_xi[1] : 0.5 * (along_xi[1] + along_eta[1]);
  const double width = 1.0 - height;
  const double xi = i == m ? width : j == m ? along_xi[0] : along_xi[0] / (1.0 - along_xi[1]) * width;
  const double eta = j == m ? width : i == m ? along_eta[0] : along_eta[0] / (1.0 - along_eta[1]) * width;
  return {xi, eta, height};
}

Point node(Shape shape, std::span<const double> line, const LatticePoint& point)
{
  const auto [i, j, k] = point;
  const int n = static_cast<int>(line.size()) - 1;
  switch (shape)
  {
  case Shape::segment:
    return {line[i], 0.0, 0.0};
  case Shape::triangle:
    return triangle_node(line, i, j);
  case Shape::quadrilateral:
    return {line[i], line[j], 0.0};
  case Shape::tetrahedron:
  {
    const Barycentric of = simplex_node(line, 4, {n - i - j - k, i, j, k});
    return {of[1], of[2], of[3]};
  }
  case Shape::hexahedron:
    return {line[i], line[j], line[k]};
  case Shape::prism:
  {
    const Point of = triangle_node(line, i, j);
    return {of[0], of[1], line[k]};
  }
  case Shape::pyramid:
    return pyramid_node(line, i, j, k);
  }
  return {};
}

}  // namespace

std::vector<Point> nodes(Shape shape, int order)
{
  if (order < 1 || order > largest_order)
    throw Error(fmt::format("the order of a {} is {}; choose an order from 1 to {}", name(shape), order,
                            largest_order));
  const std::vector<double> line = lobatto(order);
  std::vector<Point> result;
  result.reserve(lattice_size(shape, order));
  for (const LatticePoint& point : lattice_points(shape, order))
    result.push_back(node(shape, line, point));
  return result;
}

std::vector<Point> equispaced_nodes(Shape shape, int order)
{
  std::vector<Point> result;
  result.reserve(lattice_size(shape, order));
  for (const auto [i, j, k] : lattice_points(shape, order))
    result.push_back(
        {static_cast<double>(i) / order, static_cast<double>(j) / order, static_cast<double>(k) / order});
  return result;
}

}  // namespace blockfsi::element
