// Integrals over the cells and the solution of the linear system, for about 12 and 50 thousand unknowns.

#include "domain.hpp"

#include "fem/boundary.hpp"
#include "fem/cell_loop.hpp"
#include "fluid/flow.hpp"
#include "linalg/numbering.hpp"
#include "linalg/session.hpp"
#include "linalg/system.hpp"
#include "solid/material.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

using namespace blockfsi;

namespace
{

/// Order and cells along each side of a block; 12 (cells order)^2 unknowns of a flow, 8 (cells order)^2 of a
/// body.
void sizes(benchmark::internal::Benchmark* measurement)
{
  measurement->ArgNames({"order", "cells"})->Unit(benchmark::kMillisecond);
  for (const int nodes : {32, 64})
    for (const int order : {2, 4})
      measurement->Args({order, nodes / order});
}

/// A physics with smooth fields to evaluate it at.
template <class P>
struct Problem
{
  Problem(const benchmark::State& state, const P& its_physics)
      : domain(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))),
        numbering(domain.mesh().lattice, domain.mesh().owner), physics(its_physics),
        cells(domain.mesh(), domain.mesh().order + 2), unknown(domain.node_count() * P::unknowns),
        given(domain.node_count() * P::data, 0.0), residual(unknown.size())
  {
    for (std::size_t i = 0; i < unknown.size(); ++i)
    {
      const double* x = &domain.x[i / P::unknowns * 2];
      unknown[i] = 0.1 * std::sin(3.0 * x[0]) * std::cos(2.0 * x[1] + static_cast<double>(i % P::unknowns));
    }
  }

  Problem(const Problem&) = delete;  // its parts refer to each other
  Problem& operator=(const Problem&) = delete;

  std::array<fem::NodalField, 1> data() const { return {{{given.data(), P::data}}}; }

  linalg::System system() const
  {
    std::vector<std::uint8_t> fixed(unknown.size(), 0);
    for (const std::string_view boundary : {"hole", "inlet"})
    {
      const std::vector<std::uint8_t> marks = fem::nodes_on(domain.mesh(), numbering, boundary);
      for (std::size_t i = 0; i < fixed.size(); ++i)
        if (marks[i / P::unknowns] != 0 && i % P::unknowns < 2)
          fixed[i] = 1;
    }
    return {numbering,
            P::unknowns,
            domain.mesh().cells,
            domain.mesh().nodes_per_cell(),
            fixed,
            P::unknowns == 3 ? "fluid_" : "solid_"};
  }

  void fill(linalg::System& matrix)
  {
    cells.tangent(physics, domain.x, unknown, data(), matrix.cell_matrices());
  }

  void count(benchmark::State& state) const
  {
    state.counters["unknowns"] = static_cast<double>(unknown.size());
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(unknown.size()));
  }

  benchmarks::Domain domain;
  linalg::Numbering numbering;
  P physics;
  fem::CellLoop cells;
  std::vector<double> unknown;
  std::vector<double> given;
  std::vector<double> residual;
};

/// Reynolds number 200 of the hole, implicit steps of 0.01.
Problem<fluid::Flow> flow(const benchmark::State& state)
{
  const auto order = static_cast<int>(state.range(0));
  return {state, fluid::Flow{.density = 1.0,
                             .viscosity = 5e-3,
                             .rate = 200.0,
                             .step_frequency = 200.0,
                             .order = order,
                             .inverse_constant = fluid::inverse_constant(order)}};
}

Problem<solid::Body> body(const benchmark::State& state)
{
  return {state, solid::Body{.material = solid::lame(1e6, 0.3, solid::Plane::strain),
                             .inertia = 1e7,
                             .force_density = 1e3,
                             .stress_weight = 0.5}};
}

template <class P>
void residual(benchmark::State& state, Problem<P> problem)
{
  for (auto _ : state)
  {
    std::fill(problem.residual.begin(), problem.residual.end(), 0.0);
    problem.cells.add_residual(problem.physics, problem.domain.x, problem.unknown, problem.data(),
                               problem.residual);
    benchmark::ClobberMemory();
  }
  problem.count(state);
}

template <class P>
void tangent(benchmark::State& state, Problem<P> problem)
{
  linalg::System system = problem.system();
  for (auto _ : state)
    problem.fill(system);
  problem.count(state);
}

template <class P>
void assemble(benchmark::State& state, Problem<P> problem)
{
  linalg::System system = problem.system();
  problem.fill(system);
  for (auto _ : state)
    system.assemble();
  problem.count(state);
}

/// Numeric factorisation only: the ordering is found once per run.
template <class P>
void factorise(benchmark::State& state, Problem<P> problem)
{
  linalg::System system = problem.system();
  problem.fill(system);
  system.assemble();
  bool ok = system.factorise() == linalg::Status::ok;
  for (auto _ : state)
  {
    state.PauseTiming();
    system.assemble();  // without a new matrix the factors would be kept
    state.ResumeTiming();
    ok = system.factorise() == linalg::Status::ok && ok;
  }
  if (!ok)
    state.SkipWithError("the factorisation failed");
  problem.count(state);
}

template <class P>
void solve(benchmark::State& state, Problem<P> problem)
{
  linalg::System system = problem.system();
  problem.fill(system);
  problem.cells.add_residual(problem.physics, problem.domain.x, problem.unknown, problem.data(),
                             problem.residual);
  system.assemble();
  std::vector<double> increment(problem.unknown.size());
  bool ok = system.factorise() == linalg::Status::ok;
  for (auto _ : state)
    ok = system.solve(problem.residual, increment) == linalg::Status::ok && ok;
  if (!ok)
    state.SkipWithError("the solution failed");
  problem.count(state);
}

void fluid_residual(benchmark::State& state)
{
  residual(state, flow(state));
}
void fluid_tangent(benchmark::State& state)
{
  tangent(state, flow(state));
}
void fluid_assemble(benchmark::State& state)
{
  assemble(state, flow(state));
}
void fluid_factorise(benchmark::State& state)
{
  factorise(state, flow(state));
}
void fluid_solve(benchmark::State& state)
{
  solve(state, flow(state));
}
void solid_residual(benchmark::State& state)
{
  residual(state, body(state));
}
void solid_tangent(benchmark::State& state)
{
  tangent(state, body(state));
}
void solid_factorise(benchmark::State& state)
{
  factorise(state, body(state));
}
void solid_solve(benchmark::State& state)
{
  solve(state, body(state));
}

BENCHMARK(fluid_residual)->Apply(sizes);
BENCHMARK(fluid_tangent)->Apply(sizes);
BENCHMARK(fluid_assemble)->Apply(sizes);
BENCHMARK(fluid_factorise)->Apply(sizes);
BENCHMARK(fluid_solve)->Apply(sizes);
BENCHMARK(solid_residual)->Apply(sizes);
BENCHMARK(solid_tangent)->Apply(sizes);
BENCHMARK(solid_factorise)->Apply(sizes);
BENCHMARK(solid_solve)->Apply(sizes);

}  // namespace

int main(int count, char** values)
{
  const linalg::Session session;
  benchmark::Initialize(&count, values);
  if (benchmark::ReportUnrecognizedArguments(count, values))
    return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
