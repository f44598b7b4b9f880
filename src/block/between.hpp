#pragma once

#include "block/connect.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace blockfsi::block
{

/// A sparse matrix: row i has the entries weight[k] in the columns column[k] for row_begin[i] <= k <
/// row_begin[i + 1].
struct SparseRows
{
  std::vector<std::int32_t> row_begin = {0};
  std::vector<std::int32_t> column;
  std::vector<double> weight;
};

/// Evaluates a field on the interface of two regions, given at its nodes in one skeleton, at its nodes in
/// another one of the same blocks (`resized`): each node lies on its side at a graded parameter, and there
/// the piecewise polynomial of the other skeleton is taken. Rows and columns have the order of
/// `interface_nodes` of the two; the weights of a row sum up to 1. Skeletons with the same cells give the
/// identity. 2D only.
SparseRows evaluate_between(const Layout& layout, const Skeleton& from, const Skeleton& to,
                            std::string_view region_a, std::string_view region_b);

}  // namespace blockfsi::block
