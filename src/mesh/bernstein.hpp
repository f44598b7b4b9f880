#pragma once

#include "element/shape.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::mesh
{

/// Bernstein polynomials of some degrees, numbered by points (i, j, k), i fastest, then j, then k:
///   tensor   i <= a, j <= b, k <= c: products of three of a line
///   prism    i + j <= a, k <= c: of a triangle times of a line; a triangle alone has c = 0
///   simplex  i + j + k <= a: of a tetrahedron
/// With the binomials (multinomials) as factors of the coefficients, the product of two polynomials is the
/// plain product of sums over points: points add.
struct Bernstein
{
  enum class Kind : std::uint8_t
  {
    tensor,
    prism,
    simplex
  };
  using Exponents = std::array<int, 3>;

  Kind kind = Kind::tensor;
  int a = 0;
  int b = 0;
  int c = 0;

  std::size_t size() const;
  std::size_t index(const Exponents& point) const;
  /// All points in their order.
  std::vector<Exponents> points() const;
  /// Binomial or multinomial of each point, shape (size).
  std::vector<double> factors() const;
  /// Points of the corners, where a coefficient is the value of the polynomial.
  std::vector<std::int32_t> corners() const;
};

/// Polynomials of the sum of the degrees.
Bernstein operator*(const Bernstein& p, const Bernstein& q);

/// A sparse matrix, row by row.
struct SparseRows
{
  std::vector<std::int32_t> start;  ///< shape (row_count + 1)
  std::vector<std::int32_t> column;
  std::vector<double> entry;

  std::size_t row_count() const { return start.size() - 1; }
  /// Largest sum of magnitudes of a row.
  double norm() const;
  /// Most entries of a row.
  int widest() const;
};

/// A derivative of the coordinates of a cell as a Bernstein polynomial: its coefficients are `from_nodes`
/// applied to the nodes.
struct Tangent
{
  Bernstein space;
  SparseRows from_nodes;
  std::vector<double> factors;  ///< of its space
};

/// Derivatives along the reference coordinates of cells of a shape, as many as the shape has. Those of a
/// pyramid are polynomials of the collapsed coordinates xi / (1 - zeta), eta / (1 - zeta), zeta, of degrees
/// (k - 1, k, k - 1), (k, k - 1, k - 1) and (k, k, k - 1). Computed in extended precision.
std::vector<Tangent> tangents(element::Shape shape, int order);

/// Where the products of coefficients of two polynomials go: coefficient m of the first times a row of
/// contiguous coefficients of the second is added to as many from target[m rows + row] on.
struct Product
{
  Product() = default;
  Product(const Bernstein& first, const Bernstein& second);

  /// result += sign first second, all with their factors. Allocates nothing.
  void add(double sign, std::span<const double> first, std::span<const double> second,
           std::span<double> result) const;

  std::size_t first_size = 0;
  std::vector<std::int32_t> row_start;  ///< in the second, shape (rows + 1)
  std::vector<std::int32_t> target;     ///< shape (first_size, rows)
};

/// Lines of coefficients along which a patch is halved: along an axis, or along an edge of a triangle or
/// tetrahedron from its corner `from` to its corner `to`.
struct Halving
{
  int axis = -1;  ///< of a tensor product or a prism; -1: an edge
  int from = 0;
  int to = 0;
  std::vector<std::int32_t> start;  ///< shape (line_count + 1)
  std::vector<std::int32_t> index;

  /// Splits by de Casteljau's algorithm: `patch` keeps the half at `to`, `lower` gets that at `from`. Every
  /// new coefficient is a mean of two, so that nothing is lost by rounding. Allocates nothing.
  void split(std::span<double> patch, std::span<double> lower) const;
};

/// All ways to halve patches of a space in which its polynomials vary.
std::vector<Halving> halvings(const Bernstein& space);

}  // namespace blockfsi::mesh
