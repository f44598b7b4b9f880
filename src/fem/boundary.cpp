#include "fem/boundary.hpp"

#include <algorithm>

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

void agree(const linalg::Numbering& numbering, std::vector<std::uint8_t>& marks, int components)
{
  std::vector<double> values(marks.begin(), marks.end());
  numbering.add_from_ghosts(values, components);
  numbering.update_ghosts(values, components);
  std::transform(values.begin(), values.end(), marks.begin(),
                 [](double value) { return static_cast<std::uint8_t>(value > 0.0 ? 1 : 0); });
}

}  // namespace blockfsi::fem
