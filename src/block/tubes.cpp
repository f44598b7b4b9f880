#include "block/tubes.hpp"

#include "block/message.hpp"
#include "geometry/on_level_set.hpp"
#include "geometry/primitive.hpp"
#include "geometry/project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace blockfsi::block
{

namespace
{

using geometry::add;
using geometry::combine;
using geometry::cross;
using geometry::dot;
using geometry::norm;
using geometry::Point;
using geometry::scaled;
using geometry::subtract;

constexpr int around_count = 8;  ///< corners of a section on the wall
constexpr int ray_steps = 64;    ///< in which a ray looks for the wall

/// A section across a tube as points of the layout, its corners counted from the first pole.
struct Section
{
  std::array<int, around_count> wall{};
  std::array<int, around_count> core{};  ///< sides and corners of the inner square in turn
  int center = 0;
  Point x{};      ///< its centre
  Point first{};  ///< unit vector towards wall[0]
};

Point unit(const Point& a)
{
  return scaled(1.0 / norm(a), a);
}

/// The part of a vector across a direction, of unit length.
Point across(const Point& vector, const Point& direction)
{
  return unit(combine(1.0, vector, -dot(vector, direction), direction));
}

/// Some unit vector across a direction.
Point any_across(const Point& direction)
{
  std::size_t least = 0;
  for (std::size_t c = 1; c < 3; ++c)
    if (std::abs(direction[c]) < std::abs(direction[least]))
      least = c;
  Point axis{};
  axis[least] = 1.0;
  return across(axis, direction);
}

/// Unit vector at an angle from a towards b.
Point turned(const Point& a, const Point& b, double angle)
{
  return combine(std::cos(angle), a, std::sin(angle), b);
}

/// The section seen from the other end of the tube, its corners counted from `start`.
Section recounted(const Section& section, bool mirrored, int start)
{
  Section result = section;
  for (int k = 0; k < around_count; ++k)
  {
    const int from = ((mirrored ? start - k : start + k) % around_count + around_count) % around_count;
    result.wall[k] = section.wall[from];
    result.core[k] = section.core[from];
  }
  return result;
}

class Builder
{
public:
  Builder(Layout& layout, const Tubes& tubes) : layout_(layout), tubes_(tubes) {}

  void build()
  {
    check();
    find_neighbours();
    for (std::size_t n = 0; n < tubes_.nodes.size(); ++n)
      if (at_node_[n].size() == 3)
        make_joint(static_cast<int>(n));
    for (std::size_t n = 0; n < tubes_.nodes.size(); ++n)
      if (at_node_[n].size() != 2)
        for (const int segment : at_node_[n])
          if (!is_built_[segment])
            build_chain(static_cast<int>(n), segment);
    for (std::size_t s = 0; s < tubes_.segments.size(); ++s)
      if (!is_built_[s])
        fail(fmt::format(
            "the tubes from '{}' close to a ring without a joint or an end; leave one segment out",
            tubes_.nodes[tubes_.segments[s].a].name));
    layout_.boundaries.push_back(
        {tubes_.name + " wall", ByFaces{std::move(wall_faces_)}, tubes_.where, true});
  }

private:
  [[noreturn]] void fail(std::string message) const
  {
    throw mistake(tubes_.where, fmt::format("tubes '{}': {}", tubes_.name, message));
  }

  const std::string& node_name(int node) const { return tubes_.nodes[node].name; }
  const Point& at(int node) const { return tubes_.nodes[node].x; }

  void check() const
  {
    if (layout_.dim != 3)
      fail("they are made in three dimensions only");
    for (const Tubes::Segment& segment : tubes_.segments)
    {
      const std::string text =
          fmt::format("the segment from '{}' to '{}'", node_name(segment.a), node_name(segment.b));
      if (!(geometry::distance(at(segment.a), at(segment.b)) > 0.0))
        fail(text + " has no length");
      double before = 0.0;
      for (const double t : segment.sections)
      {
        if (!(t > before) || !(t < 1.0))
          fail(fmt::format("sections of {} must ascend between 0 and 1, found {}", text, t));
        before = t;
      }
    }
  }

  void find_neighbours()
  {
    at_node_.resize(tubes_.nodes.size());
    joint_.resize(tubes_.nodes.size());
    is_built_.assign(tubes_.segments.size(), false);
    for (std::size_t s = 0; s < tubes_.segments.size(); ++s)
      for (const int node : {tubes_.segments[s].a, tubes_.segments[s].b})
        at_node_[node].push_back(static_cast<int>(s));
    for (std::size_t n = 0; n < at_node_.size(); ++n)
      if (at_node_[n].empty() || at_node_[n].size() > 3)
        fail(fmt::format("{} segments meet at the node '{}'; it takes one to three", at_node_[n].size(),
                         tubes_.nodes[n].name));
  }

  /// Unit vector along a segment, away from a node.
  Point outward(int node, int segment) const
  {
    const Tubes::Segment& s = tubes_.segments[segment];
    return unit(subtract(at(s.a == node ? s.b : s.a), at(node)));
  }

  int add_point(std::string_view what, const Point& x)
  {
    layout_.points.push_back(
        {fmt::format("{} {} {}", tubes_.name, what, layout_.points.size()), x, tubes_.where});
    return static_cast<int>(layout_.points.size()) - 1;
  }

  /// Distance of the wall from a point inside, along a unit vector. The slope there says nothing, as the ray
  /// begins on the axis; so the first change of sign is looked for in steps.
  double wall_distance(const Point& from, const Point& direction, const std::string& where) const
  {
    if (!(tubes_.wall.value(from) < 0.0))
      fail(fmt::format("{} at ({:.3g}, {:.3g}, {:.3g}) lies outside of the wall; move it inside", where,
                       from[0], from[1], from[2]));
    const double step = tubes_.reach / ray_steps;
    for (int i = 0; i < ray_steps; ++i)
      if (tubes_.wall.value(combine(1.0, from, (i + 1) * step, direction)) >= 0.0)
      {
        const Point start = combine(1.0, from, i * step, direction);
        const geometry::Found found = geometry::project(tubes_.wall, start, direction, {step, step, false});
        if (found.ok())
          return i * step + found.moved;
        fail(fmt::format("from {} along ({:.3g}, {:.3g}, {:.3g}) there is {} of the wall", where,
                         direction[0], direction[1], direction[2], geometry::text(found.status)));
      }
    fail(fmt::format("from {} the wall is not met within {:g} m along ({:.3g}, {:.3g}, {:.3g}); move the "
                     "section, or let the search reach farther",
                     where, tubes_.reach, direction[0], direction[1], direction[2]));
  }

  /// Adds the corners on one ray: on the wall and of the inner square.
  void add_ray(const Point& center, const Point& direction, int k, const std::string& where, Section& section)
  {
    const double distance = wall_distance(center, direction, where);
    // The corners of the square lie farther out than its sides, but within the circle around them.
    const double share = k % 2 == 0 ? tubes_.core : 1.15 * tubes_.core;
    section.wall[k] = add_point("wall", combine(1.0, center, distance, direction));
    section.core[k] = add_point("core", combine(1.0, center, share * distance, direction));
  }

  /// A plane section.
  Section plane_section(const Point& center, const Point& first, const Point& direction,
                        const std::string& where)
  {
    Section section;
    section.center = add_point("axis", center);
    section.x = center;
    section.first = first;
    const Point second = cross(direction, first);
    for (int k = 0; k < around_count; ++k)
      add_ray(center, turned(first, second, k * std::numbers::pi / 4.0), k, where, section);
    return section;
  }

  /// Three half discs around the diameter between the poles, each between two tubes.
  void make_joint(int node)
  {
    std::array<Point, 3> t{};
    for (int i = 0; i < 3; ++i)
      t[i] = outward(node, at_node_[node][i]);
    const Point normal = add(cross(t[0], t[1]), add(cross(t[1], t[2]), cross(t[2], t[0])));
    if (!(norm(normal) > 1e-6))
      fail(fmt::format("the three tubes at '{}' lie in one line; turn one of them", node_name(node)));
    const Point pole = unit(normal);
    const std::string where = fmt::format("the joint '{}'", node_name(node));

    Section shared;  // the diameter
    shared.center = add_point("axis", at(node));
    shared.x = at(node);
    shared.first = pole;
    add_ray(at(node), pole, 0, where, shared);
    add_ray(at(node), scaled(-1.0, pole), 4, where, shared);
    joint_[node].assign(3, shared);
    // Half disc m lies between tubes m and m + 1; seen from m it has the corners 1 to 3 or 7 to 5.
    for (int m = 0; m < 3; ++m)
    {
      const int next = (m + 1) % 3;
      const Point middle = between(t[m], t[next], t[(m + 2) % 3], pole);
      Section half;
      for (int k = 1; k <= 3; ++k)
        add_ray(at(node), turned(pole, middle, k * std::numbers::pi / 4.0), k, where, half);
      for (const int tube : {m, next})
      {
        const bool forward = dot(cross(t[tube], pole), middle) > 0.0;
        for (int k = 1; k <= 3; ++k)
        {
          joint_[node][tube].wall[forward ? k : around_count - k] = half.wall[k];
          joint_[node][tube].core[forward ? k : around_count - k] = half.core[k];
        }
      }
    }
  }

  /// Unit vector across the pole that halves the angle between two tubes on the side without the third.
  static Point between(const Point& a, const Point& b, const Point& third, const Point& pole)
  {
    const Point pa = across(a, pole);
    const Point pb = across(b, pole);
    const Point sum = add(pa, pb);
    // Tubes in one line: away from the third.
    if (norm(sum) < 1e-3)
      return across(scaled(-1.0, third), pole);
    const Point half = across(sum, pole);
    // The wider angle counts where the third tube lies between both.
    const bool third_between =
        dot(across(third, pole), half) > std::max(dot(pa, half), dot(pb, half)) + 1e-12;
    return third_between ? scaled(-1.0, half) : half;
  }

  /// All tubes from a joint or an end to the next one.
  void build_chain(int node, int segment)
  {
    std::vector<int> nodes = {node};
    std::vector<int> segments;
    for (int s = segment;;)
    {
      is_built_[s] = true;
      segments.push_back(s);
      const int next = tubes_.segments[s].a == nodes.back() ? tubes_.segments[s].b : tubes_.segments[s].a;
      nodes.push_back(next);
      if (at_node_[next].size() != 2)
        break;
      s = at_node_[next][0] == s ? at_node_[next][1] : at_node_[next][0];
    }
    const std::vector<Cut> cuts = make_cuts(nodes, segments);
    const std::vector<Section> sections = make_sections(nodes, segments, cuts);
    for (std::size_t i = 0; i + 1 < sections.size(); ++i)
      fill(sections[i], sections[i + 1]);
    for (const bool last : {false, true})
      if (const int end = last ? nodes.back() : nodes.front(); at_node_[end].size() == 1)
        add_end(end, last ? sections.back() : sections.front(), last ? cuts.back() : cuts.front());
  }

  /// Where a section goes and across which direction.
  struct Cut
  {
    Point x;
    Point direction;
    std::string where;
  };

  std::vector<Cut> make_cuts(const std::vector<int>& nodes, const std::vector<int>& segments) const
  {
    std::vector<Cut> cuts;
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      const Point before = i > 0 ? unit(subtract(at(nodes[i]), at(nodes[i - 1]))) : Point{};
      const Point after = i + 1 < nodes.size() ? unit(subtract(at(nodes[i + 1]), at(nodes[i]))) : Point{};
      cuts.push_back(
          {at(nodes[i]), unit(add(before, after)), fmt::format("the node '{}'", node_name(nodes[i]))});
      if (i + 1 == nodes.size())
        break;
      const Tubes::Segment& segment = tubes_.segments[segments[i]];
      std::vector<double> ts = segment.sections;
      if (segment.a != nodes[i])
      {
        std::reverse(ts.begin(), ts.end());
        for (double& t : ts)
          t = 1.0 - t;
      }
      for (const double t : ts)
        cuts.push_back({combine(1.0 - t, at(nodes[i]), t, at(nodes[i + 1])), after,
                        fmt::format("{:g} of the way from '{}' to '{}'", t, node_name(nodes[i]),
                                    node_name(nodes[i + 1]))});
    }
    return cuts;
  }

  /// The section of a joint that belongs to a segment, in the frame of the way along the chain.
  std::optional<Section> joint_section(int node, int segment, bool at_end) const
  {
    if (at_node_[node].size() != 3)
      return std::nullopt;
    const auto tube =
        std::find(at_node_[node].begin(), at_node_[node].end(), segment) - at_node_[node].begin();
    const Section& own = joint_[node][tube];
    return at_end ? recounted(own, true, 0) : own;
  }

  /// Sections at all cuts: frames are carried along without turning, and what is missing to the joint at the
  /// end, up to an eighth of a turn, is spread over the length.
  std::vector<Section> make_sections(const std::vector<int>& nodes, const std::vector<int>& segments,
                                     const std::vector<Cut>& cuts)
  {
    const std::optional<Section> start = joint_section(nodes.front(), segments.front(), false);
    std::optional<Section> end = joint_section(nodes.back(), segments.back(), true);
    std::vector<Point> first = {
        across(start ? start->first : any_across(cuts[0].direction), cuts[0].direction)};
    std::vector<double> length = {0.0};
    for (std::size_t i = 1; i < cuts.size(); ++i)
    {
      first.push_back(across(first.back(), cuts[i].direction));
      length.push_back(length.back() + geometry::distance(cuts[i - 1].x, cuts[i].x));
    }
    double twist = 0.0;
    if (end)
    {
      const Point& direction = cuts.back().direction;
      const Point target = across(end->first, direction);
      const double angle = std::atan2(dot(target, cross(direction, first.back())), dot(target, first.back()));
      const int quarter = static_cast<int>(std::lround(angle / (std::numbers::pi / 2.0)));
      twist = angle - quarter * std::numbers::pi / 2.0;
      end = recounted(*end, false, -2 * quarter);
    }
    std::vector<Section> sections;
    for (std::size_t i = 0; i < cuts.size(); ++i)
    {
      if (i == 0 && start)
        sections.push_back(*start);
      else if (i + 1 == cuts.size() && end)
        sections.push_back(*end);
      else
        sections.push_back(plane_section(
            cuts[i].x,
            turned(first[i], cross(cuts[i].direction, first[i]), twist * length[i] / length.back()),
            cuts[i].direction, cuts[i].where));
    }
    return sections;
  }

  /// The four inner and eight outer quadrilaterals of a section, counter-clockwise seen against the tube.
  static std::vector<std::array<int, 4>> quadrilaterals(const Section& s)
  {
    std::vector<std::array<int, 4>> quads;
    for (int k = 0; k < around_count; k += 2)
      quads.push_back({s.center, s.core[k], s.core[k + 1], s.core[(k + 2) % around_count]});
    for (int k = 0; k < around_count; ++k)
    {
      const int next = (k + 1) % around_count;
      quads.push_back({s.core[k], s.wall[k], s.wall[next], s.core[next]});
    }
    return quads;
  }

  void set_divisions(int a, int b, int count, const std::optional<Grading>& grading = {})
  {
    if (!divided_.try_emplace(std::minmax(a, b), layout_.edges.size()).second)
      return;
    Edge edge;
    edge.a = a;
    edge.b = b;
    edge.divisions = count;
    edge.grading = grading;
    edge.where = tubes_.where;
    layout_.edges.push_back(std::move(edge));
  }

  /// The blocks between two sections.
  void fill(const Section& from, const Section& to)
  {
    const auto below = quadrilaterals(from);
    const auto above = quadrilaterals(to);
    for (std::size_t q = 0; q < below.size(); ++q)
    {
      Block block;
      block.name = fmt::format("{} {}", tubes_.name, ++block_count_);
      block.region = tubes_.region;
      block.shape = element::Shape::hexahedron;
      block.points.assign(below[q].begin(), below[q].end());
      block.points.insert(block.points.end(), above[q].begin(), above[q].end());
      block.where = tubes_.where;
      layout_.blocks.push_back(std::move(block));
    }
    const double length = geometry::distance(from.x, to.x);
    set_divisions(from.center, to.center,
                  std::max(1, static_cast<int>(std::lround(length / tubes_.axial_size))));
    for (const Section* section : {&from, &to})
      for (int k = 0; k < around_count; ++k)
      {
        set_divisions(section->wall[k], section->wall[(k + 1) % around_count], tubes_.around);
        set_divisions(section->core[k], section->wall[k], tubes_.radial, tubes_.radial_grading);
      }
    for (int k = 0; k < around_count; ++k)
    {
      const int next = (k + 1) % around_count;
      std::vector<int> corners = {from.wall[k], from.wall[next], to.wall[next], to.wall[k]};
      layout_.faces.push_back({corners, OnLevelSet{tubes_.wall}, tubes_.where});
      wall_faces_.push_back(std::move(corners));
    }
  }

  void add_end(int node, const Section& section, const Cut& cut)
  {
    // Both on the wall and in the plane of the section: openings are flat.
    for (int k = 0; k < around_count; ++k)
    {
      Edge& edge =
          layout_.edges[divided_.at(std::minmax(section.wall[k], section.wall[(k + 1) % around_count]))];
      const Point& a = layout_.points[edge.a].x;
      const Point& b = layout_.points[edge.b].x;
      geometry::OnLevelSet curve{tubes_.wall, geometry::plane(cut.x, cut.direction)};
      edge.curve = geometry::measured(curve, a, b);
    }
    std::vector<std::vector<int>> faces;
    for (const auto& quad : quadrilaterals(section))
      faces.emplace_back(quad.begin(), quad.end());
    layout_.boundaries.push_back({node_name(node), ByFaces{std::move(faces)}, tubes_.where, true});
  }

  Layout& layout_;
  const Tubes& tubes_;
  std::vector<std::vector<int>> at_node_;    ///< segments at each node
  std::vector<std::vector<Section>> joint_;  ///< sections of the three tubes at a joint, else empty
  std::vector<bool> is_built_;               ///< of each segment
  std::map<std::pair<int, int>, std::size_t> divided_;  ///< entries of edges by their points
  std::vector<std::vector<int>> wall_faces_;
  int block_count_ = 0;
};

}  // namespace

void add(Layout& layout, const Tubes& tubes)
{
  Builder(layout, tubes).build();
}

}  // namespace blockfsi::block
