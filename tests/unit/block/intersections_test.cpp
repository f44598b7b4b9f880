#include "layouts.hpp"

#include "mesh/validity.hpp"

#include <doctest/doctest.h>

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
