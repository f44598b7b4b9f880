#include "fem/side_loop.hpp"

#include "element/line.hpp"

#include <cmath>

namespace blockfsi::fem
{

SideLoop::SideLoop(const mesh::Mesh& mesh, int points) : mesh_(&mesh)
{
  const element::Rule rule = element::gauss(points);
  const std::vector<double> nodes = element::lobatto(mesh.order);
  const std::vector<double> ends = {0.0, 1.0};
  const element::Table along = element::lagrange(nodes, rule.points);
  const element::Table across = element::lagrange(nodes, ends);
  weights_ = rule.weights;
  const int n = mesh.order + 1;
  for (int side = 0; side < 4; ++side)
  {
    const bool horizontal = side % 2 == 0;
    const int end = side == 1 || side == 2 ? 1 : 0;
    for (int q = 0; q < points; ++q)
    {
      Basis functions;
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
        {
          const int a = q * n + (horizontal ? i : j);
          const int c = end * n + (horizontal ? j : i);
          const double value = along.value[a] * across.value[c];
          const double tangential = along.first[a] * across.value[c];
          const double normal = along.value[a] * across.first[c];
          functions.value.push_back(value);
          functions.xi.push_back(horizontal ? tangential : normal);
          functions.eta.push_back(horizontal ? normal : tangential);
        }
      basis_.push_back(std::move(functions));
    }
  }
  point_.gradient.resize(mesh.nodes_per_cell());
}

void SideLoop::locate(const mesh::Side& side, int q, std::span<const double> x)
{
  const auto nodes = mesh_->cell(side.cell);
  const Basis& functions = basis(side.side, q);
  std::array<double, 2> position{};
  std::array<double, 2> xi{};
  std::array<double, 2> eta{};
  for (std::size_t a = 0; a < nodes.size(); ++a)
    for (int k = 0; k < 2; ++k)
    {
      const double coordinate = x[static_cast<std::size_t>(nodes[a]) * 2 + k];
      position[k] += functions.value[a] * coordinate;
      xi[k] += functions.xi[a] * coordinate;
      eta[k] += functions.eta[a] * coordinate;
    }
  const double det = xi[0] * eta[1] - xi[1] * eta[0];
  for (std::size_t a = 0; a < nodes.size(); ++a)
    point_.gradient[a] = {(functions.xi[a] * eta[1] - functions.eta[a] * xi[1]) / det,
                          (functions.eta[a] * xi[0] - functions.xi[a] * eta[0]) / det};
  // Sides 0 and 1 are run counter-clockwise, 2 and 3 clockwise.
  const std::array<double, 2>& tangent = side.side % 2 == 0 ? xi : eta;
  const double length = std::hypot(tangent[0], tangent[1]);
  const double sign = side.side < 2 ? 1.0 : -1.0;
  point_.x = position;
  point_.normal = {sign * tangent[1] / length, -sign * tangent[0] / length};
  point_.weight = weights_[q] * length;
}

}  // namespace blockfsi::fem
