#include "block/kernel.hpp"

#include "block/kernel_row.hpp"

#include <array>
#include <cstddef>

namespace blockfsi::block
{

namespace
{

constexpr int dim = 3;

/// Differences on a face, the lattice of a triangle with n steps.
struct Face
{
  double* x;
  std::ptrdiff_t n;

  double* at(std::ptrdiff_t s, std::ptrdiff_t t) const { return x + dim * (s + triangle_row(n, t)); }
};

std::size_t face_size(std::ptrdiff_t n)
{
  return static_cast<std::size_t>(dim * triangle_row(n, n + 1));
}

/// Faces as the nodes of a row pass them: named by where they have (0, 0), (n, 0) and (0, n).
struct Faces
{
  const double* f012;
  const double* f013;
  const double* f123;
  const double* f023;
  Face f213;  ///< f123 with its first two corners swapped
  Face f231;  ///< f123 turned: (s, t) is (t, n - s - t) of f123
  Face f032;  ///< f023 with its last two corners swapped
  std::ptrdiff_t n;

  Faces(const BoundaryData<3>& at, std::ptrdiff_t steps, double* work)
      : f012(at.side[0]), f013(at.side[1]), f123(at.side[2]), f023(at.side[3]), f213{work, steps},
        f231{work + face_size(steps), steps}, f032{work + 2 * face_size(steps), steps}, n(steps)
  {
    for (std::ptrdiff_t t = 0; t <= n; ++t)
      for (std::ptrdiff_t s = 0; s + t <= n; ++s)
      {
        std::copy_n(of(f123, n - s - t, t), dim, f213.at(s, t));
        std::copy_n(of(f123, t, n - s - t), dim, f231.at(s, t));
        std::copy_n(of(f023, t, s), dim, f032.at(s, t));
      }
  }

  const double* of(const double* face, std::ptrdiff_t s, std::ptrdiff_t t) const
  {
    return face + dim * (s + triangle_row(n, t));
  }
};

/// What the parallel form takes at the nodes of a row (i, j, k): sum_v w_v (faces at vertex v - edges at
/// vertex v), the local Boolean sums. Every face is taken at the point that lies beside the node parallel to
/// the edges. Points that move with the node are given by where they are for the row's first node, all
/// others are added up, together with the corners of the straight tetrahedron.
struct FaceRow
{
  FaceRow(const Faces& f, const BoundaryData<3>& at, std::ptrdiff_t i, std::ptrdiff_t j, std::ptrdiff_t k)
      : moving{f.of(f.f012, i, j),      f.of(f.f013, i, k),
               f.of(f.f012, i, 0),      f.of(f.f012, i + k, j),
               f.of(f.f013, i + j, k),  f.of(f.f012, i + j + k, 0),
               f.of(f.f012, i, j + k),  f.of(f.f023, i + j, k),
               f.f213.at(i, k),         f.of(f.f023, i + j + k, 0),
               f.f213.at(i, 0),         f.of(f.f013, i, j + k),
               f.f032.at(i + k, j),     f.f231.at(i, j),
               f.f032.at(i + j + k, 0), f.f231.at(i, 0)}
  {
    std::array<std::array<double, dim>, 4> sums;
    const auto c_of = [&](const double* face, std::ptrdiff_t s, std::ptrdiff_t t, int c)
    { return f.of(face, s, t)[c]; };
    for (int c = 0; c < dim; ++c)
    {
      sums[0][c] = at.corner[0][c] + c_of(f.f023, j, k, c) - c_of(f.f012, 0, j, c) - c_of(f.f013, 0, k, c);
      sums[1][c] = at.corner[1][c] + c_of(f.f123, j, k, c) - c_of(f.f123, j, 0, c) - c_of(f.f123, 0, k, c);
      sums[2][c] = at.corner[2][c] - c_of(f.f023, f.n - k, k, c);
      sums[3][c] = at.corner[3][c] - c_of(f.f023, j, f.n - j, c);
    }
    for (std::size_t v = 0; v < 4; ++v)
      fixed[v] = repeated<dim>(sums[v].data());
  }

  std::array<const double*, 16> moving;
  std::array<Repeated<dim>, 4> fixed;
};

}  // namespace

void place_tetrahedron(const BlockPlan& plan, std::span<const BlockPlan::Row> rows, const BoundaryData<3>& at,
                       double* x)
{
  const auto place = [&](auto coordinates, double* work)
  {
    constexpr bool alike = decltype(coordinates)::are_alike;
    const Faces faces(at, plan.grid.steps[0], work);
    for (const BlockPlan::Row& row : rows)
    {
      const RowCoordinates<alike> r = coordinates.next(row);
      const FaceRow f(faces, at, row.begin, row.j, row.k);
      const auto value = [&](auto load, std::ptrdiff_t t, int m) -> Lanes
      {
        const auto a = [&](std::size_t q) { return load(f.moving[q] + t); };
        const Lanes w1 = r.template get<0>(load, t);
        const auto w2 = r.template get<1>(load, t);
        const auto w3 = r.template get<2>(load, t);
        return (1.0 - w2 - w3 - w1) * (a(0) + a(1) - a(2) + f.fixed[0][m]) +
               w1 * (a(3) + a(4) - a(5) + f.fixed[1][m]) +
               w2 * (a(6) + a(7) + a(8) - a(9) - a(10) + f.fixed[2][m]) +
               w3 * (a(11) + a(12) + a(13) - a(14) - a(15) + f.fixed[3][m]);
      };
      write_row<dim>(at, row, x, value);
    }
  };
  with_coordinates<dim>(plan, at.work, place);
}

std::size_t tetrahedron_work(const BlockPlan& plan)
{
  return 3 * face_size(plan.grid.steps[0]);
}

}  // namespace blockfsi::block
