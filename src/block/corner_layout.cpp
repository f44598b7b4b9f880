#include "block/corner_layout.hpp"

#include "block/corner_blocks.hpp"
#include "block/message.hpp"
#include "block/numbering.hpp"
#include "block/topology.hpp"
#include "core/error.hpp"
#include "element/shape.hpp"
#include "geometry/point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace blockfsi::block
{

namespace
{

using geometry::Point;

/// Deviations from a straight line or a plane, relative to its extent, that count as rounding.
constexpr double flatness = 1e-9;

/// Makes the coarse blocks of a region from the skeleton.
class Builder
{
public:
  Builder(const Layout& layout, const Skeleton& skeleton, std::string_view region,
          std::span<const std::int64_t> interface)
      : layout_(layout), skeleton_(skeleton), region_(region), interface_(interface)
  {
    check_shapes();
  }

  CornerGraph build(const CornerParameters& parameters)
  {
    const MovingSides moving = moving_sides(layout_, skeleton_, region_, interface_);
    graph_.dim = skeleton_.dim;
    graph_.interface_count = interface_.size();
    graph_.size = moving.size;
    graph_.thickness = moving.thickness;
    add_corners(parameters);
    CoarseBlocks blocks(layout_, skeleton_, moving, interface_, graph_.degree);
    for (std::size_t b = 0; b < layout_.blocks.size(); ++b)
      if (layout_.blocks[b].region == region_)
        graph_.blocks.push_back(blocks.make(static_cast<int>(b)));
    return std::move(graph_);
  }

private:
  void check_shapes() const
  {
    for (const Block& block : layout_.blocks)
      if (block.region == region_ && block.shape != element::Shape::quadrilateral &&
          block.shape != element::Shape::triangle && block.shape != element::Shape::hexahedron)
        throw mistake(block.where, fmt::format("the corners of a {} cannot follow an interface yet; blocks "
                                               "around a moving body must be triangles, quadrilaterals or "
                                               "hexahedra",
                                               element::name(block.shape)));
  }

  Point position(std::int64_t node) const { return node_position(skeleton_, node); }

  void add_corners(const CornerParameters& parameters)
  {
    const std::vector<std::vector<Share>> led = led_points(skeleton_, interface_, parameters.follows);
    graph_.corners.resize(skeleton_.point_count);
    for (std::int64_t p = 0; p < skeleton_.point_count; ++p)
    {
      graph_.corners[p].x = position(p);
      graph_.corners[p].led = led[p];
    }
    sides_at_.assign(skeleton_.point_count, {});
    for (int side = 0; side < side_count(skeleton_); ++side)
      if (side_boundary(skeleton_, side) >= 0)
        for (const int p : side_points(skeleton_, side))
          sides_at_[p].push_back(side);
    for (const Block& block : layout_.blocks)
      for (const int p : block.points)
        if (block.region == region_ && !graph_.corners[p].used)
        {
          graph_.corners[p].used = true;
          if (interface_index(interface_, p) < 0)
            release(p, parameters);
        }
    if (parameters.rule != CornerRule::fixed)
      check_leaders(parameters.follows);
  }

  /// Gives a corner its free directions, unless a rule leads it: those along all boundaries at it, if it
  /// slides along all.
  void release(int p, const CornerParameters& parameters)
  {
    for (const Follow& follow : parameters.follows)
      if (follow.point == p)
        return;
    std::vector<Point> held;
    for (const int side : sides_at_[p])
    {
      const std::optional<Point> normal = slides(side, parameters) ? flat_normal(side) : std::nullopt;
      if (!normal)
        return;
      Point rest = *normal;
      for (const Point& other : held)
        rest = geometry::add_scaled(rest, -geometry::dot(rest, other), other);
      if (const double size = geometry::norm(rest); size > flatness)
        held.push_back(geometry::scaled(1.0 / size, rest));
    }
    const std::vector<Point> free = complement(held, skeleton_.dim);
    graph_.corners[p].freedom = static_cast<int>(free.size());
    std::copy(free.begin(), free.end(), graph_.corners[p].direction.begin());
  }

  bool slides(int side, const CornerParameters& parameters) const
  {
    const std::string& name = layout_.boundaries[side_boundary(skeleton_, side)].name;
    return parameters.slide &&
           std::find(parameters.slide->begin(), parameters.slide->end(), name) != parameters.slide->end();
  }

  /// Unit normal of a side that is straight or plane.
  std::optional<Point> flat_normal(int side) const
  {
    const std::vector<int> corners = side_points(skeleton_, side);
    const Point origin = position(corners[0]);
    const Point along = geometry::subtract(position(corners[1]), origin);
    const Point across = skeleton_.dim == 2 ? Point{0.0, 0.0, geometry::norm(along)}
                                            : geometry::subtract(position(corners.back()), origin);
    const Point normal = geometry::cross(along, across);
    const double size = geometry::norm(normal);
    const double tolerance = flatness * std::sqrt(size);
    for (const std::int32_t node : side_numbers(skeleton_, side))
      if (std::abs(geometry::dot(geometry::subtract(position(node), origin), normal)) > tolerance * size)
        return std::nullopt;
    return geometry::scaled(1.0 / size, normal);
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

  const Layout& layout_;
  const Skeleton& skeleton_;
  std::string_view region_;
  std::span<const std::int64_t> interface_;
  std::vector<std::vector<int>> sides_at_;  ///< boundary sides at each point
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
