#include "block/transform.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

namespace blockfsi::block
{

namespace
{

using element::Shape;

double determinant(const Affine& map)
{
  return geometry::dot(map.matrix[0], geometry::cross(map.matrix[1], map.matrix[2]));
}

geometry::Point unit(const geometry::Point& vector, const char* what)
{
  const double length = geometry::norm(vector);
  if (!(length > 0.0))
    throw Error(std::string("the ") + what + " has no length");
  return geometry::scaled(1.0 / length, vector);
}

/// Whether lengths are kept.
bool is_rigid(const Affine& map)
{
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (std::abs(geometry::dot(map.matrix[i], map.matrix[j]) - (i == j ? 1.0 : 0.0)) > 1e-12)
        return false;
  return true;
}

/// "FROM rest" -> "TO rest"; other names stay.
std::string renamed(const std::string& name, std::string_view from, std::string_view to)
{
  if (name.size() > from.size() && name.starts_with(from) && name[from.size()] == ' ')
    return std::string(to) + name.substr(from.size());
  return name;
}

}  // namespace

void turn_over(Block& block)
{
  auto& p = block.points;
  switch (block.shape)
  {
  case Shape::segment:
    break;
  case Shape::triangle:
  case Shape::tetrahedron:
    std::swap(p[1], p[2]);
    break;
  case Shape::quadrilateral:
  case Shape::pyramid:
    std::swap(p[1], p[3]);
    break;
  case Shape::prism:
    std::swap(p[1], p[2]);
    std::swap(p[4], p[5]);
    break;
  case Shape::hexahedron:
    std::swap(p[1], p[3]);
    std::swap(p[5], p[7]);
    break;
  }
}

geometry::Curve moved(const geometry::Curve& curve, const geometry::Point& a, const geometry::Point& b,
                      const Affine& map)
{
  if (std::holds_alternative<geometry::Segment>(curve))
    return curve;
  // An axis would have to turn round in a reflection: such arcs are functions as all others.
  if (const auto* arc = std::get_if<geometry::Arc>(&curve); arc && !arc->axis && is_rigid(map))
    return geometry::Arc{map(arc->center), arc->longer, {}};
  return geometry::Function{[=](double t) { return map(geometry::evaluate(curve, a, b, t)); }};
}

FaceGeometry moved(const FaceGeometry& geometry, const Affine& map)
{
  const Affine back = inverse(map);
  const auto surface = [&](const geometry::Surface& original)
  {
    return geometry::FunctionSurface{[=](double u, double v)
                                     { return map(geometry::evaluate(original, u, v)); }};
  };
  if (const auto* on = std::get_if<Patch>(&geometry))
    return Patch{surface(on->surface)};
  if (const auto* on = std::get_if<OnSurface>(&geometry))
  {
    if (const auto* sphere = std::get_if<geometry::Sphere>(&on->surface); sphere && is_rigid(map))
      return OnSurface{geometry::Sphere{map(sphere->center), sphere->radius}};
    return OnSurface{surface(on->surface)};
  }
  if (const auto* on = std::get_if<OnLevelSet>(&geometry))
    return OnLevelSet{geometry::LevelSet(
        on->level_set.text() + ", moved",
        [level_set = on->level_set, back](const geometry::Point& x)
        {
          geometry::Level level = level_set(back(x));
          // The chain rule: the gradient goes with the transpose of the inverse.
          geometry::Point gradient{};
          for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
              gradient[j] += back.matrix[i][j] * level.gradient[i];
          level.gradient = gradient;
          return level;
        },
        [level_set = on->level_set, back](const geometry::Point& x) { return level_set.value(back(x)); })};
  return geometry;
}

geometry::Point Affine::operator()(const geometry::Point& x) const
{
  return geometry::add(turn(x), shift);
}

geometry::Point Affine::turn(const geometry::Point& vector) const
{
  return {geometry::dot(matrix[0], vector), geometry::dot(matrix[1], vector),
          geometry::dot(matrix[2], vector)};
}

Affine translation(const geometry::Point& by)
{
  Affine map;
  map.shift = by;
  return map;
}

Affine rotation(const geometry::Point& center, const geometry::Point& axis, double angle)
{
  // Rodrigues' formula: R = cos 1 + (1 - cos) a a^T + sin [a]x.
  const geometry::Point a = unit(axis, "axis of a rotation");
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Affine map;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      map.matrix[i][j] = (i == j ? c : 0.0) + (1.0 - c) * a[i] * a[j];
  map.matrix[0][1] -= s * a[2];
  map.matrix[0][2] += s * a[1];
  map.matrix[1][0] += s * a[2];
  map.matrix[1][2] -= s * a[0];
  map.matrix[2][0] -= s * a[1];
  map.matrix[2][1] += s * a[0];
  map.shift = geometry::subtract(center, map.turn(center));
  return map;
}

Affine reflection(const geometry::Point& center, const geometry::Point& normal)
{
  const geometry::Point n = unit(normal, "normal of a reflection");
  Affine map;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      map.matrix[i][j] -= 2.0 * n[i] * n[j];
  map.shift = geometry::scaled(2.0 * geometry::dot(center, n), n);
  return map;
}

Affine inverse(const Affine& map)
{
  const double d = determinant(map);
  if (d == 0.0)
    throw Error("the map has no inverse");
  Affine result;
  for (int i = 0; i < 3; ++i)
  {
    const geometry::Point column = geometry::cross(map.matrix[(i + 1) % 3], map.matrix[(i + 2) % 3]);
    for (int j = 0; j < 3; ++j)
      result.matrix[j][i] = column[j] / d;
  }
  result.shift = geometry::scaled(-1.0, result.turn(map.shift));
  return result;
}

Layout transformed(const Layout& layout, const Affine& map, std::string_view from, std::string_view to)
{
  Layout result = layout;
  for (block::Point& point : result.points)
  {
    point.x = map(point.x);
    point.name = renamed(point.name, from, to);
  }
  for (Block& block : result.blocks)
  {
    block.name = renamed(block.name, from, to);
    if (determinant(map) < 0.0)
      turn_over(block);
  }
  for (Edge& edge : result.edges)
    edge.curve = moved(edge.curve, layout.points[edge.a].x, layout.points[edge.b].x, map);
  for (Face& face : result.faces)
    face.geometry = moved(face.geometry, map);
  for (Boundary& boundary : result.boundaries)
    boundary.name = renamed(boundary.name, from, to);
  for (HoleEdge& hole : result.hole_edges)
    hole.lattice = hole.lattice == from ? std::string(to) : hole.lattice;
  return result;
}

void append(Layout& layout, const Layout& piece)
{
  const int first = static_cast<int>(layout.points.size());
  const auto shifted = [first](std::vector<int> points)
  {
    for (int& point : points)
      point += first;
    return points;
  };
  layout.points.insert(layout.points.end(), piece.points.begin(), piece.points.end());
  for (Block block : piece.blocks)
  {
    block.points = shifted(block.points);
    layout.blocks.push_back(std::move(block));
  }
  for (Edge edge : piece.edges)
  {
    edge.a += first;
    edge.b += first;
    layout.edges.push_back(std::move(edge));
  }
  for (Face face : piece.faces)
  {
    face.points = shifted(face.points);
    layout.faces.push_back(std::move(face));
  }
  for (HoleEdge hole : piece.hole_edges)
  {
    hole.a += first;
    hole.b += first;
    layout.hole_edges.push_back(std::move(hole));
  }
  for (Boundary boundary : piece.boundaries)
  {
    if (auto* edges = std::get_if<ByEdges>(&boundary.rule))
      for (auto& [a, b] : edges->edges)
      {
        a += first;
        b += first;
      }
    else if (auto* faces = std::get_if<ByFaces>(&boundary.rule))
      for (std::vector<int>& face : faces->faces)
        face = shifted(face);
    layout.boundaries.push_back(std::move(boundary));
  }
  layout.grade_towards.insert(layout.grade_towards.end(), piece.grade_towards.begin(),
                              piece.grade_towards.end());
}

}  // namespace blockfsi::block
