#include "block/corner_layout.hpp"

#include "block/corner_samples.hpp"
#include "block/message.hpp"
#include "core/error.hpp"
#include "element/line.hpp"
#include "element/shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace blockfsi::block
{

namespace
{

using Vector = std::array<double, 2>;

/// A node of the skeleton with a weight.
struct NodeWeight
{
  std::int64_t node;
  double weight;
};

Vector position(const Skeleton& skeleton, std::int64_t node)
{
  return {skeleton.x[2 * node], skeleton.x[2 * node + 1]};
}

double distance(const Vector& a, const Vector& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// Distance from the line between two points.
double distance(const Vector& x, const Vector& a, const Vector& b)
{
  const Vector along = {b[0] - a[0], b[1] - a[1]};
  const double square = along[0] * along[0] + along[1] * along[1];
  const double t = square > 0.0 ? ((x[0] - a[0]) * along[0] + (x[1] - a[1]) * along[1]) / square : 0.0;
  const double inside = std::clamp(t, 0.0, 1.0);
  return distance(x, {a[0] + inside * along[0], a[1] + inside * along[1]});
}

/// All nodes along an edge from end to end.
std::vector<std::int64_t> edge_nodes(const PlacedEdge& edge)
{
  std::vector<std::int64_t> nodes = {edge.a};
  for (std::int64_t k = 0; k < edge.count; ++k)
    nodes.push_back(edge.first + k);
  nodes.push_back(edge.b);
  return nodes;
}

/// A side of a block as it enters the transfinite map: the point at parameter t of the side, weighted.
struct Strand
{
  int side;
  double weight;
  double t;
};

/// What the map of a block is at a place besides the interpolation of its corners, which comes off once:
/// Gordon & Hall 1973 for quadrilaterals, the parallel form of Barnhill, Birkhoff & Gordon 1973 for
/// triangles.
std::vector<Strand> strands(element::Shape shape, const std::array<double, 3>& r)
{
  std::vector<Strand> result;
  const auto sides = element::sides(shape);
  const auto corners = element::corners(shape);
  for (int side = 0; side < static_cast<int>(sides.size()); ++side)
  {
    const int a = sides[side].corners[0];
    const int b = sides[side].corners[1];
    if (shape == element::Shape::triangle)
    {
      const std::array<double, 3> lambda = {1.0 - r[0] - r[1], r[0], r[1]};
      result.push_back({side, lambda[a], lambda[b]});
      result.push_back({side, lambda[b], 1.0 - lambda[a]});
      continue;
    }
    const int along = corners[a][0] != corners[b][0] ? 0 : 1;
    const int across = 1 - along;
    result.push_back({side, corners[a][across] == 0.0 ? 1.0 - r[across] : r[across],
                      corners[b][along] == 1.0 ? r[along] : 1.0 - r[along]});
  }
  return result;
}

/// Makes the coarse blocks of a region from the skeleton.
class Builder
{
public:
  Builder(const Layout& layout, const Skeleton& skeleton, std::string_view region,
          std::span<const std::int64_t> interface)
      : layout_(layout), skeleton_(skeleton), region_(region), interface_(interface)
  {
    check_shapes();
    graph_.interface_count = interface.size();
    for (const PlacedEdge& edge : skeleton.edges)
      if (on_interface(edge))
        interface_edges_.push_back(&edge);
    measure();
  }

  CornerGraph build(const CornerParameters& parameters)
  {
    add_corners(parameters);
    for (std::size_t b = 0; b < layout_.blocks.size(); ++b)
      if (layout_.blocks[b].region == region_)
        graph_.blocks.push_back(coarse_block(static_cast<int>(b)));
    return std::move(graph_);
  }

private:
  void check_shapes() const
  {
    for (const Block& block : layout_.blocks)
      if (block.region == region_ && element::dimension(block.shape) != 2)
        throw mistake(block.where, fmt::format("the corners of a {} cannot follow an interface yet; blocks "
                                               "around a moving body must be two-dimensional",
                                               element::name(block.shape)));
  }

  bool in_region(const PlacedEdge& edge) const
  {
    return std::any_of(edge.blocks.begin(), edge.blocks.end(),
                       [this](int b) { return layout_.blocks[b].region == region_; });
  }

  std::int32_t interface_index(std::int64_t node) const
  {
    const auto at = std::lower_bound(interface_.begin(), interface_.end(), node);
    return at != interface_.end() && *at == node ? static_cast<std::int32_t>(at - interface_.begin()) : -1;
  }

  bool on_interface(const PlacedEdge& edge) const
  {
    const std::vector<std::int64_t> nodes = edge_nodes(edge);
    return in_region(edge) &&
           std::all_of(nodes.begin(), nodes.end(),
                       [this](std::int64_t node) { return interface_index(node) >= 0; }) &&
           // Two ends on the interface do not make an edge of it where it has no inner nodes.
           (edge.blocks.size() == 1 ||
            layout_.blocks[edge.blocks[0]].region != layout_.blocks[edge.blocks[1]].region);
  }

  /// Extent of the interface, and the thickness of what moves: twice its area by the length of the interface,
  /// or the shortest edge of the interface where only a hole is seen.
  void measure()
  {
    double length = 0.0;
    double shortest = std::numeric_limits<double>::infinity();
    Vector low = {HUGE_VAL, HUGE_VAL};
    Vector high = {-HUGE_VAL, -HUGE_VAL};
    std::vector<bool> beyond(layout_.blocks.size(), false);
    for (const PlacedEdge* edge : interface_edges_)
    {
      double own = 0.0;
      const std::vector<std::int64_t> nodes = edge_nodes(*edge);
      for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        const Vector x = position(skeleton_, nodes[k]);
        if (k > 0)
          own += distance(position(skeleton_, nodes[k - 1]), x);
        for (int i = 0; i < 2; ++i)
        {
          low[i] = std::min(low[i], x[i]);
          high[i] = std::max(high[i], x[i]);
        }
      }
      length += own;
      shortest = std::min(shortest, own);
      for (const int b : edge->blocks)
        if (layout_.blocks[b].region != region_)
          beyond[b] = true;
    }
    if (interface_edges_.empty())
      return;
    double area = 0.0;
    for (std::size_t b = 0; b < layout_.blocks.size(); ++b)
      if (beyond[b])
        area += block_area(layout_.blocks[b]);
    graph_.size = distance(low, high);
    graph_.thickness = area > 0.0 ? 2.0 * area / length : shortest;
  }

  double block_area(const Block& block) const
  {
    double twice = 0.0;
    for (std::size_t k = 0; k < block.points.size(); ++k)
    {
      const Vector a = position(skeleton_, block.points[k]);
      const Vector b = position(skeleton_, block.points[(k + 1) % block.points.size()]);
      twice += a[0] * b[1] - a[1] * b[0];
    }
    return 0.5 * std::abs(twice);
  }

  void add_corners(const CornerParameters& parameters)
  {
    const std::vector<std::vector<Share>> led = led_points(skeleton_, interface_, parameters.follows);
    graph_.corners.resize(skeleton_.point_count);
    for (std::int64_t p = 0; p < skeleton_.point_count; ++p)
    {
      const Vector x = position(skeleton_, p);
      graph_.corners[p].x = {x[0], x[1], 0.0};
      graph_.corners[p].led = led[p];
    }
    for (const Block& block : layout_.blocks)
      for (const int p : block.points)
        if (block.region == region_ && !graph_.corners[p].used)
        {
          graph_.corners[p].used = true;
          if (interface_index(p) < 0)
            release(p, parameters);
        }
    if (parameters.rule != CornerRule::fixed)
      check_leaders(parameters.follows);
  }

  /// Gives a corner its free directions, unless a rule leads it.
  void release(int p, const CornerParameters& parameters)
  {
    for (const Follow& follow : parameters.follows)
      if (follow.point == p)
        return;
    Corner& corner = graph_.corners[p];
    std::vector<const PlacedEdge*> boundary;
    for (const PlacedEdge& edge : skeleton_.edges)
      if (edge.boundary >= 0 && (edge.a == p || edge.b == p))
        boundary.push_back(&edge);
    if (boundary.empty())
    {
      corner.freedom = 2;
      corner.direction = {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    }
    else if (boundary.size() == 2 && slides(*boundary[0], parameters) && slides(*boundary[1], parameters))
    {
      const Vector a = position(skeleton_, boundary[0]->a == p ? boundary[0]->b : boundary[0]->a);
      const Vector b = position(skeleton_, boundary[1]->a == p ? boundary[1]->b : boundary[1]->a);
      if (straight(*boundary[0], a, b) && straight(*boundary[1], a, b))
      {
        const double length = distance(a, b);
        corner.freedom = 1;
        corner.direction[0] = {(b[0] - a[0]) / length, (b[1] - a[1]) / length, 0.0};
      }
    }
  }

  bool slides(const PlacedEdge& edge, const CornerParameters& parameters) const
  {
    const std::string& name = layout_.boundaries[edge.boundary].name;
    return parameters.slide &&
           std::find(parameters.slide->begin(), parameters.slide->end(), name) != parameters.slide->end();
  }

  /// Whether an edge lies on the line between two points.
  bool straight(const PlacedEdge& edge, const Vector& a, const Vector& b) const
  {
    constexpr double tolerance = 1e-9;
    const std::vector<std::int64_t> nodes = edge_nodes(edge);
    return std::all_of(nodes.begin(), nodes.end(),
                       [&](std::int64_t node)
                       { return distance(position(skeleton_, node), a, b) <= tolerance * distance(a, b); });
  }

  void check_leaders(const std::vector<Follow>& follows) const
  {
    for (const Follow& follow : follows)
      for (const Follow::Leader& leader : follow.leaders)
        if (graph_.corners[leader.point].freedom > 0)
          throw Error(fmt::format(
              "the point '{}' follows '{}', which finds its own place; let it follow points of the interface",
              skeleton_.point_names[follow.point], skeleton_.point_names[leader.point]));
  }

  CoarseBlock coarse_block(int b)
  {
    const Block& source = layout_.blocks[b];
    CoarseBlock block;
    block.shape = source.shape;
    block.corners = source.points;
    CornerSamples& samples = samples_[static_cast<std::size_t>(block.shape)];
    if (samples.count == 0)
      samples = corner_samples(block.shape, graph_.degree);
    for (int s = 0; s < samples.count; ++s)
    {
      Vector x{};
      for (int c = 0; c < samples.corner_count; ++c)
        add(x, -samples.basis[s * samples.corner_count + c], source.points[c]);
      for (const Strand& strand : strands(source.shape, samples.point[s]))
      {
        const PlacedEdge& edge = skeleton_.edges[skeleton_.block_sides[b][strand.side]];
        const int from = source.points[element::sides(source.shape)[strand.side].corners[0]];
        const double t = edge.a == from ? strand.t : 1.0 - strand.t;
        const std::vector<NodeWeight> nodes = at(edge, t);
        for (const NodeWeight& term : nodes)
          add(x, strand.weight * term.weight, term.node);
        if (strand.weight != 0.0 && is_interface(edge))
          add_bend(block, s, strand.weight, nodes, edge, t);
      }
      block.x.insert(block.x.end(), x.begin(), x.end());
      block.distance.push_back(interface_distance(x));
    }
    return block;
  }

  void add(Vector& x, double weight, std::int64_t node) const
  {
    const Vector other = position(skeleton_, node);
    for (int i = 0; i < 2; ++i)
      x[i] += weight * other[i];
  }

  bool is_interface(const PlacedEdge& edge) const
  {
    return std::find(interface_edges_.begin(), interface_edges_.end(), &edge) != interface_edges_.end();
  }

  /// ramp (d - I d) on a side: what its inner nodes do beyond its ends.
  void add_bend(CoarseBlock& block, int sample, double ramp, const std::vector<NodeWeight>& nodes,
                const PlacedEdge& edge, double t) const
  {
    const auto share = [&](std::int64_t node, double weight)
    {
      if (weight != 0.0)
        block.bends.push_back({sample, {interface_index(node), ramp * weight}});
    };
    for (const NodeWeight& term : nodes)
      share(term.node, term.weight);
    share(edge.a, t - 1.0);
    share(edge.b, -t);
  }

  /// The point of an edge at graded parameter t, from the nodes of the cell around it.
  std::vector<NodeWeight> at(const PlacedEdge& edge, double t) const
  {
    const std::vector<std::int64_t> nodes = edge_nodes(edge);
    const auto order = static_cast<std::size_t>(skeleton_.order);
    const auto parameter = [&](std::size_t k)
    { return k == 0 ? 0.0 : (k + 1 == nodes.size() ? 1.0 : skeleton_.parameter[nodes[k]]); };
    std::size_t first = 0;
    while (first + order + 1 < nodes.size() && parameter(first + order) < t)
      first += order;
    std::vector<double> own(order + 1);
    for (std::size_t k = 0; k <= order; ++k)
      own[k] = parameter(first + k);
    const element::Table table = element::lagrange(own, std::array{t});
    std::vector<NodeWeight> result;
    for (std::size_t k = 0; k <= order; ++k)
      result.push_back({nodes[first + k], table.value[k]});
    return result;
  }

  double interface_distance(const Vector& x) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const PlacedEdge* edge : interface_edges_)
    {
      const std::vector<std::int64_t> nodes = edge_nodes(*edge);
      for (std::size_t k = 1; k < nodes.size(); ++k)
        least =
            std::min(least, distance(x, position(skeleton_, nodes[k - 1]), position(skeleton_, nodes[k])));
    }
    return std::isfinite(least) ? least : 0.0;
  }

  const Layout& layout_;
  const Skeleton& skeleton_;
  std::string_view region_;
  std::span<const std::int64_t> interface_;
  std::vector<const PlacedEdge*> interface_edges_;
  std::array<CornerSamples, element::shape_count> samples_;  ///< by shape, made when needed
  CornerGraph graph_;
};

}  // namespace

CornerGraph corner_graph(const Layout& layout, const Skeleton& skeleton, std::string_view region,
                         std::span<const std::int64_t> interface, const CornerParameters& parameters)
{
  return Builder(layout, skeleton, region, interface).build(parameters);
}

CornerMotion corner_motion(const Layout& layout, const Skeleton& skeleton, std::string_view region,
                           std::span<const std::int64_t> interface, const CornerParameters& parameters)
{
  if (interface.empty())
  {
    CornerGraph still;  // nothing moves: no need to know the blocks
    still.dim = skeleton.dim;
    still.corners.resize(skeleton.point_count);
    return {std::move(still), CornerRule::fixed};
  }
  CornerGraph graph = corner_graph(layout, skeleton, region, interface, parameters);
  if (parameters.rule == CornerRule::nonlinear)
  {
    const NonlinearParameters nonlinear = nonlinear_defaults(graph.dim);
    return {std::move(graph), nonlinear};
  }
  return {std::move(graph), parameters.rule};
}

}  // namespace blockfsi::block
