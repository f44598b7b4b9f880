// Proving cells of every shape valid: slightly curved ones, which are proved eight at a time, and ones curved
// so much that their Jacobian must be expanded. Items are cells.

#include "mesh/validity.hpp"
#include "element/nodes.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

using namespace blockfsi;
using element::Shape;

namespace
{

struct Sample
{
  mesh::Mesh mesh;
  std::vector<double> x;
};

/// Cells that share no nodes, each bent a little differently: x + bend sin(...) in every coordinate.
Sample separate_cells(Shape shape, int order, int count, double bend)
{
  const std::vector<element::Point> nodes = element::nodes(shape, order);
  const int dim = element::dimension(shape);
  Sample sample;
  sample.mesh.dim = dim;
  sample.mesh.order = order;
  for (int c = 0; c < count; ++c)
    for (const element::Point& node : nodes)
    {
      sample.mesh.cells.push_back(static_cast<std::int32_t>(sample.mesh.cells.size()));
      for (int d = 0; d < dim; ++d)
        sample.x.push_back(node[d] + bend * std::sin(3.0 * node[(d + 1) % dim] + 0.1 * c + d));
    }
  sample.mesh.local_node_count = sample.mesh.cells.size();
  sample.mesh.runs = {{shape, 0, count, 0}};
  sample.mesh.cell_block.assign(count, 0);
  return sample;
}

void certify(benchmark::State& state, Shape shape, double bend)
{
  const int order = static_cast<int>(state.range(0));
  constexpr int count = 4096;
  const Sample sample = separate_cells(shape, order, count, bend);
  const mesh::ValidityTables tables(sample.mesh);
  mesh::Validity validity;
  for (auto _ : state)
    validity = mesh::certify(tables, sample.mesh, sample.x);
  state.SetItemsProcessed(state.iterations() * count);
  state.counters["cells"] = count;
  state.counters["valid"] = static_cast<double>(validity.valid) / count;
}

const int registered = []
{
  for (const Shape shape : {Shape::triangle, Shape::quadrilateral, Shape::tetrahedron, Shape::hexahedron,
                            Shape::prism, Shape::pyramid})
    for (const double bend : {0.02, 0.25})
      benchmark::RegisterBenchmark(
          ("certify/" + std::string(element::name(shape)) + (bend < 0.1 ? "/slight" : "/strong")).c_str(),
          certify, shape, bend)
          ->ArgName("order")
          ->Arg(1)
          ->Arg(2)
          ->Arg(4)
          ->Unit(benchmark::kMillisecond);
  return 0;
}();

}  // namespace

BENCHMARK_MAIN();
