#include "block/kernel.hpp"

#include <array>
#include <cstddef>

namespace blockfsi::block
{

namespace
{

constexpr int dim = 3;

/// Differences on the four faces, each with the lattice of a triangle with n steps.
struct Faces
{
  const double* f012;
  const double* f013;
  const double* f123;
  const double* f023;
  std::ptrdiff_t n;

  std::ptrdiff_t at(std::ptrdiff_t s, std::ptrdiff_t t) const { return dim * (s + triangle_row(n, t)); }
};

using Weights = std::array<double, 4>;

/// sum_i w_i (faces at vertex i - edges at vertex i): the local Boolean sums of the parallel form. Node (i,
/// j, k), m = n - i - j - k; every face is taken at the point that lies beside the node parallel to the
/// edges.
void blend(const Faces& f, const Weights& w, std::ptrdiff_t i, std::ptrdiff_t j, std::ptrdiff_t k,
           double* out)
{
  const std::ptrdiff_t n = f.n;
  const std::ptrdiff_t m = n - i - j - k;
  const std::ptrdiff_t sum = i + j + k;
  const double* faces0[3] = {f.f012 + f.at(i, j), f.f013 + f.at(i, k), f.f023 + f.at(j, k)};
  const double* faces1[3] = {f.f012 + f.at(i + k, j), f.f013 + f.at(i + j, k), f.f123 + f.at(j, k)};
  const double* faces2[3] = {f.f012 + f.at(i, j + k), f.f023 + f.at(i + j, k), f.f123 + f.at(m + j, k)};
  const double* faces3[3] = {f.f013 + f.at(i, j + k), f.f023 + f.at(j, i + k), f.f123 + f.at(j, m + k)};
  // Edges from one end: 01, 02, 03, 12, 13, 23.
  const double* edges0[3] = {f.f012 + f.at(i, 0), f.f012 + f.at(0, j), f.f013 + f.at(0, k)};
  const double* edges1[3] = {f.f012 + f.at(sum, 0), f.f123 + f.at(j, 0), f.f123 + f.at(0, k)};
  const double* edges2[3] = {f.f012 + f.at(0, sum), f.f123 + f.at(n - i, 0), f.f023 + f.at(n - k, k)};
  const double* edges3[3] = {f.f013 + f.at(0, sum), f.f123 + f.at(0, n - i), f.f023 + f.at(j, n - j)};
  for (int c = 0; c < dim; ++c)
    out[c] +=
        w[0] * (faces0[0][c] + faces0[1][c] + faces0[2][c] - edges0[0][c] - edges0[1][c] - edges0[2][c]) +
        w[1] * (faces1[0][c] + faces1[1][c] + faces1[2][c] - edges1[0][c] - edges1[1][c] - edges1[2][c]) +
        w[2] * (faces2[0][c] + faces2[1][c] + faces2[2][c] - edges2[0][c] - edges2[1][c] - edges2[2][c]) +
        w[3] * (faces3[0][c] + faces3[1][c] + faces3[2][c] - edges3[0][c] - edges3[1][c] - edges3[2][c]);
}

}  // namespace

void place_tetrahedron(const BlockPlan& plan, std::span<const BlockPlan::Row> rows, const BoundaryData<3>& at,
                       double* x)
{
  const Faces faces{at.side[0], at.side[1], at.side[2], at.side[3], plan.grid.steps[0]};
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
      const Weights w{1.0 - r[0] - r[1] - r[2], r[0], r[1], r[2]};
      for (int c = 0; c < dim; ++c)
        out[c] = w[0] * p[0][c] + w[1] * p[1][c] + w[2] * p[2][c] + w[3] * p[3][c];
      blend(faces, w, i, row.j, row.k, out);
    }
  }
}

}  // namespace blockfsi::block
