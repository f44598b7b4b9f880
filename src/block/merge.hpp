#pragma once

#include "block/layout.hpp"

namespace blockfsi::block
{

/// Joins the pieces of a layout: points within `tolerance` [m] of each other become one, which keeps the name
/// and the place of the first. What several pieces say of one edge is united. Throws Error where they
/// contradict each other (different divisions, gradings or curves).
void merge(Layout& layout, double tolerance);

}  // namespace blockfsi::block
