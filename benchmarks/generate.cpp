// Makes one mesh from its blocks in a process of its own, so that its peak memory is that of this mesh, and
// prints what that took, as JSON. `benchmarks/run` calls it beside Gmsh:
//
//     bench_generate square|tube CELLS ORDER RATIO [triangles|tetrahedra]
//     bench_generate SHAPE CELLS ORDER
//     bench_generate read FILE
//
// RATIO is that of the sizes of the last and the first cell on the graded edges. SHAPE makes one block of
// this shape. `read` judges the mesh of a file by the same certificate.

#include "domain.hpp"

#include "core/error.hpp"
#include "mesh/convert.hpp"
#include "mesh/validity.hpp"
#include "output/mesh_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <sys/mman.h>
#include <sys/resource.h>

using namespace blockfsi;
using benchmarks::Domain;

namespace
{

/// CPU time of a task [s].
double seconds(const std::function<void()>& task)
{
  const auto now = []
  {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double start = now();
  task();
  return now() - start;
}

/// Median of several measurements [s].
double median_seconds(const std::function<void()>& task, int repetitions)
{
  std::vector<double> all(repetitions);
  for (double& one : all)
    one = seconds(task);
  std::nth_element(all.begin(), all.begin() + repetitions / 2, all.end());
  return all[repetitions / 2];
}

/// What nothing that makes a mesh can do without: writing as many bytes into memory that the process did not
/// have before [s].
double floor_seconds(std::size_t bytes)
{
  void* fresh = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (fresh == MAP_FAILED)
    throw Error("no memory for the floor");
  const double result = seconds(
      [&]
      {
        std::fill_n(static_cast<double*>(fresh), bytes / sizeof(double), 1.0);
        asm volatile("" : : "r"(fresh) : "memory");  // so that the writes are not left out
      });
  munmap(fresh, bytes);
  return result;
}

/// Most memory that the process has had [bytes].
double peak_memory()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

std::string verdicts(const mesh::Mesh& mesh, std::span<const double> x)
{
  const mesh::ValidityTables tables(mesh);
  mesh::Validity found;
  const double taken = seconds([&] { found = mesh::certify(tables, mesh, x); });
  return fmt::format(R"("valid": {}, "invalid": {}, "undecided": {}, "certify": {})", found.valid,
                     found.invalid, found.undecided, taken);
}

block::Layout layout_of(const std::vector<std::string>& words)
{
  const int cells = std::atoi(words[1].c_str());
  const int order = std::atoi(words[2].c_str());
  if (words[0] == "square" || words[0] == "tube")
  {
    const block::Grading grading = benchmarks::size_ratio(cells, std::atof(words.at(3).c_str()));
    return words[0] == "square" ? benchmarks::square_with_hole(order, cells, grading)
                                : benchmarks::quarter_tube(order, cells, grading);
  }
  for (int k = 1; k < element::shape_count; ++k)
    if (const auto shape = static_cast<element::Shape>(k); element::name(shape) == words[0])
      return benchmarks::one_block(shape, order, cells);
  throw Error(fmt::format("there is no domain '{}'", words[0]));
}

std::string measure(const std::vector<std::string>& words)
{
  const block::Layout layout = layout_of(words);
  std::optional<Domain> domain;
  const double taken = seconds([&] { domain.emplace(layout); });
  const double peak = peak_memory();
  const mesh::Mesh& mesh = domain->mesh();
  const std::size_t bytes = sizeof(double) * domain->x.size() + sizeof(std::int32_t) * mesh.cells.size();
  const auto place = [&] { block::place(domain->connected.plan, domain->skeleton.x, domain->x); };
  const double again = median_seconds(place, 9);
  const std::string counts =
      fmt::format(R"("nodes": {}, "seconds": {}, "again": {}, "peak": {}, "bytes": {}, "floor": {})",
                  mesh.node_count(), taken, again, peak, bytes, floor_seconds(bytes));
  if (words.size() < 5)
    return fmt::format(R"({{"cells": {}, {}, {}}})", mesh.cell_count(), counts, verdicts(mesh, domain->x));
  const mesh::Target target = words[4] == "triangles" ? mesh::Target::triangles : mesh::Target::tetrahedra;
  const mesh::Converted cut = mesh::convert(mesh, domain->x, {target, 0, {}});
  return fmt::format(R"({{"cells": {}, {}, {}}})", cut.mesh.cell_count(), counts, verdicts(cut.mesh, cut.x));
}

std::string judge(const std::string& path)
{
  const output::ReadMesh read = output::read_mesh(path);
  return fmt::format(R"({{"cells": {}, {}}})", read.mesh.cell_count(), verdicts(read.mesh, read.x));
}

}  // namespace

int main(int count, char** texts)
{
  const std::vector<std::string> words(texts + 1, texts + count);
  try
  {
    if (words.size() == 2 && words[0] == "read")
      fmt::print("{}\n", judge(words[1]));
    else if (words.size() >= 3)
      fmt::print("{}\n", measure(words));
    else
      throw Error(
          "call it as bench_generate DOMAIN CELLS ORDER [RATIO [TARGET]], or bench_generate read FILE");
  }
  catch (const std::exception& error)
  {
    fmt::print(stderr, "bench_generate: {}\n", error.what());
    return 2;
  }
  return 0;
}
