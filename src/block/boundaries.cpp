#include "block/boundaries.hpp"

#include "block/message.hpp"
#include "block/numbering.hpp"
#include "block/topology.hpp"
#include "core/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace blockfsi::block
{

namespace
{

/// "edge" or "face".
const char* side_word(const Skeleton& skeleton)
{
  return skeleton.dim == 2 ? "edge" : "face";
}

/// Whether all nodes of a side fulfil a condition.
bool lies_on(const Skeleton& skeleton, int side, const Condition& condition, double tolerance)
{
  const std::vector<std::int32_t> nodes = side_numbers(skeleton, side);
  return std::all_of(nodes.begin(), nodes.end(),
                     [&](std::int32_t node)
                     {
                       const double* x = skeleton.x.data() + static_cast<std::ptrdiff_t>(node) * skeleton.dim;
                       return condition.holds(x[0], x[1], skeleton.dim == 2 ? 0.0 : x[2], tolerance);
                     });
}

std::vector<int> sides_by(const ByCondition& rule, const Layout& layout, const Skeleton& skeleton)
{
  const double tolerance = 1e-8 * layout_size(layout);
  std::vector<int> sides;
  for (int side = 0; side < side_count(skeleton); ++side)
    if (side_blocks(skeleton, side).size() == 1 && lies_on(skeleton, side, rule.condition, tolerance))
      sides.push_back(side);
  if (sides.empty())
    throw Error(
        fmt::format("no outer {0} lies on \"{1}\": at least one {0} must fulfil it with all its nodes",
                    side_word(skeleton), rule.condition.text()));
  return sides;
}

int existing_edge(const Layout& layout, const Skeleton& skeleton, int a, int b)
{
  if (skeleton.dim != 2)
    throw Error("its sides are faces in a layout in 3 dimensions, not edges; list faces");
  const int edge = find_edge(skeleton.edges, a, b);
  if (edge < 0)
    throw Error(fmt::format("no block has an edge {}", edge_text(layout, a, b)));
  return edge;
}

std::vector<int> sides_by(const ByHole& rule, const Layout& layout, const Skeleton& skeleton)
{
  std::vector<int> edges;
  std::set<std::string> lattices;
  int hole_count = 0;
  for (const HoleEdge& hole : layout.hole_edges)
  {
    lattices.insert(hole.lattice);
    if (hole.lattice != rule.lattice)
      continue;
    hole_count = std::max(hole_count, hole.number);
    if (hole.number == rule.number)
      edges.push_back(existing_edge(layout, skeleton, hole.a, hole.b));
  }
  if (!edges.empty())
    return edges;
  if (hole_count > 0)
    throw Error(fmt::format("the lattice '{}' has no hole {}; its holes are numbered from 1 to {}",
                            rule.lattice, rule.number, hole_count));
  throw Error(
      fmt::format("no lattice '{}' with holes exists{}", rule.lattice, did_you_mean(rule.lattice, lattices)));
}

std::vector<int> sides_by(const ByEdges& rule, const Layout& layout, const Skeleton& skeleton)
{
  std::vector<int> edges;
  for (const auto& [a, b] : rule.edges)
    edges.push_back(existing_edge(layout, skeleton, a, b));
  if (edges.empty())
    throw Error("it lists no edges; list at least one or remove the boundary");
  return edges;
}

std::vector<int> sides_by(const ByFaces& rule, const Layout& layout, const Skeleton& skeleton)
{
  std::vector<int> faces;
  for (const std::vector<int>& points : rule.faces)
  {
    const int face = find_face(skeleton.faces, points);
    if (face < 0)
      throw Error(fmt::format("no block has a {}", side_text(layout, points)));
    faces.push_back(face);
  }
  if (faces.empty())
    throw Error("it lists no faces; list at least one or remove the boundary");
  return faces;
}

/// Whether a side lies within a region.
bool is_inner(const Layout& layout, const std::vector<int>& blocks)
{
  return blocks.size() == 2 && layout.blocks[blocks[0]].region == layout.blocks[blocks[1]].region;
}

int& boundary_of(Skeleton& skeleton, int side)
{
  return skeleton.dim == 2 ? skeleton.edges[side].boundary : skeleton.faces[side].boundary;
}

void claim(const Layout& layout, Skeleton& skeleton, int side, int boundary)
{
  const std::vector<int>& blocks = side_blocks(skeleton, side);
  if (is_inner(layout, blocks))
    throw Error(
        fmt::format("the {} lies inside the region '{}', between the blocks '{}' and '{}'; a boundary can "
                    "only lie where a region ends",
                    side_text(layout, side_points(skeleton, side)), layout.blocks[blocks[0]].region,
                    layout.blocks[blocks[0]].name, layout.blocks[blocks[1]].name));
  int& of = boundary_of(skeleton, side);
  if (of >= 0 && of != boundary)
    throw Error(fmt::format(
        "the {} belongs to the boundary '{}'{} as well; {} {} can belong to one boundary only",
        side_text(layout, side_points(skeleton, side)), layout.boundaries[of].name,
        place_text(layout.boundaries[of].where), skeleton.dim == 2 ? "an" : "a", side_word(skeleton)));
  of = boundary;
}

void assign(const Layout& layout, Skeleton& skeleton, int boundary)
{
  const Boundary& given = layout.boundaries[boundary];
  const auto sides =
      std::visit([&](const auto& rule) { return sides_by(rule, layout, skeleton); }, given.rule);
  for (const int side : sides)
    if (!given.gives_way || (side_blocks(skeleton, side).size() == 1 && side_boundary(skeleton, side) < 0))
      claim(layout, skeleton, side, boundary);
}

void check_name(const Layout& layout, int boundary)
{
  const std::string& name = layout.boundaries[boundary].name;
  if (name == interface_name)
    throw Error("this name is reserved for the sides between two regions; choose another");
  for (int other = 0; other < boundary; ++other)
    if (layout.boundaries[other].name == name)
      throw Error(fmt::format("a boundary of this name exists already{}; choose another",
                              place_text(layout.boundaries[other].where)));
}

/// Nothing may be left over: a forgotten boundary would silently become a free surface.
void check_complete(const Layout& layout, const Skeleton& skeleton)
{
  std::vector<int> forgotten;
  for (int side = 0; side < side_count(skeleton); ++side)
    if (side_blocks(skeleton, side).size() == 1 && side_boundary(skeleton, side) < 0)
      forgotten.push_back(side);
  if (forgotten.empty())
    return;
  const Block& block = layout.blocks[side_blocks(skeleton, forgotten[0])[0]];
  throw mistake(
      block.where,
      fmt::format("the outer {} of the block '{}' belongs to no boundary{}; add it to one, or join the "
                  "blocks if there should be another beside it",
                  side_text(layout, side_points(skeleton, forgotten[0])), block.name,
                  forgotten.size() > 1 ? fmt::format(" (as do {} others)", forgotten.size() - 1) : ""));
}

/// In 3D edges know a boundary that they touch.
void mark_edges(Skeleton& skeleton)
{
  if (skeleton.dim == 2)
    return;
  for (const PlacedFace& face : skeleton.faces)
    for (int e = 0; face.boundary >= 0 && e < element::corner_count(face.shape); ++e)
    {
      int& of = skeleton.edges[face.edges[e]].boundary;
      of = of < 0 ? face.boundary : std::min(of, face.boundary);
    }
}

}  // namespace

void assign_boundaries(const Layout& layout, Skeleton& skeleton)
{
  for (const bool giving_way : {false, true})
    for (std::size_t boundary = 0; boundary < layout.boundaries.size(); ++boundary)
    {
      const Boundary& given = layout.boundaries[boundary];
      if (given.gives_way != giving_way)
        continue;
      try
      {
        check_name(layout, static_cast<int>(boundary));
        assign(layout, skeleton, static_cast<int>(boundary));
      }
      catch (const Error& error)
      {
        throw mistake(given.where, error.within(fmt::format("the boundary '{}'", given.name)).message());
      }
    }
  check_complete(layout, skeleton);
  mark_edges(skeleton);
}

}  // namespace blockfsi::block
