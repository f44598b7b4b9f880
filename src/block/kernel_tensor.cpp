#include "block/kernel.hpp"

#include "block/kernel_row.hpp"

#include <cstddef>

namespace blockfsi::block
{

namespace
{

/// What a row has at one of its ends, less what the sides along it give there, where this depends on the
/// node: value + (1 - w) [(1 - v) c_0 + v c_1] + w [(1 - v) c_2 + v c_3].
template <int dim>
struct End
{
  Repeated<dim> value;
  std::array<Repeated<dim>, 4> corner;

  Lanes at(int m, const Lanes& v, const Lanes& w) const
  {
    return value[m] + (1.0 - w) * ((1.0 - v) * corner[0][m] + v * corner[1][m]) +
           w * ((1.0 - v) * corner[2][m] + v * corner[3][m]);
  }
};

}  // namespace

/// Both ruled surfaces less the bilinear one, which they share (Gordon & Hall 1973), at one row:
/// (1 - v) front + v back + (1 - u) (left - ...) + u (right - ...).
template <int dim>
void place_quadrilateral(const BlockPlan& plan, std::span<const BlockPlan::Row> rows,
                         const BoundaryData<dim>& at, double* x)
{
  const auto place = [&](auto coordinates, double*)
  {
    constexpr bool alike = decltype(coordinates)::are_alike;
    std::array<Repeated<dim>, 4> corner;
    for (std::size_t k = 0; k < 4; ++k)
      corner[k] = repeated<dim>(at.corner[k].data());
    for (const BlockPlan::Row& row : rows)
    {
      const std::ptrdiff_t j = static_cast<std::ptrdiff_t>(dim) * row.j;
      const RowCoordinates<alike> r = coordinates.next(row);
      Repeated<dim> left = repeated<dim>(at.side[3] + j);
      Repeated<dim> right = repeated<dim>(at.side[1] + j);
      if constexpr (alike)
        for (int m = 0; m < dim; ++m)
        {
          const double v = r.fixed[1];
          left[m] -= (1.0 - v) * corner[0][m] + v * corner[3][m];
          right[m] -= (1.0 - v) * corner[1][m] + v * corner[2][m] + left[m];
        }
      const double* front = at.side[0] + static_cast<std::ptrdiff_t>(dim) * row.begin;
      const double* back = at.side[2] + static_cast<std::ptrdiff_t>(dim) * row.begin;
      const auto value = [&](auto load, std::ptrdiff_t t, int m) -> Lanes
      {
        const auto u = r.template get<0>(load, t);
        const auto v = r.template get<1>(load, t);
        const Lanes between = (1.0 - v) * load(front + t) + v * load(back + t);
        if constexpr (alike)
          return between + left[m] + u * right[m];
        else
          return between + (1.0 - u) * (left[m] - (1.0 - v) * corner[0][m] - v * corner[3][m]) +
                 u * (right[m] - (1.0 - v) * corner[1][m] - v * corner[2][m]);
      };
      write_row<dim>(at, row, x, value);
    }
  };
  with_coordinates<dim>(plan, at.work, place);
}

template void place_quadrilateral<2>(const BlockPlan&, std::span<const BlockPlan::Row>,
                                     const BoundaryData<2>&, double*);
template void place_quadrilateral<3>(const BlockPlan&, std::span<const BlockPlan::Row>,
                                     const BoundaryData<3>&, double*);

namespace
{

constexpr int dim = 3;

/// Sides of a hexahedron.
enum HexahedronSide
{
  bottom,
  front,
  right,
  back,
  left,
  top
};

/// The left or the right face of a hexahedron: what rows have at one of their ends.
struct EndFace
{
  const double* face;
  std::ptrdiff_t last_j;
  std::ptrdiff_t last_k;

  const double* at(std::ptrdiff_t j, std::ptrdiff_t k) const { return face + dim * (j + (last_j + 1) * k); }

  /// The face at level k less what the faces along the rows give there, for graded coordinates v of the lines
  /// j and w of the level; shape (last_j + 1, dim).
  void level(std::ptrdiff_t k, const std::vector<double>& v, double w, double* out) const
  {
    const auto upright = [&](std::ptrdiff_t j, int c)
    { return at(j, k)[c] - (1.0 - w) * at(j, 0)[c] - w * at(j, last_k)[c]; };
    for (int c = 0; c < dim; ++c)
    {
      const double first = upright(0, c);
      const double last = upright(last_j, c);
      for (std::ptrdiff_t j = 0; j <= last_j; ++j)
        out[dim * j + c] = upright(j, c) - (1.0 - v[j]) * first - v[j] * last;
    }
  }

  End<dim> end(std::ptrdiff_t j, std::ptrdiff_t k) const
  {
    End<dim> result;
    result.value = repeated<dim>(at(j, k));
    for (std::ptrdiff_t q = 0; q < 4; ++q)
    {
      const std::ptrdiff_t s = q % 2 * last_j;
      const std::ptrdiff_t t = q / 2 * last_k;
      std::array<double, dim> corner;
      for (int c = 0; c < dim; ++c)
        corner[c] = at(s, t)[c] - at(s, k)[c] - at(j, t)[c];
      result.corner[q] = repeated<dim>(corner.data());
    }
    return result;
  }
};

/// The front or the back face of a hexahedron, with its edges along the rows.
struct AlongFace
{
  const double* face;
  std::ptrdiff_t size;  ///< numbers of a row
  std::ptrdiff_t last_k;

  const double* at(std::ptrdiff_t k) const { return face + size * k; }

