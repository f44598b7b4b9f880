#include "run/interfaces.hpp"

#include "block/between.hpp"
#include "block/resize.hpp"

#include <utility>

namespace blockfsi::run
{

namespace
{

std::optional<SolidBlocks> own_blocks(const case_file::Case& description)
{
  if (!description.solid || !description.solid_differs())
    return {};
  SolidBlocks own{description.solid_layout(), {}};
  own.skeleton = block::make_skeleton(own.layout);
  return own;
}

}  // namespace

Interfaces match_interfaces(const case_file::Case& description, const block::Skeleton& skeleton)
{
  Interfaces result;
  result.own = own_blocks(description);
  if (!description.fluid || !description.solid)
    return result;
  const std::string& fluid = description.fluid->region;
  const std::string& solid = description.solid->region;
  const block::Layout& layout = description.layout;
  result.fluid = block::interface_nodes(layout, skeleton, fluid, solid);
  if (!result.own)
  {
    result.solid = result.fluid;
    result.transfer = coupling::Transfer(result.fluid.size());
    return result;
  }
  result.solid = block::interface_nodes(layout, result.own->skeleton, fluid, solid);
  block::SparseRows rows = block::evaluate_between(layout, result.own->skeleton, skeleton, fluid, solid);
  result.transfer = coupling::Transfer(std::move(rows.row_begin), std::move(rows.column),
                                       std::move(rows.weight), result.solid.size());
  return result;
}

}  // namespace blockfsi::run
