// Writing of fields.

#include "domain.hpp"

#include "output/vtu.hpp"

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <vector>

#include <unistd.h>

using namespace blockfsi;

namespace
{

/// Velocity and pressure on a mesh of the given order: evaluated at equispaced nodes, compressed, written.
void write_vtu(benchmark::State& state)
{
  const benchmarks::Domain domain(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const std::size_t nodes = domain.node_count();
  std::vector<double> velocity(2 * nodes);
  std::vector<double> pressure(nodes);
  for (std::size_t node = 0; node < nodes; ++node)
  {
    const double x = domain.x[2 * node];
    const double y = domain.x[2 * node + 1];
    velocity[2 * node] = std::sin(3.0 * x) * std::cos(2.0 * y);
    velocity[2 * node + 1] = std::cos(5.0 * x) * std::sin(y);
    pressure[node] = std::exp(x) * std::sin(4.0 * y);
  }
  const std::array<output::Field, 2> fields = {{{"velocity", 2, velocity}, {"pressure", 1, pressure}}};
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("blockfsi-benchmark-" + std::to_string(getpid()) + ".vtu");
  for (auto _ : state)
    output::write_vtu(file, domain.mesh(), domain.x, fields, {});
  state.counters["nodes"] = static_cast<double>(nodes);
  state.counters["bytes"] = static_cast<double>(std::filesystem::file_size(file));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(nodes));
  std::filesystem::remove(file);
}

/// Order and cells along each side of a block: 4 * 64^2 and 4 * 256^2 nodes.
BENCHMARK(write_vtu)
    ->ArgNames({"order", "cells"})
    ->Args({2, 32})
    ->Args({4, 16})
    ->Args({2, 128})
    ->Args({4, 64})
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
