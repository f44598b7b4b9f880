#include "case/level_set.hpp"

#include "core/nearest.hpp"
#include "geometry/boolean.hpp"
#include "geometry/convolution.hpp"
#include "geometry/primitive.hpp"
#include "geometry/project.hpp"
#include "geometry/sampled.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <limits>
#include <sstream>

namespace blockfsi::case_file
{

namespace
{

using geometry::LevelSet;
using geometry::Point;

constexpr std::array<std::string_view, 3> in_xyz = {"x", "y", "z"};

struct Ball
{
  Point center{};
  double radius = 0.0;
};

const Keys<Ball>& ball_keys()
{
  static const Keys<Ball> keys = {
      {{"center", "[number, number] or [number, number, number]", "required", "m", "centre"},
       [](const Value& v, Reading& r, Ball& b) { b.center = point_in_space(v, r.constants); }},
      {{"radius", "number", "required", "m", "radius"},
       [](const Value& v, Reading& r, Ball& b) { b.radius = number(v, r.constants, positive); }}};
  return keys;
}

struct Rod
{
  Point point{};
  Point axis{};
  double radius = 0.0;
};

const Keys<Rod>& rod_keys()
{
  static const Keys<Rod> keys = {
      {{"point", "[number, number, number]", "required", "m", "a point of the axis"},
       [](const Value& v, Reading& r, Rod& c) { c.point = point_in_space(v, r.constants); }},
      {{"axis", "[number, number, number]", "required", "-", "direction of the axis"},
       [](const Value& v, Reading& r, Rod& c) { c.axis = point_in_space(v, r.constants); }},
      {{"radius", "number", "required", "m", "radius"},
       [](const Value& v, Reading& r, Rod& c) { c.radius = number(v, r.constants, positive); }}};
  return keys;
}

struct Corners
{
  Point low{};
  Point high{};
  bool flat = false;  ///< given in the plane
};

const Keys<Corners>& box_keys()
{
  static const Keys<Corners> keys = {{{"low", "[number, number] or [number, number, number]", "required", "m",
                                       "corner with the least coordinates"},
                                      [](const Value& v, Reading& r, Corners& b)
                                      {
                                        b.low = point_in_space(v, r.constants);
                                        b.flat = b.flat || list(v).size() == 2;
                                      }},
                                     {{"high", "[number, number] or [number, number, number]", "required",
                                       "m", "corner with the largest coordinates"},
                                      [](const Value& v, Reading& r, Corners& b)
                                      {
                                        b.high = point_in_space(v, r.constants);
                                        b.flat = b.flat || list(v).size() == 2;
                                      }}};
  return keys;
}

struct Half
{
  Point point{};
  Point normal{};
};

const Keys<Half>& plane_keys()
{
  static const Keys<Half> keys = {
      {{"point", "[number, number] or [number, number, number]", "required", "m",
        "a point of the plane or line"},
       [](const Value& v, Reading& r, Half& h) { h.point = point_in_space(v, r.constants); }},
      {{"normal", "[number, number] or [number, number, number]", "required", "-",
        "direction out of the domain behind it"},
       [](const Value& v, Reading& r, Half& h) { h.normal = point_in_space(v, r.constants); }}};
  return keys;
}

struct Ring
{
  Point center{};
  Point axis{0.0, 0.0, 1.0};
  double ring = 0.0;
  double tube = 0.0;
};

const Keys<Ring>& torus_keys()
{
  static const Keys<Ring> keys = {
      {{"center", "[number, number, number]", "required", "m", "centre of the ring"},
       [](const Value& v, Reading& r, Ring& t) { t.center = point_in_space(v, r.constants); }},
      {{"axis", "[number, number, number]", "[0, 0, 1]", "-", "normal of the ring's plane"},
       [](const Value& v, Reading& r, Ring& t) { t.axis = point_in_space(v, r.constants); }},
      {{"ring", "number", "required", "m", "radius of the ring"},
       [](const Value& v, Reading& r, Ring& t) { t.ring = number(v, r.constants, positive); }},
      {{"tube", "number", "required", "m", "radius of the tube about it"},
       [](const Value& v, Reading& r, Ring& t) { t.tube = number(v, r.constants, positive); }}};
  return keys;
}

/// A skeleton with the names of its nodes.
struct Tree
{
  geometry::Skeleton skeleton;
  std::vector<std::string> names;
  std::optional<double> sharpness;
  const Value* segments = nullptr;
  const Value* arcs = nullptr;
};

int node_named(const Value& value, const Tree& tree, const std::string& name)
{
  const auto found_name = std::find(tree.names.begin(), tree.names.end(), name);
  if (found_name == tree.names.end())
    fail(value, fmt::format("the skeleton has no node '{}'{}", name, suggestion(name, tree.names)));
  return static_cast<int>(found_name - tree.names.begin());
}

/// The nodes of "a - b - c".
std::vector<int> chain(const Value& value, const Tree& tree)
{
  std::vector<int> nodes;
  std::istringstream words(text(value));
  bool dash = false;
  for (std::string word; words >> word; dash = !dash)
  {
    if (dash != (word == "-"))
      fail(value,
           fmt::format("found {}, allowed are nodes with dashes between, \"a - b - c\"", found(value)));
    if (!dash)
      nodes.push_back(node_named(value, tree, word));
  }
  if (!dash || nodes.size() < 2)
    fail(value, fmt::format("found {}, allowed are nodes with dashes between, \"a - b - c\"", found(value)));
  return nodes;
}

void read_nodes(const Value& value, Reading& reading, Tree& tree)
{
  for (const Field& field : table(value))
  {
    const auto* numbers = std::get_if<Value::List>(&field.value.content);
    if (!numbers || numbers->size() != 4)
      fail(field.value, fmt::format("found {}, allowed is a list [x, y, z, radius]", found(field.value)));
    Point x{};
    for (std::size_t c = 0; c < 3; ++c)
      x[c] = number((*numbers)[c], reading.constants);
    tree.names.push_back(field.name);
    tree.skeleton.nodes.push_back(x);
    tree.skeleton.radii.push_back(number((*numbers)[3], reading.constants, positive));
  }
}

struct ArcData
{
  const Tree& tree;
  geometry::Bone bone;
};

const Keys<ArcData>& arc_keys()
{
  static const Keys<ArcData> keys = {
      {{"ends", "\"a - b\"", "required", "", "nodes at its ends"},
       [](const Value& v, Reading&, ArcData& a)
       {
         const std::vector<int> ends = chain(v, a.tree);
         if (ends.size() != 2)
           fail(v, fmt::format("found {}, allowed are two nodes, \"a - b\"", found(v)));
         a.bone.from = ends[0];
         a.bone.to = ends[1];
       }},
      {{"through", "[number, number, number]", "required", "m", "a point of the arc between its ends"},
       [](const Value& v, Reading& r, ArcData& a) { a.bone.through = point_in_space(v, r.constants); }}};
  return keys;
}

const Keys<Tree>& convolution_keys()
{
  static const Keys<Tree> keys = {
      {{"nodes", "table NAME = [number, number, number, number]", "required", "m",
        "x, y, z and the radius of the tube at each node"},
       read_nodes},
      {{"segments", "list of texts \"a - b - c\"", "[]", "", "straight lines between nodes"},
       [](const Value& v, Reading&, Tree& t) { t.segments = &v; }},
      {{"arcs", "list of tables", "[]", "", "arcs between nodes"},
       [](const Value& v, Reading&, Tree& t) { t.arcs = &v; }},
      {{"sharpness", "number", "3 / mean radius", "1/m",
        "s of the kernel 1 / (1 + s² d²)²: the larger, the less do neighbouring tubes blend"},
       [](const Value& v, Reading& r, Tree& t) { t.sharpness = number(v, r.constants, positive); }}};
  return keys;
}

LevelSet read_convolution(const Value& value, Reading& reading)
{
  Tree tree;
  read_keys(value, convolution_keys(), reading, tree);
  if (tree.segments)
    for (const Value& entry : list(*tree.segments))
    {
      const std::vector<int> nodes = chain(entry, tree);
      for (std::size_t i = 1; i < nodes.size(); ++i)
        tree.skeleton.bones.push_back({nodes[i - 1], nodes[i], {}});
    }
  if (tree.arcs)
    for (const Value& entry : list(*tree.arcs))
    {
      ArcData arc{tree, {}};
      read_keys(entry, arc_keys(), reading, arc);
      tree.skeleton.bones.push_back(arc.bone);
    }
  double sum = 0.0;
  for (const double radius : tree.skeleton.radii)
    sum += radius;
  const double by_default = sum > 0.0 ? 3.0 * static_cast<double>(tree.skeleton.radii.size()) / sum : 1.0;
  tree.skeleton.sharpness = tree.sharpness.value_or(by_default);
  return placed(value, [&] { return tube(geometry::Convolution(tree.skeleton)); });
}

struct File
{
  std::filesystem::path path;
};

const Keys<File>& file_keys()
{
  static const Keys<File> keys = {{{"file", "text", "required", "",
                                    "samples, relative to the case: an ascii .vti image, or a text with nx "
                                    "ny nz, origin, spacing, values"},
                                   [](const Value& v, Reading&, File& f) {
                                     f.path = std::filesystem::path(v.where.file).parent_path() / text(v);
                                   }}};
  return keys;
}

using Combine = LevelSet (*)(const std::vector<LevelSet>&, double);

/// A table of [geometry] while it is read: what it describes, then what is done to it.
struct Draft
{
  std::optional<LevelSet> shape;
  std::vector<LevelSet> parts;  ///< of a union, an intersection or a difference
  Combine combine = nullptr;
  double blend = 0.0;
  std::optional<Ball> scale;  ///< the radius holds the factor
  std::optional<Rod> rotate;  ///< the radius holds the angle
  Point move{};
};

const Keys<Ball>& scale_keys()
{
  static const Keys<Ball> keys = {
      {{"center", "[number, number] or [number, number, number]", "[0, 0, 0]", "m", "the point that stays"},
       [](const Value& v, Reading& r, Ball& b) { b.center = point_in_space(v, r.constants); }},
      {{"factor", "number", "required", "-", "so many times larger"},
       [](const Value& v, Reading& r, Ball& b) { b.radius = number(v, r.constants, positive); }}};
  return keys;
}

const Keys<Rod>& rotate_keys()
{
  static const Keys<Rod> keys = {
      {{"center", "[number, number] or [number, number, number]", "[0, 0, 0]", "m", "a point of the axis"},
       [](const Value& v, Reading& r, Rod& a) { a.point = point_in_space(v, r.constants); }},
      {{"axis", "[number, number, number]", "[0, 0, 1]", "-",
        "direction of the axis, by the right-hand rule"},
       [](const Value& v, Reading& r, Rod& a) { a.axis = point_in_space(v, r.constants); }},
      {{"angle", "number", "required", "rad", "angle; 90 degrees are \"pi / 2\""},
       [](const Value& v, Reading& r, Rod& a) { a.radius = number(v, r.constants); }}};
  return keys;
}

template <Combine combine>
void read_parts(const Value& value, Reading& reading, Draft& draft)
{
  for (const Value& entry : list(value))
    draft.parts.push_back(level_set(entry, reading));
  if (draft.parts.empty())
    fail(value, "found an empty list, allowed are names of level sets or formulas in x, y, z");
  draft.combine = combine;
}

void read_box(const Value& value, Reading& reading, Draft& draft)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Corners corners;
  read_keys(value, box_keys(), reading, corners);
  if (corners.flat)
  {
    corners.low[2] = -infinity;
    corners.high[2] = infinity;
  }
  draft.shape = placed(value, [&] { return geometry::box(corners.low, corners.high); });
}

/// What a level set is: exactly one of these.
const Keys<Draft>& shape_keys()
{
  static const Keys<Draft> keys = {
      {{"level_set", "formula in x, y, z", "", "", "negative inside, 0 on the boundary, positive outside"},
       [](const Value& v, Reading& r, Draft& d) { d.shape = LevelSet(expression(v, r.constants, in_xyz)); }},
      {{"sphere", "table", "", "", "sphere, in the plane circle"},
       [](const Value& v, Reading& r, Draft& d)
       {
         Ball ball;
         read_keys(v, ball_keys(), r, ball);
         d.shape = placed(v, [&] { return geometry::sphere(ball.center, ball.radius); });
       }},
      {{"cylinder", "table", "", "", "infinite cylinder"},
       [](const Value& v, Reading& r, Draft& d)
       {
         Rod rod;
         read_keys(v, rod_keys(), r, rod);
         d.shape = placed(v, [&] { return geometry::cylinder(rod.point, rod.axis, rod.radius); });
       }},
      {{"box", "table", "", "", "box, in the plane rectangle"}, read_box},
      {{"plane", "table", "", "", "half space, in the plane half plane"},
       [](const Value& v, Reading& r, Draft& d)
       {
         Half half;
         read_keys(v, plane_keys(), r, half);
         d.shape = placed(v, [&] { return geometry::plane(half.point, half.normal); });
       }},
      {{"torus", "table", "", "", "torus"},
       [](const Value& v, Reading& r, Draft& d)
       {
         Ring ring;
         read_keys(v, torus_keys(), r, ring);
         d.shape = placed(v, [&] { return geometry::torus(ring.center, ring.axis, ring.ring, ring.tube); });
       }},
      {{"convolution", "table", "", "", "smooth tube about a skeleton of lines and arcs"},
       [](const Value& v, Reading& r, Draft& d) { d.shape = read_convolution(v, r); }},
      {{"sampled", "table", "", "", "cubic spline through samples on a regular grid"},
       [](const Value& v, Reading& r, Draft& d)
       {
         File file;
         read_keys(v, file_keys(), r, file);
         d.shape = placed(
             v, [&] { return geometry::sampled(geometry::read_samples(file.path), text(*v.find("file"))); });
       }},
      {{"union", "list of names or formulas", "", "", "the points in any of these"},
       read_parts<geometry::unite>},
      {{"intersection", "list of names or formulas", "", "", "the points in all of these"},
       read_parts<geometry::intersect>},
      {{"difference", "list of names or formulas", "", "",
        "the points in the first but in none of the others"},
       read_parts<geometry::difference>},
      {{"complement", "name or formula", "", "", "the points outside of it"},
       [](const Value& v, Reading& r, Draft& d) { d.shape = geometry::complement(level_set(v, r)); }}};
  return keys;
}

/// What is done to it, in this order.
const Keys<Draft>& change_keys()
{
  static const Keys<Draft> keys = {
      {{"blend", "number", "0", "m",
        "radius of the fillets where parts of a union, intersection or difference meet"},
       [](const Value& v, Reading& r, Draft& d) { d.blend = number(v, r.constants, not_negative); }},
      {{"scale", "table", "", "", "makes it larger"},
       [](const Value& v, Reading& r, Draft& d) { read_keys(v, scale_keys(), r, d.scale.emplace()); }},
      {{"rotate", "table", "", "", "then turns it"},
       [](const Value& v, Reading& r, Draft& d)
       {
         d.rotate = Rod{{}, {0.0, 0.0, 1.0}, 0.0};
         read_keys(v, rotate_keys(), r, *d.rotate);
       }},
      {{"move", "[number, number] or [number, number, number]", "[0, 0, 0]", "m", "then moves it"},
       [](const Value& v, Reading& r, Draft& d) { d.move = point_in_space(v, r.constants); }}};
  return keys;
}

const Keys<Draft>& all_keys()
{
  static const Keys<Draft> keys = []
  {
    Keys<Draft> all = shape_keys();
    all.insert(all.end(), change_keys().begin(), change_keys().end());
    return all;
  }();
  return keys;
}

LevelSet read_table(const Value& value, Reading& reading)
{
  Draft draft;
  table(value);
  const auto count =
      std::count_if(shape_keys().begin(), shape_keys().end(),
                    [&](const Key<Draft>& key) { return value.find(key.says.name) != nullptr; });
  read_keys(value, all_keys(), reading, draft);
  if (count != 1)
    fail(value, fmt::format("found {} of {}, allowed is exactly one", count, listed(names(shape_keys()))));
  if (const Value* blend = value.find("blend"); blend && !draft.combine)
    fail(*blend, "only a union, an intersection or a difference has a blend");
  if (draft.combine)
    draft.shape = placed(value, [&] { return draft.combine(draft.parts, draft.blend); });
  LevelSet result = *draft.shape;
  if (draft.scale)
    result = geometry::grown(result, draft.scale->center, draft.scale->radius);
  if (draft.rotate)
    result = placed(
        value, [&]
        { return geometry::rotated(result, draft.rotate->point, draft.rotate->axis, draft.rotate->radius); });
  return draft.move == Point{} ? result : geometry::translated(result, draft.move);
}

/// The level set of a name; it is read now if it stands further down in the file.
LevelSet named(const Field& field, const Value& where, Reading& reading)
{
  if (const auto known = reading.level_sets.find(field.name); known != reading.level_sets.end())
    return known->second;
  if (std::find(reading.unfinished.begin(), reading.unfinished.end(), field.name) != reading.unfinished.end())
    fail(where, fmt::format("'{}' is made of itself", field.name));
  reading.unfinished.push_back(field.name);
  const LevelSet result = read_table(field.value, reading).named(field.name);
  reading.unfinished.pop_back();
  reading.level_sets.emplace(field.name, result);
  return result;
}

bool is_word(const std::string& text)
{
  return std::all_of(text.begin(), text.end(),
                     [](unsigned char c) { return std::isalnum(c) || c == '_' || c == ' ' || c >= 0x80; });
}

}  // namespace

