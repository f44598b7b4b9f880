#include "block/corner_blocks.hpp"

#include "block/corner_layout.hpp"
#include "block/move.hpp"
#include "block/place.hpp"
#include "flag.hpp"
#include "rods.hpp"

#include <doctest/doctest.h>

#include <random>
#include <string>

using namespace blockfsi;
using namespace blockfsi::block;
using namespace blockfsi::block::testing;

namespace
{

/// An extrusion of rods.hpp as a layout, its corners with the numbers that they have there.
Layout layout_of(const Extrusion& shape, int order, int divisions)
{
  Layout layout;
  layout.dim = 3;
  layout.order = order;
  layout.default_divisions = divisions;
  for (std::size_t level = 0; level < shape.levels.size(); ++level)
    for (const auto& [x, z] : shape.points)
      layout.points.push_back({"p" + std::to_string(layout.points.size()), {x, shape.levels[level], z}, {}});
  const int width = static_cast<int>(shape.points.size());
  for (int level = 0; level + 1 < static_cast<int>(shape.levels.size()); ++level)
    for (std::size_t q = 0; q < shape.quads.size(); ++q)
    {
      Block block;
      block.name = "b" + std::to_string(layout.blocks.size());
      block.region = shape.body[q] && level < shape.tip ? "body" : "fluid";
      block.shape = element::Shape::hexahedron;
      for (const auto& r : element::corners(element::Shape::hexahedron))
      {
        const int u = r[0] == 1.0 ? 1 : 0;
        block.points.push_back((level + (r[1] == 1.0 ? 1 : 0)) * width +
                               shape.quads[q][r[2] == 1.0 ? 3 - u : u]);
      }
      layout.blocks.push_back(block);
    }
  const auto boundary = [&](const char* name, int axis)
  {
    const char letter = "xyz"[axis];
    const std::string condition = std::string(1, letter) + " = " + std::to_string(shape.low[axis]) + " or " +
                                  std::string(1, letter) + " = " + std::to_string(shape.high[axis]);
    layout.boundaries.push_back({name, ByCondition{Condition(condition, {})}, {}});
  };
  boundary("ends", 0);
  boundary("floor and lid", 1);
  boundary("sides", 2);
  for (std::size_t level = 0; level < shape.levels.size(); ++level)
    for (const auto& [a, b] : shape.arcs)
      layout.edges.push_back(
          {static_cast<int>(level) * width + a,
           static_cast<int>(level) * width + b,
           geometry::Arc{.center = {shape.middle[0], shape.levels[level], shape.middle[1]}},
           {},
           {},
           {}});
  return layout;
}

CornerParameters sliding(CornerRule rule, std::vector<std::string> names)
{
  CornerParameters parameters;
  parameters.rule = rule;
  parameters.slide = std::move(names);
  return parameters;
}

/// A sample of a displaced coarse block.
Vector3 displaced(const CornerGraph& graph, const CoarseBlock& block, const CornerSamples& samples, int s,
                  const std::vector<double>& U, const std::vector<double>& d)
{
  Vector3 x = Vector3::Zero();
  for (int i = 0; i < graph.dim; ++i)
  {
    x[i] = block.x[graph.dim * s + i];
    for (int c = 0; c < samples.corner_count; ++c)
      x[i] += samples.basis[s * samples.corner_count + c] * U[graph.dim * block.corners[c] + i];
    for (const CoarseBlock::Bend& term : block.bends)
      if (term.sample == s)
        x[i] += term.share.weight * d[graph.dim * term.share.node + i];
  }
  return x;
}

/// Moves a mesh of one cell per block, whose nodes are the samples, by random displacements of its interface.
void check_nodes_are_samples(const Layout& layout, const char* body, const std::vector<std::string>& slide)
{
  const Skeleton skeleton = make_skeleton(layout);
  const std::vector<std::int64_t> interface = interface_nodes(layout, skeleton, "fluid", body);
  CornerMotion corners =
      corner_motion(layout, skeleton, "fluid", interface, sliding(CornerRule::radial, slide));
  const CornerGraph graph = corners.graph();
  REQUIRE(graph.degree == layout.order);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> small(-0.02, 0.02);
  std::vector<double> d(graph.dim * interface.size());
  for (double& value : d)
    value = small(random);
  std::vector<double> U(graph.dim * graph.corners.size());
  corners.follow(d, U);
  SkeletonMotion motion(skeleton, interface, std::move(corners));
  std::vector<double> skeleton_x(skeleton.x.size());
  motion.move(d, skeleton_x);
  const Connected connected = connect(layout, skeleton, "fluid", {});
  std::vector<double> x(graph.dim * connected.mesh.node_count());
  place(connected.plan, skeleton_x, x);

  const CornerSamples samples = corner_samples(graph.blocks[0].shape, graph.degree);
  const int n = graph.degree + 1;
  std::size_t at = 0;
  double worst = 0.0;
  for (std::size_t b = 0; b < layout.blocks.size(); ++b)
  {
    if (layout.blocks[b].region != "fluid")
      continue;
    const CoarseBlock& block = graph.blocks[at++];
    const auto c = std::find(connected.mesh.cell_block.begin(), connected.mesh.cell_block.end(), b);
    const auto nodes = connected.mesh.cell(c - connected.mesh.cell_block.begin());
    for (int s = 0; s < samples.count; ++s)
    {
      // Samples have the last coordinate fastest, nodes the first.
      const int node = graph.dim == 2 ? s / n + n * (s % n) : s / (n * n) + n * (s / n % n) + n * n * (s % n);
      const Vector3 wanted = displaced(graph, block, samples, s, U, d);
      for (int i = 0; i < graph.dim; ++i)
        worst = std::max(worst, std::abs(x[graph.dim * nodes[node] + i] - wanted[i]));
    }
  }
  CHECK(worst < 1e-13);
}

}  // namespace

