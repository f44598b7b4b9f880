#include "motion/regenerate.hpp"

#include "block/place.hpp"

namespace blockfsi::motion
{

Regenerate::Regenerate(const block::Skeleton& skeleton, const block::Plan& plan,
                       const std::vector<std::int64_t>& interface, const std::vector<block::Follow>& rules)
    : motion_(skeleton, interface, rules), plan_(&plan), skeleton_x_(skeleton.x.size())
{
}

void Regenerate::follow(std::span<const double> displacement, std::span<double> x)
{
  motion_.move(displacement, skeleton_x_);
  block::place(*plan_, skeleton_x_, x);
}

}  // namespace blockfsi::motion
