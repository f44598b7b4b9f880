#include "block/kernel.hpp"

#include "block/kernel_row.hpp"

#include <cstddef>

namespace blockfsi::block
{

namespace
{

constexpr int dim = 3;

/// Sides of a prism.
enum PrismSide
{
  bottom,
  front,
  right,
  left,
  top
};

/// The upright sides of a prism at a level, along (0, 1), (0, 2) and (2, 1), less the upright edges: what the
/// parallel form takes there. Each has n + 1 points.
struct Level
{
  Level(double* memory, std::ptrdiff_t n)
      : e01(memory), e02(memory + dim * (n + 1)), e21(memory + 2 * dim * (n + 1)), last(dim * n)
  {
  }

  static std::size_t size(std::ptrdiff_t n) { return 3 * dim * (static_cast<std::size_t>(n) + 1); }

  /// Reads level k. The upright edges 0, 1 and 2 enter with the weights w_0, w_1, w_2 once, not twice.
  void read(const BoundaryData<3>& at, std::ptrdiff_t n, std::ptrdiff_t k) const
  {
    const std::ptrdiff_t offset = dim * (n + 1) * k;
    std::copy_n(at.side[front] + offset, dim * (n + 1), e01);
    std::copy_n(at.side[left] + offset, dim * (n + 1), e02);
    reverse_points(at.side[right] + offset, n + 1, dim, e21);
  }

  void subtract(const Level& other, double factor = 1.0) const
  {
    for (std::ptrdiff_t t = 0; t < 3 * (last + dim); ++t)
      e01[t] -= factor * other.e01[t];
  }

  double* e01;
  double* e02;
  double* e21;
  std::ptrdiff_t last;  ///< where the last point is
};

/// The parallel form along one row of a level; its corners may have something added.
struct LevelRow
{
  LevelRow(const Level& level, const std::array<Repeated<dim>, 3>& added, std::ptrdiff_t i, std::ptrdiff_t j)
      : first01(level.e01 + i), sum01(level.e01 + i + j), sum02(level.e02 + i + j), rest21(level.e21 + i)
  {
    const double* e12 = level.e21 + level.last - j;
    std::array<std::array<double, dim>, 3> sums;
    for (int c = 0; c < dim; ++c)
    {
      sums[0][c] = level.e02[j + c] - level.e01[c];
      sums[1][c] = e12[c] - level.e21[level.last + c];
      sums[2][c] = -level.e21[c];
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      fixed[k] = repeated<dim>(sums[k].data());
      for (int m = 0; m < dim; ++m)
        fixed[k][m] += added[k][m];
    }
  }

  template <typename Loader, typename U, typename V>
  Lanes blend(Loader load, std::ptrdiff_t t, int m, const U& u, const V& v) const
  {
    return (1.0 - v - u) * (load(first01 + t) + fixed[0][m]) + u * (load(sum01 + t) + fixed[1][m]) +
           v * (load(sum02 + t) + load(rest21 + t) + fixed[2][m]);
  }

  const double* first01;
  const double* sum01;
  const double* sum02;
  const double* rest21;
  std::array<Repeated<dim>, 3> fixed;
};

}  // namespace

/// P(w, z) + (1 - z) (F_0 - P(w, 0)) + z (F_1 - P(w, 1)) with the parallel form P over the upright sides:
/// P(w, z) - P(w, 0) is formed first, and P(w, 1) - P(w, 0) is what z takes of it. Where z is that of the
/// level, P takes all but the two faces once for the level.
void place_prism(const BlockPlan& plan, std::span<const BlockPlan::Row> rows, const BoundaryData<3>& at,
                 double* x)
{
  const std::ptrdiff_t n = plan.grid.steps[0];
  const auto place = [&](auto coordinates, double* work)
  {
    constexpr bool alike = decltype(coordinates)::are_alike;
    const Level low(work, n);
    const Level high(work + Level::size(n), n);
    const Level level(work + 2 * Level::size(n), n);
    low.read(at, n, 0);
    high.read(at, n, plan.grid.steps[2]);
    high.subtract(low);
    std::array<Repeated<dim>, 6> corner;
    for (std::size_t k = 0; k < 6; ++k)
      corner[k] = repeated<dim>(at.corner[k].data());
    std::array<Repeated<dim>, 3> at_height{};  // upright edges of the straight prism at the level
    int of_level = -1;
    for (const BlockPlan::Row& row : rows)
    {
      const RowCoordinates<alike> r = coordinates.next(row);
      if (row.k != of_level)
      {
        of_level = row.k;
        level.read(at, n, row.k);
        level.subtract(low);
        if constexpr (alike)
        {
          const double z = r.fixed[2];
          level.subtract(high, z);
          for (std::size_t k = 0; k < 3; ++k)
            for (int m = 0; m < dim; ++m)
              at_height[k][m] = (1.0 - z) * corner[k][m] + z * corner[k + 3][m];
        }
      }
      const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(dim) * row.begin;
      const std::ptrdiff_t j = static_cast<std::ptrdiff_t>(dim) * row.j;
      const LevelRow at_level(level, at_height, i, j);
      const LevelRow rise(high, at_height, i, j);
      const double* face_low = at.side[bottom] + dim * triangle_row(n, row.j) + i;
      const double* face_high = at.side[top] + dim * triangle_row(n, row.j) + i;
      const auto value = [&](auto load, std::ptrdiff_t t, int m) -> Lanes
      {
        const Lanes u = r.template get<0>(load, t);
        const auto v = r.template get<1>(load, t);
        const auto z = r.template get<2>(load, t);
        const Lanes faces = (1.0 - z) * load(face_low + t) + z * load(face_high + t);
        if constexpr (alike)
          return at_level.blend(load, t, m, u, v) + faces;
        const Lanes w = 1.0 - v - u;
        return at_level.blend(load, t, m, u, v) - z * rise.blend(load, t, m, u, v) + faces +
               (1.0 - z) * (w * corner[0][m] + u * corner[1][m] + v * corner[2][m]) +
               z * (w * corner[3][m] + u * corner[4][m] + v * corner[5][m]);
      };
      write_row<dim>(at, row, x, value);
    }
  };
  with_coordinates<dim>(plan, at.work, place);
}

std::size_t prism_work(const BlockPlan& plan)
{
  return 3 * Level::size(plan.grid.steps[0]);
}

}  // namespace blockfsi::block
