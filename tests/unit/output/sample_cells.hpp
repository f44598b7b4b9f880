#pragma once

#include "element/nodes.hpp"
#include "mesh/mesh.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

namespace blockfsi
{

/// Small curved meshes of every shape for tests of files, made without the block generator: cells of a box in
/// a grid of 2 (x 2) x n, whose nodes are then moved by a smooth map.
struct CellSample
{
  mesh::Mesh mesh;
  std::vector<double> x;  ///< [m], shape (node_count, dim)
};

namespace sample
{

using Corner = std::array<double, 3>;

/// The smooth map of the box.
inline Corner bend(const Corner& r, int dim)
{
  const double a = 0.15;
  if (dim == 2)
    return {r[0] + a * std::sin(2.0 * r[1]) + 0.1 * r[0] * r[0], r[1] + a * std::cos(1.5 * r[0]) * r[1], 0.0};
  return {r[0] + a * std::sin(2.0 * r[1]) * r[2], r[1] + a * std::cos(1.5 * r[0]) + 0.1 * r[1] * r[2],
          r[2] + a * std::sin(r[0] + r[1]) + 0.1 * r[2] * r[2]};
}

/// A point of a cell with straight edges between its corners.
inline Corner straight(element::Shape shape, const std::vector<Corner>& corner, const element::Point& p)
{
  const auto [x, y, z] = p;
  std::vector<double> weight;
  switch (shape)
  {
  case element::Shape::triangle:
  case element::Shape::tetrahedron:
    weight = {1.0 - x - y - z, x, y, z};
    break;
  case element::Shape::prism:
    weight = {(1 - x - y) * (1 - z), x * (1 - z), y * (1 - z), (1 - x - y) * z, x * z, y * z};
    break;
  case element::Shape::pyramid:
  {
    const double h = z < 1.0 ? 1.0 - z : 1.0;
    weight = {(h - x) * (h - y) / h, x * (h - y) / h, x * y / h, (h - x) * y / h, z};
    if (z == 1.0)
      weight = {0.0, 0.0, 0.0, 0.0, 1.0};
    break;
  }
  default:
    weight = {(1 - x) * (1 - y) * (1 - z), x * (1 - y) * (1 - z), x * y * (1 - z), (1 - x) * y * (1 - z),
              (1 - x) * (1 - y) * z,       x * (1 - y) * z,       x * y * z,       (1 - x) * y * z};
  }
  Corner result{};
  for (std::size_t c = 0; c < corner.size(); ++c)
    for (int d = 0; d < 3; ++d)
      result[d] += weight[c] * corner[c][d];
  return result;
}

/// Puts cells together; nodes at the same place of the box are one.
class Builder
{
public:
  Builder(int dim, int order)
  {
    sample.mesh.dim = dim;
    sample.mesh.order = order;
    sample.mesh.block_names = {"first", "second <&> \"block\""};
    sample.mesh.block_regions = {"fluid", "solid"};
  }

  void add(element::Shape shape, const std::vector<Corner>& corners, int block)
  {
    mesh::Mesh& mesh = sample.mesh;
    if (mesh.runs.empty() || mesh.runs.back().shape != shape)
      mesh.runs.push_back({shape, static_cast<std::int32_t>(mesh.cell_count()), 0,
                           static_cast<std::int64_t>(mesh.cells.size())});
    ++mesh.runs.back().count;
    mesh.cell_block.push_back(block);
    cell_corners.push_back(corners);
    for (const element::Point& p : element::nodes(shape, mesh.order))
      mesh.cells.push_back(node(straight(shape, corners, p)));
  }

  /// Sides whose corners all lie in the plane r[direction] = at.
  void name_boundary(const char* name, int direction, double at)
  {
    std::vector<mesh::Side>& sides = sample.mesh.boundaries[name];
    for (std::size_t c = 0; c < sample.mesh.cell_count(); ++c)
    {
      const auto all = element::sides(sample.mesh.shape(c));
      for (std::size_t s = 0; s < all.size(); ++s)
      {
        bool on = true;
        for (int k = 0; k < element::corner_count(all[s].shape); ++k)
          on = on && std::abs(cell_corners[c][all[s].corners[k]][direction] - at) < 1e-9;
        if (on)
          sides.push_back({static_cast<std::int32_t>(c), static_cast<std::int32_t>(s)});
      }
    }
  }

  CellSample finish()
  {
    sample.mesh.local_node_count = nodes.size();
    sample.mesh.total_node_count = static_cast<std::int64_t>(nodes.size());
    sample.mesh.total_cell_count = static_cast<std::int64_t>(sample.mesh.cell_count());
    return sample;
  }

private:
  std::int32_t node(const Corner& r)
  {
    std::array<std::int64_t, 3> key{};
    for (int d = 0; d < 3; ++d)
      key[d] = std::llround(r[d] * 1e9);
    const auto [found, is_new] = nodes.try_emplace(key, static_cast<std::int32_t>(nodes.size()));
    if (is_new)
    {
      const Corner x = bend(r, sample.mesh.dim);
      sample.x.insert(sample.x.end(), x.begin(), x.begin() + sample.mesh.dim);
    }
    return found->second;
  }

