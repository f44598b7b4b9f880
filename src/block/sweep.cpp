#include "block/sweep.hpp"

#include "block/message.hpp"
#include "block/transform.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <variant>

namespace blockfsi::block
{

namespace
{

using element::Shape;

/// How a piece moves through space, from section to section.
struct Path
{
  std::string name;
  std::string of;
  Location where;
  std::vector<Affine> sections;
  bool closed = false;  ///< the last section is the first
  int divisions = 1;    ///< cells between two sections
  std::optional<Grading> grading;
  /// Whether a point stays where it is.
  std::function<bool(const geometry::Point&)> is_fixed;
  /// The way of a point from one section to the next.
  std::function<geometry::Curve(const geometry::Point&)> way;
  /// What an edge sweeps from section k to the next, where that is not the interpolation of its sides.
  std::function<FaceGeometry(const geometry::Curve&, const geometry::Point& a, const geometry::Point& b,
                             std::size_t k)>
      swept;
};

class Sweep
{
public:
  Sweep(const Layout& base, const Path& path) : base_(base), path_(path)
  {
    result_.dim = 3;
    result_.order = base.order;
    result_.default_divisions = base.default_divisions;
    result_.grade_towards = base.grade_towards;
  }

  Layout make()
  {
    for (std::size_t k = 0; k < path_.sections.size(); ++k)
      add_points(k);
    find_edges();
    for (std::size_t k = 0; k < path_.sections.size(); ++k)
      add_section_edges(k);
    for (std::size_t k = 0; k < stage_count(); ++k)
      add_stage(k);
    add_boundaries();
    return std::move(result_);
  }

private:
  std::size_t stage_count() const { return path_.closed ? path_.sections.size() : path_.sections.size() - 1; }
  std::size_t after(std::size_t k) const { return (k + 1) % path_.sections.size(); }
  int at(std::size_t section, int point) const { return index_[section][point]; }
  bool fixed(int point) const { return path_.is_fixed(base_.points[point].x); }

  [[noreturn]] void fail(const Location& where, const std::string& message) const
  {
    throw mistake(where, fmt::format("'{}': {}", path_.name, message));
  }

  std::string renamed(const std::string& name) const
  {
    return name.starts_with(path_.of + " ") ? path_.name + name.substr(path_.of.size())
                                            : path_.name + " " + name;
  }

  void add_points(std::size_t k)
  {
    index_.emplace_back();
    for (std::size_t p = 0; p < base_.points.size(); ++p)
    {
      const Point& point = base_.points[p];
      if (k > 0 && fixed(static_cast<int>(p)))
      {
        index_[k].push_back(at(0, static_cast<int>(p)));
        continue;
      }
      index_[k].push_back(static_cast<int>(result_.points.size()));
      result_.points.push_back(
          {fmt::format("{} {}", renamed(point.name), k), path_.sections[k](point.x), point.where});
    }
  }

  void find_edges()
  {
    for (const Block& block : base_.blocks)
    {
      if (element::dimension(block.shape) != 2)
        fail(block.where, fmt::format("the block '{}' is a {}; only blocks of the plane can be swept",
                                      block.name, element::name(block.shape)));
      for (const auto& [a, b] : element::edges(block.shape))
        edges_.insert(std::minmax(block.points[a], block.points[b]));
    }
  }

  const Edge* said(int a, int b) const
  {
    const auto found =
        std::find_if(base_.edges.begin(), base_.edges.end(),
                     [&](const Edge& edge) { return std::minmax(edge.a, edge.b) == std::minmax(a, b); });
    return found == base_.edges.end() ? nullptr : &*found;
  }

  /// What the piece says of its edges holds in each section.
  void add_section_edges(std::size_t k)
  {
    for (const Edge& edge : base_.edges)
    {
      if (k > 0 && fixed(edge.a) && fixed(edge.b))
        continue;
      Edge copy = edge;
      copy.a = at(k, edge.a);
      copy.b = at(k, edge.b);
      copy.curve = moved(edge.curve, base_.points[edge.a].x, base_.points[edge.b].x, path_.sections[k]);
      result_.edges.push_back(std::move(copy));
    }
  }

  void add_stage(std::size_t k)
  {
    std::set<int> used;
    for (const Block& block : base_.blocks)
    {
      used.insert(block.points.begin(), block.points.end());
      add_block(block, k);
    }
    for (const int point : used)
      if (!fixed(point))
      {
        Edge edge;
        edge.a = at(k, point);
        edge.b = at(after(k), point);
        edge.curve = path_.way(result_.points[edge.a].x);
        edge.divisions = path_.divisions;
        edge.grading = path_.grading;
        edge.where = path_.where;
        result_.edges.push_back(std::move(edge));
      }
    for (const auto& [a, b] : edges_)
      add_face(a, b, k);
  }

