#include "fem/boundary.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace blockfsi::fem
{

std::vector<std::uint8_t> nodes_on(const mesh::Mesh& mesh, const linalg::Numbering& numbering,
                                   std::string_view boundary)
{
  std::vector<std::uint8_t> marks(mesh.node_count(), 0);
  const auto found = mesh.boundaries.find(boundary);
  if (found != mesh.boundaries.end())
    for (const mesh::Side& side : found->second)
      for (int k = 0; k <= mesh.order; ++k)
        marks[mesh.cell(side.cell)[mesh::side_node(mesh.order, side.side, k)]] = 1;
  agree(numbering, marks, 1);
  return marks;
}

std::vector<std::uint8_t> normal_components(const mesh::Mesh& mesh, const linalg::Numbering& numbering,
                                            std::string_view boundary, std::span<const double> x)
{
  std::vector<std::uint8_t> marks(2 * mesh.node_count(), 0);
  const auto found = mesh.boundaries.find(boundary);
  for (const mesh::Side& side : found == mesh.boundaries.end() ? std::vector<mesh::Side>{} : found->second)
  {
    std::array<double, 2> least = {INFINITY, INFINITY};
    std::array<double, 2> greatest = {-INFINITY, -INFINITY};
    const auto nodes = mesh.cell(side.cell);
    for (int k = 0; k <= mesh.order; ++k)
      for (int c = 0; c < 2; ++c)
      {
        const double value = x[2 * nodes[mesh::side_node(mesh.order, side.side, k)] + c];
        least[c] = std::min(least[c], value);
        greatest[c] = std::max(greatest[c], value);
      }
    const std::array<double, 2> extent = {greatest[0] - least[0], greatest[1] - least[1]};
    const int normal = extent[0] < extent[1] ? 0 : 1;
    if (extent[normal] > 1e-8 * extent[1 - normal])
      throw Error(
          fmt::format("boundary '{}' slips, but near ({:g}, {:g}) it does not run along an axis; only "
                      "a straight boundary along x or y can slip",
                      boundary, least[0], least[1]));
    for (int k = 0; k <= mesh.order; ++k)
      marks[2 * nodes[mesh::side_node(mesh.order, side.side, k)] + normal] = 1;
  }
  agree(numbering, marks, 2);
  return marks;
}

void agree(const linalg::Numbering& numbering, std::vector<std::uint8_t>& marks, int components)
{
  std::vector<double> values(marks.begin(), marks.end());
  numbering.add_from_ghosts(values, components);
  numbering.update_ghosts(values, components);
  std::transform(values.begin(), values.end(), marks.begin(),
                 [](double value) { return static_cast<std::uint8_t>(value > 0.0 ? 1 : 0); });
}

}  // namespace blockfsi::fem
