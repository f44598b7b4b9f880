#include "block/connect.hpp"
#include "block/numbering.hpp"

#include "layouts.hpp"

#include <doctest/doctest.h>

#include <numeric>
#include <random>
#include <set>

using namespace blockfsi;
using namespace blockfsi::block;
using namespace blockfsi::block::testing;

namespace
{

/// Corners of a hexahedron in all 24 orders that turn it.
std::vector<std::array<int, 8>> turns()
{
  const auto corners = element::corners(element::Shape::hexahedron);
  std::vector<std::array<int, 8>> result;
  std::array<int, 3> axes{0, 1, 2};
  do
    for (int mirror = 0; mirror < 8; ++mirror)
    {
      int sign = 1;
      for (int a = 0; a < 3; ++a)
        for (int b = a + 1; b < 3; ++b)
          sign *= axes[a] < axes[b] ? 1 : -1;
      for (int d = 0; d < 3; ++d)
        sign *= (mirror >> d & 1) != 0 ? -1 : 1;
      if (sign < 0)
        continue;
      std::array<int, 8> turn{};
      for (int c = 0; c < 8; ++c)
      {
        std::array<double, 3> x{};
        for (int d = 0; d < 3; ++d)
          x[d] = (mirror >> d & 1) != 0 ? 1.0 - corners[c][axes[d]] : corners[c][axes[d]];
        turn[c] = static_cast<int>(std::find(corners.begin(), corners.end(), x) - corners.begin());
      }
      result.push_back(turn);
    }
  while (std::next_permutation(axes.begin(), axes.end()));
  return result;
}

/// 2 x 2 x 2 blocks over 27 points, the middle one moved, some edges curved and graded; each block lists its
/// corners in a random turn.
Layout eight_blocks(int order, std::mt19937& random, bool turned)
{
  Layout layout;
  layout.dim = 3;
  layout.order = order;
  layout.default_divisions = 2;
  const auto number = [](int i, int j, int k) { return i + 3 * (j + 3 * k); };
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i)
        layout.points.push_back({"p" + std::to_string(number(i, j, k)), {1.0 * i, 1.0 * j, 1.0 * k}, {}});
  layout.points[number(1, 1, 1)].x = {1.1, 0.9, 1.2};
  const auto all = turns();
  for (int b = 0; b < 8; ++b)
  {
    Block block{"b" + std::to_string(b), b < 4 ? "fluid" : "solid", {}, {}, element::Shape::hexahedron};
    const auto& turn = all[turned ? random() % 24 : 0];
    const auto corners = element::corners(element::Shape::hexahedron);
    for (int c = 0; c < 8; ++c)
    {
      const auto& x = corners[turn[c]];
      block.points.push_back(number(b % 2 + static_cast<int>(x[0]), b / 2 % 2 + static_cast<int>(x[1]),
                                    b / 4 + static_cast<int>(x[2])));
    }
    layout.blocks.push_back(block);
  }
  add_edge(layout, number(1, 1, 1), number(1, 2, 1)).curve = geometry::Through{{{1.1, 1.5, 1.3}}};
  Edge& graded = add_edge(layout, number(1, 1, 0), number(1, 1, 1));
  graded.curve = geometry::Through{{{0.9, 1.0, 0.5}}};
  graded.grading = Geometric{1.5};
  graded.divisions = 3;
  add_edge(layout, number(0, 0, 0), number(1, 0, 0)).divisions = 4;
  layout.boundaries.push_back(
      {"wall", ByCondition{{"x = 0 or x = 2 or y = 0 or y = 2 or z = 0 or z = 2", {}}}, {}});
  return layout;
}

/// Volume of a mesh of hexahedra, and the smallest Jacobian.
Measure measure_volume(const mesh::Mesh& mesh, const std::vector<double>& x)
{
  const int n = mesh.order + 1;
  const element::Rule rule = element::gauss(mesh.order + 2);
  const element::Table table = element::lagrange(element::lobatto(mesh.order), rule.points);
  const int m = table.point_count;
  Measure measure;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
    for (int q = 0; q < m * m * m; ++q)
    {
      const std::array<int, 3> at{q % m, q / m % m, q / m / m};
      double J[3][3] = {};
      for (int node = 0; node < n * n * n; ++node)
      {
        const std::array<int, 3> i{node % n, node / n % n, node / n / n};
        for (int d = 0; d < 3; ++d)
        {
          double value = 1.0;
          for (int e = 0; e < 3; ++e)
            value *= e == d ? table.first[at[e] * n + i[e]] : table.value[at[e] * n + i[e]];
          for (int k = 0; k < 3; ++k)
            J[d][k] += value * x[3 * mesh.cell(c)[node] + k];
        }
      }
      const double determinant = J[0][0] * (J[1][1] * J[2][2] - J[1][2] * J[2][1]) -
                                 J[0][1] * (J[1][0] * J[2][2] - J[1][2] * J[2][0]) +
                                 J[0][2] * (J[1][0] * J[2][1] - J[1][1] * J[2][0]);
      measure.area += rule.weights[at[0]] * rule.weights[at[1]] * rule.weights[at[2]] * determinant;
      measure.smallest = std::min(measure.smallest, determinant);
    }
  return measure;
}

