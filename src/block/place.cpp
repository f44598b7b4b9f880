#include "block/place.hpp"

#include <cassert>

namespace blockfsi::block
{

namespace
{

constexpr int dim = 2;

/// The transfinite map at one node: both ruled surfaces less the bilinear one, which they share.
void place_inner(const Plan::Inner& inner, const double* skeleton, double* x)
{
  const double u = inner.u;
  const double v = inner.v;
  const double* bottom = skeleton + dim * inner.side[0];
  const double* right = skeleton + dim * inner.side[1];
  const double* top = skeleton + dim * inner.side[2];
  const double* left = skeleton + dim * inner.side[3];
  const double* corner0 = skeleton + dim * inner.corner[0];
  const double* corner1 = skeleton + dim * inner.corner[1];
  const double* corner2 = skeleton + dim * inner.corner[2];
  const double* corner3 = skeleton + dim * inner.corner[3];
  for (int c = 0; c < dim; ++c)
    x[dim * inner.node + c] = (1.0 - v) * (bottom[c] - (1.0 - u) * corner0[c] - u * corner1[c]) +
                              v * (top[c] - (1.0 - u) * corner3[c] - u * corner2[c]) + (1.0 - u) * left[c] +
                              u * right[c];
}

}  // namespace

void place(const Plan& plan, std::span<const double> skeleton_x, std::span<double> x)
{
  assert(plan.dim == dim);
  for (std::size_t k = 0; k < plan.skeleton_node.size(); ++k)
    for (int c = 0; c < dim; ++c)
      x[dim * plan.skeleton_node[k] + c] = skeleton_x[dim * plan.skeleton_number[k] + c];
  for (const Plan::Inner& inner : plan.inner)
    place_inner(inner, skeleton_x.data(), x.data());
}

std::vector<double> initial_nodes(const Connected& connected, const Skeleton& skeleton)
{
  std::vector<double> x(connected.mesh.node_count() * skeleton.dim);
  place(connected.plan, skeleton.x, x);
  return x;
}

}  // namespace blockfsi::block
