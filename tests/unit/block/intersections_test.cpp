#include "block/topology.hpp"
#include "layouts.hpp"
#include "mesh/validity.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace blockfsi;
using namespace blockfsi::block;
using namespace blockfsi::block::testing;

namespace
{

constexpr std::array<std::string_view, 1> along_curve{"t"};

geometry::Formula formula(const std::string& x, const std::string& y)
{
  return {{Expression(x, {}, along_curve), Expression(y, {}, along_curve), 0.0}};
}

/// The unit square turned about its first point by k |x|^2, its edges along.
Layout swirled_square(double k)
{
  const auto turned = [k](double x, double y) -> std::array<double, 2>
  {
    const double angle = k * (x * x + y * y);
    return {x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle)};
  };
  Layout layout = one_block({turned(0, 0), turned(1, 0), turned(1, 1), turned(0, 1)}, 4, 6);
  const auto edge = [&](int a, int b, double x0, double y0, double dx, double dy)
  {
    add_edge(layout, a, b).curve = geometry::Function{[=](double t) -> geometry::Point
                                                      {
                                                        const auto x = turned(x0 + t * dx, y0 + t * dy);
                                                        return {x[0], x[1], 0.0};
                                                      }};
  };
  edge(0, 1, 0, 0, 1, 0);
  edge(1, 2, 1, 0, 0, 1);
  edge(3, 2, 0, 1, 1, 0);
  edge(0, 3, 0, 0, 0, 1);
  return layout;
}

}  // namespace

TEST_CASE("a sound block with strongly curved edges is accepted, though its chords turn a corner inside out")
{
  const Layout layout = swirled_square(-0.85);
  Layout of_chords = layout;
  of_chords.edges.clear();
  CHECK(message_of([&] { make_skeleton(of_chords); }).find("inside out at its corner 'p1'") !=
        std::string::npos);
  const Skeleton skeleton = make_skeleton(layout);
  const Connected connected = connect(layout, skeleton, "", {});
  CHECK(mesh::certify(mesh::ValidityTables(connected.mesh), connected.mesh, place(connected, skeleton))
            .all_valid());
}

TEST_CASE("curved blocks that touch at their points only are no crossings")
{
  // Thin rings between circles: their pieces as polygons would cross.
  for (const double inner : {0.9, 0.99, 0.999, 0.9999})
    CHECK_NOTHROW(make_skeleton(ring(inner, 1.0, 3, 2, 3)));
}

TEST_CASE("edges that cross are named with the place, also far from where their polygons are looked at")
{
  Layout layout = unit_square(2, 2);
  add_edge(layout, 0, 1).curve = formula("t", "4 * 1.01 * t * (1 - t)");
  CHECK(message_of([&] { make_skeleton(layout); }) ==
        "the edges from 'p0' (0, 0) to 'p1' (1, 0) and from 'p3' (0, 1) to 'p2' (1, 1) cross at (0.45024814, "
        "1); move their points or change their curves");
  layout.edges[0].curve = formula("t", "4 * 0.99 * t * (1 - t)");
  CHECK_NOTHROW(make_skeleton(layout));
}

TEST_CASE("curves that cross by little, and far from where they are cut, are found")
{
  // Side 0 bulges into side 2 (y = 1) by so much, about t = 0.5 or elsewhere.
  for (const double depth : {1e-2, 1e-4, 1e-6, 1e-7})
    for (const std::string bump : {"4 * t * (1 - t)", "6.75 * t^2 * (1 - t)", "6.75 * t * (1 - t)^2"})
    {
      CAPTURE(depth);
      CAPTURE(bump);
      Layout layout = unit_square(2, 2);
      add_edge(layout, 0, 1).curve = formula("t", fmt::format("({:.17g})", 1.0 + depth) + " * " + bump);
      CHECK(message_of([&] { make_topology(layout); }).find("cross at (") != std::string::npos);
      layout.edges[0].curve = formula("t", fmt::format("({:.17g})", 1.0 - depth) + " * " + bump);
      CHECK_NOTHROW(make_topology(layout));
      // The other side bulges, too: the gap or the overlap is the same.
      add_edge(layout, 3, 2).curve = formula("t", "1 + 0.3 * t * (1 - t)");
      layout.edges[0].curve =
          formula("t", fmt::format("({:.17g})", 1.0 + depth) + " * " + bump + " + 0.3 * t * (1 - t)");
      CHECK(message_of([&] { make_topology(layout); }).find("cross at (") != std::string::npos);
      layout.edges[0].curve =
          formula("t", fmt::format("({:.17g})", 1.0 - depth) + " * " + bump + " + 0.3 * t * (1 - t)");
      CHECK_NOTHROW(make_topology(layout));
    }
}

TEST_CASE("curves that wind into each other are named where they cross first")
{
  Layout layout = unit_square(2, 2);
  add_edge(layout, 0, 1).curve = formula("t", "0.55 * sin(7 * pi * t)^2");
  add_edge(layout, 3, 2).curve = formula("t", "1 - 0.5 * sin(7 * pi * t)^2");
  const std::string told = message_of([&] { make_topology(layout); });
  CHECK(told.find("cross at (0.0") != std::string::npos);
  layout.edges[0].curve = formula("t", "0.4999999 * sin(7 * pi * t)^2");
  CHECK_NOTHROW(make_topology(layout));
}

TEST_CASE("curves that touch, or share a point and a tangent there, do not cross")
{
  Layout touching = unit_square(2, 2);
  add_edge(touching, 0, 1).curve = formula("t", "4 * t * (1 - t)");
  CHECK_NOTHROW(make_topology(touching));

  // Two blocks on either side of a cusp between sides that leave (0, 0) along the x axis.
  for (const double curvature : {1.0, 0.1, 1e-3})
  {
    Layout layout;
    layout.order = 2;
    layout.default_divisions = 2;
    layout.points = {{"cusp", {0, 0, 0}, {}},
                     {"up", {1, curvature, 0}, {}},
                     {"above", {0, 2, 0}, {}},
                     {"down", {1, -curvature, 0}, {}},
                     {"below", {0, -2, 0}, {}}};
    for (const auto& corners : {std::vector<int>{0, 1, 2}, std::vector<int>{0, 4, 3}})
      layout.blocks.push_back({"block", "fluid", corners, {}, element::Shape::triangle});
    add_edge(layout, 0, 1).curve = formula("t", fmt::format("({:.17g})", curvature) + " * t^2");
    add_edge(layout, 0, 3).curve = formula("t", fmt::format("({:.17g})", -curvature) + " * t^2");
    CAPTURE(curvature);
    CHECK(message_of([&] { make_topology(layout); }) == "");
  }
}

TEST_CASE("a point on a curve that does not end there is named")
{
  Layout layout = ring(1.0, 2.0, 2, 2);
  // A block beyond the ring with a corner on its outer circle.
  const int first = static_cast<int>(layout.points.size());
  const double angle = 0.7;
  for (const auto& [x, y] : {std::pair{2.0 * std::cos(angle), 2.0 * std::sin(angle)}, {5.0, 3.0}, {4.0, 6.0}})
    layout.points.push_back({"p" + std::to_string(layout.points.size()), {x, y, 0.0}, {}});
  layout.blocks.push_back({"fin", "fluid", {first, first + 1, first + 2}, {}, element::Shape::triangle});
  CHECK(message_of([&] { make_topology(layout); }).find("lies on the edge from 'outer") != std::string::npos);
  layout.points[first].x[0] += 1e-6;
  CHECK_NOTHROW(make_topology(layout));
}