  void add_face(int a, int b, std::size_t k)
  {
    const Edge* edge = said(a, b);
    if (fixed(a) && fixed(b))
      return;
    const geometry::Curve curve = edge ? edge->curve : geometry::Curve{};
    const int from = edge ? edge->a : a;
    const int to = edge ? edge->b : b;
    FaceGeometry geometry = path_.swept(curve, base_.points[from].x, base_.points[to].x, k);
    if (std::holds_alternative<Interpolated>(geometry))
      return;
    if (fixed(a) || fixed(b))
      fail(edge ? edge->where : path_.where,
           fmt::format(
               "the edge from '{}' to '{}' ends on the axis but is not a straight line across it; what it "
               "sweeps there cannot be a face of a block: cut the corner off",
               base_.points[from].name, base_.points[to].name));
    result_.faces.push_back({{at(k, from), at(k, to), at(after(k), to), at(after(k), from)},
                             std::move(geometry),
                             edge ? edge->where : path_.where});
  }

  void add_block(const Block& base, std::size_t k)
  {
    Block block = base;
    block.name = fmt::format("{} {}", renamed(base.name), k);
    const auto count = base.points.size();
    const auto fixed_count = static_cast<std::size_t>(
        std::count_if(base.points.begin(), base.points.end(), [this](int p) { return fixed(p); }));
    if (fixed_count == 0)
    {
      block.shape = count == 4 ? Shape::hexahedron : Shape::prism;
      block.points.clear();
      for (const std::size_t section : {k, after(k)})
        for (const int point : base.points)
          block.points.push_back(at(section, point));
    }
    else
      wedge(base, k, fixed_count, block);
    if (volume_at_first_corner(block) < 0.0)
      turn_over(block);
    result_.blocks.push_back(std::move(block));
  }

  /// A quadrilateral with a side on the axis sweeps a prism around it.
  void wedge(const Block& base, std::size_t k, std::size_t fixed_count, Block& block) const
  {
    const auto& p = base.points;
    for (std::size_t c = 0; p.size() == 4 && fixed_count == 2 && c < 4; ++c)
    {
      const int a = p[c];
      const int b = p[(c + 1) % 4];
      if (!fixed(a) || !fixed(b))
        continue;
      const int beside_b = p[(c + 2) % 4];
      const int beside_a = p[(c + 3) % 4];
      block.shape = Shape::prism;
      block.points = {at(k, a), at(k, beside_a), at(after(k), beside_a),
                      at(k, b), at(k, beside_b), at(after(k), beside_b)};
      return;
    }
    fail(base.where,
         fmt::format("the block '{}' touches the axis in a point; only a whole side of a quadrilateral "
                     "may lie on it",
                     base.name));
  }

  double volume_at_first_corner(const Block& block) const
  {
    const auto along = [&](int corner)
    { return geometry::subtract(result_.points[block.points[corner]].x, result_.points[block.points[0]].x); };
    const bool hexahedron = block.shape == Shape::hexahedron;
    return geometry::dot(along(1), geometry::cross(along(hexahedron ? 3 : 2), along(hexahedron ? 4 : 3)));
  }

  /// The face that an edge sweeps from section k on.
  std::vector<int> swept_face(int a, int b, std::size_t k) const
  {
    std::vector<int> face = {at(k, a), at(k, b)};
    if (!fixed(b))
      face.push_back(at(after(k), b));
    if (!fixed(a))
      face.push_back(at(after(k), a));
    return face;
  }

  void add_boundary(std::string name, const std::vector<std::array<int, 2>>& edges, const Location& where)
  {
    ByFaces faces;
    for (std::size_t k = 0; k < stage_count(); ++k)
      for (const auto& [a, b] : edges)
        if (!fixed(a) || !fixed(b))
          faces.faces.push_back(swept_face(a, b, k));
    result_.boundaries.push_back({std::move(name), std::move(faces), where, true});
  }

  void add_boundaries()
  {
    for (const Boundary& boundary : base_.boundaries)
      if (const auto* edges = std::get_if<ByEdges>(&boundary.rule))
        add_boundary(renamed(boundary.name), edges->edges, boundary.where);
    std::map<std::pair<std::string, int>, std::vector<std::array<int, 2>>> holes;
    for (const HoleEdge& hole : base_.hole_edges)
      holes[{hole.lattice, hole.number}].push_back({hole.a, hole.b});
    for (const auto& [hole, edges] : holes)
      add_boundary(fmt::format("{} hole {}", path_.name, hole.second), edges, path_.where);
    if (path_.closed)
      return;
    for (const bool last : {false, true})
    {
      ByFaces faces;
      for (const Block& block : base_.blocks)
      {
        faces.faces.emplace_back();
        for (const int point : block.points)
          faces.faces.back().push_back(at(last ? path_.sections.size() - 1 : 0, point));
      }
      result_.boundaries.push_back(
          {path_.name + (last ? " last" : " first"), std::move(faces), path_.where, true});
    }
  }

