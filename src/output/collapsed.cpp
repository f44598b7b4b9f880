#include "output/collapsed.hpp"

#include "core/error.hpp"
#include "element/line.hpp"
#include "output/lattice_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace blockfsi::output
{

namespace
{

using element::LatticePoint;
using element::Shape;

/// The points of a triangle's lattice as seen from its corners in ascending order of their points, so that
/// cells on both sides see the same.
struct Canonical
{
  std::vector<std::int32_t> rim;     ///< points on its edges
  std::vector<std::int32_t> inside;  ///< positions in the list that was given
};

Canonical canonical(std::span<const std::int32_t> points, int order)
{
  const std::array<LatticePoint, 3> corners = {{{0, 0, 0}, {order, 0, 0}, {0, order, 0}}};
  const auto at = [order](const LatticePoint& p)
  { return static_cast<std::int32_t>(element::lattice_index(Shape::triangle, order, p)); };
  std::array<int, 3> sorted = {0, 1, 2};
  std::sort(sorted.begin(), sorted.end(),
            [&](int a, int b) { return points[at(corners[a])] < points[at(corners[b])]; });
  Canonical result;
  for (const auto& [s, t, unused] : element::lattice_points(Shape::triangle, order))
  {
    std::array<int, 3> barycentric{};
    barycentric[sorted[0]] = order - s - t;
    barycentric[sorted[1]] = s;
    barycentric[sorted[2]] = t;
    const std::int32_t position = at({barycentric[1], barycentric[2], 0});
    if (s == 0 || t == 0 || s + t == order)
      result.rim.push_back(points[position]);
    else
      result.inside.push_back(position);
  }
  return result;
}

/// Triangles by their rim, with the points inside in canonical order.
using Triangles = std::map<std::vector<std::int32_t>, std::vector<std::int32_t>>;

std::vector<std::int32_t> side_points(std::span<const std::int32_t> cell, std::span<const std::int32_t> side)
{
  std::vector<std::int32_t> points;
  for (const std::int32_t at : side)
    points.push_back(cell[at]);
  return points;
}

/// The sides of a shape that are triangles, as indices in its lattice.
std::vector<std::vector<std::int32_t>> triangle_sides(Shape shape, int order)
{
  std::vector<std::vector<std::int32_t>> result;
  for (std::size_t s = 0; s < element::sides(shape).size(); ++s)
    if (element::sides(shape)[s].shape == Shape::triangle)
      result.push_back(element::side_lattice(shape, order, static_cast<int>(s)));
  return result;
}

Triangles triangles_of(const Draft& draft)
{
  Triangles triangles;
  if (draft.order < 3)
    return triangles;
  for (const DraftCells& list : draft.cells)
  {
    const auto n = static_cast<std::size_t>(element::lattice_size(list.shape, draft.order));
    const auto sides = triangle_sides(list.shape, draft.order);
    for (std::size_t c = 0; c < list.number.size(); ++c)
      for (const std::vector<std::int32_t>& side : sides)
      {
        const std::vector<std::int32_t> points = side_points(std::span(list.points).subspan(c * n, n), side);
        const Canonical of = canonical(points, draft.order);
        triangles[of.rim] = side_points(points, of.inside);
      }
  }
  return triangles;
}

/// Values of the functions of the collapsed hexahedron at the points of the pyramid's lattice, shape
/// (lattice_size(pyramid), lattice_size(hexahedron)).
std::vector<double> hexahedron_to_pyramid(int order)
{
  std::vector<double> line(order + 1);
  for (int i = 0; i <= order; ++i)
    line[i] = static_cast<double>(i) / order;
  const auto hexahedron = element::lattice_points(Shape::hexahedron, order);
  std::vector<double> map;
  for (const auto& [i, j, k] : element::lattice_points(Shape::pyramid, order))
  {
    const double width = std::max(order - k, 1);  // at the apex any will do
    const std::array<double, 3> at = {i / width, j / width, static_cast<double>(k) / order};
    const element::Table table = element::lagrange(line, at);
    for (const auto& [a, b, c] : hexahedron)
      map.push_back(table.value[a] * table.value[order + 1 + b] * table.value[2 * (order + 1) + c]);
  }
  return map;
}

/// Adds pyramids one after the other.
class Builder
{
public:
  explicit Builder(Draft& draft)
      : draft_(draft), triangles_(triangles_of(draft)), map_(hexahedron_to_pyramid(draft.order)),
        lattice_(element::lattice_points(Shape::pyramid, draft.order)),
        sides_(triangle_sides(Shape::pyramid, draft.order)), from_(lattice_.size(), -1)
  {
    const CollapsedPyramid collapsed(draft.order);
    for (std::size_t h = 0; h < collapsed.hexahedron.size(); ++h)
      if (collapsed.hexahedron[h] >= 0)
        from_[collapsed.hexahedron[h]] = static_cast<std::int32_t>(h);
  }

  void add(const Collapsed& pyramid)
  {
    std::vector<std::int32_t> cell(lattice_.size(), -1);
    for (std::size_t k = 0; k < cell.size(); ++k)
      if (from_[k] >= 0)
        cell[k] = pyramid.points[from_[k]];
    if (draft_.order > 2)
      for (const std::vector<std::int32_t>& side : sides_)
        share(cell, side, pyramid);
    for (std::size_t k = 0; k < cell.size(); ++k)
      if (cell[k] < 0)
        cell[k] = make_point(pyramid, k);
    DraftCells& list = draft_.cells_of(Shape::pyramid);
    list.points.insert(list.points.end(), cell.begin(), cell.end());
    list.block.push_back(pyramid.block);
    list.number.push_back(pyramid.number);
  }

private:
  /// Points inside a triangle: those of the other side, or new ones.
  void share(std::vector<std::int32_t>& cell, std::span<const std::int32_t> side, const Collapsed& pyramid)
  {
    const Canonical of = canonical(side_points(cell, side), draft_.order);
    const auto [found, is_new] = triangles_.try_emplace(of.rim);
    for (std::size_t k = 0; k < of.inside.size(); ++k)
    {
      const std::int32_t at = side[of.inside[k]];
      if (is_new)
        found->second.push_back(make_point(pyramid, at));
      cell[at] = found->second[k];
    }
  }

  std::int32_t make_point(const Collapsed& pyramid, std::size_t position)
  {
    const auto point = static_cast<std::int32_t>(draft_.point_count());
    evaluate(draft_.points, 3, pyramid, position);
    for (ReadField& field : draft_.fields)
      evaluate(field.values, field.components, pyramid, position);
    return point;
  }

  void evaluate(std::vector<double>& values, int components, const Collapsed& pyramid, std::size_t position)
  {
    const std::size_t n = pyramid.points.size();
    for (int d = 0; d < components; ++d)
    {
      double sum = 0.0;
      for (std::size_t h = 0; h < n; ++h)
        sum += map_[position * n + h] * values[std::size_t(pyramid.points[h]) * components + d];
      values.push_back(sum);
    }
  }

  Draft& draft_;
  Triangles triangles_;
  std::vector<double> map_;
  std::vector<LatticePoint> lattice_;
  std::vector<std::vector<std::int32_t>> sides_;
  std::vector<std::int32_t> from_;  ///< where each node of the pyramid stands in the hexahedron, or -1
};

}  // namespace

bool is_collapsed(std::span<const std::int32_t> points, int degree)
{
  const std::size_t top = std::size_t(degree + 1) * (degree + 1);
  const std::span<const std::int32_t> last = points.last(top);
  return std::all_of(last.begin(), last.end(), [&](std::int32_t point) { return point == last.front(); });
}

void add_collapsed(Draft& draft, std::span<const Collapsed> pyramids)
{
  if (pyramids.empty())
    return;
  for (const Collapsed& pyramid : pyramids)
    for (const std::int32_t point : pyramid.points)
      if (point < 0 || static_cast<std::size_t>(point) >= draft.point_count())
        throw Error(fmt::format("cell {} has the node {}, but there are {} points", pyramid.number, point,
                                draft.point_count()));
  Builder builder(draft);
  for (const Collapsed& pyramid : pyramids)
    builder.add(pyramid);
}

}  // namespace blockfsi::output
