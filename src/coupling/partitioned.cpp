#include "coupling/partitioned.hpp"

#include <algorithm>
#include <cmath>

namespace blockfsi::coupling
{

namespace
{

/// Part of the interface's displacement that the displacement of a step counts at least.
constexpr double least_part = 1e-6;

}  // namespace

double relative_residual(std::span<const double> d, std::span<const double> d_tilde,
                         std::span<const double> d_start, double least_displacement)
{
  double residual = 0.0, displacement = 0.0, total = 0.0;
  for (std::size_t i = 0; i < d.size(); ++i)
  {
    residual += (d_tilde[i] - d[i]) * (d_tilde[i] - d[i]);
    displacement += (d_tilde[i] - d_start[i]) * (d_tilde[i] - d_start[i]);
    total += d_tilde[i] * d_tilde[i];
  }
  if (residual == 0.0)
    return 0.0;
  const double least = least_displacement * std::sqrt(static_cast<double>(d.size()));
  return std::sqrt(residual) / std::max({std::sqrt(displacement), least, least_part * std::sqrt(total)});
}

}  // namespace blockfsi::coupling
