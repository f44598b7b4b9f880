#pragma once

#include <span>
#include <vector>

namespace blockfsi::mesh
{

/// Largest order of a cell: work arrays of fixed size are made for it.
inline constexpr int max_order = 8;

/// A linear map of the order + 1 nodes of a line to other values along that line, shape (rows, columns),
/// stored column by column: entry (q, i) is entries[q + i rows]. rows <= max_order + 1, columns <= max_order
/// + 1.
struct LineMap
{
  int rows = 0;
  int columns = 0;
  std::vector<double> entries;
};

/// Applies one map per direction to the nodes of a cell:
///   result[q + r a.rows] = sum over i, j of a(q, i) b(r, j) values[i + j a.columns].
/// values has shape (b.columns, a.columns), result (b.rows, a.rows). Allocates nothing.
void apply(const LineMap& along_xi, const LineMap& along_eta, std::span<const double> values,
           std::span<double> result);

/// Values and first derivatives of the Lagrange functions of `nodes` at `points`.
struct LineMaps
{
  LineMap value;
  LineMap derivative;
};

LineMaps lagrange_maps(std::span<const double> nodes, std::span<const double> points);

/// Throws Error unless 1 <= order <= max_order.
void check_order(int order);

}  // namespace blockfsi::mesh
