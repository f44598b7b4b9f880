#include "run/mesh_update.hpp"

#include "block/corners.hpp"

namespace blockfsi::run
{

motion::Update make_update(const case_file::Case& description, const motion::Domain& domain)
{
  std::vector<block::Follow> follows = description.motion.follows;
  if (description.motion.corners == case_file::Corners::automatic && !domain.interface.empty())
  {
    const std::vector<block::Follow> more = block::automatic_rules(
        description.layout, domain.skeleton, domain.interface, description.motion.follows);
    follows.insert(follows.end(), more.begin(), more.end());
  }
  return motion::make_update(description.motion.update, domain, follows);
}

}  // namespace blockfsi::run
