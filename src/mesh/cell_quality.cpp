#include "mesh/cell_quality.hpp"

#include "core/lanes.hpp"
#include "element/line.hpp"
#include "element/table.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <utility>

namespace blockfsi::mesh
{

namespace
{

using element::Point;
using element::Shape;

/// Derivatives of the coordinates along each reference coordinate; in 2D the third is the unit vector out of
/// the plane.
using Matrix = std::array<Point, 3>;

double dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Point cross(const Point& a, const Point& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double length(const Point& a)
{
  return std::sqrt(dot(a, a));
}

Point difference(const Point& a, const Point& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double determinant(const Matrix& j)
{
  return dot(j[0], cross(j[1], j[2]));
}

/// Sum of the columns of a matrix times the coordinates of a point.
Point combine(const Matrix& columns, const Point& p)
{
  Point result{};
  for (int d = 0; d < 3; ++d)
    for (int c = 0; c < 3; ++c)
      result[c] += columns[d][c] * p[d];
  return result;
}

Matrix cofactors(const Matrix& j)
{
  return {cross(j[1], j[2]), cross(j[2], j[0]), cross(j[0], j[1])};
}

using Gradient = ShapeQuality::Gradient;

constexpr int lines = element::largest_order + 1;
constexpr int most_points = lines * lines * lines + Gradient::batch - 1;

/// Derivatives of the coordinates at many points: entry [d][c][q] of the coordinate c along d at the point q.
struct Derivatives
{
  std::array<std::array<std::array<double, most_points>, 3>, 3> along;

  Matrix at(int dim, int q) const
  {
    Matrix j{};
    if (dim == 2)
      j[2][2] = 1.0;
    for (int d = 0; d < dim; ++d)
      for (int c = 0; c < dim; ++c)
        j[d][c] = along[d][c][q];
    return j;
  }
};

/// The sums of a batch stay in registers while the nodes pass by.
template <int dim>
void evaluate(const Gradient& gradient, std::span<const double> x, Derivatives& result)
{
  constexpr int batch = Gradient::batch;
  for (int d = 0; d < dim; ++d)
  {
    const double* row = gradient.along[d].data();
    for (int first = 0; first < gradient.point_count; first += batch)
    {
      std::array<Lanes, dim> sum{};
      for (std::size_t n = 0; n < x.size(); n += dim, row += batch)
      {
        Lanes slope;
        std::memcpy(&slope, row, sizeof(Lanes));
        for (int c = 0; c < dim; ++c)
          sum[c] += slope * x[n + c];
      }
      for (int c = 0; c < dim; ++c)
        std::memcpy(&result.along[d][c][first], &sum[c], sizeof(Lanes));
    }
  }
}

void evaluate(const Gradient& gradient, int dim, std::span<const double> x, Derivatives& result)
{
  dim == 2 ? evaluate<2>(gradient, x, result) : evaluate<3>(gradient, x, result);
}

Gradient gradient_at(Shape shape, int order, std::span<const Point> points)
{
  constexpr int batch = Gradient::batch;
  const element::CellTable table = element::tabulate(shape, order, points);
  Gradient result;
  result.point_count = table.point_count;
  for (int d = 0; d < element::dimension(shape); ++d)
    for (int first = 0; first < table.point_count; first += batch)
      for (int n = 0; n < table.node_count; ++n)
        for (int q = first; q < first + batch; ++q)
          result.along[d].push_back(q < table.point_count
                                        ? table.first[d][static_cast<std::size_t>(q) * table.node_count + n]
                                        : 0.0);
  return result;
}

/// Largest eigenvalue of the matrix of the products of columns, by the trigonometric solution of its cubic.
double largest_squared(const Matrix& m)
{
  const double a = dot(m[0], m[0]);
  const double b = dot(m[1], m[1]);
  const double c = dot(m[2], m[2]);
  const double d = dot(m[0], m[1]);
  const double e = dot(m[1], m[2]);
  const double f = dot(m[0], m[2]);
  const double mean = (a + b + c) / 3.0;
  const double spread = std::sqrt(((a - mean) * (a - mean) + (b - mean) * (b - mean) +
                                   (c - mean) * (c - mean) + 2.0 * (d * d + e * e + f * f)) /
                                  6.0);
  if (spread <= 1e-15 * mean)
    return mean;
  const Matrix deviation = {Point{(a - mean) / spread, d / spread, f / spread},
                            Point{d / spread, (b - mean) / spread, e / spread},
                            Point{f / spread, e / spread, (c - mean) / spread}};
  const double angle = std::acos(std::clamp(0.5 * determinant(deviation), -1.0, 1.0)) / 3.0;
  return mean + 2.0 * spread * std::cos(angle);
}

/// Largest over least singular value. The least one is the determinant over the product of the others, which
/// is the largest singular value of the cofactors: so no digits are lost where the ratio is large.
double aspect_ratio(const ShapeQuality& tables, const Matrix& j)
{
  Matrix relative{};
  for (int d = 0; d < tables.dim; ++d)
    relative[d] = combine(j, tables.from_ideal[d]);
  if (tables.dim == 2)
  {
    const double a = dot(relative[0], relative[0]);
    const double b = dot(relative[1], relative[1]);
    const double c = dot(relative[0], relative[1]);
    const double largest = 0.5 * (a + b) + std::hypot(0.5 * (a - b), c);
    return largest / std::abs(relative[0][0] * relative[1][1] - relative[0][1] * relative[1][0]);
  }
  return std::sqrt(largest_squared(relative) * largest_squared(cofactors(relative))) /
         std::abs(determinant(relative));
}

double scaled_jacobian(const ShapeQuality& tables, const Matrix& j, double jacobian)
{
  std::array<double, 6> lengths{};
  for (std::size_t e = 0; e < tables.directions.size(); ++e)
    lengths[e] = length(combine(j, tables.directions[e]));
  double largest = 0.0;
  for (const auto& corner : tables.corners)
  {
    double product = 1.0;
    for (int e = 0; e < tables.dim; ++e)
      product *= lengths[corner[e]];
    if (!std::isfinite(product))
      return -1.0;
    largest = std::max(largest, product);
  }
  return largest > 0.0 ? std::min(1.0, tables.factor * jacobian / largest) : 0.0;
}

double measure_angle(const ShapeQuality& tables, const ShapeQuality::Angle& angle, const Matrix& j)
{
  const bool flat = tables.dim == 2;
  const Matrix map = flat ? j : cofactors(j);
  const Point a = combine(map, angle.first);
  const Point b = combine(map, angle.second);
  const Point turn = cross(a, b);
  double degrees = std::atan2(flat ? turn[2] : length(turn), dot(a, b)) * 180.0 / std::numbers::pi;
  if (!flat)
    degrees = determinant(j) < 0.0 ? 180.0 + degrees : 180.0 - degrees;
  return degrees < 0.0 ? degrees + 360.0 : degrees;
}

double edge_length(const ShapeQuality& tables, const ShapeQuality::Edge& edge, std::span<const double> x)
{
  double sum = 0.0;
  for (std::size_t q = 0; q < tables.edge_weights.size(); ++q)
  {
    Point tangent{};
    for (std::size_t n = 0; n < edge.size(); ++n)
      for (int c = 0; c < tables.dim; ++c)
        tangent[c] +=
            tables.edge_gradient[q * edge.size() + n] * x[static_cast<std::size_t>(tables.dim) * edge[n] + c];
    sum += tables.edge_weights[q] * length(tangent);
  }
  return sum;
}

/// Outward normal of a side of the reference cell.
Point side_normal(Shape shape, const element::SideShape& side)
{
  const auto corners = element::corners(shape);
  const Point& origin = corners[side.corners[0]];
  const Point first = difference(corners[side.corners[1]], origin);
  const Point second = difference(corners[side.corners[element::corner_count(side.shape) - 1]], origin);
  return side.outward ? cross(first, second) : cross(second, first);
}

bool has_corner(const element::SideShape& side, int corner)
{
  const auto end = side.corners.begin() + element::corner_count(side.shape);
  return std::find(side.corners.begin(), end, corner) != end;
}

/// In 2D at each corner, counter-clockwise from the edge to the next corner to that to the one before.
std::vector<Point> place_corner_angles(Shape shape, std::vector<ShapeQuality::Angle>& angles)
{
  const auto corners = element::corners(shape);
  const std::size_t count = corners.size();
  std::vector<Point> points;
  for (std::size_t c = 0; c < count; ++c)
  {
    points.push_back(corners[c]);
    angles.push_back({difference(corners[(c + 1) % count], corners[c]),
                      difference(corners[(c + count - 1) % count], corners[c])});
  }
  return points;
}

/// In 3D at both ends and the middle of each edge. The end at the apex of a pyramid is approached along the
/// edge.
std::vector<Point> place_edge_angles(Shape shape, std::vector<ShapeQuality::Angle>& angles)
{
  std::vector<Point> points;
  for (const auto& [a, b] : element::edges(shape))
  {
    ShapeQuality::Angle angle;
    bool is_second = false;
    for (const element::SideShape& side : element::sides(shape))
      if (has_corner(side, a) && has_corner(side, b))
        (std::exchange(is_second, true) ? angle.second : angle.first) = side_normal(shape, side);
    const bool to_apex = shape == Shape::pyramid && b == 4;
    for (const double t : {0.0, 0.5, to_apex ? 1.0 - 1e-9 : 1.0})
    {
      Point point{};
      for (int d = 0; d < 3; ++d)
        point[d] = (1.0 - t) * element::corners(shape)[a][d] + t * element::corners(shape)[b][d];
      points.push_back(point);
      angles.push_back(angle);
    }
  }
  return points;
}

/// Directions of the edges that meet at each corner, up to sign. At the apex of a pyramid four meet; what is
/// there is seen from the base.
void place_directions(ShapeQuality& tables)
{
  const auto add = [&tables](const Point& direction)
  {
    for (std::size_t e = 0; e < tables.directions.size(); ++e)
      if (length(cross(tables.directions[e], direction)) == 0.0)
        return static_cast<std::int8_t>(e);
    tables.directions.push_back(direction);
    return static_cast<std::int8_t>(tables.directions.size() - 1);
  };
  const auto corners = element::corners(tables.shape);
  for (int c = 0; c < static_cast<int>(corners.size()); ++c)
  {
    std::array<std::int8_t, 3> of_corner;
    of_corner.fill(std::numeric_limits<std::int8_t>::max());  // sorted last where a corner has two edges
    int count = 0;
    for (const auto& [a, b] : element::edges(tables.shape))
      if ((a == c || b == c) && count < tables.dim)
        of_corner[count++] = add(difference(corners[b], corners[a]));
    std::sort(of_corner.begin(), of_corner.end());
    const bool is_apex = tables.shape == Shape::pyramid && c == 4;
    if (!is_apex &&
        std::find(tables.corners.begin(), tables.corners.end(), of_corner) == tables.corners.end())
      tables.corners.push_back(of_corner);
  }
}

/// Inverse of the matrix whose columns are the edges of the ideal cell, and the inverse of its scaled
/// Jacobian.
void place_ideal(ShapeQuality& tables)
{
  const double height = std::sqrt(0.75);
  Matrix ideal = {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};
  const Shape shape = tables.shape;
  if (shape == Shape::triangle || shape == Shape::tetrahedron || shape == Shape::prism)
    ideal[1] = {0.5, height, 0.0};
  if (shape == Shape::tetrahedron)
    ideal[2] = {0.5, height / 3.0, std::sqrt(2.0 / 3.0)};
  if (shape == Shape::pyramid)
    ideal[2] = {0.5, 0.5, std::sqrt(0.5)};
  // Its edges have length 1.
  tables.factor = 1.0 / determinant(ideal);
  const Matrix rows = cofactors(ideal);
  for (int d = 0; d < 3; ++d)
    for (int c = 0; c < 3; ++c)
      tables.from_ideal[d][c] = rows[c][d] * tables.factor;
}

}  // namespace

ShapeQuality::ShapeQuality(Shape shape_, int order) : shape(shape_), dim(element::dimension(shape_))
{
  samples = gradient_at(shape, order, element::nodes(shape, std::max(order, 4)));
  const std::vector<Point> points =
      dim == 2 ? place_corner_angles(shape, angles) : place_edge_angles(shape, angles);
  angle_points = gradient_at(shape, order, points);
  for (std::size_t e = 0; e < element::edges(shape).size(); ++e)
    edges.push_back(element::edge_lattice(shape, order, static_cast<int>(e)));
  const element::Rule rule = element::gauss(order + 2);
  edge_weights = rule.weights;
  edge_gradient = element::lagrange(element::lobatto(order), rule.points).first;
  place_directions(*this);
  place_ideal(*this);
}

void sample_jacobian(const ShapeQuality& tables, std::span<const double> x, std::span<double> result)
{
  Derivatives derivatives;
  evaluate(tables.samples, tables.dim, x, derivatives);
  for (int q = 0; q < tables.samples.point_count; ++q)
    result[q] = determinant(derivatives.at(tables.dim, q));
}

namespace
{

void measure_angles(const ShapeQuality& tables, std::span<const double> x, Derivatives& derivatives,
                    CellQuality& quality)
{
  evaluate(tables.angle_points, tables.dim, x, derivatives);
  for (int q = 0; q < tables.angle_points.point_count; ++q)
  {
    const double angle = measure_angle(tables, tables.angles[q], derivatives.at(tables.dim, q));
    quality.smallest_angle = std::min(quality.smallest_angle, angle);
    quality.largest_angle = std::max(quality.largest_angle, angle);
  }
}

/// Leaves the derivatives at the samples.
CellQuality measure_shape(const ShapeQuality& tables, std::span<const double> x, Derivatives& derivatives)
{
  CellQuality quality;
  measure_angles(tables, x, derivatives, quality);
  evaluate(tables.samples, tables.dim, x, derivatives);
  for (int q = 0; q < tables.samples.point_count; ++q)
  {
    const Matrix j = derivatives.at(tables.dim, q);
    quality.scaled_jacobian = std::min(quality.scaled_jacobian, scaled_jacobian(tables, j, determinant(j)));
  }
  return quality;
}

}  // namespace

CellQuality measure_shape(const ShapeQuality& tables, std::span<const double> x)
{
  Derivatives derivatives;
  return measure_shape(tables, x, derivatives);
}

CellQuality measure(const ShapeQuality& tables, std::span<const double> x)
{
  Derivatives derivatives;
  CellQuality quality = measure_shape(tables, x, derivatives);
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (int q = 0; q < tables.samples.point_count; ++q)
  {
    const Matrix j = derivatives.at(tables.dim, q);
    const double jacobian = determinant(j);
    least = std::min(least, jacobian);
    most = std::max(most, jacobian);
    quality.aspect_ratio = std::max(quality.aspect_ratio, aspect_ratio(tables, j));
  }
  quality.jacobian_ratio = most > 0.0 ? least / most : -1.0;
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0.0;
  for (const ShapeQuality::Edge& edge : tables.edges)
  {
    const double of_edge = edge_length(tables, edge, x);
    shortest = std::min(shortest, of_edge);
    longest = std::max(longest, of_edge);
  }
  quality.edge_ratio = longest / shortest;
  return quality;
}

Histogram histogram(std::span<const CellQuality> cells, double CellQuality::*measure, double low, double high,
                    int intervals)
{
  Histogram result{low, high, std::vector<std::int64_t>(intervals, 0)};
  for (const CellQuality& cell : cells)
  {
    const double place = intervals * (cell.*measure - low) / (high - low);
    // Written so that NaN falls into the last interval.
    const int interval = place < intervals ? static_cast<int>(std::max(place, 0.0)) : intervals - 1;
    ++result.counts[interval];
  }
  return result;
}

}  // namespace blockfsi::mesh
