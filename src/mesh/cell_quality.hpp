#pragma once

#include "core/lanes.hpp"
#include "element/nodes.hpp"
#include "element/shape.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::mesh
{

/// How good a cell is.
struct CellQuality
{
  /// Least det J over the product of the lengths of edges that meet at a corner, as long as they are at the
  /// sample, times the factor that makes it 1 for the ideal cell (equilateral; all edges equal on a pyramid);
  /// at most 1, <= 0 where the cell is folded.
  double scaled_jacobian = 1.0;
  /// Least over largest det J; 1 where the map is affine.
  double jacobian_ratio = 1.0;
  /// In 2D between the edges at corners, in 3D between the sides along edges [degrees], in [0, 360); above
  /// 180 at a folded place.
  double smallest_angle = 360.0;
  double largest_angle = 0.0;
  /// Largest ratio of the singular values of the Jacobian matrix relative to the ideal cell.
  double aspect_ratio = 1.0;
  /// Longest over shortest edge.
  double edge_ratio = 1.0;
};

/// Tables to measure cells of one shape and order. Samples are element::nodes of order max(order, 4), which
/// include corners, edges and sides.
struct ShapeQuality
{
  ShapeQuality(element::Shape shape, int order);

  /// Where an angle is measured, between two directions from a corner (2D) or two normals of sides (3D), in
  /// reference coordinates.
  struct Angle
  {
    element::Point first{};
    element::Point second{};
  };
  /// An edge: its nodes within the cell.
  using Edge = std::vector<std::int32_t>;
  /// Derivatives of the Lagrange functions along xi, eta, zeta at some points, shapes (batches of `batch`
  /// points, node_count, batch); what is left of the last batch is 0.
  struct Gradient
  {
    static constexpr int batch = lane_count;
    int point_count = 0;
    std::array<std::vector<double>, 3> along;
  };

  element::Shape shape = element::Shape::quadrilateral;
  int dim = 2;
  Gradient samples;
  Gradient angle_points;
  std::vector<Angle> angles;  ///< shape (angle_points.point_count)
  std::vector<Edge> edges;
  std::vector<double> edge_weights;   ///< of Gauss points on an edge
  std::vector<double> edge_gradient;  ///< derivatives there, shape (Gauss points, order + 1)
  /// Directions of edges, and the dim of them that meet at each corner.
  std::vector<element::Point> directions;
  std::vector<std::array<std::int8_t, 3>> corners;
  double factor = 1.0;  ///< of the scaled Jacobian
  /// Takes the ideal cell to the reference cell, column by column.
  std::array<element::Point, 3> from_ideal{};
};

/// det J at the samples of a cell with nodes x [m], shape (node_count, dim), to `result`, shape (samples).
/// Allocates nothing.
void sample_jacobian(const ShapeQuality& tables, std::span<const double> x, std::span<double> result);

/// Quality of a cell with nodes x [m], shape (node_count, dim). Coordinates that are not finite give a scaled
/// Jacobian of -1. Allocates nothing.
CellQuality measure(const ShapeQuality& tables, std::span<const double> x);

/// The scaled Jacobian and the angles of the same only, in less time; all else as of the ideal cell.
CellQuality measure_shape(const ShapeQuality& tables, std::span<const double> x);

/// How many of some values lie in each of equal intervals of [low, high]; the first and the last interval
/// also count what lies beyond, and the last what is no number.
struct Histogram
{
  double low = 0.0;
  double high = 1.0;
  std::vector<std::int64_t> counts;
};

/// Of one measure of cells, for instance histogram(cells, &CellQuality::scaled_jacobian, 0, 1, 10).
Histogram histogram(std::span<const CellQuality> cells, double CellQuality::*measure, double low, double high,
                    int intervals);

}  // namespace blockfsi::mesh
