#include "block/blend.hpp"

#include <algorithm>
#include <array>

namespace blockfsi::block
{

namespace
{

using element::Shape;

/// Coordinates on the boundary of a block, in the order of its sides.
template <int dim>
struct Boundary
{
  std::array<const double*, 6> side{};
  std::array<std::array<double, dim>, 8> corner{};
  double* work = nullptr;  ///< what is left of the working memory
};

template <int dim>
Boundary<dim> gather(const BlockPlan& plan, const double* skeleton_x, double* work)
{
  Boundary<dim> boundary;
  for (std::size_t side = 0; side < plan.sides.size(); ++side)
  {
    boundary.side[side] = work;
    for (const std::int32_t node : plan.sides[side])
      for (int c = 0; c < dim; ++c)
        *work++ = skeleton_x[static_cast<std::ptrdiff_t>(dim) * node + c];
  }
  for (int k = 0; k < element::corner_count(plan.grid.shape); ++k)
    for (int c = 0; c < dim; ++c)
      boundary.corner[k][c] = skeleton_x[static_cast<std::ptrdiff_t>(dim) * plan.corners[k] + c];
  boundary.work = work;
  return boundary;
}

/// Both ruled surfaces less the bilinear one, which they share (Gordon & Hall 1973), at one row:
/// (1 - v) front + v back + (1 - u) (left - ...) + u (right - ...).
template <int dim>
void place_quadrilateral(const BlockPlan& plan, const Boundary<dim>& at, double* x)
{
  const double* reference = plan.reference.data();
  const bool graded_alike = plan.reference.empty();
  const auto& c = at.corner;
  for (const BlockPlan::Row& row : plan.rows)
  {
    const double* left = at.side[3] + static_cast<std::ptrdiff_t>(dim) * row.j;
    const double* right = at.side[1] + static_cast<std::ptrdiff_t>(dim) * row.j;
    const double* front = at.side[0] + static_cast<std::ptrdiff_t>(dim) * row.begin;
    const double* back = at.side[2] + static_cast<std::ptrdiff_t>(dim) * row.begin;
    double* out = x + static_cast<std::ptrdiff_t>(dim) * row.node;
    const int count = row.end - row.begin;
    if (graded_alike)
    {
      const double v = plan.lines[1][row.j];
      const double* u = plan.lines[0].data() + row.begin;
      std::array<double, dim> low{};
      std::array<double, dim> rise{};
      for (int d = 0; d < dim; ++d)
      {
        low[d] = left[d] - (1.0 - v) * c[0][d] - v * c[3][d];
        rise[d] = right[d] - (1.0 - v) * c[1][d] - v * c[2][d] - low[d];
      }
      for (int i = 0; i < count; ++i)
        for (int d = 0; d < dim; ++d)
          out[dim * i + d] = (1.0 - v) * front[dim * i + d] + v * back[dim * i + d] + low[d] + u[i] * rise[d];
      continue;
    }
    for (int i = 0; i < count; ++i)
    {
      const double u = *reference++;
      const double v = *reference++;
      for (int d = 0; d < dim; ++d)
        out[dim * i + d] = (1.0 - v) * (front[dim * i + d] - (1.0 - u) * c[0][d] - u * c[1][d]) +
                           v * (back[dim * i + d] - (1.0 - u) * c[3][d] - u * c[2][d]) + (1.0 - u) * left[d] +
                           u * right[d];
    }
  }
}

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

/// Coordinates of the edges along xi and of the faces through them, as a row sees them.
template <int dim>
struct HexahedronRow
{
  std::array<const double*, 4> edge{};  ///< at (v, w) = (0, 0), (1, 0), (0, 1), (1, 1)
  const double* front = nullptr;
  const double* back = nullptr;
  const double* bottom = nullptr;
  const double* top = nullptr;
};

/// What a row has at its two ends, less what the faces along it give there, for weights v and w.
template <int dim>
struct HexahedronEnds
{
  HexahedronEnds(const BlockPlan& plan, const Boundary<dim>& at, int j, int k)
  {
    const std::ptrdiff_t columns = plan.grid.steps[1] + 1;
    const std::ptrdiff_t last_j = plan.grid.steps[1];
    const std::ptrdiff_t last_k = plan.grid.steps[2];
    for (int end = 0; end < 2; ++end)
    {
      const double* face = at.side[end == 0 ? HexahedronSide::left : HexahedronSide::right];
      const auto point = [&](std::ptrdiff_t s, std::ptrdiff_t t) { return face + dim * (s + columns * t); };
      face_[end] = point(j, k);
      along_w_[end] = {point(0, k), point(last_j, k)};
      along_v_[end] = {point(j, 0), point(j, last_k)};
      corner_[end] = {point(0, 0), point(last_j, 0), point(0, last_k), point(last_j, last_k)};
    }
  }

