#include "output/lattice_values.hpp"

#include <Eigen/Core>

#include <algorithm>

namespace blockfsi::output
{

namespace
{

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Columns = Eigen::MatrixXd;

/// Cells that are evaluated in one product of matrices.
constexpr int batch = 64;

void change_run(const mesh::Mesh& mesh, const mesh::CellRun& run, const Matrix& map,
                std::span<const double> values, int components, int width, std::span<double> result)
{
  const auto n = static_cast<int>(map.cols());
  Columns from(n, batch * components);
  Columns to(n, batch * components);
  for (std::int32_t first = 0; first < run.count; first += batch)
  {
    const int count = std::min(batch, run.count - first);
    const std::span<const std::int32_t> nodes =
        std::span(mesh.cells).subspan(run.entry + std::int64_t{first} * n, std::size_t(count) * n);
    for (int c = 0; c < count; ++c)
      for (int d = 0; d < components; ++d)
        for (int k = 0; k < n; ++k)
          from(k, c * components + d) = values[std::size_t(nodes[c * n + k]) * components + d];
    to.leftCols(count * components).noalias() = map * from.leftCols(count * components);
    for (int c = 0; c < count; ++c)
      for (int d = 0; d < components; ++d)
        for (int k = 0; k < n; ++k)
          result[std::size_t(nodes[c * n + k]) * width + d] = to(k, c * components + d);
  }
}

}  // namespace

LatticeChange::LatticeChange(const mesh::Mesh& mesh, element::NodeKind from, element::NodeKind to)
    : mesh_(mesh)
{
  if (mesh.order > 2)  // below, both lattices are the same
    for (const mesh::CellRun& run : mesh.runs)
      maps_.push_back(element::resample(run.shape, {mesh.order, from}, {mesh.order, to}));
}

std::vector<double> LatticeChange::operator()(std::span<const double> values, int components, int width) const
{
  std::vector<double> result(mesh_.node_count() * width);
  for (std::size_t node = 0; node < mesh_.node_count(); ++node)
    std::copy_n(values.begin() + node * components, components, result.begin() + node * width);
  for (std::size_t r = 0; r < maps_.size(); ++r)
  {
    const mesh::CellRun& run = mesh_.runs[r];
    const auto n = static_cast<int>(element::lattice_size(run.shape, mesh_.order));
    change_run(mesh_, run, Eigen::Map<const Matrix>(maps_[r].data(), n, n), values, components, width,
               result);
  }
  return result;
}

CollapsedPyramid::CollapsedPyramid(int p) : order(p)
{
  for (const auto& [i, j, k] : element::lattice_points(element::Shape::hexahedron, order))
  {
    const bool lateral = (i == 0 || i == order) && (j == 0 || j == order);
    if (k == 0 || k == order || lateral)
    {
      const int a = k == 0 ? i : std::min(i, order - k);
      const int b = k == 0 ? j : std::min(j, order - k);
      hexahedron.push_back(
          static_cast<std::int32_t>(element::lattice_index(element::Shape::pyramid, order, {a, b, k})));
      continue;
    }
    hexahedron.push_back(-1 - static_cast<std::int32_t>(extra.size()));
    extra.push_back(
        {static_cast<double>(i) / order, static_cast<double>(j) / order, static_cast<double>(k) / order});
  }
}

}  // namespace blockfsi::output
