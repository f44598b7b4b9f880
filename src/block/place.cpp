#include "block/place.hpp"

#include "block/blend.hpp"

#include <algorithm>
#include <cassert>

namespace blockfsi::block
{

void place(const Plan& plan, std::span<const double> skeleton_x, std::span<double> x)
{
  const int dim = plan.dim;
  if (plan.whole_skeleton)
    std::copy(skeleton_x.begin(), skeleton_x.end(), x.begin());
  else
    for (std::size_t k = 0; k < plan.skeleton_node.size(); ++k)
      for (int c = 0; c < dim; ++c)
        x[dim * plan.skeleton_node[k] + c] = skeleton_x[dim * plan.skeleton_number[k] + c];
  for (const BlockPlan& block : plan.blocks)
    blend(block, dim, skeleton_x.data(), plan.work.data(), x.data());
}

std::vector<double> initial_nodes(const Connected& connected, const Skeleton& skeleton)
{
  std::vector<double> x(connected.mesh.node_count() * skeleton.dim);
  place(connected.plan, skeleton.x, x);
  return x;
}

}  // namespace blockfsi::block