  double value(int end, int d, double v, double w) const
  {
    return face_[end][d] - (1.0 - v) * along_w_[end][0][d] - v * along_w_[end][1][d] -
           (1.0 - w) * along_v_[end][0][d] - w * along_v_[end][1][d] +
           (1.0 - v) * ((1.0 - w) * corner_[end][0][d] + w * corner_[end][2][d]) +
           v * ((1.0 - w) * corner_[end][1][d] + w * corner_[end][3][d]);
  }

private:
  std::array<const double*, 2> face_{};
  std::array<std::array<const double*, 2>, 2> along_w_{};
  std::array<std::array<const double*, 2>, 2> along_v_{};
  std::array<std::array<const double*, 4>, 2> corner_{};
};

/// Sum over faces less sum over edges plus sum over corners (Gordon & Hall 1973), arranged by rows along u:
/// (1 - v) F + v B + (1 - w) bottom + w top + (1 - u) L + u R, where F and B are front and back less the
/// edges along u and L and R are HexahedronEnds.
template <int dim>
void place_hexahedron(const BlockPlan& plan, const Boundary<dim>& at, double* x)
{
  const std::ptrdiff_t length = plan.grid.steps[0] + 1;
  const std::ptrdiff_t last_j = plan.grid.steps[1];
  const std::ptrdiff_t last_k = plan.grid.steps[2];
  const double* reference = plan.reference.data();
  const bool graded_alike = plan.reference.empty();
  double* front_rest = at.work;
  double* back_rest = at.work + dim * length;
  int level = -1;
  for (const BlockPlan::Row& row : plan.rows)
  {
    const double* face_front = at.side[front] + dim * length * row.k;
    const double* face_back = at.side[back] + dim * length * row.k;
    const double* face_bottom = at.side[bottom] + dim * length * row.j;
    const double* face_top = at.side[top] + dim * length * row.j;
    const std::array<const double*, 4> edge{at.side[bottom], at.side[bottom] + dim * length * last_j,
                                            at.side[front] + dim * length * last_k,
                                            at.side[back] + dim * length * last_k};
    const HexahedronEnds<dim> ends(plan, at, row.j, row.k);
    double* out =
        x + static_cast<std::ptrdiff_t>(dim) * row.node - static_cast<std::ptrdiff_t>(dim) * row.begin;
    if (!graded_alike)
    {
      for (int i = row.begin; i < row.end; ++i)
      {
        const double u = *reference++;
        const double v = *reference++;
        const double w = *reference++;
        for (int d = 0; d < dim; ++d)
        {
          const std::ptrdiff_t t = static_cast<std::ptrdiff_t>(dim) * i + d;
          out[t] = (1.0 - v) * (face_front[t] - (1.0 - w) * edge[0][t] - w * edge[2][t]) +
                   v * (face_back[t] - (1.0 - w) * edge[1][t] - w * edge[3][t]) + (1.0 - w) * face_bottom[t] +
                   w * face_top[t] + (1.0 - u) * ends.value(0, d, v, w) + u * ends.value(1, d, v, w);
        }
      }
      continue;
    }
    const double v = plan.lines[1][row.j];
    const double w = plan.lines[2][row.k];
    if (row.k != level)
    {
      level = row.k;
      for (std::ptrdiff_t t = 0; t < dim * length; ++t)
      {
        front_rest[t] = face_front[t] - (1.0 - w) * edge[0][t] - w * edge[2][t];
        back_rest[t] = face_back[t] - (1.0 - w) * edge[1][t] - w * edge[3][t];
      }
    }
    std::array<double, dim> low{};
    std::array<double, dim> rise{};
    for (int d = 0; d < dim; ++d)
    {
      low[d] = ends.value(0, d, v, w);
      rise[d] = ends.value(1, d, v, w) - low[d];
    }
    const double* u = plan.lines[0].data();
    for (int i = row.begin; i < row.end; ++i)
      for (int d = 0; d < dim; ++d)
      {
        const std::ptrdiff_t t = static_cast<std::ptrdiff_t>(dim) * i + d;
        out[t] = (1.0 - v) * front_rest[t] + v * back_rest[t] + (1.0 - w) * face_bottom[t] + w * face_top[t] +
                 low[d] + u[i] * rise[d];
      }
  }
}

template <int dim>
void blend(const BlockPlan& plan, const double* skeleton_x, double* work, double* x)
{
  const Boundary<dim> boundary = gather<dim>(plan, skeleton_x, work);
  switch (plan.grid.shape)
  {
  case Shape::quadrilateral:
    place_quadrilateral<dim>(plan, boundary, x);
    break;
  case Shape::hexahedron:
    if constexpr (dim == 3)
      place_hexahedron<dim>(plan, boundary, x);
    break;
  default:
    break;
  }
}

}  // namespace

std::size_t work_size(const BlockPlan& plan, int dim)
{
  std::size_t nodes = 2 * (static_cast<std::size_t>(plan.grid.steps[0]) + 1);
  for (const auto& side : plan.sides)
    nodes += side.size();
  return nodes * static_cast<std::size_t>(dim);
}

void blend(const BlockPlan& plan, int dim, const double* skeleton_x, double* work, double* x)
{
  if (plan.rows.empty())
    return;
  if (dim == 2)
    blend<2>(plan, skeleton_x, work, x);
  else
    blend<3>(plan, skeleton_x, work, x);
}

}  // namespace blockfsi::block
