#pragma once

#include "block/connect.hpp"
#include "block/lattice.hpp"
#include "block/layout.hpp"
#include "block/place.hpp"
#include "core/error.hpp"
#include "element/line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Layouts and measures that several tests of blocks share.
namespace blockfsi::block::testing
{

inline std::vector<double> place(const Connected& connected, const Skeleton& skeleton)
{
  std::vector<double> x(connected.mesh.node_count() * connected.mesh.dim);
  block::place(connected.plan, skeleton.x, x);
  return x;
}

/// A layout without blocks.
inline Layout empty(int dim, int order)
{
  Layout layout;
  layout.dim = dim;
  layout.order = order;
  layout.default_divisions = 2;
  return layout;
}

/// An entry for the edge from point a to b, to be filled.
inline Edge& add_edge(Layout& layout, int a, int b)
{
  Edge& edge = layout.edges.emplace_back();
  edge.a = a;
  edge.b = b;
  return edge;
}

/// Number of a node in the lattice of all blocks.
inline std::int64_t lattice_number(const mesh::Mesh& mesh, std::size_t node)
{
  return mesh.lattice.empty() ? static_cast<std::int64_t>(node) : mesh.lattice[node];
}

/// Puts all outer edges that belong to no listed boundary into one named "wall".
inline void close(Layout& layout)
{
  std::map<std::pair<int, int>, int> count;
  for (const Block& block : layout.blocks)
    for (int side = 0; side < 4; ++side)
      ++count[std::minmax(block.points[side], block.points[(side + 1) % 4])];
  for (const Boundary& boundary : layout.boundaries)
    if (const auto* rule = std::get_if<ByEdges>(&boundary.rule))
      for (const auto& [a, b] : rule->edges)
        count.erase(std::minmax(a, b));
  ByEdges rule;
  for (const auto& [ends, blocks] : count)
    if (blocks == 1)
      rule.edges.push_back({ends.first, ends.second});
  layout.boundaries.push_back({"wall", rule, {}});
}

/// One block over four points, closed by "wall".
inline Layout one_block(const std::array<std::array<double, 2>, 4>& corners, int order, int divisions)
{
  Layout layout;
  layout.order = order;
  layout.default_divisions = divisions;
  for (int p = 0; p < 4; ++p)
    layout.points.push_back({"p" + std::to_string(p), {corners[p][0], corners[p][1], 0.0}, {}});
  layout.blocks.push_back({"block", "fluid", {0, 1, 2, 3}, {}});
  close(layout);
  return layout;
}

inline Layout unit_square(int order, int divisions)
{
  return one_block({{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}}, order, divisions);
}

/// Wall & Ramm's flap, variant A, as in the sketch of the case file.
inline Layout flap_layout(int order)
{
  Lattice lattice;
  lattice.name = "channel";
  lattice.x = {0.0, 0.045, 0.055, 0.095, 0.195};
  lattice.y = {0.12, 0.065, 0.0603, 0.0597, 0.055, 0.0};
  lattice.draw = {"fluid fluid fluid fluid", "fluid . fluid fluid", "fluid . flap fluid",
                  "fluid . fluid fluid", "fluid fluid fluid fluid"};
  lattice.divide_x = {4, 2, 5, 6};
  lattice.divide_y = {4, 2, 1, 2, 4};
  Layout layout;
  layout.order = order;
  add(layout, lattice);
  layout.boundaries = {{"inlet", ByCondition{{"x = 0", {}}}, {}},
                       {"outlet", ByCondition{{"x = 0.195", {}}}, {}},
                       {"sides", ByCondition{{"y = 0 or y = 0.12", {}}}, {}},
                       {"square", ByHole{"channel", 1}, {}}};
  return layout;
}

/// A ring about the origin of `sectors` blocks between two radii, with arcs.
inline Layout ring(double inner, double outer, int order, int divisions, int sectors = 4)
{
  Layout layout;
  layout.order = order;
  layout.default_divisions = divisions;
  for (int s = 0; s < sectors; ++s)
    for (const double radius : {inner, outer})
    {
      const double angle = 0.1 + 2.0 * std::acos(-1.0) * s / sectors;
      const std::string name = (radius == inner ? "inner" : "outer") + std::to_string(s);
      layout.points.push_back({name, {radius * std::cos(angle), radius * std::sin(angle), 0.0}, {}});
    }
  for (int s = 0; s < sectors; ++s)
  {
    const int next = (s + 1) % sectors;
    layout.blocks.push_back(
        {"sector " + std::to_string(s), "fluid", {2 * s, 2 * s + 1, 2 * next + 1, 2 * next}, {}});
    for (const int circle : {0, 1})
      add_edge(layout, 2 * s + circle, 2 * next + circle).curve = geometry::Arc{};
  }
  close(layout);
  return layout;
}

/// Area and smallest Jacobian (at Gauss points and the corners) of a mesh.
struct Measure
{
  double area = 0.0;
  double smallest = std::numeric_limits<double>::infinity();
};

inline Measure measure(const mesh::Mesh& mesh, const std::vector<double>& x)
{
  const int n = mesh.order + 1;
  element::Rule rule = element::gauss(mesh.order + 2);
  for (const double end : {0.0, 1.0})
  {
    rule.points.push_back(end);
    rule.weights.push_back(0.0);
  }
  const element::Table table = element::lagrange(element::lobatto(mesh.order), rule.points);
  Measure measure;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
    for (int q = 0; q < table.point_count; ++q)
      for (int r = 0; r < table.point_count; ++r)
      {
        std::array<double, 4> gradient{};
        for (int j = 0; j < n; ++j)
          for (int i = 0; i < n; ++i)
            for (int k = 0; k < 2; ++k)
            {
              const double value = x[2 * mesh.cell(c)[i + j * n] + k];
              gradient[2 * k] += table.first[q * n + i] * table.value[r * n + j] * value;
              gradient[2 * k + 1] += table.value[q * n + i] * table.first[r * n + j] * value;
            }
        const double determinant = gradient[0] * gradient[3] - gradient[1] * gradient[2];
        measure.area += rule.weights[q] * rule.weights[r] * determinant;
        measure.smallest = std::min(measure.smallest, determinant);
      }
  return measure;
}

/// The message of the Error that a call throws, or "".
template <typename Call>
std::string message_of(Call call)
{
  try
  {
    call();
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "";
}

}  // namespace blockfsi::block::testing