Point point_in_space(const Value& value, const Constants& constants)
{
  const auto* content = std::get_if<Value::List>(&value.content);
  if (!content || content->size() < 2 || content->size() > 3)
    fail(value, fmt::format("found {}, allowed is a list of two or three numbers [x, y] or [x, y, z]",
                            found(value)));
  Point result{};
  for (std::size_t c = 0; c < content->size(); ++c)
    result[c] = number((*content)[c], constants);
  return result;
}

LevelSet level_set(const Value& value, Reading& reading)
{
  const std::string& name = text(value);
  std::vector<std::string> known;
  if (reading.geometry)
    for (const Field& field : table(*reading.geometry))
    {
      if (field.name == name)
        return named(field, value, reading);
      known.push_back(field.name);
    }
  if (is_word(name) && !reading.constants.contains(name) && name != "x" && name != "y" && name != "z")
    fail(value, fmt::format("there is no level set '{}' in [geometry]{}", name,
                            known.empty() ? "" : suggestion(name, known)));
  return LevelSet(expression(value, reading.constants, in_xyz));
}

namespace
{

/// Where a point of blocks lies on level sets.
struct OnSurface
{
  Point near{};
  std::vector<LevelSet> on;
  std::optional<Point> direction;
};

const Keys<OnSurface>& on_surface_keys()
{
  static const Keys<OnSurface> keys = {
      {{"near", "[number, number] or [number, number, number]", "required", "m",
        "where to look for the point"},
       [](const Value& v, Reading& r, OnSurface& o) { o.near = point_in_space(v, r.constants); }},
      {{"on", "name or formula, or list of two", "required", "",
        "level set, or two, that the point lies on: the nearest point along the gradient"},
       [](const Value& v, Reading& r, OnSurface& o) { o.on = one_or_two_level_sets(v, r); }},
      {{"direction", "[number, number] or [number, number, number]", "the gradient", "-",
        "where to look from there, both ways; for one level set"},
       [](const Value& v, Reading& r, OnSurface& o) { o.direction = point_in_space(v, r.constants); }}};
  return keys;
}

}  // namespace

