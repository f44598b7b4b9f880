#pragma once

#include "block/connect.hpp"
#include "block/lattice.hpp"
#include "block/place.hpp"
#include "core/timing.hpp"
#include "element/line.hpp"
#include "fem/cell_geometry.hpp"
#include "linalg/communicator.hpp"
#include "linalg/numbering.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace verification
{

using Vector = std::array<double, 2>;

/// A meshed rectangle of 2 x 2 blocks, whose inner and outer lines may be bent.
struct Domain
{
  blockfsi::block::Layout layout;
  blockfsi::block::Skeleton skeleton;
  blockfsi::block::Connected connected;
  blockfsi::linalg::Numbering numbering;
  std::vector<double> x;

  const blockfsi::mesh::Mesh& mesh() const { return connected.mesh; }
};

/// `bend` [m] is the height of the arcs (sines) that replace the straight lines between the blocks and around
/// them; the four sides are boundaries "left", "right", "bottom", "top".
inline Domain rectangle(Vector low, Vector high, int cells_per_block, int order, double bend,
                        const std::string& region)
{
  using namespace blockfsi;
  Domain domain;
  block::Lattice lattice;
  lattice.name = "square";
  const Vector middle = {0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])};
  lattice.x = {low[0], middle[0], high[0]};
  lattice.y = {low[1], middle[1], high[1]};
  lattice.draw = {region + " " + region, region + " " + region};
  lattice.divide_x = {cells_per_block, cells_per_block};
  lattice.divide_y = {cells_per_block, cells_per_block};
  const std::array<std::string_view, 1> parameter = {"t"};
  const auto curve = [&](std::array<int, 2> from, std::array<int, 2> to)
  {
    const Vector a = {lattice.x[from[0]], lattice.y[from[1]]};
    const Vector b = {lattice.x[to[0]], lattice.y[to[1]]};
    geometry::Formula formula;
    formula.speed = geometry::Speed::own;  // neighbouring curves carry the same parameter
    for (int c = 0; c < 2; ++c)
    {
      std::string text = "(" + std::to_string(a[c]) + ") + t * (" + std::to_string(b[c] - a[c]) + ")";
      if (b[c] == a[c])
        text += " + " + std::to_string(bend) + " * sin(pi * t)";
      formula.x[c] = Expression(text, {}, parameter);
    }
    lattice.curves.push_back({from, to, formula});
  };
  if (bend != 0.0)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 2; ++j)
      {
        curve({i, j}, {i, j + 1});
        curve({j, i}, {j + 1, i});
      }
  domain.layout.order = order;
  block::add(domain.layout, lattice);
  const auto side = [&](const std::string& name, std::array<int, 4> first, std::array<int, 4> second)
  {
    const auto find = [&](int i, int j)
    {
      const std::string point = "square x" + std::to_string(i) + " y" + std::to_string(j);
      for (std::size_t k = 0; k < domain.layout.points.size(); ++k)
        if (domain.layout.points[k].name == point)
          return static_cast<int>(k);
      return -1;
    };
    block::ByEdges edges;
    edges.edges.push_back({find(first[0], first[1]), find(first[2], first[3])});
    edges.edges.push_back({find(second[0], second[1]), find(second[2], second[3])});
    domain.layout.boundaries.push_back({name, edges, {}});
  };
  side("left", {0, 0, 0, 1}, {0, 1, 0, 2});
  side("right", {2, 0, 2, 1}, {2, 1, 2, 2});
  side("bottom", {0, 0, 1, 0}, {1, 0, 2, 0});
  side("top", {0, 2, 1, 2}, {1, 2, 2, 2});
  domain.skeleton = block::make_skeleton(domain.layout);
  domain.connected = block::connect(domain.layout, domain.skeleton, region, linalg::part());
  domain.numbering = linalg::Numbering(domain.mesh().lattice, domain.mesh().owner);
  domain.x.resize(2 * domain.mesh().node_count());
  block::place(domain.connected.plan, domain.skeleton.x, domain.x);
  return domain;
}

/// A formula of x, y and t.
inline blockfsi::Expression formula(const std::string& text, const blockfsi::Constants& constants = {})
{
  const std::array<std::string_view, 3> variables = {"x", "y", "t"};
  return blockfsi::Expression(text, constants, variables);
}

/// Nodes of the unit square moved inside, X + amplitude sin(2 pi X) sin(2 pi Y) sin(2 pi t) (1, 1); the sides
/// rest.
inline std::vector<double> moved_inside(const std::vector<double>& X, double amplitude, double t)
{
  constexpr double circle = 2.0 * std::numbers::pi;
  std::vector<double> x = X;
  for (std::size_t i = 0; i < X.size(); i += 2)
  {
    const double change =
        amplitude * std::sin(circle * X[i]) * std::sin(circle * X[i + 1]) * std::sin(circle * t);
    x[i] += change;
    x[i + 1] += change;
  }
  return x;
}

/// a + factor (b - a) entry by entry.
inline std::vector<double> between(const std::vector<double>& a, const std::vector<double>& b, double factor)
{
  std::vector<double> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    result[i] = a[i] + factor * (b[i] - a[i]);
  return result;
}

/// (b - a) / step entry by entry.
inline std::vector<double> rate(const std::vector<double>& a, const std::vector<double>& b, double step)
{
  std::vector<double> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    result[i] = (b[i] - a[i]) / step;
  return result;
}

/// L2 norm over the mesh of the difference of two components of a nodal field and a function of position.
inline double error(const blockfsi::mesh::Mesh& mesh, const std::vector<double>& x,
                    const std::vector<double>& field, int stride,
                    const std::function<Vector(double, double)>& exact)
{
  using namespace blockfsi;
  const element::Rule rule = element::gauss(mesh.order + 4);
  const element::Table table = element::lagrange(element::lobatto(mesh.order), rule.points);
  const int n = mesh.order + 1;
  const int m = static_cast<int>(rule.points.size());
  double sum = 0.0;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
    for (int q = 0; q < m; ++q)
      for (int r = 0; r < m; ++r)
      {
        Vector position{}, xi{}, eta{}, value{};
        for (int j = 0; j < n; ++j)
          for (int i = 0; i < n; ++i)
          {
            const std::size_t node = mesh.cell(c)[j * n + i];
            const double shape = table.value[q * n + i] * table.value[r * n + j];
            for (int k = 0; k < 2; ++k)
            {
              position[k] += shape * x[2 * node + k];
              xi[k] += table.first[q * n + i] * table.value[r * n + j] * x[2 * node + k];
              eta[k] += table.value[q * n + i] * table.first[r * n + j] * x[2 * node + k];
              value[k] += shape * field[stride * node + k];
            }
          }
        const Vector right = exact(position[0], position[1]);
        const double det = xi[0] * eta[1] - xi[1] * eta[0];
        const double weight = rule.weights[q] * rule.weights[r] * det;
        sum += weight * (std::pow(value[0] - right[0], 2) + std::pow(value[1] - right[1], 2));
      }
  return std::sqrt(linalg::part().size > 1 ? [&] { linalg::sum(std::span(&sum, 1)); return sum; }() : sum);
}

}  // namespace verification
