#include "run/gathered.hpp"

#include "linalg/communicator.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace blockfsi::run
{

std::vector<double> gather_values(std::span<const double> mine)
{
  const std::vector<std::size_t> counts =
      linalg::gather(std::span<const std::size_t>(std::array{mine.size()}));
  const std::size_t most = *std::max_element(counts.begin(), counts.end());
  if (most == 0)
    return {};
  std::vector<double> padded(mine.begin(), mine.end());
  padded.resize(most, 0.0);
  const std::vector<double> all = linalg::gather(std::span<const double>(padded));
  std::vector<double> result;
  for (std::size_t rank = 0; rank < counts.size(); ++rank)
  {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(rank * most);
    result.insert(result.end(), first, first + static_cast<std::ptrdiff_t>(counts[rank]));
  }
  return result;
}

}  // namespace blockfsi::run
