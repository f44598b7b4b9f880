#pragma once

#include "mesh/cell_quality.hpp"
#include "mesh/mesh.hpp"
#include "mesh/tensor.hpp"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace blockfsi::mesh
{

/// How good the worst places of a mesh are. The default is the quality of a mesh without cells: merging it
/// changes nothing. Trivially copyable, so that it can travel between processes as bytes.
struct Quality
{
  /// Least det J / (|x_xi| |x_eta|) [-] on quadrilaterals: 1 where the grid lines are orthogonal, <= 0 where
  /// a cell is folded; on other shapes as in CellQuality.
  double scaled_jacobian = 1.0;
  /// Angles between neighbouring edges at the corners of cells, in 3D between neighbouring sides along edges
  /// [degrees], in [0, 360); above 180 at a folded corner.
  double smallest_angle = 360.0;
  double largest_angle = 0.0;
  /// Jacobian of the deformation gradient from the first mesh, det J / det J0 [-].
  double smallest_change = std::numeric_limits<double>::infinity();
  double largest_change = -std::numeric_limits<double>::infinity();
  /// Where the scaled Jacobian is least: number in the whole mesh and block; -1 if there is no cell.
  std::int64_t cell = -1;
  std::int32_t block = -1;
};

/// The worse of two in each measure: combines the parts of several processes, in any order with one result.
Quality merge(const Quality& a, const Quality& b);

/// Tables to measure meshes of one order, made once. Samples of quadrilaterals are the Gauss-Lobatto-Legendre
/// points of order max(order, 4) in both directions, which include the corners and sides of the cell; of
/// other shapes they are the nodes of that order.
struct QualityTables
{
  /// For quadrilaterals in the plane. Throws Error unless 1 <= order <= max_order.
  explicit QualityTables(int order);
  /// For the shapes of a mesh. Throws Error if cells have another dimension than their coordinates.
  explicit QualityTables(const Mesh& mesh);

  /// Of a quadrilateral.
  int samples_per_cell() const { return maps.value.rows * maps.value.rows; }
  /// Throws Error if no tables for the shape were made.
  const ShapeQuality& of(element::Shape shape) const;

  LineMaps maps;  ///< from the nodes of a line to its samples
  std::vector<ShapeQuality> shapes;
};

/// det J at all samples [m^dim], cell by cell: of the first mesh, for `measure`.
std::vector<double> sample_jacobian(const QualityTables& tables, const Mesh& mesh, std::span<const double> x);

/// Quality of the mesh at coordinates x [m], shape (node_count, dim). `first` is what sample_jacobian gave
/// for the first mesh, or empty: then the change stays at its default. Coordinates that are not finite give a
/// scaled Jacobian of -1. Allocates nothing.
Quality measure(const QualityTables& tables, const Mesh& mesh, std::span<const double> x,
                std::span<const double> first = {});

/// Quality of each cell, shape (cell_count). Allocates nothing.
void measure_cells(const QualityTables& tables, const Mesh& mesh, std::span<const double> x,
                   std::span<CellQuality> cells);

}  // namespace blockfsi::mesh