std::vector<LevelSet> one_or_two_level_sets(const Value& value, Reading& reading)
{
  const auto* entries = std::get_if<Value::List>(&value.content);
  if (!entries)
    return {level_set(value, reading)};
  if (entries->size() != 2)
    fail(value, fmt::format("found {}, allowed is a name or formula or a list of two", found(value)));
  return {level_set((*entries)[0], reading), level_set((*entries)[1], reading)};
}

Point corner_point(const Value& value, Reading& reading)
{
  if (!std::holds_alternative<Value::Table>(value.content))
    return point(value, reading.constants);
  OnSurface data;
  read_keys(value, on_surface_keys(), reading, data);
  if (data.on.size() == 2 && data.direction)
    fail(value, "a point on two level sets has no direction");
  // How far away the point may be is for the user to judge, so that far is as large as the place itself.
  const double size = std::max(geometry::norm(data.near), 1e-3);
  const geometry::SearchLimits limits{.size = size, .farthest = 10.0 * size};
  const geometry::Found found_point = data.on.size() == 2 ? project(data.on[0], data.on[1], data.near, limits)
                                      : data.direction
                                          ? project(data.on[0], data.near, *data.direction, limits)
                                          : project_along_gradient(data.on[0], data.near, limits);
  if (!found_point.ok())
    fail(value,
         fmt::format(
             "no point of the level set '{}' was found from {}: {}; look nearer or in another direction",
             data.on[0].text(), geometry::text(data.near), geometry::text(found_point.status)));
  return found_point.x;
}

std::vector<Section> point_sections()
{
  return {
      section("NAME = { ... }", "a point on level sets, in [blocks.points] and in place", on_surface_keys())};
}

void read_geometry(const Value& value, Reading& reading)
{
  reading.geometry = &value;
  for (const Field& field : table(value))
    named(field, field.value, reading);
}

std::vector<Section> geometry_sections()
{
  Section shapes =
      section("[geometry.NAME]", "a level set by name: exactly one of the keys up to complement", all_keys());
  return {std::move(shapes),
          section("sphere = { ... }", "", ball_keys()),
          section("cylinder = { ... }", "", rod_keys()),
          section("box = { ... }", "", box_keys()),
          section("plane = { ... }", "", plane_keys()),
          section("torus = { ... }", "", torus_keys()),
          section("convolution = { ... }", "", convolution_keys()),
          section("arcs = [{ ... }]", "", arc_keys()),
          section("sampled = { ... }", "", file_keys()),
          section("scale = { ... }", "", scale_keys()),
          section("rotate = { ... }", "", rotate_keys())};
}

}  // namespace blockfsi::case_file
