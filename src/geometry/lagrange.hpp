#pragma once

#include "geometry/bspline.hpp"

#include <span>

namespace blockfsi::geometry
{

/// The Lagrange functions of at most max_degree + 1 nodes at t with two derivatives, by products of
/// differences: exact at the nodes. Allocates nothing.
inline void lagrange(std::span<const double> nodes, double t, BasisValues& result)
{
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    double value = 1.0;
    double first = 0.0;
    double second = 0.0;
    for (std::size_t j = 0; j < nodes.size(); ++j)
    {
      if (j == i)
        continue;
      const double slope = 1.0 / (nodes[i] - nodes[j]);
      const double factor = (t - nodes[j]) * slope;
      second = second * factor + 2.0 * first * slope;
      first = first * factor + value * slope;
      value *= factor;
    }
    result.value[i] = value;
    result.first[i] = first;
    result.second[i] = second;
  }
}

}  // namespace blockfsi::geometry
