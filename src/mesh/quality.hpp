#pragma once

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
  /// Least det J / (|x_xi| |x_eta|) [-]: 1 where the grid lines are orthogonal, <= 0 where a cell is folded.
  double scaled_jacobian = 1.0;
  /// Angles between neighbouring edges at the corners of cells [degrees], in [0, 360); above 180 at a folded
  /// corner.
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

/// Tables to measure meshes of one order, made once. Samples are the Gauss-Lobatto-Legendre points of order
/// max(order, 4) in both directions, which include the corners and sides of the cell.
struct QualityTables
{
  /// Throws Error unless 1 <= order <= max_order.
  explicit QualityTables(int order);

  int samples_per_cell() const { return maps.value.rows * maps.value.rows; }

  LineMaps maps;  ///< from the nodes of a line to its samples
};

/// det J at all samples [m^2], shape (cell_count, samples_per_cell): of the first mesh, for `measure`.
std::vector<double> sample_jacobian(const QualityTables& tables, const Mesh& mesh, std::span<const double> x);

/// Quality of the mesh at coordinates x [m], shape (node_count, 2). `first` is what sample_jacobian gave for
/// the first mesh, or empty: then the change stays at its default. Coordinates that are not finite give a
/// scaled Jacobian of -1. Allocates nothing.
Quality measure(const QualityTables& tables, const Mesh& mesh, std::span<const double> x,
                std::span<const double> first = {});

}  // namespace blockfsi::mesh
