#pragma once

#include "mesh/mesh.hpp"
#include "mesh/tensor.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::mesh
{

/// What is proved about the Jacobian of a cell.
enum class Verdict : std::int32_t
{
  valid,      ///< positive everywhere in the cell
  invalid,    ///< somewhere not positive beyond rounding
  undecided,  ///< neither was proved: positive, if at all, by less than the subdivision resolves
};

/// Tables to certify cells of one order k, made once (formulation.md chapter 4; Johnen, Remacle and Geuzaine
/// 2013).
///
/// The Jacobian of the cell is a polynomial of degree 2k - 1 per direction. Its Bernstein coefficients are
/// formed as products of those of the tangents, of degrees k - 1 and k. Interpolating sampled Jacobians
/// instead would solve systems of degree 2k - 1 = 15 at order 8, whose condition is the square of what is
/// needed here.
struct ValidityTables
{
  /// Throws Error unless 1 <= order <= max_order.
  explicit ValidityTables(int order);

  int order = 1;
  /// Nodes of a line to the Bernstein coefficients of the function, shape (k + 1, k + 1), and of its
  /// derivative, shape (k, k + 1).
  LineMap value;
  LineMap derivative;
  /// Binomials of k, shape (k + 1), and of k - 1, shape (k): with them as factors, the product of two
  /// polynomials is the plain convolution of their coefficients.
  std::vector<double> binomial;
  std::vector<double> binomial_below;
  /// 1 / binomial(2k - 1, a), shape (2k).
  std::vector<double> inverse_binomial;
  /// Bound of the rounding error of the coefficients of a tangent, for a cell of unit size.
  double rounding = 0.0;
};

/// Sign of the Jacobian of one cell with nodes x [m], shape ((order + 1)^2, 2), relative to the cell's size
/// and free of rounding: `valid` is a proof. Allocates nothing.
Verdict certify(const ValidityTables& tables, std::span<const double> x);

/// Verdicts over the cells of a mesh. The default is that of a mesh without cells. Trivially copyable.
struct Validity
{
  std::int64_t valid = 0;
  std::int64_t invalid = 0;
  std::int64_t undecided = 0;
  /// The cell that is not valid with the lowest number in the whole mesh, and its block; -1: none.
  std::int64_t cell = -1;
  std::int32_t block = -1;

  bool all_valid() const { return invalid == 0 && undecided == 0; }
};

/// Combines the parts of several processes.
Validity merge(const Validity& a, const Validity& b);

/// Certifies all cells of the mesh at coordinates x [m], shape (node_count, 2). Where `verdicts` is given it
/// gets the verdict of each cell, shape (cell_count). Allocates nothing.
Validity certify(const ValidityTables& tables, const Mesh& mesh, std::span<const double> x,
                 std::span<Verdict> verdicts = {});

}  // namespace blockfsi::mesh
