#include "block/face_shape.hpp"
#include "block/message.hpp"
#include "block/topology.hpp"
#include "geometry/on_level_set.hpp"
#include "geometry/overloaded.hpp"
#include "geometry/primitive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace blockfsi::block
{

namespace
{

using geometry::Overloaded;
using geometry::Point;

/// Surfaces may miss the corners of their faces by so much of the size of the layout; what lies between the
/// corners is looked at when nodes are placed.
constexpr double corner_tolerance = 1e-6;

std::vector<int> sorted(std::vector<int> points)
{
  std::sort(points.begin(), points.end());
  return points;
}

/// The corners of all faces of blocks in their order round them, by the same corners sorted.
using Faces = std::map<std::vector<int>, std::vector<int>>;

Faces faces_of_blocks(const Layout& layout)
{
  Faces result;
  for (const Block& block : layout.blocks)
    for (const element::SideShape& side : element::sides(block.shape))
    {
      std::vector<int> points;
      for (int c = 0; c < element::corner_count(side.shape); ++c)
        points.push_back(block.points[side.corners[c]]);
      result.emplace(sorted(points), points);
    }
  return result;
}

/// The corners of a face must follow each other round it.
void check_round(const Layout& layout, const Face& face, const std::vector<int>& round)
{
  const std::size_t count = round.size();
  for (std::size_t k = 0; k < count; ++k)
  {
    const int a = face.points[k];
    const int b = face.points[(k + 1) % count];
    const std::size_t at = std::find(round.begin(), round.end(), a) - round.begin();
    if (b == round[(at + 1) % count] || b == round[(at + count - 1) % count])
      continue;
    std::string names;
    for (const int point : round)
      names += (names.empty() ? "" : " - ") + layout.points[point].name;
    throw mistake(face.where,
                  fmt::format("the corners of the {} do not run round it: no edge joins {} and {}; list them "
                              "as \"{}\"",
                              side_text(layout, face.points), point_text(layout, a), point_text(layout, b),
                              names));
  }
}

/// The corners of a patch must be those of the face.
void check_corners(const Layout& layout, const Face& face, const geometry::Surface& surface, double size)
{
  static constexpr std::array<const char*, 4> ordinals = {"first", "second", "third", "fourth"};
  const int count = geometry::corner_count(surface);
  for (int c = 0; c < count && count == static_cast<int>(face.points.size()); ++c)
  {
    const Point& x = layout.points[face.points[c]].x;
    const Point corner = geometry::corner(surface, c);
    const auto [u, v] = geometry::corner_parameters(surface, c);
    if (!(geometry::distance(x, corner) <= corner_tolerance * size))
      throw mistake(
          face.where,
          fmt::format("the surface of the {} is at ({:.9g}, {:.9g}, {:.9g}) for u = {}, v = {}, but "
                      "its {} corner is {}; list the corners so that u runs from the first to the "
                      "second and v from the first to the last, or correct the surface",
                      side_text(layout, face.points), corner[0], corner[1], corner[2], u, v, ordinals[c],
                      point_text(layout, face.points[c])));
  }
}

/// Mistakes that would be told of the edges of a face otherwise, of which the user said nothing. That no
/// block has the face is told later.
void check_faces(const Layout& layout, const Faces& faces)
{
  const double size = layout_size(layout);
  for (const Face& face : layout.faces)
    if (const auto found = faces.find(sorted(face.points)); found != faces.end())
    {
      check_round(layout, face, found->second);
      if (const auto* patch = std::get_if<Patch>(&face.geometry))
        check_corners(layout, face, patch->surface, size);
    }
}

/// The level set of a surface, where it has one.
std::optional<geometry::LevelSet> level_set_of(const geometry::Surface& surface)
{
  return std::visit(Overloaded{[](const geometry::Plane& p) -> std::optional<geometry::LevelSet>
                               { return geometry::plane(p.origin, geometry::cross(p.first, p.second)); },
                               [](const geometry::Sphere& s) -> std::optional<geometry::LevelSet>
                               { return geometry::sphere(s.center, s.radius); },
                               [](const geometry::Cylinder& c) -> std::optional<geometry::LevelSet>
                               { return geometry::cylinder(c.center, c.axis, c.radius); },
                               [](const geometry::Torus& t) -> std::optional<geometry::LevelSet>
                               { return geometry::torus(t.center, t.axis, t.major, t.minor); },
                               [](const auto&) -> std::optional<geometry::LevelSet> { return std::nullopt; }},
                    surface);
}

std::optional<geometry::LevelSet> level_set_of(const FaceGeometry& geometry)
{
  if (const auto* on = std::get_if<OnLevelSet>(&geometry))
    return on->level_set;
  if (const auto* on = std::get_if<OnSurface>(&geometry))
    return level_set_of(on->surface);
  return std::nullopt;
}

/// An edge of shaped faces.
struct Use
{
  const Face* face;
  int side;  ///< from corner `side` to the next one
};

/// The curve along a side of a patch, or on a surface that is no level set.
geometry::Curve along(const Use& use, const Point& a, const Point& b)
{
  if (const auto* patch = std::get_if<Patch>(&use.face->geometry))
  {
    const int count = geometry::corner_count(patch->surface);
    const auto from = geometry::corner_parameters(patch->surface, use.side);
    const auto to = geometry::corner_parameters(patch->surface, (use.side + 1) % count);
    return geometry::Function{[surface = patch->surface, from, to](double t) {
                                return geometry::evaluate(surface, (1.0 - t) * from[0] + t * to[0],
                                                          (1.0 - t) * from[1] + t * to[1]);
                              },
                              {},
                              geometry::Speed::own};
  }
  const auto& surface = std::get<OnSurface>(use.face->geometry).surface;
  return geometry::Function{[surface, a, b](double t)
                            { return geometry::closest(surface, geometry::combine(1.0 - t, a, t, b)).x; }};
}

geometry::Curve on_level_set(const geometry::LevelSet& first, const std::optional<geometry::LevelSet>& second,
                             const Point& a, const Point& b)
{
  geometry::OnLevelSet curve{first, second};
  geometry::check(curve, a, b);
  return geometry::measured(curve, a, b);
}

geometry::Curve curve_of(const std::vector<Use>& uses, const Point& a, const Point& b)
{
  for (const Use& use : uses)
    if (std::holds_alternative<Patch>(use.face->geometry))
      return along(use, a, b);
  const std::optional<geometry::LevelSet> first = level_set_of(uses[0].face->geometry);
  if (uses.size() == 1)
    return first ? on_level_set(*first, std::nullopt, a, b) : along(uses[0], a, b);
  const std::optional<geometry::LevelSet> second = level_set_of(uses[1].face->geometry);
  if (!first || !second)
    throw Error(
        "two surfaces meet in it, of which one is no level set, sphere, cylinder, torus or plane; give the "
        "edge a curve of its own");
  return on_level_set(*first, second, a, b);
}

/// Faces of one level set, such as the wall of a vessel, shape their common edges once.
bool same_shape(const FaceGeometry& a, const FaceGeometry& b)
{
  if (a.index() != b.index())
    return false;
  if (const auto* on = std::get_if<OnLevelSet>(&a))
    return on->level_set.same_as(std::get<OnLevelSet>(b).level_set);
  const auto first = level_set_of(a);
  const auto second = level_set_of(b);
  return first && second && first->text() == second->text();
}

}  // namespace

Layout with_curves_on_faces(const Layout& layout)
{
  if (layout.faces.empty())
    return layout;
  const Faces faces = faces_of_blocks(layout);
  check_faces(layout, faces);
  Layout result = layout;
  std::map<std::pair<int, int>, std::vector<Use>> uses;
  for (const Face& face : layout.faces)
  {
    if (std::holds_alternative<Interpolated>(face.geometry) || !faces.contains(sorted(face.points)))
      continue;
    const auto count = static_cast<int>(face.points.size());
    for (int side = 0; side < count; ++side)
    {
      auto& of = uses[std::minmax(face.points[side], face.points[(side + 1) % count])];
      if (std::none_of(of.begin(), of.end(),
                       [&](const Use& use) { return same_shape(use.face->geometry, face.geometry); }))
        of.push_back({&face, side});
    }
  }
  std::map<std::pair<int, int>, std::size_t> entries;
  for (std::size_t e = 0; e < result.edges.size(); ++e)
    entries.emplace(std::minmax(result.edges[e].a, result.edges[e].b), e);
  for (const auto& [ends, of] : uses)
  {
    const auto entry = entries.find(ends);
    if (entry != entries.end() &&
        !std::holds_alternative<geometry::Segment>(result.edges[entry->second].curve))
      continue;
    const Face& face = *of[0].face;
    // The curve runs as the entry does, else as the side of the face.
    Edge edge;
    if (entry != entries.end())
      edge = result.edges[entry->second];
    else
    {
      edge.a = face.points[of[0].side];
      edge.b = face.points[(of[0].side + 1) % face.points.size()];
      edge.where = face.where;
    }
    try
    {
      edge.curve = curve_of(of, layout.points[edge.a].x, layout.points[edge.b].x);
    }
    catch (const Error& error)
    {
      throw mistake(face.where, error
                                    .within("the edge " + edge_text(layout, edge.a, edge.b) + " of the " +
                                            side_text(layout, face.points))
                                    .message());
    }
    if (entry != entries.end())
      result.edges[entry->second] = std::move(edge);
    else
      result.edges.push_back(std::move(edge));
  }
  return result;
}

}  // namespace blockfsi::block
