#pragma once

#include "domain.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

/// Coordinates of the nodes within one block as one would write them by hand for one shape: the formula on an
/// even lattice of n steps along each edge, one loop per row, over sides and corners that lie ready.
namespace benchmarks::by_hand
{

/// What the loops read. Sides have the order and, but for the corners, the values of BlockPlan::sides; of
/// shapes with triangles what they differ by from straight ones.
struct Sides
{
  explicit Sides(const Domain& domain);

  const double* of(int side, std::ptrdiff_t node) const { return side_[side].data() + dim * node; }

  int dim;
  std::ptrdiff_t n;
  std::array<std::array<double, 3>, 8> corner{};

private:
  void subtract_straight(const blockfsi::element::SideShape& side, std::vector<double>& x) const;

  std::vector<std::vector<double>> side_;
};

inline Sides::Sides(const Domain& domain)
    : dim(domain.skeleton.dim), n(domain.connected.plan.blocks[0].grid.steps[0])
{
  using namespace blockfsi;
  const block::BlockPlan& plan = domain.connected.plan.blocks[0];
  const element::Shape shape = plan.grid.shape;
  const auto append = [&](std::int32_t node, auto to)
  { std::copy_n(domain.skeleton.x.begin() + static_cast<std::ptrdiff_t>(dim) * node, dim, to); };
  for (int k = 0; k < element::corner_count(shape); ++k)
    append(plan.corners[k], corner[k].begin());
  for (std::size_t s = 0; s < plan.sides.size(); ++s)
  {
    std::vector<double>& x = side_.emplace_back();
    for (const std::int32_t node : plan.sides[s])
      append(node, std::back_inserter(x));
    if (shape != element::Shape::quadrilateral && shape != element::Shape::hexahedron)
      subtract_straight(element::sides(shape)[s], x);
  }
}

inline void Sides::subtract_straight(const blockfsi::element::SideShape& side, std::vector<double>& x) const
{
  using blockfsi::element::Shape;
  double* at = x.data();
  for (std::ptrdiff_t t = 0; t <= (side.shape == Shape::segment ? 0 : n); ++t)
    for (std::ptrdiff_t s = 0; s <= (side.shape == Shape::triangle ? n - t : n); ++s)
    {
      const double u = static_cast<double>(s) / static_cast<double>(n);
      const double v = static_cast<double>(t) / static_cast<double>(n);
      const bool four = side.shape == Shape::quadrilateral;
      const std::array<double, 4> w{four ? (1.0 - u) * (1.0 - v) : 1.0 - u - v, four ? u * (1.0 - v) : u,
                                    four ? u * v : v, (1.0 - u) * v};
      for (int c = 0; c < dim; ++c, ++at)
        for (int k = 0; k < blockfsi::element::corner_count(side.shape); ++k)
          *at -= w[k] * corner[side.corners[k]][c];
    }
}

/// Where a row begins in the lattice of a triangle.
inline std::ptrdiff_t row(std::ptrdiff_t n, std::ptrdiff_t j)
{
  return j * (n + 1) - j * (j - 1) / 2;
}

/// A point that is the same along a row.
template <int dim>
struct Fixed
{
  template <typename Component>
  explicit Fixed(const Component& component)
  {
    for (int c = 0; c < dim; ++c)
      x[c] = component(c);
  }
  double operator[](int c) const { return x[c]; }
  double x[dim];
};

// The loops: x, the inner nodes in their order.

inline void quadrilateral(const Sides& b, double* __restrict x)
{
  constexpr int dim = 2;
  const std::ptrdiff_t n = b.n;
  const double h = 1.0 / static_cast<double>(n);
  const double* low = b.of(0, 0);
  const double* high = b.of(2, 0);
  for (std::ptrdiff_t j = 1; j < n; ++j)
  {
    const double v = static_cast<double>(j) * h;
    const auto& p = b.corner;
    const Fixed<dim> left([&](int c) { return b.of(3, j)[c] - (1.0 - v) * p[0][c] - v * p[3][c]; });
    const Fixed<dim> right([&](int c) { return b.of(1, j)[c] - (1.0 - v) * p[1][c] - v * p[2][c]; });
    for (std::ptrdiff_t i = 1; i < n; ++i)
    {
      const double u = static_cast<double>(i) * h;
      for (int c = 0; c < dim; ++c)
        *x++ = (1.0 - v) * low[dim * i + c] + v * high[dim * i + c] + (1.0 - u) * left[c] + u * right[c];
    }
  }
}

inline void triangle(const Sides& b, double* __restrict x)
{
  constexpr int dim = 2;
  const std::ptrdiff_t n = b.n;
  const double h = 1.0 / static_cast<double>(n);
  const double* e01 = b.of(0, 0);
  const double* e12 = b.of(1, 0);
  const double* e02 = b.of(2, 0);
  for (std::ptrdiff_t j = 1; j < n - 1; ++j)
  {
    const double v = static_cast<double>(j) * h;
    const Fixed<dim> first([&](int c) { return b.corner[0][c] + e02[dim * j + c]; });
    const Fixed<dim> second([&](int c) { return b.corner[1][c] + e12[dim * j + c]; });
    const Fixed<dim> third([&](int c) { return b.corner[2][c]; });
    for (std::ptrdiff_t i = 1; i < n - j; ++i)
    {
      const double u = static_cast<double>(i) * h;
      for (int c = 0; c < dim; ++c)
        *x++ = (1.0 - u - v) * (e01[dim * i + c] + first[c]) + u * (e01[dim * (i + j) + c] + second[c]) +
               v * (e02[dim * (i + j) + c] + e12[dim * (n - i) + c] + third[c]);
    }
  }
}

/// A level of a block, shape (n + 1, 3): what its upright sides give there less what the bottom and the top
/// have of them.
struct Level
{
  explicit Level(std::ptrdiff_t n) : x(3 * (static_cast<std::size_t>(n) + 1)) {}

