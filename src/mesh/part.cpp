#include "mesh/part.hpp"

#include "element/table.hpp"

#include <numeric>
#include <utility>

namespace blockfsi::mesh
{

namespace
{

using element::Shape;

/// An entity is named by the nodes of its corners and, lest two arcs between the same corners be mixed up, by
/// the lowest of all its nodes but the corners.
Entities entities_of(Shape shape, int order)
{
  Entities result;
  const auto add = [&](Mean corners, std::vector<std::int32_t> nodes)
  {
    result.corners.push_back(corners);
    result.nodes.push_back(std::move(nodes));
  };
  for (int c = 0; c < element::corner_count(shape); ++c)
    add(static_cast<Mean>(1U << static_cast<unsigned>(c)), {});
  const auto edges = element::edges(shape);
  for (std::size_t e = 0; e < edges.size(); ++e)
    add(static_cast<Mean>(1U << static_cast<unsigned>(edges[e][0]) |
                          1U << static_cast<unsigned>(edges[e][1])),
        element::edge_lattice(shape, order, static_cast<int>(e)));
  for (int side = 0; side < static_cast<int>(element::sides(shape).size()) && element::dimension(shape) == 3;
       ++side)
    add(side_corners(shape, side), element::side_lattice(shape, order, side));
  add(all_corners(shape), {});
  return result;
}

/// Positions of the corners of a cell among its nodes.
std::vector<std::int32_t> corner_positions(Shape shape, int order)
{
  std::vector<std::int32_t> result;
  for (const element::Point& corner : element::corners(shape))
    result.push_back(static_cast<std::int32_t>(
        element::lattice_index(shape, order,
                               {static_cast<int>(corner[0]) * order, static_cast<int>(corner[1]) * order,
                                static_cast<int>(corner[2]) * order})));
  return result;
}

/// Reference coordinates in the cell of a node of its part.
std::vector<element::Point> node_points(Shape shape, const CellPart& part, int order)
{
  const element::CellTable table = element::tabulate(part.shape, 1, element::nodes(part.shape, order), 0);
  const std::vector<std::int32_t> corners = corner_positions(part.shape, 1);
  std::vector<element::Point> points(table.point_count);
  for (int q = 0; q < table.point_count; ++q)
    for (int c = 0; c < element::corner_count(part.shape); ++c)
    {
      const element::Point corner = mean_point(shape, part.corners[c]);
      for (int d = 0; d < 3; ++d)
        points[q][d] += table.value[q * table.node_count + corners[c]] * corner[d];
    }
  return points;
}

}  // namespace

std::vector<Weights> corner_weights(Shape shape, int order)
{
  std::vector<Weights> result;
  for (const auto [i, j, k] : element::lattice_points(shape, order))
  {
    Weights w{};
    const int a = order - i;
    const int b = order - j;
    const int c = order - k;
    const int rest = order - i - j;
    switch (shape)
    {
    case Shape::segment:
      w = {a, i};
      break;
    case Shape::triangle:
      w = {rest, i, j};
      break;
    case Shape::quadrilateral:
      w = {a * b, i * b, i * j, a * j};
      break;
    case Shape::tetrahedron:
      w = {rest - k, i, j, k};
      break;
    case Shape::hexahedron:
      w = {a * b * c, i * b * c, i * j * c, a * j * c, a * b * k, i * b * k, i * j * k, a * j * k};
      break;
    case Shape::prism:
      w = {rest * c, i * c, j * c, rest * k, i * k, j * k};
      break;
    case Shape::pyramid:
      // A level has c steps; where one of i, j is at its end, the weights are those of a triangle times c.
      w = {(c - i) * (c - j), i * (c - j), i * j, (c - i) * j, c > 0 ? c * k : 1};
      break;
    }
    int common = 0;
    for (const int weight : w)
      common = std::gcd(common, weight);
    for (int& weight : w)
      weight /= common;
    result.push_back(w);
  }
  return result;
}

PartTables::PartTables(Shape shape_, int order_, int new_order_)
    : shape(shape_), order(order_), new_order(new_order_), entities(entities_of(shape_, order_)),
      corners(corner_positions(shape_, order_))
{
}

const PartNodes& PartTables::of(const CellPart& part)
{
  const auto found = parts.find(part);
  if (found != parts.end())
    return found->second;
  PartNodes made;
  made.part = part;
  // A part that is the whole cell has the cell's own nodes, exactly.
  made.matrix = part == whole(shape).front()
                    ? element::resample(shape, {order}, {new_order})
                    : element::tabulate(shape, order, node_points(shape, part, new_order), 0).value;
  for (const Weights& weights : corner_weights(part.shape, new_order))
  {
    Mean touched = 0;
    for (int c = 0; c < element::corner_count(part.shape); ++c)
      if (weights[c] > 0)
        touched = static_cast<Mean>(touched | part.corners[c]);
    made.entity.push_back(entities.holding(touched));
  }
  for (const element::SideShape& side : element::sides(part.shape))
  {
    Mean touched = 0;
    for (int c = 0; c < element::corner_count(side.shape); ++c)
      touched = static_cast<Mean>(touched | part.corners[side.corners[c]]);
    made.side.push_back(touched);
  }
  return parts.emplace(part, std::move(made)).first->second;
}

}  // namespace blockfsi::mesh
