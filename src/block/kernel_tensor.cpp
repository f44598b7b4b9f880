#include "block/kernel.hpp"

#include <cstddef>

namespace blockfsi::block
{

/// Both ruled surfaces less the bilinear one, which they share (Gordon & Hall 1973), at one row:
/// (1 - v) front + v back + (1 - u) (left - ...) + u (right - ...).
template <int dim>
void place_quadrilateral(const BlockPlan& plan, std::span<const BlockPlan::Row> rows,
                         const BoundaryData<dim>& at, double* x)
{
  const double* reference = plan.reference.data();
  const bool graded_alike = plan.reference.empty();
  const auto& c = at.corner;
  for (const BlockPlan::Row& row : rows)
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

/// What a row has at its two ends, less what the faces along it give there, for weights v and w.
struct HexahedronEnds
{
  HexahedronEnds(const BlockPlan& plan, const BoundaryData<3>& at, int j, int k)
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

}  // namespace

/// Sum over faces less sum over edges plus sum over corners (Gordon & Hall 1973), arranged by rows along u:
/// (1 - v) F + v B + (1 - w) bottom + w top + (1 - u) L + u R, where F and B are front and back less the
/// edges along u and L and R are HexahedronEnds.
void place_hexahedron(const BlockPlan& plan, std::span<const BlockPlan::Row> rows, const BoundaryData<3>& at,
                      double* x)
{
  const std::ptrdiff_t length = plan.grid.steps[0] + 1;
  const std::ptrdiff_t last_j = plan.grid.steps[1];
  const std::ptrdiff_t last_k = plan.grid.steps[2];
  const double* reference = plan.reference.data();
  const bool graded_alike = plan.reference.empty();
  double* front_rest = at.work;
  double* back_rest = at.work + dim * length;
  int level = -1;
  for (const BlockPlan::Row& row : rows)
  {
    const double* face_front = at.side[front] + dim * length * row.k;
    const double* face_back = at.side[back] + dim * length * row.k;
    const double* face_bottom = at.side[bottom] + dim * length * row.j;
    const double* face_top = at.side[top] + dim * length * row.j;
    const std::array<const double*, 4> edge{at.side[bottom], at.side[bottom] + dim * length * last_j,
                                            at.side[front] + dim * length * last_k,
                                            at.side[back] + dim * length * last_k};
    const HexahedronEnds ends(plan, at, row.j, row.k);
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

std::size_t kernel_work(const BlockPlan& plan, int dimension)
{
  const bool needs = plan.grid.shape == element::Shape::hexahedron;
  return needs ? 2 * static_cast<std::size_t>(dimension) * (static_cast<std::size_t>(plan.grid.steps[0]) + 1)
               : 0;
}

}  // namespace blockfsi::block
