// Making a mesh of about a million nodes from its blocks, making it anew, and judging it.

#include "domain.hpp"

#include "block/corner_layout.hpp"
#include "mesh/quality.hpp"
#include "mesh/validity.hpp"
#include "motion/regenerate.hpp"

#include <benchmark/benchmark.h>

#include <utility>

using namespace blockfsi;
using benchmarks::Domain;
using benchmarks::square_with_hole;

namespace
{

/// Order and cells along each side of a block: 4 * 500^2 nodes.
void sizes(benchmark::internal::Benchmark* measurement)
{
  measurement->ArgNames({"order", "cells"})->Unit(benchmark::kMillisecond);
  for (const int order : {1, 2, 4})
    measurement->Args({order, 500 / order});
}

std::pair<int, int> arguments(const benchmark::State& state)
{
  return {static_cast<int>(state.range(0)), static_cast<int>(state.range(1))};
}

void count_nodes(benchmark::State& state, std::size_t nodes)
{
  state.counters["nodes"] = static_cast<double>(nodes);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(nodes));
}

/// Gradings, edges and the nodes on them: grows with the edges only.
void make_skeleton(benchmark::State& state)
{
  const auto [order, cells] = arguments(state);
  const block::Layout layout = square_with_hole(order, cells);
  std::int64_t count = 0;
  for (auto _ : state)
    count = block::make_skeleton(layout).count;
  count_nodes(state, static_cast<std::size_t>(count));
}

/// Connectivity and plan, once per run.
void connect(benchmark::State& state)
{
  const auto [order, cells] = arguments(state);
  const block::Layout layout = square_with_hole(order, cells);
  const block::Skeleton skeleton = block::make_skeleton(layout);
  std::size_t nodes = 0;
  for (auto _ : state)
    nodes = block::connect(layout, skeleton, "fluid", {}).mesh.node_count();
  count_nodes(state, nodes);
}

/// From the layout to coordinates, everything included.
void make_mesh(benchmark::State& state)
{
  const auto [order, cells] = arguments(state);
  const block::Layout layout = square_with_hole(order, cells);
  std::size_t nodes = 0;
  for (auto _ : state)
    nodes = Domain(layout).node_count();
  count_nodes(state, nodes);
}

/// Coordinates of all nodes from those of the skeleton.
void place(benchmark::State& state)
{
  const auto [order, cells] = arguments(state);
  Domain domain(order, cells);
  for (auto _ : state)
  {
    block::place(domain.connected.plan, domain.skeleton.x, domain.x);
    benchmark::ClobberMemory();
  }
  count_nodes(state, domain.node_count());
}

/// What a coupling iteration pays for its mesh: the hole moves, the skeleton follows, all nodes are placed.
void follow(benchmark::State& state)
{
  const auto [order, cells] = arguments(state);
  Domain domain(order, cells);
  std::vector<std::int64_t> hole = {0, 1, 2, 3};
  for (const block::PlacedEdge& edge : domain.skeleton.edges)
    for (std::int64_t node = edge.first; edge.a < 4 && edge.b < 4 && node < edge.first + edge.count; ++node)
      hole.push_back(node);
  const std::vector<double> displacement(2 * hole.size(), 0.01);
  motion::Regenerate motion(
      domain.skeleton, domain.connected.plan, hole,
      block::corner_motion(square_with_hole(order, cells), domain.skeleton, "fluid", hole, {}));
  for (auto _ : state)
  {
    motion.follow(displacement, domain.x);
    benchmark::ClobberMemory();
  }
  count_nodes(state, domain.node_count());
}

/// Scaled Jacobian, angles and change, once per coupling iteration.
void measure_quality(benchmark::State& state)
{
  const auto [order, cells] = arguments(state);
  const Domain domain(order, cells);
  const mesh::QualityTables tables(order);
  const std::vector<double> first = mesh::sample_jacobian(tables, domain.mesh(), domain.x);
  for (auto _ : state)
    benchmark::DoNotOptimize(mesh::measure(tables, domain.mesh(), domain.x, first));
  count_nodes(state, domain.node_count());
}

/// Proof that every cell is valid, once per step.
void certify(benchmark::State& state)
{
  const auto [order, cells] = arguments(state);
  const Domain domain(order, cells);
  const mesh::ValidityTables tables(order);
  for (auto _ : state)
    benchmark::DoNotOptimize(mesh::certify(tables, domain.mesh(), domain.x));
  count_nodes(state, domain.node_count());
}

BENCHMARK(make_skeleton)->Apply(sizes);
BENCHMARK(connect)->Apply(sizes);
BENCHMARK(make_mesh)->Apply(sizes);
BENCHMARK(place)->Apply(sizes);
BENCHMARK(follow)->Apply(sizes);
BENCHMARK(measure_quality)->Apply(sizes);
BENCHMARK(certify)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();
