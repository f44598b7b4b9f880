#pragma once

#include "block/connect.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::block
{

/// A corner that moves by a weighted sum of the displacements of other points.
struct Follow
{
  int point = 0;
  struct Leader
  {
    int point = 0;
    double weight = 1.0;
  };
  std::vector<Leader> leaders;
};

/// How the skeleton follows the interface: a linear map, set up once.
class SkeletonMotion
{
public:
  /// `interface` lists skeleton numbers of the moving nodes, ascending. Points among them follow the
  /// interface, points with a rule follow their leaders (which may be interface points or have rules
  /// themselves), all others stay. Throws Error if rules run in a circle or move an interface point.
  SkeletonMotion(const Skeleton& skeleton, const std::vector<std::int64_t>& interface,
                 const std::vector<Follow>& rules);

  /// Skeleton coordinates for a displacement of the interface. Edges between moved points that are not on the
  /// interface follow linearly in their graded parameter: x = X + (1 - w) d_a + w d_b. Allocates nothing.
  ///   displacement [m], shape (interface count, dim);  skeleton_x [m], shape (skeleton.count, dim), written.
  void move(std::span<const double> displacement, std::span<double> skeleton_x) const;

private:
  struct Term
  {
    std::int32_t interface_index;
    double weight;
  };
  int dim_;
  std::vector<double> x_;
  std::vector<std::int32_t> row_begin_;  ///< shape (skeleton count + 1)
  std::vector<Term> terms_;
};

}  // namespace blockfsi::block
