// The nodes within one block of about a million placed again, and the same by loops written by hand.

#include "by_hand.hpp"
#include "domain.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using namespace blockfsi;
using benchmarks::Domain;
using element::Shape;

namespace
{

/// Steps of nodes along the edges of a block, divisible by 2, 3 and 4.
int steps_of(Shape shape)
{
  switch (shape)
  {
  case Shape::triangle:
    return 1404;
  case Shape::quadrilateral:
    return 996;
  case Shape::tetrahedron:
    return 180;
  case Shape::hexahedron:
    return 96;
  case Shape::prism:
    return 120;
  default:
    return 144;
  }
}

/// A block with bent sides.
Domain bent_block(Shape shape, int order)
{
  Domain domain(benchmarks::one_block(shape, order, steps_of(shape) / order));
  const auto dim = static_cast<std::size_t>(domain.skeleton.dim);
  std::vector<double>& x = domain.skeleton.x;
  for (std::size_t n = 0; n < x.size(); n += dim)
  {
    const double phase = 2.0 * x[n] + 3.0 * x[n + 1] + (dim == 3 ? x[n + 2] : 0.0);
    for (std::size_t c = 0; c < dim; ++c)
      x[n + c] += 0.02 * std::sin(phase + static_cast<double>(c));
  }
  block::place(domain.connected.plan, x, domain.x);
  return domain;
}

/// The inner nodes follow those of the boundary.
double* inner_nodes(Domain& domain)
{
  return domain.x.data() + domain.skeleton.x.size();
}

void count_nodes(benchmark::State& state, const Domain& domain)
{
  state.counters["nodes"] = static_cast<double>(domain.node_count());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(domain.node_count()));
}

void place(benchmark::State& state, Shape shape)
{
  Domain domain = bent_block(shape, static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    block::place(domain.connected.plan, domain.skeleton.x, domain.x);
    benchmark::ClobberMemory();
  }
  count_nodes(state, domain);
}

void by_hand(benchmark::State& state, Shape shape)
{
  Domain domain = bent_block(shape, 1);
  const std::vector<double> expected = domain.x;
  const benchmarks::by_hand::Sides sides(domain);
  for (auto _ : state)
  {
    benchmarks::by_hand::place(sides, shape, inner_nodes(domain));
    benchmark::ClobberMemory();
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i)
    largest = std::max(largest, std::abs(expected[i] - domain.x[i]));
  if (largest > 1e-13)
    state.SkipWithError("the loop gives other nodes");
  count_nodes(state, domain);
}

}  // namespace

int main(int count, char** values)
{
  for (int k = 1; k < element::shape_count; ++k)
  {
    const auto shape = static_cast<Shape>(k);
    const std::string name(element::name(shape));
    const auto add = [&](const std::string& what, auto* function)
    {
      return benchmark::RegisterBenchmark((what + "/" + name).c_str(), function, shape)
          ->ArgName("order")
          ->Unit(benchmark::kMillisecond);
    };
    add("by_hand", by_hand)->Arg(1);
    add("place", place)->DenseRange(1, 4);
  }
  benchmark::Initialize(&count, values);
  if (benchmark::ReportUnrecognizedArguments(count, values))
    return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
