#pragma once

#include "block/connect.hpp"
#include "linalg/numbering.hpp"
#include "motion/extension.hpp"

#include "../mesh/structured.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

/// A square all of whose sides are the interface, or all but the bottom, which is the boundary "floor".
struct Square
{
  SampleMesh sample;
  blockfsi::linalg::Numbering numbering;
  blockfsi::block::Skeleton skeleton;
  blockfsi::block::Plan plan;
  std::vector<std::int64_t> interface;

  Square(
      int order, int cells, bool has_floor = false,
      const std::function<std::array<double, 2>(double, double)>& map =
          [](double x, double y) {
            return std::array{x, y};
          })
      : sample(structured(order, cells, cells, map))
  {
    auto& boundaries = sample.mesh.boundaries;
    for (std::int32_t k = 0; k < cells; ++k)
    {
      boundaries[has_floor ? "floor" : "interface"].push_back({k, 0});
      boundaries["interface"].push_back({k * cells + cells - 1, 1});
      boundaries["interface"].push_back({(cells - 1) * cells + k, 2});
      boundaries["interface"].push_back({k * cells, 3});
    }
    for (const blockfsi::mesh::Side& side : boundaries["interface"])
      for (int k = 0; k <= order; ++k)
      {
        const int place = blockfsi::mesh::side_node(order, side.side, k);
        interface.push_back(sample.mesh.lattice[sample.mesh.cell(side.cell)[place]]);
      }
    std::sort(interface.begin(), interface.end());
    interface.erase(std::unique(interface.begin(), interface.end()), interface.end());
    numbering = blockfsi::linalg::Numbering(sample.mesh.lattice, sample.mesh.owner);
  }

  blockfsi::motion::Domain domain() const
  {
    return {skeleton, plan, sample.mesh, numbering, sample.x, interface};
  }

  /// The displacement of a function at the interface, shape (interface count, 2).
  std::vector<double> at_interface(const std::function<std::array<double, 2>(double, double)>& u) const
  {
    std::vector<double> d;
    for (const std::int64_t node : interface)
    {
      // Nodes of the sample are numbered as in its lattice.
      const std::array<double, 2> value = u(sample.x[2 * node], sample.x[2 * node + 1]);
      d.insert(d.end(), value.begin(), value.end());
    }
    return d;
  }

  /// Largest distance of the nodes from where a displacement puts them.
  double error(const std::vector<double>& x,
               const std::function<std::array<double, 2>(double, double)>& u) const
  {
    double result = 0.0;
    for (std::size_t i = 0; i < x.size(); i += 2)
    {
      const std::array<double, 2> value = u(sample.x[i], sample.x[i + 1]);
      result =
          std::max(result, std::hypot(x[i] - sample.x[i] - value[0], x[i + 1] - sample.x[i + 1] - value[1]));
    }
    return result;
  }
};