/// Positions, rounded, of all nodes.
std::set<std::array<long, 3>> positions(const std::vector<double>& x)
{
  std::set<std::array<long, 3>> result;
  for (std::size_t n = 0; n < x.size(); n += 3)
    result.insert({std::lround(x[n] * 1e11), std::lround(x[n + 1] * 1e11), std::lround(x[n + 2] * 1e11)});
  return result;
}

}  // namespace

TEST_CASE("hexahedra fill their domain and have positive Jacobians at any order")
{
  std::mt19937 random(1);
  for (const int order : {1, 2, 3, 5})
  {
    const Layout layout = eight_blocks(order, random, true);
    const Skeleton skeleton = make_skeleton(layout);
    const Connected all = connect(layout, skeleton, "", {});
    CHECK(all.mesh.cell_count() == 6u * 4u * 5u);
    CHECK(all.mesh.node_count() == (6u * order + 1) * (4u * order + 1) * (5u * order + 1));
    const Measure found = measure_volume(all.mesh, place(all, skeleton));
    CHECK(found.area == doctest::Approx(8.0).epsilon(1e-13));
    CHECK(found.smallest > 0.0);
  }
}

TEST_CASE("the nodes do not depend on how blocks list their corners")
{
  std::mt19937 random(2);
  const Layout plain = eight_blocks(3, random, false);
  const Skeleton skeleton = make_skeleton(plain);
  const auto expected = positions(place(connect(plain, skeleton, "", {}), skeleton));
  for (int trial = 0; trial < 20; ++trial)
  {
    const Layout layout = eight_blocks(3, random, true);
    const Skeleton turned = make_skeleton(layout);
    const auto found = positions(place(connect(layout, turned, "", {}), turned));
    std::size_t common = 0;
    for (const auto& x : found)
      common += expected.count(x);
    // Rounding splits a few.
    CHECK(found.size() == expected.size());
    CHECK(common > expected.size() - 20);
  }
}

TEST_CASE("each inner face of hexahedral cells has two cells, each outer one belongs to the boundary")
{
  std::mt19937 random(3);
  for (const int order : {1, 2})
  {
    const Layout layout = eight_blocks(order, random, true);
    const Skeleton skeleton = make_skeleton(layout);
    const mesh::Mesh mesh = connect(layout, skeleton, "", {}).mesh;
    std::map<std::set<std::int32_t>, int> count;
    for (std::size_t c = 0; c < mesh.cell_count(); ++c)
      for (int side = 0; side < 6; ++side)
      {
        std::set<std::int32_t> nodes;
        for (const std::int32_t at : element::side_lattice(element::Shape::hexahedron, order, side))
          nodes.insert(mesh.cell(c)[at]);
        ++count[nodes];
      }
    std::size_t outer = 0;
    for (const auto& [nodes, cells] : count)
    {
      CHECK(cells <= 2);
      outer += cells == 1 ? 1 : 0;
    }
    CHECK(outer == 2u * (6 * 4 + 6 * 5 + 4 * 5));
    CHECK(mesh.boundaries.at("wall").size() == outer);
    for (const mesh::Side& side : mesh.boundaries.at("wall"))
    {
      std::set<std::int32_t> nodes;
      for (const std::int32_t at : element::side_lattice(element::Shape::hexahedron, order, side.side))
        nodes.insert(mesh.cell(side.cell)[at]);
      CHECK(count.at(nodes) == 1);
    }
  }
}

TEST_CASE("regions of hexahedra share just the interface nodes, bit for bit")
{
  std::mt19937 random(4);
  const Layout layout = eight_blocks(2, random, true);
  const Skeleton skeleton = make_skeleton(layout);
  const Connected fluid = connect(layout, skeleton, "fluid", {});
  const Connected solid = connect(layout, skeleton, "solid", {});
  std::vector<std::int64_t> shared;
  std::set_intersection(fluid.mesh.lattice.begin(), fluid.mesh.lattice.end(), solid.mesh.lattice.begin(),
                        solid.mesh.lattice.end(), std::back_inserter(shared));
  CHECK(shared == interface_nodes(layout, skeleton, "fluid", "solid"));
  CHECK(fluid.mesh.boundaries.at("interface").size() == 6u * 4u);
  const std::vector<double> x = place(fluid, skeleton);
  const std::vector<double> y = place(solid, skeleton);
  for (const std::int64_t node : shared)
  {
    const auto a = std::lower_bound(fluid.mesh.lattice.begin(), fluid.mesh.lattice.end(), node) -
                   fluid.mesh.lattice.begin();
    const auto b = std::lower_bound(solid.mesh.lattice.begin(), solid.mesh.lattice.end(), node) -
                   solid.mesh.lattice.begin();
    for (int c = 0; c < 3; ++c)
      CHECK(x[3 * a + c] == y[3 * b + c]);
  }
}
