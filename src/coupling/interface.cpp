#include "coupling/interface.hpp"

#include "linalg/communicator.hpp"

#include <algorithm>

namespace blockfsi::coupling
{

Interface::Interface(std::span<const std::int64_t> numbers, const mesh::Mesh& mesh) : count_(numbers.size())
{
  const int rank = linalg::part().rank;
  for (std::size_t index = 0; index < numbers.size(); ++index)
  {
    const auto found = std::lower_bound(mesh.lattice.begin(), mesh.lattice.end(), numbers[index]);
    if (found == mesh.lattice.end() || *found != numbers[index])
      continue;
    const auto node = static_cast<std::int32_t>(found - mesh.lattice.begin());
    local_.push_back({node, static_cast<std::int32_t>(index)});
    if (mesh.owner_of(node) == rank)
      owned_.push_back(local_.back());
  }
}

void Interface::gather(std::span<const double> field, int stride, std::span<double> values) const
{
  std::fill(values.begin(), values.end(), 0.0);
  for (const Pair& pair : owned_)
    for (int c = 0; c < 2; ++c)
      values[2 * pair.index + c] = field[static_cast<std::size_t>(pair.node) * stride + c];
  linalg::sum(values);
}

void Interface::scatter(std::span<const double> values, std::span<double> field) const
{
  for (const Pair& pair : local_)
    for (int c = 0; c < 2; ++c)
      field[2 * static_cast<std::size_t>(pair.node) + c] = values[2 * pair.index + c];
}

}  // namespace blockfsi::coupling
