#include "mesh/validity.hpp"

#include "element/line.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace blockfsi::mesh
{

static_assert(std::is_trivially_copyable_v<Validity>);

namespace
{

using Extended = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

constexpr int max_line = max_order + 1;
using Coefficients = std::array<double, max_line * max_line>;

/// Halvings of a cell before the verdict stays open (even numbers are in xi), and patches looked at.
constexpr int max_level = 40;
constexpr int max_patches = 20000;

/// Bernstein coefficients of a Jacobian, entry a + b n.
using Patch = std::array<double, 4 * max_order * max_order>;

std::vector<double> binomials(int n)
{
  std::vector<double> result(n + 1, 1.0);
  for (int i = 1; i <= n; ++i)
    result[i] = result[i - 1] * (n - i + 1) / i;
  return result;
}

/// Nodal values to Bernstein coefficients of degree `order`: the inverse of the Bernstein functions at the
/// nodes, in extended precision because its condition number is near 2^order.
Extended to_bernstein(int order)
{
  const std::vector<double> nodes = element::lobatto(order);
  const std::vector<double> binomial = binomials(order);
  Extended bernstein(order + 1, order + 1);
  for (int q = 0; q <= order; ++q)
    for (int i = 0; i <= order; ++i)
    {
      const long double x = nodes[q];
      bernstein(q, i) = binomial[i] * std::pow(x, i) * std::pow(1.0L - x, order - i);
    }
  return bernstein.fullPivLu().inverse();
}

LineMap line_map(const Extended& matrix)
{
  LineMap map{static_cast<int>(matrix.rows()), static_cast<int>(matrix.cols()), {}};
  map.entries.reserve(matrix.size());
  for (Eigen::Index i = 0; i < matrix.cols(); ++i)
    for (Eigen::Index q = 0; q < matrix.rows(); ++q)
      map.entries.push_back(static_cast<double>(matrix(q, i)));
  return map;
}

double row_sum_norm(const Extended& matrix)
{
  return static_cast<double>(matrix.cwiseAbs().rowwise().sum().maxCoeff());
}

double largest(const Coefficients& coefficients, int count)
{
  double result = 0.0;
  for (int i = 0; i < count; ++i)
    result = std::max(result, std::abs(coefficients[i]));
  return result;
}

/// Coefficients of the tangents of a cell, with largest magnitudes and size of the cell.
struct Tangents
{
  std::array<Coefficients, 2> xi;   ///< shape (k + 1, k), entry i + j k
  std::array<Coefficients, 2> eta;  ///< shape (k, k + 1), entry i + j (k + 1)
  double xi_largest = 0.0;
  double eta_largest = 0.0;
  double size = 0.0;
};

void evaluate(const ValidityTables& tables, std::span<const double> x, Tangents& tangents)
{
  const int nodes = (tables.order + 1) * (tables.order + 1);
  const int count = tables.order * (tables.order + 1);
  Coefficients coordinate;
  for (int d = 0; d < 2; ++d)
  {
    // Relative to one node, so that a place far from the origin costs no digits.
    for (int k = 0; k < nodes; ++k)
      coordinate[k] = x[2 * k + d] - x[d];
    tangents.size = std::max(tangents.size, largest(coordinate, nodes));
    apply(tables.derivative, tables.value, coordinate, tangents.xi[d]);
    apply(tables.value, tables.derivative, coordinate, tangents.eta[d]);
    tangents.xi_largest = std::max(tangents.xi_largest, largest(tangents.xi[d], count));
    tangents.eta_largest = std::max(tangents.eta_largest, largest(tangents.eta[d], count));
  }
}

void multiply_binomials(std::span<const double> along_xi, std::span<const double> along_eta,
                        Coefficients& coefficients)
{
  for (std::size_t j = 0; j < along_eta.size(); ++j)
    for (std::size_t i = 0; i < along_xi.size(); ++i)
      coefficients[i + j * along_xi.size()] *= along_xi[i] * along_eta[j];
}

/// result += sign a b for polynomials a of degrees (k - 1, k) and b of degrees (k, k - 1), as convolution.
void add_product(int order, double sign, const Coefficients& a, const Coefficients& b, Patch& result)
{
  const int width = 2 * order;
  for (int j = 0; j <= order; ++j)
    for (int i = 0; i < order; ++i)
    {
      const double factor = sign * a[i + j * order];
      for (int n = 0; n < order; ++n)
        for (int m = 0; m <= order; ++m)
          result[i + m + (j + n) * width] += factor * b[m + n * (order + 1)];
    }
}

Patch jacobian(const ValidityTables& tables, Tangents& tangents)
{
  const int order = tables.order;
  const int width = 2 * order;
  for (int d = 0; d < 2; ++d)
  {
    multiply_binomials(tables.binomial_below, tables.binomial, tangents.xi[d]);
    multiply_binomials(tables.binomial, tables.binomial_below, tangents.eta[d]);
  }
  Patch patch;
  std::fill_n(patch.begin(), width * width, 0.0);
  add_product(order, 1.0, tangents.xi[0], tangents.eta[1], patch);
  add_product(order, -1.0, tangents.xi[1], tangents.eta[0], patch);
  for (int b = 0; b < width; ++b)
    for (int a = 0; a < width; ++a)
      patch[a + b * width] *= tables.inverse_binomial[a] * tables.inverse_binomial[b];
  return patch;
}

/// Splits along one direction by de Casteljau's algorithm: `patch` keeps the upper half, the lower is
/// returned. Every new coefficient is a mean of two, so that nothing is lost by rounding.
Patch split(Patch& patch, int width, bool along_xi)
{
  const int step = along_xi ? 1 : width;
  const int line = along_xi ? width : 1;
  Patch lower;
  for (int l = 0; l < width; ++l)
  {
    double* const upper = &patch[l * line];
    for (int i = 0; i < width; ++i)
    {
      lower[l * line + i * step] = upper[0];
      for (int k = 0; k < width - 1 - i; ++k)
        upper[k * step] = 0.5 * (upper[k * step] + upper[(k + 1) * step]);
    }
  }
  return lower;
}

/// A positive number is one above the rounding error; comparisons are such that NaN is not positive.
struct Search
{
  int width = 0;
  double rounding = 0.0;
  int patches = 0;

  Verdict certify(Patch& patch, int level)
  {
    const int last = width - 1;
    for (const int corner : {0, last, last * width, last * width + last})
      if (!(patch[corner] > rounding))
        return Verdict::invalid;
    if (*std::min_element(patch.begin(), patch.begin() + width * width) > rounding)
      return Verdict::valid;
    if (level == max_level || ++patches > max_patches)
      return Verdict::undecided;
    Patch lower = split(patch, width, level % 2 == 0);
    const Verdict first = certify(lower, level + 1);
    if (first == Verdict::invalid)
      return first;
    const Verdict second = certify(patch, level + 1);
    return second == Verdict::valid ? first : second;
  }
};

void count(Verdict verdict, std::int64_t cell, std::int32_t block, Validity& validity)
{
  validity.valid += verdict == Verdict::valid;
  validity.invalid += verdict == Verdict::invalid;
  validity.undecided += verdict == Verdict::undecided;
  if (verdict != Verdict::valid && (validity.cell < 0 || cell < validity.cell))
  {
    validity.cell = cell;
    validity.block = block;
  }
}

}  // namespace

ValidityTables::ValidityTables(int order_) : order(order_)
{
  check_order(order);
  const Extended bernstein = to_bernstein(order);
  const Extended slopes = order * (bernstein.bottomRows(order) - bernstein.topRows(order));
  value = line_map(bernstein);
  derivative = line_map(slopes);
  binomial = binomials(order);
  binomial_below = binomials(order - 1);
  for (const double b : binomials(2 * order - 1))
    inverse_binomial.push_back(1.0 / b);
  // Two sums of order + 1 products each, with rounded entries and arguments.
  const double roundings = 2.0 * (order + 4);
  rounding =
      roundings * std::numeric_limits<double>::epsilon() * row_sum_norm(bernstein) * row_sum_norm(slopes);
}

Verdict certify(const ValidityTables& tables, std::span<const double> x)
{
  Tangents tangents;
  evaluate(tables, x, tangents);
  Patch patch = jacobian(tables, tangents);
  // The Jacobian is the difference of two means of products of tangents: errors of the factors, then of the
  // sums.
  const double of_factors =
      2.0 * tables.rounding * tangents.size * (tangents.xi_largest + tangents.eta_largest);
  const double sums = 2.0 * (tables.order + 1) * (tables.order + 1) + 2.0 * max_level;
  const double of_sums =
      2.0 * sums * std::numeric_limits<double>::epsilon() * tangents.xi_largest * tangents.eta_largest;
  Search search{2 * tables.order, of_factors + of_sums};
  return search.certify(patch, 0);
}

Validity merge(const Validity& a, const Validity& b)
{
  const bool a_is_first = b.cell < 0 || (a.cell >= 0 && a.cell <= b.cell);
  Validity result = a_is_first ? a : b;
  result.valid = a.valid + b.valid;
  result.invalid = a.invalid + b.invalid;
  result.undecided = a.undecided + b.undecided;
  return result;
}

Validity certify(const ValidityTables& tables, const Mesh& mesh, std::span<const double> x,
                 std::span<Verdict> verdicts)
{
  std::array<double, 2 * max_line * max_line> of_cell;
  Validity validity;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
  {
    const std::span<const std::int32_t> nodes = mesh.cell(c);
    for (std::size_t k = 0; k < nodes.size(); ++k)
    {
      of_cell[2 * k] = x[2 * nodes[k]];
      of_cell[2 * k + 1] = x[2 * nodes[k] + 1];
    }
    const Verdict verdict = certify(tables, std::span(of_cell).first(2 * nodes.size()));
    count(verdict, mesh.number_of_cell(c), mesh.cell_block[c], validity);
    if (!verdicts.empty())
      verdicts[c] = verdict;
  }
  return validity;
}

}  // namespace blockfsi::mesh
