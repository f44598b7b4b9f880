#include "block/kernel.hpp"

#include "block/kernel_row.hpp"

#include <array>
#include <cstddef>
#include <limits>

namespace blockfsi::block
{

namespace
{

constexpr int dim = 3;
/// Makes 0 of 0 / h at the apex, where h is 0, and changes no other h.
constexpr double at_apex = std::numeric_limits<double>::min();

/// Sides of a pyramid.
enum PyramidSide
{
  base,
  front,
  right,
  back,
  left
};

/// What the faces give along a row (i, j, k). Faces differ from those of the straight pyramid by `front` ...
/// `left` (triangles with n steps) and the base (n by n steps). A corner of the base takes the base at the
/// point beside the node, parallel to the edges of the corner, and the two triangles at the node's level.
struct FaceRow
{
  FaceRow(const BoundaryData<3>& at, std::ptrdiff_t n, std::ptrdiff_t i, std::ptrdiff_t j, std::ptrdiff_t k)
  {
    const auto on_base = [&](std::ptrdiff_t s, std::ptrdiff_t t)
    { return at.side[base] + dim * (s + (n + 1) * t); };
    const auto on = [&](PyramidSide face, std::ptrdiff_t s)
    { return at.side[face] + dim * (s + triangle_row(n, k)); };
    near_base = {on_base(i, j), on_base(i + k, j), on_base(i + k, j + k), on_base(i, j + k)};
    near_edge = {on_base(i, 0), on_base(i + k, 0), on_base(i + k, n), on_base(i, n)};
    along_front = on(front, i);
    along_back = on(back, i);
    right_face = repeated<dim>(on(right, j));
    left_face = repeated<dim>(on(left, j));
    edge = {repeated<dim>(on(front, 0)), repeated<dim>(on(front, n - k)), repeated<dim>(on(back, n - k)),
            repeated<dim>(on(back, 0))};
    const std::array<const double*, 4> ends{on_base(0, j), on_base(n, j), on_base(n, j + k),
                                            on_base(0, j + k)};
    for (std::size_t q = 0; q < 4; ++q)
    {
      fixed[q] = repeated<dim>(ends[q]);
      const Repeated<dim>& side = q == 0 || q == 3 ? left_face : right_face;
      for (int m = 0; m < dim; ++m)
        fixed[q][m] = side[m] - fixed[q][m] - edge[q][m];
    }
  }

  std::array<const double*, 4> near_base;  ///< of the row's first node, for the corners 0 to 3
  std::array<const double*, 4> near_edge;  ///< on the edges (0, 1) and (3, 2) of the base
  const double* along_front;
  const double* along_back;
  Repeated<dim> right_face;
  Repeated<dim> left_face;
  std::array<Repeated<dim>, 4> edge;   ///< upright edges at the level
  std::array<Repeated<dim>, 4> fixed;  ///< what the corners take that is the same along the row
};

}  // namespace

/// The straight pyramid and sum_a w_a T_a with the polynomial weights of formulation.md 1: T_1 to T_4 are the
/// local Boolean sums at the corners of the base, T_5 is the transfinite surface of the level. As w_1 + w_2
/// is (1 - z) (1 - z - r_1), the two faces along the rows need no weights of their own.
void place_pyramid(const BlockPlan& plan, std::span<const BlockPlan::Row> rows, const BoundaryData<3>& at,
                   double* x)
{
  std::array<Repeated<dim>, 5> p;
  for (std::size_t k = 0; k < 5; ++k)
    p[k] = repeated<dim>(at.corner[k].data());
  const std::ptrdiff_t n = plan.grid.steps[0];
  const auto place = [&](auto coordinates, double* work)
  {
    constexpr bool alike = decltype(coordinates)::are_alike;
    // Of the faces in front and at the back with their edges of the base, what a level takes.
    double* at_front = work;
    double* at_back = work + dim * (n + 1);
    int of_level = -1;
    for (const BlockPlan::Row& row : rows)
    {
      const RowCoordinates<alike> r = coordinates.next(row);
      const FaceRow f(at, n, row.begin, row.j, row.k);
      // What is linear in xi, where it is 0 (corner 0) and 1 (corner 1): the straight pyramid, and of the
      // transfinite surface of the level what the ends of the row give.
      const auto at_end = [&](std::size_t q, const auto& r1, const auto& z, int m) -> Lanes
      {
        const auto h = 1.0 - z;
        const auto eta = r1 / (h + at_apex);
        const Lanes& face = q == 0 ? f.left_face[m] : f.right_face[m];
        return (h - r1) * p[q][m] + r1 * p[3 - q][m] + z * p[4][m] +
               (1.0 - h * h) * (face - (1.0 - eta) * f.edge[q][m] - eta * f.edge[3 - q][m]);
      };
      const std::ptrdiff_t begin = static_cast<std::ptrdiff_t>(dim) * row.begin;
      std::array<Repeated<dim>, 2> ends{};
      if constexpr (alike)
      {
        for (std::size_t q = 0; q < 2; ++q)
          for (int m = 0; m < dim; ++m)
            ends[q][m] = at_end(q, r.fixed[1], r.fixed[2], m);
        if (row.k != of_level)
        {
          of_level = row.k;
          const double h = 1.0 - r.fixed[2];
          for (std::ptrdiff_t t = -begin; t < dim * (n - row.k + 1) - begin; ++t)
          {
            const double s = r.along[0][t];
            at_front[begin + t] =
                f.along_front[t] - h * ((h - s) * f.near_edge[0][t] + s * f.near_edge[1][t]);
            at_back[begin + t] = f.along_back[t] - h * ((h - s) * f.near_edge[3][t] + s * f.near_edge[2][t]);
          }
        }
      }
      const auto value = [&](auto load, std::ptrdiff_t t, int m) -> Lanes
      {
        const Lanes r0 = r.template get<0>(load, t);
        const auto r1 = r.template get<1>(load, t);
        const auto z = r.template get<2>(load, t);
        const auto h = 1.0 - z;
        const auto inverse = 1.0 / (h + at_apex);
        const Lanes xi = r0 * inverse;
        const auto eta = r1 * inverse;
        const auto rest = h - r1;
        const auto near = [&](std::size_t q) { return load(f.near_base[q] + t) + f.fixed[q][m]; };
        const auto edge = [&](std::size_t q) { return load(f.near_edge[q] + t); };
        const auto blend = [&](const Lanes& front, const Lanes& back, const Lanes& left, const Lanes& right)
        {
          return rest * ((h - r0) * near(0) + r0 * near(1)) + r1 * (r0 * near(2) + (h - r0) * near(3)) +
                 (1.0 - eta) * front + eta * back + (1.0 - xi) * left + xi * right;
        };
        if constexpr (alike)
          return blend(load(at_front + begin + t), load(at_back + begin + t), ends[0][m], ends[1][m]);
        else
          return blend(load(f.along_front + t) - h * ((h - r0) * edge(0) + r0 * edge(1)),
                       load(f.along_back + t) - h * ((h - r0) * edge(3) + r0 * edge(2)), at_end(0, r1, z, m),
                       at_end(1, r1, z, m));
      };
      write_row<dim>(at, row, x, value);
    }
  };
  with_coordinates<dim>(plan, at.work, place);
}

std::size_t pyramid_work(const BlockPlan& plan)
{
  return 2 * dim * (static_cast<std::size_t>(plan.grid.steps[0]) + 1);
}

}  // namespace blockfsi::block
