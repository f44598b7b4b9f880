#include "fem/cell_loop.hpp"

#include <algorithm>

namespace blockfsi::fem
{

void CellLoop::gather(std::size_t batch, NodalField field, Lanes* out) const
{
  const int n = mesh_->nodes_per_cell();
  for (int lane = 0; lane < lane_count; ++lane)
  {
    const std::int32_t* nodes = mesh_->cells.data() + cell(batch, lane) * n;
    for (int i = 0; i < n; ++i)
    {
      const double* values = field.values + static_cast<std::size_t>(nodes[i]) * field.components;
      for (int c = 0; c < field.components; ++c)
        out[c * n + i][lane] = values[c];
    }
  }
}

Quadrature CellLoop::quadrature(std::span<const double> x)
{
  const std::vector<double> places = values_at_points(x, {x.data(), 2});
  const std::size_t m = static_cast<std::size_t>(table_.points) * table_.points;
  Quadrature result{std::vector<double>(places.size() / 3), std::vector<double>(mesh_->cell_count() * m)};
  for (std::size_t i = 0; i < result.x.size(); ++i)
    result.x[i] = places[3 * i];
  for (std::size_t batch = 0; batch < batch_count(); ++batch)
  {
    gather(batch, {x.data(), 2}, nodal_.data());
    geometry_.compute(table_, nodal_.data(), false);
    for (int lane = 0; lane < used(batch); ++lane)
      for (std::size_t q = 0; q < m; ++q)
        result.weight[cell(batch, lane) * m + q] = geometry_.points[q].weight[lane];
  }
  return result;
}

std::vector<double> CellLoop::values_at_points(std::span<const double> x, NodalField field)
{
  constexpr int max_points = max_line * max_line;
  const int n = mesh_->nodes_per_cell();
  const int m = table_.points * table_.points;
  const int components = field.components;
  nodal_.resize(static_cast<std::size_t>(n) * std::max(2, components));
  std::vector<double> result(mesh_->cell_count() * m * components * 3);
  Lanes reference[3][max_points];
  for (std::size_t batch = 0; batch < batch_count(); ++batch)
  {
    gather(batch, {x.data(), 2}, nodal_.data());
    geometry_.compute(table_, nodal_.data(), false);
    gather(batch, field, nodal_.data());
    for (int c = 0; c < components; ++c)
    {
      interpolate(table_, nodal_.data() + static_cast<std::size_t>(c) * n,
                  {reference[0], reference[1], reference[2]});
      for (int q = 0; q < m; ++q)
      {
        const auto grad = gradient(geometry_.points[q], reference[1][q], reference[2][q]);
        for (int lane = 0; lane < used(batch); ++lane)
        {
          double* out = result.data() + ((cell(batch, lane) * m + q) * components + c) * 3;
          out[0] = reference[0][q][lane];
          out[1] = grad[0][lane];
          out[2] = grad[1][lane];
        }
      }
    }
  }
  return result;
}

}  // namespace blockfsi::fem
