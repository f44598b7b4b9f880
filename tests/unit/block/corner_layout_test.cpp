#include "block/corner_layout.hpp"

#include "flag.hpp"
#include "layouts.hpp"

#include <doctest/doctest.h>

using namespace blockfsi;
using namespace blockfsi::block;
using namespace blockfsi::block::testing;

namespace
{

/// The coarse blocks of the fluid around a flag, and what they were made from.
struct Parts
{
  explicit Parts(const CornerParameters& parameters, int order = 3)
      : layout(FlagLayout(narrow_channel, order, 4).layout), skeleton(make_skeleton(layout)),
        interface(interface_nodes(layout, skeleton, "fluid", "flag")),
        graph(corner_graph(layout, skeleton, "fluid", interface, parameters))
  {
  }
  const Corner& corner(const std::string& name) const
  {
    for (std::size_t p = 0; p < layout.points.size(); ++p)
      if (layout.points[p].name == name)
        return graph.corners[p];
    throw Error("no point " + name);
  }
  int number(const std::string& name) const { return static_cast<int>(&corner(name) - graph.corners.data()); }

  Layout layout;
  Skeleton skeleton;
  std::vector<std::int64_t> interface;
  CornerGraph graph;
};

CornerParameters sliding(std::vector<std::string> names)
{
  CornerParameters parameters;
  parameters.slide = std::move(names);
  return parameters;
}

}  // namespace

TEST_CASE("corners on the interface are led by it, inside they are free, on walls they slide, elsewhere stay")
{
  const Parts parts(sliding({"walls"}));
  CHECK(parts.graph.blocks.size() == 24);
  CHECK(unknown_numbers(parts.graph).back() == 28);  // formulation.md chapter 9
  for (const char* name : {"ft", "fb", "tt", "tb", "rt", "rb"})
  {
    CHECK(parts.corner(name).freedom == 0);
    CHECK(parts.corner(name).led.size() == 1);
  }
  CHECK(parts.corner("b1").freedom == 2);
  CHECK(parts.corner("b0").freedom == 1);
  CHECK(std::abs(parts.corner("b0").direction[0][0]) == 1.0);
  for (const char* name : {"i0", "i1", "o3", "o5", "c135", "c45"})
  {
    CHECK(parts.corner(name).freedom == 0);
    CHECK(parts.corner(name).led.empty());
  }
  CHECK(Parts(sliding({})).corner("b0").freedom == 0);
  // Where two boundaries meet, one that does not slide holds the corner; where they make an angle, both do.
  CHECK(Parts(sliding({"walls", "inlet", "outlet"})).corner("i0").freedom == 0);
  CHECK(Parts(sliding({"inlet"})).corner("i1").freedom == 1);
  CHECK(Parts(sliding({"cylinder"})).corner("c135").freedom == 0);  // it is curved
}

TEST_CASE("the thickness is that of the flag, the size is its length")
{
  const Parts parts(sliding({}));
  CHECK(parts.graph.size == doctest::Approx(0.4 - std::sqrt(0.0024)).epsilon(0.01));
  CHECK(parts.graph.thickness == doctest::Approx(0.02).epsilon(0.05));
}

TEST_CASE("samples of a block lie on its curved sides, and bends carry the shape of the interface")
{
  for (const int order : {1, 4})
  {
    const Parts parts(sliding({}), order);
    const CornerSamples samples = corner_samples(element::Shape::quadrilateral, parts.graph.degree);
    const CoarseBlock& block = parts.graph.blocks[3];  // between the corners on the cylinder and the box
    for (int s = 0; s < samples.count; ++s)
      if (samples.point[s][0] == 1.0)
        CHECK(std::hypot(block.x[2 * s], block.x[2 * s + 1]) ==
              doctest::Approx(0.05).epsilon(order == 1 ? 0.03 : 1e-5));
    // Quadratic in the parameter along each edge of the interface: the bend is what it has beyond its ends.
    std::vector<double> d(2 * parts.interface.size());
    for (std::size_t k = 0; k < parts.interface.size(); ++k)
      d[2 * k + 1] = parts.skeleton.x[2 * parts.interface[k]] * parts.skeleton.x[2 * parts.interface[k]];
    const CoarseBlock& above = parts.graph.blocks[10];  // ft tt t2 r2
    REQUIRE_FALSE(above.bends.empty());
    std::vector<double> bend(samples.count, 0.0);
    for (const CoarseBlock::Bend& term : above.bends)
      bend[term.sample] += term.share.weight * d[2 * term.share.node + 1];
    for (int s = 0; s < samples.count; ++s)
    {
      const double u = samples.point[s][0];
      const double wanted = -(1.0 - samples.point[s][1]) * u * (1.0 - u) * 0.3 * 0.3;
      if (order == 1)
        CHECK(std::abs(bend[s] - wanted) < 0.003);
      else
        CHECK(bend[s] == doctest::Approx(wanted).epsilon(1e-12));
    }
  }
}

TEST_CASE("a corner led by one that finds its own place is refused")
{
  const Parts parts(sliding({"walls"}));
  const auto message = [&](const std::string& point, const std::string& leader, CornerRule rule)
  {
    CornerParameters parameters = sliding({"walls"});
    parameters.rule = rule;
    parameters.follows = {{parts.number(point), {{parts.number(leader), 1.0}}}};
    return message_of([&] { Parts{parameters}; });
  };
  CHECK(message("r2", "t2", CornerRule::elastic) ==
        "the point 'r2' follows 't2', which finds its own place; let it follow points of the interface");
  CHECK(message("r2", "t2", CornerRule::fixed).empty());
  CHECK(message("r2", "ft", CornerRule::elastic).empty());
}

TEST_CASE("a corner with a rule of the user is led by it, also on a boundary")
{
  const Parts plain(sliding({"walls"}));
  CornerParameters parameters = sliding({"walls"});
  parameters.follows = {{plain.number("t3"), {{plain.number("tt"), 0.5}}}, {plain.number("r2"), {}}};
  const Parts parts(parameters);
  CHECK(parts.corner("t3").freedom == 0);
  REQUIRE(parts.corner("t3").led.size() == 1);
  CHECK(parts.corner("t3").led[0].weight == 0.5);
  CHECK(parts.corner("r2").freedom == 0);
  CHECK(parts.corner("r2").led.empty());
}
