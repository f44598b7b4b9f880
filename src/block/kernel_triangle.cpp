#include "block/kernel.hpp"

#include <array>
#include <cstddef>

namespace blockfsi::block
{

namespace
{

/// Barycentric weights of a node.
using Weights = std::array<double, 3>;

/// Reads the weights of the nodes of a row: equal steps, or those stored.
class RowWeights
{
public:
  RowWeights(const BlockPlan& plan) : plan_(plan), stored_(plan.reference.data()) {}

  Weights next(int i, int j)
  {
    if (plan_.reference.empty())
    {
      const std::vector<double>& line = plan_.lines[0];
      return {1.0 - line[i] - line[j], line[i], line[j]};
    }
    const Weights weights{1.0 - stored_[0] - stored_[1], stored_[0], stored_[1]};
    stored_ += 2;
    return weights;
  }

private:
  const BlockPlan& plan_;
  const double* stored_;
};

/// Differences along the three edges of a triangle (0, 1), (1, 2), (0, 2) at node (i, j): the parallel form
/// sum_i w_i (E_ij(w_j) + E_ik(w_k)), shape of the arrays (n + 1, dim).
template <int dim>
struct Edges
{
  const double* e01;
  const double* e12;
  const double* e02;
  std::ptrdiff_t n;

  double blend(const Weights& w, std::ptrdiff_t i, std::ptrdiff_t j, std::ptrdiff_t c) const
  {
    const std::ptrdiff_t sum = i + j;
    return w[0] * (e01[dim * i + c] + e02[dim * j + c]) + w[1] * (e01[dim * sum + c] + e12[dim * j + c]) +
           w[2] * (e02[dim * sum + c] + e12[dim * (n - i) + c]);
  }
};

}  // namespace

template <int dim>
void place_triangle(const BlockPlan& plan, std::span<const BlockPlan::Row> rows, const BoundaryData<dim>& at,
                    double* x)
{
  const Edges<dim> edges{at.side[0], at.side[1], at.side[2], plan.grid.steps[0]};
  RowWeights weights(plan);
  for (const BlockPlan::Row& row : rows)
  {
    double* out = x + static_cast<std::ptrdiff_t>(dim) * row.node;
    for (int i = row.begin; i < row.end; ++i, out += dim)
    {
      const Weights w = weights.next(i, row.j);
      for (int c = 0; c < dim; ++c)
        out[c] = w[0] * at.corner[0][c] + w[1] * at.corner[1][c] + w[2] * at.corner[2][c] +
                 edges.blend(w, i, row.j, c);
    }
  }
}

template void place_triangle<2>(const BlockPlan&, std::span<const BlockPlan::Row>, const BoundaryData<2>&,
                                double*);
template void place_triangle<3>(const BlockPlan&, std::span<const BlockPlan::Row>, const BoundaryData<3>&,
                                double*);

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

/// What the parallel form over the three upright sides gives at a level: sides less the upright edges.
struct Level
{
  Level(const BoundaryData<3>& at, std::ptrdiff_t n, std::ptrdiff_t k)
      : edges{at.side[front] + dim * (n + 1) * k, at.side[right] + dim * (n + 1) * k,
              at.side[left] + dim * (n + 1) * k, n}
  {
  }

  double blend(const Weights& w, std::ptrdiff_t i, std::ptrdiff_t j, std::ptrdiff_t c) const
  {
    return edges.blend(w, i, j, c) - w[0] * edges.e01[c] - w[1] * edges.e12[c] -
           w[2] * edges.e12[dim * edges.n + c];
  }

  Edges<dim> edges;
};

}  // namespace

/// P(w, z) + (1 - z) (F_0 - P(w, 0)) + z (F_1 - P(w, 1)) with the parallel form P over the upright sides.
void place_prism(const BlockPlan& plan, std::span<const BlockPlan::Row> rows, const BoundaryData<3>& at,
                 double* x)
{
  const std::ptrdiff_t n = plan.grid.steps[0];
  const Level low(at, n, 0);
  const Level high(at, n, plan.grid.steps[2]);
  const bool alike = plan.reference.empty();
  const double* stored = plan.reference.data();
  const auto& p = at.corner;
  for (const BlockPlan::Row& row : rows)
  {
    const Level level(at, n, row.k);
    const std::ptrdiff_t first = triangle_row(n, row.j);
    const double* face_low = at.side[bottom] + dim * first;
    const double* face_high = at.side[top] + dim * first;
    double* out = x + static_cast<std::ptrdiff_t>(dim) * row.node;
    for (int i = row.begin; i < row.end; ++i, out += dim)
    {
      const double w1 = alike ? plan.lines[0][i] : stored[0];
      const double w2 = alike ? plan.lines[0][row.j] : stored[1];
      const double z = alike ? plan.lines[2][row.k] : stored[2];
      stored += alike ? 0 : 3;
      const Weights w{1.0 - w1 - w2, w1, w2};
      for (int c = 0; c < dim; ++c)
      {
        const std::ptrdiff_t t = static_cast<std::ptrdiff_t>(dim) * i + c;
        out[c] = level.blend(w, i, row.j, c) +
                 (1.0 - z) * (w[0] * p[0][c] + w[1] * p[1][c] + w[2] * p[2][c] + face_low[t] -
                              low.blend(w, i, row.j, c)) +
                 z * (w[0] * p[3][c] + w[1] * p[4][c] + w[2] * p[5][c] + face_high[t] -
                      high.blend(w, i, row.j, c));
      }
    }
  }
}

}  // namespace blockfsi::block
