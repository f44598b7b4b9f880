#include "run/mesh_update.hpp"

#include "block/corner_layout.hpp"

namespace blockfsi::run
{

motion::Update make_update(const case_file::Case& description, const motion::Domain& domain)
{
  if (domain.skeleton.dim != 2 && !std::holds_alternative<motion::Regeneration>(description.motion.update))
    throw Error(description.motion.where, "a mesh in space can only be moved by regenerate");
  return motion::make_update(description.motion.update, domain,
                             block::corner_motion(description.layout, domain.skeleton,
                                                  description.fluid->region, domain.interface,
                                                  description.motion.corners));
}

}  // namespace blockfsi::run
