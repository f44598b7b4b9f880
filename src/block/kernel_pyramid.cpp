#include "block/kernel.hpp"

#include <array>
#include <cstddef>

namespace blockfsi::block
{

namespace
{

constexpr int dim = 3;

/// Differences on the base, a lattice of n by n steps, and on the four triangles.
struct Faces
{
  const double* base;
  const double* front;
  const double* right;
  const double* back;
  const double* left;
  std::ptrdiff_t n;

  const double* on_base(std::ptrdiff_t i, std::ptrdiff_t j) const { return base + dim * (i + (n + 1) * j); }
  const double* on(const double* face, std::ptrdiff_t s, std::ptrdiff_t t) const
  {
    return face + dim * (s + triangle_row(n, t));
  }
};

/// sum_a w_a T_a with the polynomial weights of formulation.md 1: T_1 to T_4 are the local Boolean sums at
/// the corners of the base, T_5 is the transfinite surface of the level.
void blend(const Faces& f, const std::array<double, 3>& r, std::ptrdiff_t i, std::ptrdiff_t j,
           std::ptrdiff_t k, double* out)
{
  const std::ptrdiff_t n = f.n;
  const double h = 1.0 - r[2];
  const double xi = r[0] / h;
  const double eta = r[1] / h;
  const std::array<double, 5> w{(h - r[0]) * (h - r[1]), r[0] * (h - r[1]), r[0] * r[1], (h - r[0]) * r[1],
                                1.0 - h * h};
  const double* A = f.on(f.front, i, k);
  const double* B = f.on(f.right, j, k);
  const double* C = f.on(f.back, i, k);
  const double* D = f.on(f.left, j, k);
  const double* e1 = f.on(f.front, 0, k);
  const double* e2 = f.on(f.front, n - k, k);
  const double* e3 = f.on(f.back, n - k, k);
  const double* e4 = f.on(f.back, 0, k);
  const double* q1[3] = {f.on_base(i, j), f.on_base(i, 0), f.on_base(0, j)};
  const double* q2[3] = {f.on_base(i + k, j), f.on_base(i + k, 0), f.on_base(n, j)};
  const double* q3[3] = {f.on_base(i + k, j + k), f.on_base(i + k, n), f.on_base(n, j + k)};
  const double* q4[3] = {f.on_base(i, j + k), f.on_base(i, n), f.on_base(0, j + k)};
  for (int c = 0; c < dim; ++c)
    out[c] +=
        w[0] * (q1[0][c] + A[c] + D[c] - q1[1][c] - q1[2][c] - e1[c]) +
        w[1] * (q2[0][c] + A[c] + B[c] - q2[1][c] - q2[2][c] - e2[c]) +
        w[2] * (q3[0][c] + B[c] + C[c] - q3[1][c] - q3[2][c] - e3[c]) +
        w[3] * (q4[0][c] + C[c] + D[c] - q4[1][c] - q4[2][c] - e4[c]) +
        w[4] * ((1.0 - eta) * A[c] + eta * C[c] + (1.0 - xi) * D[c] + xi * B[c] -
                (1.0 - eta) * ((1.0 - xi) * e1[c] + xi * e2[c]) - eta * ((1.0 - xi) * e4[c] + xi * e3[c]));
}

}  // namespace

void place_pyramid(const BlockPlan& plan, std::span<const BlockPlan::Row> rows, const BoundaryData<3>& at,
                   double* x)
{
  const Faces faces{at.side[0], at.side[1], at.side[2], at.side[3], at.side[4], plan.grid.steps[0]};
  const bool alike = plan.reference.empty();
  const double* stored = plan.reference.data();
  const std::vector<double>& line = plan.lines[0];
  const auto& p = at.corner;
  for (const BlockPlan::Row& row : rows)
  {
    double* out = x + static_cast<std::ptrdiff_t>(dim) * row.node;
    for (int i = row.begin; i < row.end; ++i, out += dim)
    {
      const std::array<double, 3> r =
          alike ? std::array{line[i], line[row.j], line[row.k]} : std::array{stored[0], stored[1], stored[2]};
      stored += alike ? 0 : 3;
      const double h = 1.0 - r[2];
      const double xi = r[0] / h;
      for (int c = 0; c < dim; ++c)
        out[c] = (h - r[1]) * ((1.0 - xi) * p[0][c] + xi * p[1][c]) +
                 r[1] * ((1.0 - xi) * p[3][c] + xi * p[2][c]) + r[2] * p[4][c];
      blend(faces, r, i, row.j, row.k, out);
    }
  }
}

}  // namespace blockfsi::block
