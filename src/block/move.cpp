#include "block/move.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace blockfsi::block
{

SkeletonMotion::SkeletonMotion(const Skeleton& skeleton, std::span<const std::int64_t> interface,
                               CornerMotion corners)
    : dim_(skeleton.dim), x_(skeleton.x), corners_(std::move(corners)),
      U_(skeleton.point_count * skeleton.dim), inner_(skeleton.count - skeleton.point_count)
{
  for (const PlacedEdge& edge : skeleton.edges)
    for (std::int64_t node = edge.first; node < edge.first + edge.count; ++node)
      inner_[node - skeleton.point_count] = {edge.a, edge.b, skeleton.parameter[node], -1};
  for (std::size_t k = 0; k < interface.size(); ++k)
    if (interface[k] >= skeleton.point_count)
      inner_[interface[k] - skeleton.point_count].interface_index = static_cast<std::int32_t>(k);
}

CornerReport SkeletonMotion::move(std::span<const double> displacement, std::span<double> skeleton_x)
{
  assert(skeleton_x.size() == x_.size());
  const CornerReport report = corners_.follow(displacement, U_);
  for (std::size_t i = 0; i < U_.size(); ++i)
    skeleton_x[i] = x_[i] + U_[i];
  const double* x = x_.data() + U_.size();
  double* moved = skeleton_x.data() + U_.size();
  for (const Inner& inner : inner_)
    for (int c = 0; c < dim_; ++c)
    {
      const double change = inner.interface_index >= 0 ? displacement[inner.interface_index * dim_ + c]
                                                       : (1.0 - inner.parameter) * U_[inner.a * dim_ + c] +
                                                             inner.parameter * U_[inner.b * dim_ + c];
      *moved++ = *x++ + change;
    }
  return report;
}

}  // namespace blockfsi::block