  CellSample sample;
  std::map<std::array<std::int64_t, 3>, std::int32_t> nodes;
  std::vector<std::vector<Corner>> cell_corners;
};

/// Corners of the box (i, j, k) of a grid of unit boxes in the order of a hexahedron.
inline std::vector<Corner> box(int i, int j, int k)
{
  std::vector<Corner> corners;
  for (const auto& c : element::corners(element::Shape::hexahedron))
    corners.push_back({i + c[0], j + c[1], k + c[2]});
  return corners;
}

inline std::vector<Corner> pick(const std::vector<Corner>& from, std::initializer_list<int> which)
{
  std::vector<Corner> corners;
  for (const int c : which)
    corners.push_back(from[c]);
  return corners;
}

inline Corner middle(const std::vector<Corner>& box)
{
  return {0.5 * (box[0][0] + box[6][0]), 0.5 * (box[0][1] + box[6][1]), 0.5 * (box[0][2] + box[6][2])};
}

/// Faces of a box seen from inside as the base of a pyramid.
inline constexpr std::array<std::array<int, 4>, 6> faces = {
    {{0, 1, 2, 3}, {0, 4, 5, 1}, {1, 5, 6, 2}, {3, 2, 6, 7}, {0, 3, 7, 4}, {4, 7, 6, 5}}};

inline void add_box(Builder& builder, element::Shape shape, const std::vector<Corner>& b, int block)
{
  using element::Shape;
  const auto add = [&](std::initializer_list<int> which) { builder.add(shape, pick(b, which), block); };
  if (shape == Shape::hexahedron)
    builder.add(shape, b, block);
  if (shape == Shape::prism)
  {
    add({0, 1, 2, 4, 5, 6});
    add({0, 2, 3, 4, 6, 7});
  }
  if (shape == Shape::tetrahedron)  // all around the diagonal from 0 to 6
  {
    add({0, 1, 2, 6});
    add({0, 2, 3, 6});
    add({0, 3, 7, 6});
    add({0, 7, 4, 6});
    add({0, 4, 5, 6});
    add({0, 5, 1, 6});
  }
  if (shape == Shape::pyramid)
    for (const auto& f : faces)
      builder.add(shape, {b[f[0]], b[f[1]], b[f[2]], b[f[3]], middle(b)}, block);
}

inline void name_boundaries(Builder& builder, int dim, const Corner& size)
{
  constexpr std::array<std::array<const char*, 2>, 3> names = {
      {{"inlet", "outlet & \"more\""}, {"low", "high"}, {"bottom", "top"}}};
  for (int d = 0; d < dim; ++d)
  {
    builder.name_boundary(names[d][0], d, 0.0);
    builder.name_boundary(names[d][1], d, size[d]);
  }
  builder.name_boundary("none", 0, -1.0);
}

}  // namespace sample

/// 2 x 2 x 2 boxes of one shape (2 x 3 in two dimensions) in two blocks.
inline CellSample sample_of(element::Shape shape, int order)
{
  using namespace sample;
  const int dim = element::dimension(shape);
  Builder builder(dim, order);
  if (dim == 3)
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        for (int k = 0; k < 2; ++k)
          add_box(builder, shape, box(i, j, k), i);
  else
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 3; ++j)
      {
        const std::vector<Corner> b = box(i, j, 0);
        if (shape == element::Shape::quadrilateral)
          builder.add(shape, pick(b, {0, 1, 2, 3}), i);
        else
        {
          builder.add(shape, pick(b, {1, 2, 0}), i);
          builder.add(shape, pick(b, {3, 0, 2}), i);
        }
      }
  name_boundaries(builder, dim, dim == 3 ? Corner{2.0, 2.0, 2.0} : Corner{2.0, 3.0, 0.0});
  return builder.finish();
}

/// All shapes of one dimension in one mesh: prisms, a hexahedron, a pyramid on it with tetrahedra around; or
/// quadrilaterals and triangles.
inline CellSample mixed_sample(int dim, int order)
{
  using namespace sample;
  using element::Shape;
  Builder builder(dim, order);
  if (dim == 2)
  {
    builder.add(Shape::quadrilateral, pick(box(0, 0, 0), {0, 1, 2, 3}), 0);
    builder.add(Shape::quadrilateral, pick(box(1, 1, 0), {1, 2, 3, 0}), 1);
    for (const auto& b : {box(1, 0, 0), box(0, 1, 0)})
    {
      builder.add(Shape::triangle, pick(b, {0, 1, 3}), 1);
      builder.add(Shape::triangle, pick(b, {2, 3, 1}), 0);
    }
    name_boundaries(builder, dim, {2.0, 2.0, 0.0});
    return builder.finish();
  }
  add_box(builder, Shape::prism, box(0, 0, 0), 0);
  add_box(builder, Shape::hexahedron, box(1, 0, 0), 0);
  const std::vector<Corner> last = box(2, 0, 0);
  const auto face = [&last](int f) {
    return pick(last, {faces[f][0], faces[f][1], faces[f][2], faces[f][3]});
  };
  std::vector<Corner> base = face(4);
  base.push_back(middle(last));
  builder.add(Shape::pyramid, base, 1);
  for (const int f : {0, 1, 2, 3, 5})
  {
    const std::vector<Corner> q = face(f);
    builder.add(Shape::tetrahedron, {q[0], q[1], q[2], middle(last)}, 1);
    builder.add(Shape::tetrahedron, {q[2], q[3], q[0], middle(last)}, 1);
  }
  name_boundaries(builder, dim, {3.0, 1.0, 1.0});
  return builder.finish();
}

}  // namespace blockfsi
