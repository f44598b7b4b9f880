#include "case/skeleton.hpp"

#include "case/level_set.hpp"
#include "core/nearest.hpp"
#include "geometry/convolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>

namespace blockfsi::case_file
{

using geometry::LevelSet;
using geometry::Point;

namespace
{

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

}  // namespace

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

std::vector<Section> skeleton_sections()
{
  return {section("convolution = { ... }", "", convolution_keys()),
          section("arcs = [{ ... }]", "", arc_keys())};
}

}  // namespace blockfsi::case_file
