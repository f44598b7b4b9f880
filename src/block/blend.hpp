#pragma once

#include "block/plan.hpp"

#include <cstddef>

namespace blockfsi::block
{

/// Numbers that placing the nodes of a plan needs as working memory.
std::size_t work_size(const BlockPlan& plan, int dim);

/// Places the inner nodes of a block, or of a face, from the nodes of its sides by the transfinite map of its
/// shape (formulation.md 1) with graded coordinates: linear in the skeleton. Allocates nothing.
///   skeleton_x [m], shape (skeleton.count, dim);  work, shape (work_size);  x [m], rows of `plan` are
///   written.
void blend(const BlockPlan& plan, int dim, const double* skeleton_x, double* work, double* x);

}  // namespace blockfsi::block
