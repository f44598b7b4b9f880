#include "case/case.hpp"

#include "block/resize.hpp"

namespace blockfsi::case_file
{

bool Case::solid_differs() const
{
  return solid && ((solid->order != 0 && solid->order != layout.order) || solid->divide != 1.0);
}

block::Layout Case::solid_layout() const
{
  return block::resized(layout, solid->region, solid->order != 0 ? solid->order : layout.order,
                        solid->divide);
}

}  // namespace blockfsi::case_file
