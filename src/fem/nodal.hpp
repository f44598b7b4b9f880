#pragma once

#include "core/expression.hpp"

#include <array>
#include <span>

namespace blockfsi::fem
{

/// Values at the nodes of a vector given by formulas in x, y, t; a formula without variables is evaluated
/// once.
///   x [m], shape (node_count, 2);  values, shape (node_count, 2), written.
void evaluate_at_nodes(const std::array<Expression, 3>& formulas, std::span<const double> x, double time,
                       std::span<double> values);

}  // namespace blockfsi::fem
