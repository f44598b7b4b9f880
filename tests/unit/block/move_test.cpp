#include "block/move.hpp"

#include "block/corner_layout.hpp"
#include "layouts.hpp"

#include <doctest/doctest.h>

using namespace blockfsi;
using namespace blockfsi::block;
using namespace blockfsi::block::testing;

namespace
{

/// Three unit squares in a row; points 0..3 below, 4..7 above; the interface is the edge from 1 to 5.
Layout row_of_squares(int order)
{
  Layout layout;
  layout.order = order;
  layout.default_divisions = 2;
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 4; ++i)
      layout.points.push_back({"p" + std::to_string(i + 4 * j), {1.0 * i, 1.0 * j, 0.0}, {}});
  for (int i = 0; i < 3; ++i)
    layout.blocks.push_back(
        {"b" + std::to_string(i), i == 0 ? "solid" : "fluid", {i, i + 1, i + 5, i + 4}, {}});
  close(layout);
  return layout;
}

/// Coordinates after the interface has moved by (0.1, 0) at point 1 and (0.3, 0) at point 5, linearly
/// between.
std::vector<double> moved(const Layout& layout, const Skeleton& skeleton, std::vector<Follow> rules)
{
  const std::vector<std::int64_t> interface = interface_nodes(layout, skeleton, "solid", "fluid");
  CornerParameters parameters;
  parameters.rule = CornerRule::fixed;
  parameters.follows = std::move(rules);
  SkeletonMotion motion(skeleton, interface, corner_motion(layout, skeleton, "fluid", interface, parameters));
  std::vector<double> displacement(2 * interface.size(), 0.0);
  for (std::size_t k = 0; k < interface.size(); ++k)
    displacement[2 * k] = 0.1 + 0.2 * skeleton.x[2 * interface[k] + 1];
  std::vector<double> x(skeleton.x.size());
  motion.move(displacement, x);
  return x;
}

}  // namespace

TEST_CASE("interface nodes move as told, edges that end there follow linearly, all others stay")
{
  for (const int order : {1, 3})
  {
    const Layout layout = row_of_squares(order);
    const Skeleton skeleton = make_skeleton(layout);
    const std::vector<double> x = moved(layout, skeleton, {});
    for (std::int64_t node = 0; node < skeleton.count; ++node)
    {
      const double X = skeleton.x[2 * node];
      const double y = skeleton.x[2 * node + 1];
      const double wanted = X <= 2.0 ? (0.1 + 0.2 * y) * (1.0 - std::abs(X - 1.0)) : 0.0;
      CHECK(x[2 * node] - X == doctest::Approx(wanted).epsilon(1e-14));
      CHECK(x[2 * node + 1] == y);
    }
  }
}

TEST_CASE("a corner follows the weighted sum of its leaders, through chains of rules")
{
  const Layout layout = row_of_squares(2);
  const Skeleton skeleton = make_skeleton(layout);
  // 2 follows half of 1 and a quarter of 5; 3 follows twice 2, which itself has a rule; 6 follows a fixed
  // point.
  const std::vector<double> x =
      moved(layout, skeleton, {{3, {{2, 2.0}}}, {2, {{1, 0.5}, {5, 0.25}}}, {6, {{0, 1.0}}}});
  CHECK(x[2 * 2] == doctest::Approx(2.0 + 0.5 * 0.1 + 0.25 * 0.3).epsilon(1e-15));
  CHECK(x[2 * 3] == doctest::Approx(3.0 + 2.0 * 0.125).epsilon(1e-15));
  CHECK(x[2 * 6] == 2.0);
}

TEST_CASE("without displacement the skeleton is the initial one bit for bit")
{
  const Layout layout = flap_layout(3);
  const Skeleton skeleton = make_skeleton(layout);
  const std::vector<std::int64_t> interface = interface_nodes(layout, skeleton, "fluid", "flap");
  for (const CornerRule rule :
       {CornerRule::fixed, CornerRule::radial, CornerRule::elastic, CornerRule::nonlinear})
  {
    CornerParameters parameters;
    parameters.rule = rule;
    SkeletonMotion motion(skeleton, interface,
                          corner_motion(layout, skeleton, "fluid", interface, parameters));
    std::vector<double> x(skeleton.x.size());
    motion.move(std::vector<double>(2 * interface.size(), 0.0), x);
    CHECK(x == skeleton.x);
  }
}

TEST_CASE("rules in a circle, rules for interface points and double rules are refused")
{
  const Layout layout = row_of_squares(1);
  const Skeleton skeleton = make_skeleton(layout);
  const auto message = [&](std::vector<Follow> rules)
  { return message_of([&] { moved(layout, skeleton, std::move(rules)); }); };
  CHECK(message({{2, {{1, 1.0}, {6, 1.0}}}, {6, {{7, 1.0}}}, {7, {{2, 1.0}}}}) ==
        "the rules that corners follow run in a circle: 'p2' follows 'p6' follows 'p7' follows 'p2'; let one "
        "of them "
        "follow a point of the interface");
  CHECK(message({{3, {{2, 1.0}}}, {2, {{2, 1.0}}}}) == "the rules that corners follow run in a circle: 'p2' "
                                                       "follows 'p2'; let one of them follow a point of the "
                                                       "interface");
  CHECK(message({{5, {{1, 1.0}}}}) ==
        "the point 'p5' lies on the interface and moves with it; remove its rule");
  CHECK(message({{2, {{1, 1.0}}}, {2, {{5, 1.0}}}}) ==
        "the point 'p2' has two rules; give it one with several leaders");
  CHECK(message({{2, {{99, 1.0}}}}) == "a rule names point 99, but the points are numbered from 0 to 7");
}
