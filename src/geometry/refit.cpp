#include "geometry/refit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace blockfsi::geometry
{

namespace
{

constexpr int degree = 8;
constexpr std::size_t count = degree + 1;
using Matrix = std::array<std::array<double, count>, count>;

/// Chebyshev points of the second kind on [0, 1], with both ends.
std::array<double, count> make_nodes()
{
  std::array<double, count> nodes{};
  for (std::size_t i = 0; i < count; ++i)
    nodes[i] = 0.5 * (1.0 - std::cos(std::numbers::pi * static_cast<double>(i) / degree));
  nodes[degree / 2] = 0.5;
  nodes[degree] = 1.0;
  return nodes;
}

/// From values at the nodes to coefficients of Bernstein's polynomials: the inverse of their values there, by
/// Gauss and Jordan with pivots.
Matrix make_inverse(const std::array<double, count>& nodes)
{
  const std::vector<double> bernstein = clamped_knots(degree, count);
  Matrix a{};
  Matrix inverse{};
  for (std::size_t i = 0; i < count; ++i)
  {
    BasisValues N;
    basis<0>(bernstein, degree, degree, nodes[i], N);
    std::copy_n(N.value.begin(), count, a[i].begin());
    inverse[i][i] = 1.0;
  }
  for (std::size_t k = 0; k < count; ++k)
  {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < count; ++i)
      if (std::abs(a[i][k]) > std::abs(a[pivot][k]))
        pivot = i;
    std::swap(a[k], a[pivot]);
    std::swap(inverse[k], inverse[pivot]);
    for (std::size_t i = 0; i < count; ++i)
    {
      const double factor = i == k ? 1.0 - 1.0 / a[k][k] : a[i][k] / a[k][k];
      const auto row = a[k];
      const auto row_inverse = inverse[k];
      for (std::size_t j = 0; j < count; ++j)
      {
        a[i][j] -= factor * row[j];
        inverse[i][j] -= factor * row_inverse[j];
      }
    }
  }
  return inverse;
}

const std::array<double, count>& nodes()
{
  static const std::array<double, count> points = make_nodes();
  return points;
}

const Matrix& inverse()
{
  static const Matrix matrix = make_inverse(nodes());
  return matrix;
}

std::vector<double> halved(std::span<const double> breaks)
{
  std::vector<double> result{breaks.front()};
  for (std::size_t i = 1; i < breaks.size(); ++i)
  {
    result.push_back(0.5 * (breaks[i - 1] + breaks[i]));
    result.push_back(breaks[i]);
  }
  return result;
}

/// Knots of polynomials that only share their ends.
std::vector<double> knots_of(std::span<const double> breaks)
{
  std::vector<double> knots{breaks.front()};
  for (const double t : breaks)
    knots.insert(knots.end(), degree, t);
  knots.push_back(breaks.back());
  return knots;
}

/// The parameters of all nodes of all pieces; the end of one piece is the start of the next.
std::vector<double> all_nodes(std::span<const double> breaks)
{
  std::vector<double> result{breaks.front()};
  for (std::size_t p = 1; p < breaks.size(); ++p)
    for (std::size_t i = 1; i < count; ++i)
      result.push_back(i == degree ? breaks[p] : breaks[p - 1] + nodes()[i] * (breaks[p] - breaks[p - 1]));
  return result;
}

/// Values at the nodes to control points, in place, for a row of entries `stride` apart.
void to_coefficients(std::vector<Point>& x, std::size_t first, std::size_t stride, std::size_t pieces)
{
  for (std::size_t p = 0; p < pieces; ++p)
  {
    const std::size_t start = first + p * degree * stride;
    std::array<Point, count> result{};
    for (std::size_t i = 1; i + 1 < count; ++i)
      for (std::size_t k = 0; k < count; ++k)
        result[i] = add_scaled(result[i], inverse()[i][k], x[start + k * stride]);
    // The ends are control points as they are, and the next piece needs the value.
    for (std::size_t i = 1; i + 1 < count; ++i)
      x[start + i * stride] = result[i];
  }
}

/// Between the nodes.
std::vector<double> checks(const std::vector<double>& at)
{
  std::vector<double> result;
  for (std::size_t i = 1; i < at.size(); ++i)
    result.push_back(0.5 * (at[i - 1] + at[i]));
  return result;
}

Refitted<NurbsCurve> fit(const std::function<Point(double)>& curve, std::span<const double> breaks)
{
  const std::vector<double> at = all_nodes(breaks);
  Refitted<NurbsCurve> result{{degree, knots_of(breaks), {}, {}}, 0.0};
  for (const double t : at)
    result.spline.points.push_back(curve(t));
  to_coefficients(result.spline.points, 0, 1, breaks.size() - 1);
  for (const double t : checks(at))
    result.error = std::max(result.error, distance(evaluate(result.spline, t), curve(t)));
  return result;
}

Refitted<NurbsSurface> fit(const std::function<Point(double, double)>& surface,
                           std::span<const double> breaks_u, std::span<const double> breaks_v)
{
  const std::vector<double> u = all_nodes(breaks_u);
  const std::vector<double> v = all_nodes(breaks_v);
  Refitted<NurbsSurface> result{{{degree, degree}, {knots_of(breaks_u), knots_of(breaks_v)}, {}, {}}, 0.0};
  std::vector<Point>& points = result.spline.points;
  for (const double s : u)
    for (const double t : v)
      points.push_back(surface(s, t));
  for (std::size_t i = 0; i < u.size(); ++i)
    to_coefficients(points, i * v.size(), 1, breaks_v.size() - 1);
  for (std::size_t j = 0; j < v.size(); ++j)
    to_coefficients(points, j, v.size(), breaks_u.size() - 1);
  for (const double s : checks(u))
    for (const double t : checks(v))
      result.error = std::max(result.error, distance(evaluate(result.spline, s, t), surface(s, t)));
  return result;
}

}  // namespace

Refitted<NurbsCurve> refit(const std::function<Point(double)>& curve, std::span<const double> breaks,
                           double tolerance)
{
  constexpr int most_halvings = 6;
  std::vector<double> pieces(breaks.begin(), breaks.end());
  Refitted<NurbsCurve> result = fit(curve, pieces);
  for (int i = 0; i < most_halvings && result.error > tolerance; ++i)
  {
    pieces = halved(pieces);
    result = fit(curve, pieces);
  }
  return result;
}

Refitted<NurbsSurface> refit(const std::function<Point(double, double)>& surface,
                             std::span<const double> breaks_u, std::span<const double> breaks_v,
                             double tolerance)
{
  constexpr int most_halvings = 5;
  std::vector<double> pieces_u(breaks_u.begin(), breaks_u.end());
  std::vector<double> pieces_v(breaks_v.begin(), breaks_v.end());
  Refitted<NurbsSurface> result = fit(surface, pieces_u, pieces_v);
  for (int i = 0; i < most_halvings && result.error > tolerance; ++i)
  {
    pieces_u = halved(pieces_u);
    pieces_v = halved(pieces_v);
    result = fit(surface, pieces_u, pieces_v);
  }
  return result;
}

}  // namespace blockfsi::geometry
