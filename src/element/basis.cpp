#include "element/basis.hpp"

#include <algorithm>
#include <cmath>

namespace blockfsi::element
{

namespace
{

constexpr std::array<std::array<int, 2>, 6> pairs = {{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

Jet constant(double value)
{
  Jet jet;
  jet.value = value;
  return jet;
}

Jet coordinate(double value, int direction)
{
  Jet jet = constant(value);
  jet.first[direction] = 1.0;
  return jet;
}

/// alpha a + beta b.
Jet combine(double alpha, const Jet& a, double beta, const Jet& b)
{
  Jet c;
  c.value = alpha * a.value + beta * b.value;
  for (int d = 0; d < 3; ++d)
    c.first[d] = alpha * a.first[d] + beta * b.first[d];
  for (int p = 0; p < 6; ++p)
    c.second[p] = alpha * a.second[p] + beta * b.second[p];
  return c;
}

Jet operator*(const Jet& a, const Jet& b)
{
  Jet c;
  c.value = a.value * b.value;
  for (int d = 0; d < 3; ++d)
    c.first[d] = a.first[d] * b.value + a.value * b.first[d];
  for (int p = 0; p < 6; ++p)
  {
    const auto [d, e] = pairs[p];
    c.second[p] =
        a.second[p] * b.value + a.first[d] * b.first[e] + a.first[e] * b.first[d] + a.value * b.second[p];
  }
  return c;
}

/// Jacobi polynomials s^n P_n^(alpha, 0)(x / s), n = 0..order, by their recurrence: without division by s.
using Line = std::array<Jet, largest_order + 1>;

Line jacobi(int order, int alpha, const Jet& x, const Jet& s)
{
  Line p;
  p[0] = constant(1.0);
  if (order > 0)
    p[1] = combine(0.5 * (alpha + 2), x, 0.5 * alpha, s);
  const Jet s_squared = s * s;
  for (int n = 1; n < order; ++n)
  {
    const double m = 2.0 * n + alpha;
    const double scale = 1.0 / (2.0 * (n + 1) * (n + alpha + 1) * m);
    const Jet factor = combine(scale * m * (m + 1) * (m + 2), x, scale * (m + 1) * alpha * alpha, s);
    p[n + 1] = combine(1.0, factor * p[n], -scale * 2.0 * (n + alpha) * n * (m + 2), s_squared * p[n - 1]);
  }
  return p;
}

/// Orthonormal Legendre polynomials of one coordinate of the unit interval.
Line legendre(int order, const Point& point, int direction)
{
  Line p = jacobi(order, 0, combine(2.0, coordinate(point[direction], direction), -1.0, constant(1.0)),
                  constant(1.0));
  for (int n = 0; n <= order; ++n)
    p[n] = combine(std::sqrt(2.0 * n + 1.0), p[n], 0.0, p[n]);
  return p;
}

void triangle(int order, const Point& point, std::span<Jet> result)
{
  const Jet xi = coordinate(point[0], 0);
  const Jet eta = coordinate(point[1], 1);
  const Jet width = combine(1.0, constant(1.0), -1.0, eta);
  const Line along = jacobi(order, 0, combine(2.0, xi, -1.0, width), width);
  std::size_t m = 0;
  for (int i = 0; i <= order; ++i)
  {
    const Line across = jacobi(order - i, 2 * i + 1, combine(2.0, eta, -1.0, constant(1.0)), constant(1.0));
    for (int j = 0; i + j <= order; ++j)
      result[m++] = combine(std::sqrt((2.0 * i + 1) * (2.0 * (i + j) + 2)), along[i] * across[j], 0.0, xi);
  }
}

void tetrahedron(int order, const Point& point, std::span<Jet> result)
{
  const Jet one = constant(1.0);
  const Jet xi = coordinate(point[0], 0);
  const Jet eta = coordinate(point[1], 1);
  const Jet zeta = coordinate(point[2], 2);
  const Jet depth = combine(1.0, one, -1.0, zeta);
  const Jet width = combine(1.0, depth, -1.0, eta);
  const Line along = jacobi(order, 0, combine(2.0, xi, -1.0, width), width);
  std::size_t m = 0;
  for (int i = 0; i <= order; ++i)
  {
    const Line across = jacobi(order - i, 2 * i + 1, combine(2.0, eta, -1.0, depth), depth);
    for (int j = 0; i + j <= order; ++j)
    {
      const Line up = jacobi(order - i - j, 2 * (i + j) + 2, combine(2.0, zeta, -1.0, one), one);
      for (int k = 0; i + j + k <= order; ++k)
      {
        const double norm = (2.0 * i + 1) * (2.0 * (i + j) + 2) * (2.0 * (i + j + k) + 3);
        result[m++] = combine(std::sqrt(norm), along[i] * across[j] * up[k], 0.0, xi);
      }
    }
  }
}

/// height^power, and 0 instead of what is unbounded at the apex.
double bounded_power(double height, int power)
{
  return power < 0 && height == 0.0 ? 0.0 : std::pow(height, power);
}

/// Derivatives along xi, eta, zeta of h^m g(xi / h, eta / h, zeta), h = 1 - zeta, from those of g at (x, y).
Jet collapse(const Jet& g, double x, double y, double h, int m)
{
  const auto [g1, g2, g3] = g.first;
  const auto [g11, g22, g33, g12, g13, g23] = g.second;
  const double h0 = bounded_power(h, m);
  const double h1 = bounded_power(h, m - 1);
  const double h2 = bounded_power(h, m - 2);
  // The derivative of h^m g along zeta is h^(m-1) w + h^m g3.
  const double w = x * g1 + y * g2 - m * g.value;
  const double w1 = g1 + x * g11 + y * g12 - m * g1;
  const double w2 = g2 + x * g12 + y * g22 - m * g2;
  const double w3 = x * g13 + y * g23 - m * g3;
  Jet f;
  f.value = h0 * g.value;
  f.first = {h1 * g1, h1 * g2, h1 * w + h0 * g3};
  f.second = {h2 * g11, h2 * g22,           h2 * (x * w1 + y * w2 - (m - 1) * w) + 2.0 * h1 * w3 + h0 * g33,
              h2 * g12, h2 * w1 + h1 * g13, h2 * w2 + h1 * g23};
  return f;
}

void pyramid(int order, const Point& point, std::span<Jet> result)
{
  const Jet one = constant(1.0);
  const double h = 1.0 - point[2];
  const Point collapsed = h == 0.0 ? Point{0.5, 0.5, 1.0} : Point{point[0] / h, point[1] / h, point[2]};
  const Line along = legendre(order, collapsed, 0);
  const Line across = legendre(order, collapsed, 1);
  const Jet up = combine(2.0, coordinate(point[2], 2), -1.0, one);
  std::size_t n = 0;
  for (int m = 0; m <= order; ++m)
  {
    Line levels = jacobi(order - m, 2 * m + 2, up, one);
    for (int l = 0; l <= order - m; ++l)
      levels[l] = combine(std::sqrt(2.0 * (m + l) + 3.0), levels[l], 0.0, one);
    for (int i = 0; i <= m; ++i)
      for (int j = 0; j <= m; ++j)
        for (int l = 0; std::max(i, j) == m && l <= order - m; ++l)
          result[n++] = collapse(along[i] * across[j] * levels[l], collapsed[0], collapsed[1], h, m);
  }
}

}  // namespace

void orthonormal(Shape shape, int order, const Point& point, std::span<Jet> result)
{
  const int count = order + 1;
  switch (shape)
  {
  case Shape::triangle:
    return triangle(order, point, result);
  case Shape::tetrahedron:
    return tetrahedron(order, point, result);
  case Shape::pyramid:
    return pyramid(order, point, result);
  case Shape::prism:
  {
    const std::size_t level = lattice_size(Shape::triangle, order);
    triangle(order, point, result.first(level));
    const Line up = legendre(order, point, 2);
    for (int k = order; k >= 0; --k)
      for (std::size_t m = 0; m < level; ++m)
        result[m + k * level] = result[m] * up[k];
    return;
  }
  case Shape::segment:
  {
    const Line along = legendre(order, point, 0);
    std::copy_n(along.begin(), count, result.begin());
    return;
  }
  case Shape::quadrilateral:
  case Shape::hexahedron:
  {
    const Line along = legendre(order, point, 0);
    const Line across = legendre(order, point, 1);
    const Line up = legendre(shape == Shape::hexahedron ? order : 0, point, 2);
    const int levels = shape == Shape::hexahedron ? count : 1;
    for (int k = 0; k < levels; ++k)
      for (int j = 0; j < count; ++j)
        for (int i = 0; i < count; ++i)
          result[i + count * (j + count * k)] = along[i] * across[j] * up[k];
    return;
  }
  }
}

}  // namespace blockfsi::element
