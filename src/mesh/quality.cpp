#include "mesh/quality.hpp"

#include "core/error.hpp"
#include "element/line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>

namespace blockfsi::mesh
{

static_assert(std::is_trivially_copyable_v<Quality>);

namespace
{

constexpr int max_samples = (max_order + 1) * (max_order + 1);
using Samples = std::array<double, max_samples>;

/// Derivatives of both coordinates along both directions at the samples of a cell.
struct Tangents
{
  std::array<Samples, 2> xi;
  std::array<Samples, 2> eta;

  double jacobian(int s) const { return xi[0][s] * eta[1][s] - xi[1][s] * eta[0][s]; }
  double product(int s) const { return xi[0][s] * eta[0][s] + xi[1][s] * eta[1][s]; }
};

void evaluate(const QualityTables& tables, std::span<const std::int32_t> nodes, std::span<const double> x,
              Tangents& tangents)
{
  Samples coordinate;
  for (int d = 0; d < 2; ++d)
  {
    for (std::size_t k = 0; k < nodes.size(); ++k)
      coordinate[k] = x[2 * nodes[k] + d];
    apply(tables.maps.derivative, tables.maps.value, coordinate, tangents.xi[d]);
    apply(tables.maps.value, tables.maps.derivative, coordinate, tangents.eta[d]);
  }
}

double scaled_jacobian(const Tangents& tangents, int s)
{
  const double lengths =
      std::hypot(tangents.xi[0][s], tangents.xi[1][s]) * std::hypot(tangents.eta[0][s], tangents.eta[1][s]);
  if (!std::isfinite(lengths))
    return -1.0;
  return lengths > 0.0 ? tangents.jacobian(s) / lengths : 0.0;
}

/// Angle inside the cell at a corner [degrees]. Seen from the corners at xi = 1 or at eta = 1, but not both,
/// one of the two edges runs against its tangent, which turns the sign of their product.
double corner_angle(const Tangents& tangents, int s, double sign)
{
  const double angle =
      std::atan2(tangents.jacobian(s), sign * tangents.product(s)) * 180.0 / std::numbers::pi;
  return angle < 0.0 ? angle + 360.0 : angle;
}

void measure_corners(const Tangents& tangents, int points, Quality& quality)
{
  const std::array<int, 4> corners = {0, points - 1, points * (points - 1), points * points - 1};
  const std::array<double, 4> signs = {1.0, -1.0, -1.0, 1.0};
  for (int k = 0; k < 4; ++k)
  {
    const double angle = corner_angle(tangents, corners[k], signs[k]);
    quality.smallest_angle = std::min(quality.smallest_angle, angle);
    quality.largest_angle = std::max(quality.largest_angle, angle);
  }
}

Quality measure_cell(const Tangents& tangents, int points, std::span<const double> first)
{
  Quality quality;
  for (int s = 0; s < points * points; ++s)
  {
    quality.scaled_jacobian = std::min(quality.scaled_jacobian, scaled_jacobian(tangents, s));
    if (first.empty())
      continue;
    const double change = tangents.jacobian(s) / first[s];
    quality.smallest_change = std::min(quality.smallest_change, change);
    quality.largest_change = std::max(quality.largest_change, change);
  }
  measure_corners(tangents, points, quality);
  return quality;
}

/// Coordinates of the nodes of a cell.
using CellNodes = std::array<double, 3 * (max_order + 1) * (max_order + 1) * (max_order + 1)>;

std::span<const double> gather(const Mesh& mesh, std::int32_t c, std::span<const double> x, CellNodes& to)
{
  const auto dim = static_cast<std::size_t>(mesh.dim);
  const std::span<const std::int32_t> nodes = mesh.cell(c);
  // Relative to one node, so that a place far from the origin costs no digits.
  for (std::size_t k = 0; k < nodes.size(); ++k)
    for (std::size_t d = 0; d < dim; ++d)
      to[dim * k + d] = x[dim * nodes[k] + d] - x[dim * nodes[0] + d];
  return std::span(to).first(dim * nodes.size());
}

/// Quadrilaterals are measured by maps along lines, which is several times faster.
bool is_flat_tensor(element::Shape shape)
{
  return shape == element::Shape::quadrilateral;
}

std::size_t sample_count(const QualityTables& tables, element::Shape shape)
{
  return is_flat_tensor(shape) ? tables.samples_per_cell() : tables.of(shape).samples.point_count;
}

/// A cell of any other shape.
Quality measure_cell(const ShapeQuality& tables, std::span<const double> x, std::span<const double> first)
{
  const CellQuality of_cell = measure_shape(tables, x);
  Quality quality;
  quality.scaled_jacobian = of_cell.scaled_jacobian;
  quality.smallest_angle = of_cell.smallest_angle;
  quality.largest_angle = of_cell.largest_angle;
  if (first.empty())
    return quality;
  std::array<double, (max_order + 1) * (max_order + 1) * (max_order + 1)> now;
  sample_jacobian(tables, x, now);
  for (std::size_t s = 0; s < first.size(); ++s)
  {
    quality.smallest_change = std::min(quality.smallest_change, now[s] / first[s]);
    quality.largest_change = std::max(quality.largest_change, now[s] / first[s]);
  }
  return quality;
}

}  // namespace

Quality merge(const Quality& a, const Quality& b)
{
  // Between equals the lower cell is named, so that the order of merging does not matter.
  const bool a_is_worse = a.scaled_jacobian != b.scaled_jacobian ? a.scaled_jacobian < b.scaled_jacobian
                          : b.cell < 0                           ? true
                                                                 : a.cell >= 0 && a.cell < b.cell;
  Quality result = a_is_worse ? a : b;
  result.smallest_angle = std::min(a.smallest_angle, b.smallest_angle);
  result.largest_angle = std::max(a.largest_angle, b.largest_angle);
  result.smallest_change = std::min(a.smallest_change, b.smallest_change);
  result.largest_change = std::max(a.largest_change, b.largest_change);
  return result;
}

QualityTables::QualityTables(int order)
{
  check_order(order);
  maps = lagrange_maps(element::lobatto(order), element::lobatto(std::max(order, 4)));
}

QualityTables::QualityTables(const Mesh& mesh) : QualityTables(mesh.order)
{
  for (const element::Shape shape : shapes_of(mesh))
    shapes.emplace_back(shape, mesh.order);
}

const ShapeQuality& QualityTables::of(element::Shape shape) const
{
  for (const ShapeQuality& tables : shapes)
    if (tables.shape == shape)
      return tables;
  throw Error(fmt::format("no tables to measure cells of the shape {} were made", element::name(shape)));
}

std::vector<double> sample_jacobian(const QualityTables& tables, const Mesh& mesh, std::span<const double> x)
{
  std::vector<double> result;
  Tangents tangents;
  CellNodes nodes;
  for (const CellRun& run : mesh.runs)
  {
    const std::size_t samples = sample_count(tables, run.shape);
    std::size_t at = result.size();
    result.resize(at + run.count * samples);
    for (std::int32_t c = run.first; c < run.first + run.count; ++c, at += samples)
      if (is_flat_tensor(run.shape))
      {
        evaluate(tables, mesh.cell(c), x, tangents);
        for (std::size_t s = 0; s < samples; ++s)
          result[at + s] = tangents.jacobian(static_cast<int>(s));
      }
      else
        sample_jacobian(tables.of(run.shape), gather(mesh, c, x, nodes),
                        std::span(result).subspan(at, samples));
  }
  return result;
}

Quality measure(const QualityTables& tables, const Mesh& mesh, std::span<const double> x,
                std::span<const double> first)
{
  Quality quality;
  Tangents tangents;
  CellNodes nodes;
  std::size_t at = 0;
  for (const CellRun& run : mesh.runs)
  {
    const std::size_t samples = sample_count(tables, run.shape);
    for (std::int32_t c = run.first; c < run.first + run.count; ++c, at += samples)
    {
      const std::span<const double> before = first.empty() ? first : first.subspan(at, samples);
      Quality of_cell;
      if (is_flat_tensor(run.shape))
      {
        evaluate(tables, mesh.cell(c), x, tangents);
        of_cell = measure_cell(tangents, tables.maps.value.rows, before);
      }
      else
        of_cell = measure_cell(tables.of(run.shape), gather(mesh, c, x, nodes), before);
      of_cell.cell = mesh.number_of_cell(c);
      of_cell.block = mesh.cell_block[c];
      quality = merge(quality, of_cell);
    }
  }
  return quality;
}

void measure_cells(const QualityTables& tables, const Mesh& mesh, std::span<const double> x,
                   std::span<CellQuality> cells)
{
  CellNodes nodes;
  for (const CellRun& run : mesh.runs)
    for (std::int32_t c = run.first; c < run.first + run.count; ++c)
      cells[c] = measure(tables.of(run.shape), gather(mesh, c, x, nodes));
}

}  // namespace blockfsi::mesh
