#pragma once

#include "mesh/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

/// Cell matrices times a direction, added up at the nodes.
inline std::vector<double> apply(const blockfsi::mesh::Mesh& mesh, std::size_t components,
                                 const std::vector<double>& matrices, const std::vector<double>& direction)
{
  const std::size_t n = components * static_cast<std::size_t>(mesh.nodes_per_cell());
  std::vector<double> product(direction.size(), 0.0);
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        product[components * mesh.cell(c)[i / components] + i % components] +=
            matrices[(c * n + i) * n + j] *
            direction[components * mesh.cell(c)[j / components] + j % components];
  return product;
}

/// Largest difference of a product and the derivative of `residual` along the same direction by differences
/// of fourth order, relative to the largest entry of the product.
inline double derivative_error(const std::vector<double>& product, const std::vector<double>& direction,
                               const std::vector<double>& z,
                               const std::function<std::vector<double>(const std::vector<double>&)>& residual)
{
  constexpr double step = 1e-3;
  const auto at = [&](double change)
  {
    std::vector<double> moved = z;
    for (std::size_t i = 0; i < z.size(); ++i)
      moved[i] += change * direction[i];
    return residual(moved);
  };
  const auto near_ahead = at(step);
  const auto near_behind = at(-step);
  const auto ahead = at(2.0 * step);
  const auto behind = at(-2.0 * step);
  double error = 0.0;
  double norm = 0.0;
  for (std::size_t i = 0; i < z.size(); ++i)
  {
    const double difference =
        (8.0 * (near_ahead[i] - near_behind[i]) - (ahead[i] - behind[i])) / (12.0 * step);
    error = std::max(error, std::abs(product[i] - difference));
    norm = std::max(norm, std::abs(product[i]));
  }
  return error / norm;
}