TEST_CASE(
    "the coarse blocks' map with its bends is the map that places the nodes, whatever the interface does")
{
  check_nodes_are_samples(FlagLayout(narrow_channel, 4, 1).layout, "flag", {"walls"});
  check_nodes_are_samples(layout_of(flap_on_floor(), 4, 1), "body", {"floor and lid", "sides"});
  check_nodes_are_samples(layout_of(rod_on_floor(), 4, 1), "body", {"ends", "floor and lid"});
}

TEST_CASE("coarse blocks in space are those of a construction from plain arrays")
{
  const Extrusion shape = flap_on_floor();
  Layout layout = layout_of(shape, 2, 3);
  layout.grade_towards.push_back({{"body"}, 0.02, {}});  // where the nodes are does not matter
  const Skeleton skeleton = make_skeleton(layout);
  const std::vector<std::int64_t> interface = interface_nodes(layout, skeleton, "fluid", "body");
  const CornerGraph graph = corner_graph(layout, skeleton, "fluid", interface,
                                         sliding(CornerRule::radial, {"floor and lid", "sides"}));
  const ExtrudedBlocks other(shape, graph.degree);
  REQUIRE(graph.blocks.size() == 98);
  REQUIRE(graph.corners.size() == other.graph.corners.size());
  CHECK(unknown_numbers(graph).back() == 240);  // corners3d.md, as the 98 blocks
  for (std::size_t c = 0; c < graph.corners.size(); ++c)
  {
    CHECK(graph.corners[c].freedom == other.graph.corners[c].freedom);
    CHECK(graph.corners[c].led.size() == other.graph.corners[c].led.size());
    for (int k = 0; k < graph.corners[c].freedom; ++k)
      for (int i = 0; i < 3; ++i)
        CHECK(std::abs(graph.corners[c].direction[k][i]) == other.graph.corners[c].direction[k][i]);
  }
  CHECK(graph.size == doctest::Approx(std::hypot(0.06, 0.5, 0.4)));
  CHECK(graph.thickness == doctest::Approx(2.0 * 0.012 / (2.0 * 0.2 + 2.0 * 0.03 + 0.024)));

  // A quadratic displacement is what it is on either set of points of the interface.
  const auto field = [](const Vector3& X)
  { return Vector3(X[1] * X[1], X[0] * X[2] - X[1], X[2] * X[1] + X[0] * X[0]); };
  std::vector<double> d;
  for (const std::int64_t node : interface)
  {
    const Vector3 u = field({skeleton.x[3 * node], skeleton.x[3 * node + 1], skeleton.x[3 * node + 2]});
    d.insert(d.end(), u.begin(), u.end());
  }
  std::vector<double> other_d;
  for (const Vector3& X : other.nodes)
  {
    const Vector3 u = field(X);
    other_d.insert(other_d.end(), u.begin(), u.end());
  }
  const CornerSamples samples = corner_samples(element::Shape::hexahedron, graph.degree);
  const std::vector<double> U(3 * graph.corners.size(), 0.0);
  double worst = 0.0;
  double distance = 0.0;
  for (std::size_t b = 0; b < graph.blocks.size(); ++b)
    for (int s = 0; s < samples.count; ++s)
    {
      const Vector3 mine = displaced(graph, graph.blocks[b], samples, s, U, d);
      const Vector3 wanted = displaced(other.graph, other.graph.blocks[b], samples, s, U, other_d);
      worst = std::max(worst, (mine - wanted).norm());
      distance =
          std::max(distance, std::abs(graph.blocks[b].distance[s] - other.graph.blocks[b].distance[s]));
    }
  CHECK(worst < 1e-13);
  CHECK(distance < 2e-2);  // the other one measures to points, up to 0.35 / 24 apart
}
