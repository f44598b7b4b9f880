#include "coupling/partitioned.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace blockfsi::coupling
{

namespace
{

/// Part of the interface's displacement that the displacement of a step counts at least.
constexpr double least_part = 1e-6;

}  // namespace

void predict(int order, double ratio, std::span<const double> d_n, std::span<const double> d_n1,
             std::span<const double> d_n2, std::span<double> out)
{
  assert(0 <= order && order <= 2 && (order < 2 || ratio == 1.0));
  for (std::size_t i = 0; i < out.size(); ++i)
  {
    if (order == 0)
      out[i] = d_n[i];
    else if (order == 1)
      out[i] = d_n[i] + ratio * (d_n[i] - d_n1[i]);
    else
      out[i] = 2.5 * d_n[i] - 2.0 * d_n1[i] + 0.5 * d_n2[i];
  }
}

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
