#include "block/move.hpp"

#include "block/blend.hpp"
#include "block/corner_blocks.hpp"
#include "block/face_plan.hpp"
#include "block/numbering.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace blockfsi::block
{

SkeletonMotion::SkeletonMotion(const Skeleton& skeleton, std::span<const std::int64_t> interface,
                               CornerMotion corners)
    : dim_(skeleton.dim), x_(skeleton.x), corners_(std::move(corners)),
      interface_(interface.begin(), interface.end()),
      point_values_(static_cast<std::size_t>(skeleton.point_count) * skeleton.dim)
{
  const auto moves = [&](std::int64_t node) { return interface_index(interface_, node) >= 0; };
  for (const PlacedEdge& edge : skeleton.edges)
    for (std::int64_t node = edge.first; node < edge.first + edge.count; ++node)
      if (!moves(node))
        inner_.push_back({edge.a, edge.b, static_cast<std::int32_t>(node), skeleton.parameter[node]});
  std::size_t work = 0;
  for (const PlacedFace& face : skeleton.faces)
    if (face.count > 0 && !moves(face.first))
    {
      faces_.push_back(face_plan(skeleton, face));
      work = std::max(work, work_size(faces_.back(), dim_));
    }
  work_.resize(work);
}

CornerReport SkeletonMotion::move(std::span<const double> displacement, std::span<double> skeleton_x)
{
  assert(skeleton_x.size() == x_.size());
  double* change = skeleton_x.data();
  const CornerReport report = corners_.follow(displacement, skeleton_x.first(point_values_));
  for (const Inner& inner : inner_)
    for (int c = 0; c < dim_; ++c)
      change[inner.node * dim_ + c] =
          (1.0 - inner.parameter) * change[inner.a * dim_ + c] + inner.parameter * change[inner.b * dim_ + c];
  for (std::size_t k = 0; k < interface_.size(); ++k)
    std::copy_n(displacement.data() + k * dim_, dim_, change + interface_[k] * dim_);
  for (const BlockPlan& face : faces_)
    blend(face, dim_, change, work_.data(), change);
  for (std::size_t i = 0; i < x_.size(); ++i)
    skeleton_x[i] = x_[i] + change[i];
  return report;
}

}  // namespace blockfsi::block
