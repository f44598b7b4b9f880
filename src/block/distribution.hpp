#pragma once

#include "block/layout.hpp"
#include "block/strips.hpp"
#include "block/topology.hpp"

#include <vector>

namespace blockfsi::block
{

/// Parameters of the cell corners on each edge, ascending from 0 to 1, shape (edge_count, divisions + 1): the
/// edge's own grading, else the one that its strip gets from `grade_towards`, else equal cells. Divisions and
/// boundaries of the edges must be known. Throws Error where a grading cannot be met or names something
/// unknown.
std::vector<std::vector<double>> distribute(const Layout& layout, const Topology& topology,
                                            const std::vector<Strip>& strips);

}  // namespace blockfsi::block