  /// The face at level k less its two edges along the rows.
  void level(std::ptrdiff_t k, double w, double* out) const
  {
    for (std::ptrdiff_t t = 0; t < size; ++t)
      out[t] = at(k)[t] - (1.0 - w) * at(0)[t] - w * at(last_k)[t];
  }

  Lanes value(const auto& load, std::ptrdiff_t k, std::ptrdiff_t t, const Lanes& w) const
  {
    return load(at(k) + t) - (1.0 - w) * load(at(0) + t) - w * load(at(last_k) + t);
  }
};

/// The four upright faces of a hexahedron.
struct UprightFaces
{
  UprightFaces(const BlockPlan& plan, const BoundaryData<3>& at)
      : front_face{at.side[front], dim * (plan.grid.steps[0] + std::ptrdiff_t{1}), plan.grid.steps[2]},
        back_face{at.side[back], front_face.size, plan.grid.steps[2]}, left_face{at.side[left],
                                                                                 plan.grid.steps[1],
                                                                                 plan.grid.steps[2]},
        right_face{at.side[right], plan.grid.steps[1], plan.grid.steps[2]}
  {
  }

  AlongFace front_face;
  AlongFace back_face;
  EndFace left_face;
  EndFace right_face;
};

/// Where all lines of one direction are graded alike: what the upright faces give at a level.
void place_levels(const BlockPlan& plan, std::span<const BlockPlan::Row> rows, const BoundaryData<3>& at,
                  Coordinates<dim, true>& coordinates, double* work, double* x)
{
  const UprightFaces faces(plan, at);
  const std::ptrdiff_t size = faces.front_face.size;
  double* along_front = work;
  double* along_back = along_front + size;
  double* at_left = along_back + size;
  double* at_right = at_left + dim * (plan.grid.steps[1] + std::ptrdiff_t{1});
  int level = -1;
  for (const BlockPlan::Row& row : rows)
  {
    const RowCoordinates<true> r = coordinates.next(row);
    const double v = r.fixed[1];
    const double w = r.fixed[2];
    if (row.k != level)
    {
      level = row.k;
      faces.front_face.level(row.k, w, along_front);
      faces.back_face.level(row.k, w, along_back);
      faces.left_face.level(row.k, plan.lines[1], w, at_left);
      faces.right_face.level(row.k, plan.lines[1], w, at_right);
    }
    const std::ptrdiff_t begin = static_cast<std::ptrdiff_t>(dim) * row.begin;
    const double* bottom_row = at.side[bottom] + size * row.j + begin;
    const double* top_row = at.side[top] + size * row.j + begin;
    const double* front_row = along_front + begin;
    const double* back_row = along_back + begin;
    const Repeated<dim> low = repeated<dim>(at_left + static_cast<std::ptrdiff_t>(dim) * row.j);
    Repeated<dim> rise = repeated<dim>(at_right + static_cast<std::ptrdiff_t>(dim) * row.j);
    for (int m = 0; m < dim; ++m)
      rise[m] -= low[m];
    const auto value = [&](auto load, std::ptrdiff_t t, int m) -> Lanes
    {
      const Lanes u = r.get<0>(load, t);
      return (1.0 - v) * load(front_row + t) + v * load(back_row + t) + (1.0 - w) * load(bottom_row + t) +
             w * load(top_row + t) + low[m] + u * rise[m];
    };
    write_row<dim>(at, row, x, value);
  }
}

void place_nodes(const BlockPlan& plan, std::span<const BlockPlan::Row> rows, const BoundaryData<3>& at,
                 Coordinates<dim, false>& coordinates, double* x)
{
  const UprightFaces faces(plan, at);
  for (const BlockPlan::Row& row : rows)
  {
    const RowCoordinates<false> r = coordinates.next(row);
    const std::ptrdiff_t begin = static_cast<std::ptrdiff_t>(dim) * row.begin;
    const double* bottom_row = at.side[bottom] + faces.front_face.size * row.j + begin;
    const double* top_row = at.side[top] + faces.front_face.size * row.j + begin;
    const End<dim> low = faces.left_face.end(row.j, row.k);
    const End<dim> high = faces.right_face.end(row.j, row.k);
    const auto value = [&](auto load, std::ptrdiff_t t, int m) -> Lanes
    {
      const Lanes u = r.get<0>(load, t);
      const Lanes v = r.get<1>(load, t);
      const Lanes w = r.get<2>(load, t);
      return (1.0 - v) * faces.front_face.value(load, row.k, begin + t, w) +
             v * faces.back_face.value(load, row.k, begin + t, w) + (1.0 - w) * load(bottom_row + t) +
             w * load(top_row + t) + (1.0 - u) * low.at(m, v, w) + u * high.at(m, v, w);
    };
    write_row<dim>(at, row, x, value);
  }
}

}  // namespace

/// Sum over faces less sum over edges plus sum over corners (Gordon & Hall 1973), arranged by rows along u:
/// (1 - v) F + v B + (1 - w) bottom + w top + (1 - u) L + u R, where F and B are front and back less the
/// edges along u, L and R left and right less what the other four give there.
void place_hexahedron(const BlockPlan& plan, std::span<const BlockPlan::Row> rows, const BoundaryData<3>& at,
                      double* x)
{
  const auto place = [&](auto coordinates, double* work)
  {
    if constexpr (decltype(coordinates)::are_alike)
      place_levels(plan, rows, at, coordinates, work, x);
    else
      place_nodes(plan, rows, at, coordinates, x);
  };
  with_coordinates<dim>(plan, at.work, place);
}

std::size_t hexahedron_work(const BlockPlan& plan)
{
  return 2 * dim *
         (static_cast<std::size_t>(plan.grid.steps[0]) + static_cast<std::size_t>(plan.grid.steps[1]) + 2);
}

}  // namespace blockfsi::block