  const Layout& base_;
  const Path& path_;
  Layout result_;
  std::vector<std::vector<int>> index_;  ///< of each point of the piece in each section
  std::set<std::pair<int, int>> edges_;  ///< of all blocks of the piece
};

/// A normal of the plane in which the first block lies.
geometry::Point normal_of(const Layout& base)
{
  const std::vector<int>& p = base.blocks.front().points;
  const auto along = [&](int corner)
  { return geometry::subtract(base.points[p[corner]].x, base.points[p[0]].x); };
  return geometry::cross(along(1), along(static_cast<int>(p.size()) - 1));
}

}  // namespace

Layout extruded(const Layout& base, const Extrusion& extrusion)
{
  if (base.blocks.empty())
    throw mistake(extrusion.where,
                  fmt::format("'{}': there is nothing in '{}' to extrude", extrusion.name, extrusion.of));
  const double length = geometry::norm(extrusion.by);
  const geometry::Point normal = normal_of(base);
  if (!(std::abs(geometry::dot(normal, extrusion.by)) > 1e-9 * geometry::norm(normal) * length))
    throw mistake(extrusion.where,
                  fmt::format("'{}': the vector ({:g}, {:g}, {:g}) lies in the plane of '{}'; it must "
                              "lead out of it",
                              extrusion.name, extrusion.by[0], extrusion.by[1], extrusion.by[2],
                              extrusion.of));
  Path path;
  path.name = extrusion.name;
  path.of = extrusion.of;
  path.where = extrusion.where;
  path.sections = {Affine{}, translation(extrusion.by)};
  path.divisions = extrusion.divisions;
  path.grading = extrusion.grading;
  path.is_fixed = [](const geometry::Point&) { return false; };
  path.way = [](const geometry::Point&) { return geometry::Curve{}; };
  // Sides that are translated edges are their interpolation.
  path.swept = [](const geometry::Curve&, const geometry::Point&, const geometry::Point&, std::size_t)
  { return FaceGeometry{}; };
  return Sweep(base, path).make();
}

Layout revolved(const Layout& base, const Revolution& revolution)
{
  const auto fail = [&revolution](const std::string& message)
  { throw mistake(revolution.where, fmt::format("'{}': {}", revolution.name, message)); };
  if (base.blocks.empty())
    fail(fmt::format("there is nothing in '{}' to turn", revolution.of));
  if (!(geometry::norm(revolution.axis) > 0.0))
    fail("the axis has no direction");
  if (!(revolution.angle > 0.0) || revolution.angle > 360.0)
    fail(fmt::format("the angle is {:g} degrees; it must lie above 0 and be 360 at most", revolution.angle));
  if (revolution.sectors < 1 || revolution.angle / revolution.sectors >= 180.0)
    fail(fmt::format("{} sectors turn by {:g} degrees each; each must turn by less than 180",
                     revolution.sectors, revolution.angle / std::max(1, revolution.sectors)));
  const geometry::Point axis = geometry::scaled(1.0 / geometry::norm(revolution.axis), revolution.axis);
  const auto foot = [center = revolution.center, axis](const geometry::Point& x)
  { return geometry::combine(1.0, center, geometry::dot(geometry::subtract(x, center), axis), axis); };
  double size = 0.0;
  for (const Point& point : base.points)
    size = std::max(size, geometry::distance(point.x, foot(point.x)));
  const double step = revolution.angle / revolution.sectors * std::numbers::pi / 180.0;

  Path path;
  path.name = revolution.name;
  path.of = revolution.of;
  path.where = revolution.where;
  path.closed = revolution.angle == 360.0;
  for (int k = 0; k < revolution.sectors + (path.closed ? 0 : 1); ++k)
    path.sections.push_back(rotation(revolution.center, axis, k * step));
  path.divisions = revolution.around;
  path.is_fixed = [foot, size](const geometry::Point& x)
  { return geometry::distance(x, foot(x)) <= 1e-12 * size; };
  path.way = [foot](const geometry::Point& x) { return geometry::Curve{geometry::Arc{foot(x)}}; };
  path.swept = [=, center = revolution.center](const geometry::Curve& curve, const geometry::Point& a,
                                               const geometry::Point& b, std::size_t k) -> FaceGeometry
  {
    // Cylinders, cones and plane rings are the interpolation of their sides, but not a cone at its tip.
    const bool at_axis = path.is_fixed(a) || path.is_fixed(b);
    const bool across = std::abs(geometry::dot(geometry::subtract(b, a), axis)) <= 1e-12 * size;
    if (std::holds_alternative<geometry::Segment>(curve) && (!at_axis || across))
      return Interpolated{};
    return Patch{geometry::FunctionSurface{[=](double u, double v) {
      return rotation(center, axis, (static_cast<double>(k) + v) * step)(geometry::evaluate(curve, a, b, u));
    }}};
  };
  return Sweep(base, path).make();
}

}  // namespace blockfsi::block
