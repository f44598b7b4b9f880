#include "block/corner_blocks.hpp"

#include "block/face_plan.hpp"
#include "block/numbering.hpp"
#include "block/reference.hpp"
#include "block/topology.hpp"
#include "element/line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blockfsi::block
{

namespace
{

/// Place and weight of nodes of a line that interpolate at a parameter: those of the cell around it.
std::vector<std::pair<int, double>> interpolation(const std::vector<double>& parameter, int order, double t)
{
  int first = 0;
  while (first + order + 1 < static_cast<int>(parameter.size()) && parameter[first + order] < t)
    first += order;
  const std::vector<double> own(parameter.begin() + first, parameter.begin() + first + order + 1);
  const element::Table table = element::lagrange(own, std::array{t});
  std::vector<std::pair<int, double>> result;
  for (int k = 0; k <= order; ++k)
    result.emplace_back(first + k, table.value[k]);
  return result;
}

double segment_distance(const geometry::Point& x, const geometry::Point& a, const geometry::Point& b)
{
  const geometry::Point along = geometry::subtract(b, a);
  const double square = geometry::dot(along, along);
  const double t = square > 0.0 ? geometry::dot(geometry::subtract(x, a), along) / square : 0.0;
  return geometry::distance(x, geometry::add_scaled(a, std::clamp(t, 0.0, 1.0), along));
}

double triangle_distance(const geometry::Point& x, const std::array<geometry::Point, 3>& corner)
{
  const geometry::Point u = geometry::subtract(corner[1], corner[0]);
  const geometry::Point v = geometry::subtract(corner[2], corner[0]);
  const geometry::Point w = geometry::subtract(x, corner[0]);
  const geometry::Point normal = geometry::cross(u, v);
  const double square = geometry::dot(normal, normal);
  if (square > 0.0)
  {
    // Barycentric coordinates of the foot of the perpendicular.
    const double s = geometry::dot(geometry::cross(w, v), normal) / square;
    const double t = geometry::dot(geometry::cross(u, w), normal) / square;
    if (s >= 0.0 && t >= 0.0 && s + t <= 1.0)
      return std::abs(geometry::dot(w, normal)) / std::sqrt(square);
  }
  return std::min({segment_distance(x, corner[0], corner[1]), segment_distance(x, corner[1], corner[2]),
                   segment_distance(x, corner[2], corner[0])});
}

double triangle_area(const geometry::Point& a, const geometry::Point& b, const geometry::Point& c)
{
  return 0.5 * geometry::norm(geometry::cross(geometry::subtract(b, a), geometry::subtract(c, a)));
}

/// Length of the nodes of an edge joined by straight lines.
double length(const Skeleton& skeleton, const PlacedEdge& edge)
{
  const std::vector<std::int32_t> nodes = edge_numbers(edge);
  double sum = 0.0;
  for (std::size_t k = 1; k < nodes.size(); ++k)
    sum += geometry::distance(node_position(skeleton, nodes[k - 1]), node_position(skeleton, nodes[k]));
  return sum;
}

/// Area of the nodes of a face joined by triangles.
double area(const Skeleton& skeleton, const PlacedFace& face)
{
  const Grid grid = face_grid(face, skeleton.order);
  const std::vector<std::int32_t> nodes = face_numbers(skeleton, face);
  double sum = 0.0;
  for (int j = 0; j + 1 < row_count(grid, 0); ++j)
    for (int i = 0; i + 1 < row_length(grid, j, 0); ++i)
    {
      const auto at = [&](int a, int b) { return node_position(skeleton, nodes[index(grid, {a, b, 0})]); };
      sum += triangle_area(at(i, j), at(i + 1, j), at(i, j + 1));
      if (i + 1 < row_length(grid, j + 1, 0))
        sum += triangle_area(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return sum;
}

/// Area of a straight block in the plane; volume of one in space from its sides, of which bilinear ones are
/// the mean of both ways to cut them.
double content(const Layout& layout, const Block& block)
{
  const auto x = [&](int corner) { return layout.points[block.points[corner]].x; };
  double sum = 0.0;
  if (layout.dim == 2)
  {
    for (std::size_t k = 0; k < block.points.size(); ++k)
    {
      const geometry::Point a = x(static_cast<int>(k));
      const geometry::Point b = x(static_cast<int>((k + 1) % block.points.size()));
      sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    return std::abs(sum);
  }
  const auto cone = [&](int a, int b, int c)
  { return geometry::dot(x(a), geometry::cross(x(b), x(c))) / 6.0; };
  for (const element::SideShape& side : element::sides(block.shape))
  {
    const auto& p = side.corners;
    const double own = side.shape == element::Shape::triangle
                           ? cone(p[0], p[1], p[2])
                           : 0.5 * (cone(p[0], p[1], p[2]) + cone(p[0], p[2], p[3]) + cone(p[0], p[1], p[3]) +
                                    cone(p[1], p[2], p[3]));
    sum += side.outward ? own : -own;
  }
  return std::abs(sum);
}

/// Extent of the interface, and the thickness of what moves.
void measure(const Layout& layout, const Skeleton& skeleton, std::string_view region,
             std::span<const std::int64_t> interface, MovingSides& moving)
{
  double surface = 0.0;
  std::vector<bool> beyond(layout.blocks.size(), false);
  for (std::size_t side = 0; side < moving.side.size(); ++side)
    if (moving.side[side])
    {
      surface +=
          skeleton.dim == 2 ? length(skeleton, skeleton.edges[side]) : area(skeleton, skeleton.faces[side]);
      for (const int b : side_blocks(skeleton, static_cast<int>(side)))
        if (layout.blocks[b].region != region)
          beyond[b] = true;
    }
  if (surface == 0.0)
    return;
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < moving.edge.size(); ++e)
    if (moving.edge[e])
      shortest = std::min(shortest, length(skeleton, skeleton.edges[e]));
  geometry::Point low = node_position(skeleton, interface[0]);
  geometry::Point high = low;
  for (const std::int64_t node : interface)
    for (int i = 0; i < skeleton.dim; ++i)
    {
      low[i] = std::min(low[i], skeleton.x[node * skeleton.dim + i]);
      high[i] = std::max(high[i], skeleton.x[node * skeleton.dim + i]);
    }
  double body = 0.0;
  for (std::size_t b = 0; b < layout.blocks.size(); ++b)
    if (beyond[b])
      body += content(layout, layout.blocks[b]);
  moving.size = geometry::distance(low, high);
  moving.thickness = body > 0.0 ? 2.0 * body / surface : shortest;
}

}  // namespace

std::int32_t interface_index(std::span<const std::int64_t> interface, std::int64_t node)
{
  const auto at = std::lower_bound(interface.begin(), interface.end(), node);
  return at != interface.end() && *at == node ? static_cast<std::int32_t>(at - interface.begin()) : -1;
}

MovingSides moving_sides(const Layout& layout, const Skeleton& skeleton, std::string_view region,
                         std::span<const std::int64_t> interface)
{
  MovingSides moving;
  moving.side.assign(side_count(skeleton), false);
  moving.edge.assign(skeleton.edges.size(), false);
  for (int side = 0; side < side_count(skeleton); ++side)
  {
    const std::vector<int>& blocks = side_blocks(skeleton, side);
    const bool in_region =
        std::any_of(blocks.begin(), blocks.end(), [&](int b) { return layout.blocks[b].region == region; });
    // Corners on the interface do not make a side of it where it has no inner nodes.
    if (!in_region ||
        (blocks.size() == 2 && layout.blocks[blocks[0]].region == layout.blocks[blocks[1]].region))
      continue;
    const std::vector<std::int32_t> nodes = side_numbers(skeleton, side);
    moving.side[side] = std::all_of(nodes.begin(), nodes.end(),
                                    [&](std::int32_t node) { return interface_index(interface, node) >= 0; });
    if (moving.side[side])
      for (const int edge : side_edges(skeleton, side))
        moving.edge[edge] = true;
  }
  measure(layout, skeleton, region, interface, moving);
  return moving;
}

CoarseBlocks::CoarseBlocks(const Layout& layout, const Skeleton& skeleton, const MovingSides& moving,
                           std::span<const std::int64_t> interface, int degree)
    : layout_(layout), skeleton_(skeleton), moving_(moving), interface_(interface), degree_(degree),
      samples_(degree)
{
  for (const PlacedFace& face : skeleton.faces)
  {
    FaceLattice& lattice = faces_.emplace_back();
    lattice.nodes = face_numbers(skeleton, face);
    lattice.parameters = edge_parameters(skeleton, face);
  }
  add_facets();
}

CoarseBlock CoarseBlocks::make(int number)
{
  const Block& source = layout_.blocks[number];
  CoarseBlock block;
  block.shape = source.shape;
  block.corners = source.points;
  const CornerSamples& samples = samples_.of(block.shape);
  const double corner_weight = skeleton_.dim == 2 ? -1.0 : 1.0;
  for (int s = 0; s < samples.count; ++s)
  {
    geometry::Point x{};
    for (int c = 0; c < samples.corner_count; ++c)
      x = geometry::add_scaled(x, corner_weight * samples.basis[s * samples.corner_count + c],
                               position(source.points[c]));
    const auto bend = [&](const NodeWeight& term, double weight)
    {
      if (term.weight * weight != 0.0)
        block.bends.push_back({s, {interface_index(interface_, term.node), term.weight * weight}});
    };
    for (const Strand& strand : strands(number, samples, s))
    {
      for (const NodeWeight& term : nodes_at(strand))
      {
        x = geometry::add_scaled(x, strand.weight * term.weight, position(term.node));
        if (strand.bend_weight != 0.0)
          bend(term, strand.bend_weight);
      }
      // d - I d: what the entity does beyond its corners.
      if (strand.bend_weight != 0.0)
        for (const NodeWeight& term : corners_at(strand))
          bend(term, -strand.bend_weight);
    }
    block.x.insert(block.x.end(), x.begin(), x.begin() + skeleton_.dim);
    block.distance.push_back(distance(x));
  }
  return block;
}

/// The map of a block at a sample besides the interpolation of its corners: Gordon & Hall 1973 on products of
/// lines, the parallel form of Barnhill, Birkhoff & Gordon 1973 on triangles. The ramp of a side or an edge
/// is the sum of the functions of its corners, its own coordinates are where these have their mean.
std::vector<CoarseBlocks::Strand> CoarseBlocks::strands(int number, const CornerSamples& samples,
                                                        int sample) const
{
  const Block& block = layout_.blocks[number];
  std::vector<Strand> result;
  if (block.shape == element::Shape::triangle)
  {
    add_triangle_strands(number, samples.point[sample], result);
    return result;
  }
  const double* basis = samples.basis.data() + static_cast<std::size_t>(sample) * samples.corner_count;
  const auto sides = element::sides(block.shape);
  const auto edges = element::edges(block.shape);
  const auto add_edge = [&](int local, double weight, double bend_weight)
  {
    const auto [a, b] = edges[local];
    const double ramp = basis[a] + basis[b];
    if (ramp == 0.0)
      return;
    const int e = skeleton_.block_edges[number][local];
    const double at_b = basis[skeleton_.edges[e].b == block.points[b] ? b : a] / ramp;
    result.push_back({false, e, weight * ramp, moving_.edge[e] ? bend_weight * ramp : 0.0, {at_b, 0.0}});
  };
  if (skeleton_.dim == 2)
  {
    for (int local = 0; local < static_cast<int>(edges.size()); ++local)
      add_edge(local, 1.0, 1.0);
    return result;
  }
  for (std::size_t local = 0; local < sides.size(); ++local)
  {
    const int f = skeleton_.block_sides[number][local];
    const PlacedFace& face = skeleton_.faces[f];
    double ramp = 0.0;
    std::array<double, 2> place{};
    for (const int c : sides[local].corners)
    {
      ramp += basis[c];
      const auto* const at = std::find(face.points.begin(), face.points.end(), block.points[c]);
      const auto& corner = element::corners(face.shape)[at - face.points.begin()];
      for (int k = 0; k < 2; ++k)
        place[k] += basis[c] * corner[k];
    }
    if (ramp != 0.0)
      result.push_back({true, f, ramp, moving_.side[f] ? ramp : 0.0, {place[0] / ramp, place[1] / ramp}});
  }
  for (int local = 0; local < static_cast<int>(edges.size()); ++local)
  {
    // Faces at the edge that are not on the interface follow its shape, and the map takes it off once.
    int following = -1;
    for (std::size_t side = 0; side < sides.size(); ++side)
    {
      const auto& corners = sides[side].corners;
      const auto has = [&](int c) { return std::find(corners.begin(), corners.end(), c) != corners.end(); };
      if (has(edges[local][0]) && has(edges[local][1]) && !moving_.side[skeleton_.block_sides[number][side]])
        ++following;
    }
    add_edge(local, -1.0, following);
  }
  return result;
}

void CoarseBlocks::add_triangle_strands(int number, const std::array<double, 3>& r,
                                        std::vector<Strand>& result) const
{
  const std::array<double, 3> lambda = {1.0 - r[0] - r[1], r[0], r[1]};
  const auto edges = element::edges(element::Shape::triangle);
  for (std::size_t local = 0; local < edges.size(); ++local)
  {
    const auto [a, b] = edges[local];
    const int e = skeleton_.block_edges[number][local];
    const bool forward = skeleton_.edges[e].a == layout_.blocks[number].points[a];
    for (const auto& [weight, t] : {std::pair{lambda[a], lambda[b]}, {lambda[b], 1.0 - lambda[a]}})
      result.push_back({false, e, weight, moving_.edge[e] ? weight : 0.0, {forward ? t : 1.0 - t, 0.0}});
  }
}

/// The point of an edge or a face at its graded coordinates, from the nodes of the cell around it.
std::vector<CoarseBlocks::NodeWeight> CoarseBlocks::nodes_at(const Strand& strand) const
{
  std::vector<NodeWeight> result;
  const auto [u, v] = strand.place;
  if (!strand.is_face)
  {
    const PlacedEdge& edge = skeleton_.edges[strand.number];
    const std::vector<std::int32_t> nodes = edge_numbers(edge);
    for (const auto& [k, weight] :
         interpolation(directed_parameters(skeleton_, edge, edge.a), skeleton_.order, u))
      result.push_back({nodes[k], weight});
    return result;
  }
  // The line of nodes i meets the height v where the parameters on both edges along it say.
  const FaceLattice& face = faces_[strand.number];
  const auto blended = [&](int low, int high, double s)
  {
    std::vector<double> t = face.parameters[low];
    for (std::size_t k = 0; k < t.size(); ++k)
      t[k] += s * (face.parameters[high][k] - t[k]);
    return t;
  };
  const auto along_u = interpolation(blended(0, 2, v), skeleton_.order, u);
  const auto along_v = interpolation(blended(3, 1, u), skeleton_.order, v);
  const auto width = static_cast<int>(face.parameters[0].size());
  for (const auto& [j, second] : along_v)
    for (const auto& [i, first] : along_u)
      result.push_back({face.nodes[j * width + i], first * second});
  return result;
}

/// The linear interpolation of its corners there.
std::vector<CoarseBlocks::NodeWeight> CoarseBlocks::corners_at(const Strand& strand) const
{
  const auto [u, v] = strand.place;
  if (!strand.is_face)
  {
    const PlacedEdge& edge = skeleton_.edges[strand.number];
    return {{edge.a, 1.0 - u}, {edge.b, u}};
  }
  const auto& p = skeleton_.faces[strand.number].points;
  return {{p[0], (1.0 - u) * (1.0 - v)}, {p[1], u * (1.0 - v)}, {p[2], u * v}, {p[3], (1.0 - u) * v}};
}

geometry::Point CoarseBlocks::position(std::int64_t node) const
{
  return node_position(skeleton_, node);
}

void CoarseBlocks::add_facets()
{
  for (std::size_t side = 0; side < moving_.side.size(); ++side)
  {
    if (!moving_.side[side])
      continue;
    if (skeleton_.dim == 2)
    {
      const std::vector<std::int32_t> nodes = edge_numbers(skeleton_.edges[side]);
      for (std::size_t k = 1; k < nodes.size(); ++k)
        facets_.push_back({position(nodes[k - 1]), position(nodes[k]), position(nodes[k])});
      continue;
    }
    const auto at = [&](int i, int j)
    {
      geometry::Point x{};
      const double h = 1.0 / degree_;
      for (const NodeWeight& term : nodes_at({true, static_cast<int>(side), 0.0, 0.0, {i * h, j * h}}))
        x = geometry::add_scaled(x, term.weight, position(term.node));
      return x;
    };
    for (int j = 0; j < degree_; ++j)
      for (int i = 0; i < degree_; ++i)
      {
        facets_.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
        facets_.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
}

double CoarseBlocks::distance(const geometry::Point& x) const
{
  if (facets_.empty())
    return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& facet : facets_)
    least = std::min(least, skeleton_.dim == 2 ? segment_distance(x, facet[0], facet[1])
                                               : triangle_distance(x, facet));
  return least;
}

}  // namespace blockfsi::block
