// Time per point of CAD geometry as Open CASCADE evaluates it and as our own NURBS do, on the same curve and
// surface.

#include "geometry/nurbs.hpp"

#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <benchmark/benchmark.h>
#include <gp_Pnt.hxx>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace blockfsi::geometry;

namespace
{

constexpr int degree = 3;
constexpr int control_points = 12;
constexpr int spans = control_points - degree;
constexpr std::size_t count = 4096;

gp_Pnt control_point(int i, int j)
{
  return {1.0 * i, 1.0 * j, std::sin(1.0 * i * j + i)};
}

double weight(bool rational, int i, int j)
{
  return rational ? 1.0 + 0.3 * std::cos(i + 2.0 * j) : 1.0;
}

/// Parameters that ascend row by row, as those of the nodes of a block.
std::vector<double> parameters(bool along_rows)
{
  std::vector<double> result;
  for (std::size_t i = 0; i < count; ++i)
    result.push_back(static_cast<double>(along_rows ? i % 64 : i / 64) / 64.0 + 1.0 / 128.0);
  return result;
}

struct Shapes
{
  NurbsCurve curve;
  NurbsSurface surface;
  Handle(Geom_BSplineCurve) cad_curve;
  Handle(Geom_BSplineSurface) cad_surface;
};

Shapes make_shapes(bool rational)
{
  Shapes shapes;
  const std::vector<double> knots = clamped_knots(degree, control_points);
  shapes.curve = {degree, knots, {}, {}};
  shapes.surface = {{degree, degree}, {knots, knots}, {}, {}};
  TColgp_Array1OfPnt row(1, control_points);
  TColStd_Array1OfReal row_weights(1, control_points);
  TColgp_Array2OfPnt poles(1, control_points, 1, control_points);
  TColStd_Array2OfReal weights(1, control_points, 1, control_points);
  for (int i = 1; i <= control_points; ++i)
  {
    row(i) = control_point(i, 1);
    row_weights(i) = weight(rational, i, 1);
    shapes.curve.points.push_back({row(i).X(), row(i).Y(), row(i).Z()});
    if (rational)
      shapes.curve.weights.push_back(row_weights(i));
    for (int j = 1; j <= control_points; ++j)
    {
      poles(i, j) = control_point(i, j);
      weights(i, j) = weight(rational, i, j);
      shapes.surface.points.push_back({poles(i, j).X(), poles(i, j).Y(), poles(i, j).Z()});
      if (rational)
        shapes.surface.weights.push_back(weights(i, j));
    }
  }
  TColStd_Array1OfReal values(1, spans + 1);
  TColStd_Array1OfInteger multiplicities(1, spans + 1);
  for (int i = 0; i <= spans; ++i)
  {
    values(i + 1) = knots[degree + i];
    multiplicities(i + 1) = i == 0 || i == spans ? degree + 1 : 1;
  }
  shapes.cad_curve = new Geom_BSplineCurve(row, row_weights, values, multiplicities, degree);
  shapes.cad_surface =
      new Geom_BSplineSurface(poles, weights, values, values, multiplicities, multiplicities, degree, degree);
  return shapes;
}

void report(benchmark::State& state)
{
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(count));
}

void own_curve(benchmark::State& state)
{
  const Shapes shapes = make_shapes(state.range(0) != 0);
  const std::vector<double> t = parameters(false);
  std::vector<Point> x(count);
  for (auto _ : state)
  {
    evaluate(shapes.curve, t, x);
    benchmark::DoNotOptimize(x.data());
  }
  report(state);
}

void cad_curve(benchmark::State& state)
{
  const Shapes shapes = make_shapes(state.range(0) != 0);
  const std::vector<double> t = parameters(false);
  gp_Pnt x;
  for (auto _ : state)
    for (const double at : t)
    {
      shapes.cad_curve->D0(at, x);
      benchmark::DoNotOptimize(x);
    }
  report(state);
}

void own_surface(benchmark::State& state)
{
  const Shapes shapes = make_shapes(state.range(0) != 0);
  const std::vector<double> u = parameters(true);
  const std::vector<double> v = parameters(false);
  std::vector<Point> x(count);
  for (auto _ : state)
  {
    evaluate(shapes.surface, u, v, x);
    benchmark::DoNotOptimize(x.data());
  }
  report(state);
}

void cad_surface(benchmark::State& state)
{
  const Shapes shapes = make_shapes(state.range(0) != 0);
  const std::vector<double> u = parameters(true);
  const std::vector<double> v = parameters(false);
  gp_Pnt x;
  for (auto _ : state)
    for (std::size_t i = 0; i < count; ++i)
    {
      shapes.cad_surface->D0(u[i], v[i], x);
      benchmark::DoNotOptimize(x);
    }
  report(state);
}

void own_surface_derivatives(benchmark::State& state)
{
  const Shapes shapes = make_shapes(state.range(0) != 0);
  const std::vector<double> u = parameters(true);
  const std::vector<double> v = parameters(false);
  for (auto _ : state)
    for (std::size_t i = 0; i < count; ++i)
    {
      SurfaceJet s = jet(shapes.surface, u[i], v[i]);
      benchmark::DoNotOptimize(s);
    }
  report(state);
}

void cad_surface_derivatives(benchmark::State& state)
{
  const Shapes shapes = make_shapes(state.range(0) != 0);
  const std::vector<double> u = parameters(true);
  const std::vector<double> v = parameters(false);
  gp_Pnt x;
  gp_Vec x_u, x_v, x_uu, x_vv, x_uv;
  for (auto _ : state)
    for (std::size_t i = 0; i < count; ++i)
    {
      shapes.cad_surface->D2(u[i], v[i], x, x_u, x_v, x_uu, x_vv, x_uv);
      benchmark::DoNotOptimize(x_uv);
    }
  report(state);
}

}  // namespace

// Argument 1: with weights.
BENCHMARK(own_curve)->Arg(0)->Arg(1);
BENCHMARK(cad_curve)->Arg(0)->Arg(1);
BENCHMARK(own_surface)->Arg(0)->Arg(1);
BENCHMARK(cad_surface)->Arg(0)->Arg(1);
BENCHMARK(own_surface_derivatives)->Arg(0)->Arg(1);
BENCHMARK(cad_surface_derivatives)->Arg(0)->Arg(1);

BENCHMARK_MAIN();
