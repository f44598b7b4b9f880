#include "block/face_plan.hpp"

#include "block/numbering.hpp"

#include <algorithm>

namespace blockfsi::block
{

EdgeParameters edge_parameters(const Skeleton& skeleton, const PlacedFace& face)
{
  EdgeParameters parameters;
  const auto edges = element::edges(face.shape);
  for (std::size_t e = 0; e < edges.size(); ++e)
    parameters.push_back(
        directed_parameters(skeleton, skeleton.edges[face.edges[e]], face.points[edges[e][0]]));
  return parameters;
}

BlockPlan face_plan(const Skeleton& skeleton, const PlacedFace& face)
{
  BlockPlan plan;
  plan.grid = face_grid(face, skeleton.order);
  std::copy(face.points.begin(), face.points.end(), plan.corners.begin());
  const auto sides = element::sides(face.shape);
  for (std::size_t side = 0; side < sides.size(); ++side)
  {
    const PlacedEdge& edge = skeleton.edges[face.edges[side]];
    plan.sides.push_back(edge_numbers(edge));
    if (edge.a != face.points[sides[side].corners[0]])
      std::reverse(plan.sides.back().begin(), plan.sides.back().end());
  }
  const Grid inner = interior(plan.grid);
  auto node = static_cast<std::int32_t>(face.first);
  for (int j = 0; face.count > 0 && j < row_count(inner, 0); ++j)
  {
    const int length = row_length(inner, j, 0);
    plan.rows.push_back({j + 1, 0, 1, length + 1, node});
    node += length;
  }
  set_reference(edge_parameters(skeleton, face), skeleton.order, 0, plan);
  return plan;
}

}  // namespace blockfsi::block
