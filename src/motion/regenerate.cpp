#include "motion/regenerate.hpp"

#include "block/place.hpp"

#include <utility>

namespace blockfsi::motion
{

Regenerate::Regenerate(const block::Skeleton& skeleton, const block::Plan& plan,
                       std::span<const std::int64_t> interface, block::CornerMotion corners)
    : motion_(skeleton, interface, std::move(corners)), plan_(&plan), skeleton_x_(skeleton.x.size())
{
}

block::CornerReport Regenerate::follow(std::span<const double> displacement, std::span<double> x)
{
  const block::CornerReport report = motion_.move(displacement, skeleton_x_);
  block::place(*plan_, skeleton_x_, x);
  return report;
}

}  // namespace blockfsi::motion