  void fill(const Sides& b, int side, std::ptrdiff_t k)
  {
    const double w = static_cast<double>(k) / static_cast<double>(b.n);
    const double* at = b.of(side, k * (b.n + 1));
    const double* low = b.of(side, 0);
    const double* high = b.of(side, b.n * (b.n + 1));
    for (std::size_t t = 0; t < x.size(); ++t)
      x[t] = at[t] - (1.0 - w) * low[t] - w * high[t];
  }

  std::vector<double> x;
};

inline void hexahedron(const Sides& b, double* __restrict x)
{
  constexpr int dim = 3;
  const std::ptrdiff_t n = b.n;
  const double h = 1.0 / static_cast<double>(n);
  std::array<Level, 4> upright{Level(n), Level(n), Level(n), Level(n)};
  for (std::ptrdiff_t k = 1; k < n; ++k)
  {
    const double w = static_cast<double>(k) * h;
    for (int side = 0; side < 4; ++side)
      upright[side].fill(b, side + 1, k);
    const double* front = upright[0].x.data();
    const double* right = upright[1].x.data();
    const double* back = upright[2].x.data();
    const double* left = upright[3].x.data();
    for (std::ptrdiff_t j = 1; j < n; ++j)
    {
      const double v = static_cast<double>(j) * h;
      const double* bottom = b.of(0, j * (n + 1));
      const double* top = b.of(5, j * (n + 1));
      const auto end = [&](const double* face, int c)
      { return face[dim * j + c] - (1.0 - v) * face[c] - v * face[dim * n + c]; };
      const Fixed<dim> at_left([&](int c) { return end(left, c); });
      const Fixed<dim> at_right([&](int c) { return end(right, c); });
      for (std::ptrdiff_t i = 1; i < n; ++i)
      {
        const double u = static_cast<double>(i) * h;
        for (int c = 0; c < dim; ++c)
          *x++ = (1.0 - v) * front[dim * i + c] + v * back[dim * i + c] + (1.0 - w) * bottom[dim * i + c] +
                 w * top[dim * i + c] + (1.0 - u) * at_left[c] + u * at_right[c];
      }
    }
  }
}

inline void prism(const Sides& b, double* __restrict x)
{
  constexpr int dim = 3;
  const std::ptrdiff_t n = b.n;
  const double h = 1.0 / static_cast<double>(n);
  std::array<Level, 3> upright{Level(n), Level(n), Level(n)};
  for (std::ptrdiff_t k = 1; k < n; ++k)
  {
    const double w = static_cast<double>(k) * h;
    for (int side = 0; side < 3; ++side)
      upright[side].fill(b, side + 1, k);
    const double* e01 = upright[0].x.data();
    const double* e12 = upright[1].x.data();
    const double* e02 = upright[2].x.data();
    const auto corner = [&](int k_low, int c)
    { return (1.0 - w) * b.corner[k_low][c] + w * b.corner[k_low + 3][c]; };
    for (std::ptrdiff_t j = 1; j < n - 1; ++j)
    {
      const double v = static_cast<double>(j) * h;
      const double* bottom = b.of(0, row(n, j));
      const double* top = b.of(4, row(n, j));
      const Fixed<dim> first([&](int c) { return corner(0, c) + e02[dim * j + c] - e01[c]; });
      const Fixed<dim> second([&](int c) { return corner(1, c) + e12[dim * j + c] - e12[c]; });
      const Fixed<dim> third([&](int c) { return corner(2, c) - e12[dim * n + c]; });
      for (std::ptrdiff_t i = 1; i < n - j; ++i)
      {
        const double u = static_cast<double>(i) * h;
        for (int c = 0; c < dim; ++c)
          *x++ = (1.0 - w) * bottom[dim * i + c] + w * top[dim * i + c] +
                 (1.0 - u - v) * (e01[dim * i + c] + first[c]) + u * (e01[dim * (i + j) + c] + second[c]) +
                 v * (e02[dim * (i + j) + c] + e12[dim * (n - i) + c] + third[c]);
      }
    }
  }
}

inline void tetrahedron(const Sides& b, double* __restrict x)
{
  constexpr int dim = 3;
  const std::ptrdiff_t n = b.n;
  const double h = 1.0 / static_cast<double>(n);
  const auto f012 = [&](std::ptrdiff_t s, std::ptrdiff_t t) { return b.of(0, s + row(n, t)); };
  const auto f013 = [&](std::ptrdiff_t s, std::ptrdiff_t t) { return b.of(1, s + row(n, t)); };
  const auto f123 = [&](std::ptrdiff_t s, std::ptrdiff_t t) { return b.of(2, s + row(n, t)); };
  const auto f023 = [&](std::ptrdiff_t s, std::ptrdiff_t t) { return b.of(3, s + row(n, t)); };
  // Two faces again, so that they are read along rows: (s, t) of the first is (n - s - t, t) of 123, of the
  // second (t, n - s - t) of 123, of the third (t, s) of 023.
  std::array<std::vector<double>, 3> turned;
  for (std::ptrdiff_t t = 0; t <= n; ++t)
    for (std::ptrdiff_t s = 0; s + t <= n; ++s)
    {
      turned[0].insert(turned[0].end(), f123(n - s - t, t), f123(n - s - t, t) + dim);
      turned[1].insert(turned[1].end(), f123(t, n - s - t), f123(t, n - s - t) + dim);
      turned[2].insert(turned[2].end(), f023(t, s), f023(t, s) + dim);
    }
  const auto at = [&](int which, std::ptrdiff_t s, std::ptrdiff_t t)
  { return turned[which].data() + dim * (s + row(n, t)); };
  for (std::ptrdiff_t k = 1; k < n - 2; ++k)
    for (std::ptrdiff_t j = 1; j < n - k - 1; ++j)
    {
      const double v = static_cast<double>(j) * h;
      const double w = static_cast<double>(k) * h;
      const double* a0 = f012(0, j);
      const double* a1 = f013(0, k);
      const double* a2 = f012(0, 0);
      const double* b0 = f012(k, j);
      const double* b1 = f013(j, k);
      const double* b2 = f012(j + k, 0);
      const double* c0 = f012(0, j + k);
      const double* c1 = f023(j, k);
      const double* c2 = at(0, 0, k);
      const double* c3 = f023(j + k, 0);
      const double* c4 = at(0, 0, 0);
      const double* d0 = f013(0, j + k);
      const double* d1 = at(2, k, j);
      const double* d2 = at(1, 0, j);
      const double* d3 = at(2, j + k, 0);
      const double* d4 = at(1, 0, 0);
      const Fixed<dim> first([&](int c)
                             { return b.corner[0][c] + f023(j, k)[c] - f012(0, j)[c] - f013(0, k)[c]; });
      const Fixed<dim> second([&](int c)
                              { return b.corner[1][c] + f123(j, k)[c] - f123(j, 0)[c] - f123(0, k)[c]; });
      const Fixed<dim> third([&](int c) { return b.corner[2][c] - f023(n - k, k)[c]; });
      const Fixed<dim> fourth([&](int c) { return b.corner[3][c] - f023(j, n - j)[c]; });
      for (std::ptrdiff_t i = 1; i < n - j - k; ++i)
      {
        const double u = static_cast<double>(i) * h;
        for (int c = 0; c < dim; ++c)
        {
          const std::ptrdiff_t t = dim * i + c;
          *x++ = (1.0 - u - v - w) * (a0[t] + a1[t] - a2[t] + first[c]) +
                 u * (b0[t] + b1[t] - b2[t] + second[c]) +
                 v * (c0[t] + c1[t] + c2[t] - c3[t] - c4[t] + third[c]) +
                 w * (d0[t] + d1[t] + d2[t] - d3[t] - d4[t] + fourth[c]);
        }
      }
    }
}

inline void pyramid(const Sides& b, double* __restrict x)
{
  constexpr int dim = 3;
  const std::ptrdiff_t n = b.n;
  const double step = 1.0 / static_cast<double>(n);
  const auto base = [&](std::ptrdiff_t s, std::ptrdiff_t t) { return b.of(0, s + (n + 1) * t); };
  const auto& p = b.corner;
  for (std::ptrdiff_t k = 1; k < n - 1; ++k)
  {
    const double z = static_cast<double>(k) * step;
    const double h = 1.0 - z;
    const double* front = b.of(1, row(n, k));
    const double* right = b.of(2, row(n, k));
    const double* back = b.of(3, row(n, k));
    const double* left = b.of(4, row(n, k));
    const std::ptrdiff_t m = n - k;
    for (std::ptrdiff_t j = 1; j < m; ++j)
    {
      const double y = static_cast<double>(j) * step;
      const double eta = y / h;
      const double* q0 = base(0, j);
      const double* q1 = base(k, j);
      const double* q2 = base(k, j + k);
      const double* q3 = base(0, j + k);
      const double* e0 = base(0, 0);
      const double* e1 = base(k, 0);
      const double* e2 = base(k, n);
      const double* e3 = base(0, n);
      const auto corner = [&](const double* face, const double* end, const double* edge)
      { return Fixed<dim>([&](int c) { return face[dim * j + c] - end[c] - edge[c]; }); };
      const Fixed<dim> f0 = corner(left, base(0, j), front);
      const Fixed<dim> f1 = corner(right, base(n, j), front + dim * m);
      const Fixed<dim> f2 = corner(right, base(n, j + k), back + dim * m);
      const Fixed<dim> f3 = corner(left, base(0, j + k), back);
      // What is linear in xi: the straight pyramid and the level's transfinite surface at its ends.
      const auto end = [&](const double* face, const double* low, const double* high, int p0, int p3)
      {
        return Fixed<dim>(
            [&](int c)
            {
              return (1.0 - h * h) * (face[dim * j + c] - (1.0 - eta) * low[c] - eta * high[c]) +
                     (h - y) * p[p0][c] + y * p[p3][c] + z * p[4][c];
            });
      };
      const Fixed<dim> at_left = end(left, front, back, 0, 3);
      const Fixed<dim> at_right = end(right, front + dim * m, back + dim * m, 1, 2);
      for (std::ptrdiff_t i = 1; i < m; ++i)
      {
        const double r = static_cast<double>(i) * step;
        const double xi = r / h;
        for (int c = 0; c < dim; ++c)
        {
          const std::ptrdiff_t t = dim * i + c;
          *x++ = (h - y) *
                     ((h - r) * (q0[t] - e0[t] + front[t] + f0[c]) + r * (q1[t] - e1[t] + front[t] + f1[c])) +
                 y * (r * (q2[t] - e2[t] + back[t] + f2[c]) + (h - r) * (q3[t] - e3[t] + back[t] + f3[c])) +
                 (1.0 - h * h) * ((1.0 - eta) * front[t] + eta * back[t]) + (1.0 - xi) * at_left[c] +
                 xi * at_right[c];
        }
      }
    }
  }
}

/// The loop of a shape.
inline void place(const Sides& sides, blockfsi::element::Shape shape, double* x)
{
  using blockfsi::element::Shape;
  switch (shape)
  {
  case Shape::triangle:
    return triangle(sides, x);
  case Shape::quadrilateral:
    return quadrilateral(sides, x);
  case Shape::tetrahedron:
    return tetrahedron(sides, x);
  case Shape::hexahedron:
    return hexahedron(sides, x);
  case Shape::prism:
    return prism(sides, x);
  default:
    return pyramid(sides, x);
  }
}

}  // namespace benchmarks::by_hand
