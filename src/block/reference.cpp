#include "block/reference.hpp"

#include "block/crossing.hpp"
#include "block/reference_triangular.hpp"

#include <algorithm>
#include <cmath>

namespace blockfsi::block
{

namespace
{

using element::Shape;

/// Edges of a hexahedron along each direction, at the other two coordinates (0, 0), (1, 0), (0, 1), (1, 1).
constexpr std::array<std::array<int, 4>, 3> hexahedron_lines{{{0, 2, 4, 6}, {3, 1, 7, 5}, {8, 9, 11, 10}}};

void set_quadrilateral(const EdgeParameters& edges, BlockPlan& plan)
{
  if (edges[0] == edges[2] && edges[3] == edges[1])
  {
    plan.lines = {edges[0], edges[3], {}};
    return;
  }
  for (const BlockPlan::Row& row : plan.rows)
    for (int i = row.begin; i < row.end; ++i)
    {
      const std::array<double, 2> uv = crossing(edges[0][i], edges[2][i], edges[3][row.j], edges[1][row.j]);
      plan.reference.insert(plan.reference.end(), uv.begin(), uv.end());
    }
}

/// Parameters of the four edges along a direction at one line of the lattice.
using Four = std::array<double, 4>;

double bilinear(const Four& at, double s, double t)
{
  return (1.0 - t) * ((1.0 - s) * at[0] + s * at[1]) + t * ((1.0 - s) * at[2] + s * at[3]);
}

/// Where the three families of lines meet: Gauss-Seidel sweeps, which end at once where edges are alike.
std::array<double, 3> crossing(const std::array<Four, 3>& at)
{
  std::array<double, 3> x{};
  for (int d = 0; d < 3; ++d)
    x[d] = bilinear(at[d], 0.5, 0.5);
  for (int sweep = 0; sweep < 200; ++sweep)
  {
    const std::array<double, 3> before = x;
    x[0] = bilinear(at[0], x[1], x[2]);
    x[1] = bilinear(at[1], x[0], x[2]);
    x[2] = bilinear(at[2], x[0], x[1]);
    if (std::abs(x[0] - before[0]) + std::abs(x[1] - before[1]) + std::abs(x[2] - before[2]) < 1e-15)
      break;
  }
  return x;
}

void set_hexahedron(const EdgeParameters& edges, BlockPlan& plan)
{
  const auto alike = [&](const std::array<int, 4>& line)
  { return std::all_of(line.begin(), line.end(), [&](int e) { return edges[e] == edges[line[0]]; }); };
  if (std::all_of(hexahedron_lines.begin(), hexahedron_lines.end(), alike))
  {
    for (std::size_t d = 0; d < 3; ++d)
      plan.lines[d] = edges[hexahedron_lines[d][0]];
    return;
  }
  const auto four = [&](int d, int line)
  {
    Four at{};
    for (std::size_t e = 0; e < 4; ++e)
      at[e] = edges[hexahedron_lines[d][e]][line];
    return at;
  };
  for (const BlockPlan::Row& row : plan.rows)
    for (int i = row.begin; i < row.end; ++i)
    {
      const std::array<double, 3> uvw = crossing({four(0, i), four(1, row.j), four(2, row.k)});
      plan.reference.insert(plan.reference.end(), uvw.begin(), uvw.end());
    }
}

}  // namespace

std::vector<double> directed_parameters(const Skeleton& skeleton, const PlacedEdge& edge, int first)
{
  std::vector<double> t{0.0};
  t.insert(t.end(), skeleton.parameter.begin() + edge.first,
           skeleton.parameter.begin() + edge.first + edge.count);
  t.push_back(1.0);
  if (edge.a != first)
  {
    std::reverse(t.begin(), t.end());
    for (double& value : t)
      value = 1.0 - value;
  }
  return t;
}

void set_reference(const EdgeParameters& edges, int order, int diagonal, BlockPlan& plan)
{
  switch (plan.grid.shape)
  {
  case Shape::quadrilateral:
    return set_quadrilateral(edges, plan);
  case Shape::hexahedron:
    return set_hexahedron(edges, plan);
  default:
    return set_triangular(edges, order, diagonal, plan);
  }
}

}  // namespace blockfsi::block
