#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::coupling
{

/// Hands displacements of the interface from the solid's nodes to the fluid's, d_F = P d_S, and loads back by
/// the transpose, f_S = P^T f_F. So virtual work is the same on both sides, f_S . d_S = f_F . P d_S for any
/// d_S, and, where the rows of P sum up to 1, so is the resultant force.
class Transfer
{
public:
  /// Interfaces that share their nodes: P is the identity.
  explicit Transfer(std::size_t count = 0);

  /// P by rows, one for each node of the fluid: row i has weight[k] in column[k], a node of the solid, for
  /// row_begin[i] <= k < row_begin[i + 1].
  Transfer(std::vector<std::int32_t> row_begin, std::vector<std::int32_t> column, std::vector<double> weight,
           std::size_t solid_count);

  std::size_t fluid_count() const { return fluid_count_; }
  std::size_t solid_count() const { return solid_count_; }

  /// d_F = P d_S. Shapes (fluid_count, 2), written, and (solid_count, 2).
  void to_fluid(std::span<const double> solid, std::span<double> fluid) const;
  /// f_S = P^T f_F. Shapes (solid_count, 2), written, and (fluid_count, 2).
  void to_solid(std::span<const double> fluid, std::span<double> solid) const;

private:
  std::size_t fluid_count_;
  std::size_t solid_count_;
  std::vector<std::int32_t> row_begin_;  ///< empty for the identity
  std::vector<std::int32_t> column_;
  std::vector<double> weight_;
};

}  // namespace blockfsi::coupling
