#include "block/sweep.hpp"

#include "block/merge.hpp"
#include "block/round.hpp"
#include "block/transform.hpp"
#include "core/error.hpp"
#include "layouts.hpp"
#include "measure.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace blockfsi::block;
namespace element = blockfsi::element;
using blockfsi::block::testing::empty;
using std::numbers::pi;

namespace
{

/// A quadrilateral (or, with three points, a triangle) of one block in the xy plane.
Layout polygon(const std::vector<std::array<double, 2>>& corners, int order)
{
  Layout layout = empty(3, order);
  Block block;
  block.name = "p block";
  block.region = "solid";
  block.shape = corners.size() == 3 ? element::Shape::triangle : element::Shape::quadrilateral;
  for (const auto& x : corners)
  {
    block.points.push_back(static_cast<int>(layout.points.size()));
    layout.points.push_back({"p " + std::to_string(layout.points.size()), {x[0], x[1], 0.0}, {}});
  }
  ByEdges all;
  for (std::size_t k = 0; k < corners.size(); ++k)
    all.edges.push_back({block.points[k], block.points[(k + 1) % corners.size()]});
  layout.boundaries.push_back({"p side", all, {}});
  layout.blocks.push_back(block);
  return layout;
}

}  // namespace

TEST_CASE("an extruded disc is a cylinder, whichever way it is drawn")
{
  Layout base = empty(3, 6);
  Disc disc;
  disc.name = "d";
  disc.region = "fluid";
  disc.radius = 0.5;
  add(base, disc);
  for (const double height : {2.0, -2.0})
  {
    Extrusion extrusion;
    extrusion.name = "pipe";
    extrusion.of = "d";
    extrusion.by = {0.0, 0.0, height};
    extrusion.divisions = 3;
    const sample::Made mesh = sample::make(extruded(base, extrusion));
    CHECK(sample::volume(mesh) == doctest::Approx(pi * 0.25 * 2.0).epsilon(1e-12));
    CHECK(sample::area(mesh, "pipe wall") == doctest::Approx(pi * 2.0).epsilon(1e-12));
    CHECK(sample::area(mesh, "pipe first") == doctest::Approx(pi * 0.25).epsilon(1e-12));
  }
}

TEST_CASE("an extruded triangle is a prism")
{
  Extrusion extrusion;
  extrusion.name = "prism";
  extrusion.of = "p";
  extrusion.by = {0.3, 0.0, 1.5};
  const sample::Made mesh = sample::make(extruded(polygon({{0, 0}, {2, 0}, {0, 1}}, 3), extrusion));
  CHECK(mesh.mesh.is_all(element::Shape::prism));
  CHECK(sample::volume(mesh) == doctest::Approx(1.5).epsilon(1e-13));
}

TEST_CASE("a revolved disc is a torus, with the area and the volume of Pappus")
{
  Layout base = empty(3, 6);
  Disc disc;
  disc.name = "d";
  disc.region = "fluid";
  disc.center = {2.0, 0.0, 0.0};
  disc.radius = 0.5;
  disc.around = 2;
  disc.radial = 2;
  add(base, disc);
  Revolution revolution;
  revolution.name = "torus";
  revolution.of = "d";
  revolution.around = 4;
  const sample::Made whole = sample::make(revolved(base, revolution));
  CHECK(sample::volume(whole) == doctest::Approx(2.0 * pi * 2.0 * pi * 0.25).epsilon(1e-9));
  CHECK(sample::area(whole, "torus wall") == doctest::Approx(4.0 * pi * pi * 2.0 * 0.5).epsilon(1e-8));
  revolution.angle = 90.0;
  revolution.sectors = 1;
  const sample::Made quarter = sample::make(revolved(base, revolution));
  CHECK(sample::volume(quarter) == doctest::Approx(0.5 * pi * 2.0 * pi * 0.25).epsilon(1e-9));
  CHECK(sample::area(quarter, "torus last") == doctest::Approx(pi * 0.25).epsilon(1e-10));
}

TEST_CASE("a rectangle at the axis sweeps a cylinder of prisms")
{
  Revolution revolution;
  revolution.name = "rod";
  revolution.of = "p";
  revolution.around = 2;
  const sample::Made mesh =
      sample::make(revolved(polygon({{0, 0}, {0.5, 0}, {0.5, 3}, {0, 3}}, 6), revolution));
  CHECK(mesh.mesh.is_all(element::Shape::prism));
  CHECK(sample::volume(mesh) == doctest::Approx(0.75 * pi).epsilon(1e-7));
}

TEST_CASE("what cannot be swept is refused by name")
{
  Extrusion extrusion;
  extrusion.name = "e";
  extrusion.of = "p";
  extrusion.by = {1.0, 1.0, 0.0};
  const Layout square = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 2);
  CHECK_THROWS_WITH_AS(extruded(square, extrusion),
                       "'e': the vector (1, 1, 0) lies in the plane of 'p'; it must lead out of it",
                       blockfsi::Error);
  Revolution revolution;
  revolution.name = "r";
  revolution.of = "p";
  revolution.sectors = 2;
  CHECK_THROWS_WITH_AS(revolved(square, revolution),
                       "'r': 2 sectors turn by 180 degrees each; each must turn by less than 180",
                       blockfsi::Error);
  revolution.sectors = 4;
  CHECK_THROWS_AS(revolved(polygon({{0, 0}, {1, -1}, {1, 1}}, 2), revolution), blockfsi::Error);
}

TEST_CASE("moved and mirrored pieces keep volume and orientation, and take the new name")
{
  Layout base = empty(3, 4);
  Ball ball;
  ball.name = "b";
  ball.region = "solid";
  ball.center = {1.0, 0.0, 0.0};
  ball.around = 1;
  ball.radial = 1;
  add(base, ball);
  const double volume = sample::volume(sample::make(base));
  for (const Affine& map :
       {translation({1, 2, 3}), rotation({1, 1, 0}, {1, 2, 2}, 0.7), reflection({0, 0, 0}, {1, 1, 0})})
  {
    const Layout moved = transformed(base, map, "b", "c");
    CHECK(moved.points[0].name.starts_with("c core"));
    CHECK(moved.boundaries[0].name == "c wall");
    const sample::Made mesh = sample::make(moved);
    CHECK(sample::volume(mesh) == doctest::Approx(volume).epsilon(1e-12));
    const auto back = inverse(map)(map({0.3, 0.4, 0.5}));
    CHECK(back[0] == doctest::Approx(0.3).epsilon(1e-14));
    CHECK(back[2] == doctest::Approx(0.5).epsilon(1e-14));
  }
}

TEST_CASE("boundaries of a piece give way to others and vanish inside")
{
  Layout layout = empty(3, 1);
  Box box;
  box.region = "solid";
  box.name = "left";
  box.to = {1, 1, 1};
  add(layout, box);
  Layout right = empty(3, 1);
  box.name = "right";
  box.from = {1, 0, 0};
  box.to = {2, 1, 1};
  add(right, box);
  append(layout, right);
  merge(layout, 1e-9);
  layout.boundaries.push_back({"floor", ByCondition{blockfsi::Condition("z = 0", {})}, {}});
  const sample::Made mesh = sample::make(layout);
  CHECK(sample::area(mesh, "floor") == doctest::Approx(2.0).epsilon(1e-14));
  CHECK(mesh.mesh.boundaries.count("left z0") == 0);
  CHECK(mesh.mesh.boundaries.count("left x1") == 0);
  CHECK(sample::area(mesh, "right x1") == doctest::Approx(1.0).epsilon(1e-14));
}

TEST_CASE("a moved curve is where the map takes the points of the curve")
{
  const blockfsi::geometry::Point a{1, 0, 0};
  const blockfsi::geometry::Point b{0, 1, 0};
  const blockfsi::geometry::Point opposite{-1, 0, 0};
  using blockfsi::geometry::Arc;
  const std::vector<std::pair<blockfsi::geometry::Curve, blockfsi::geometry::Point>> curves = {
      {Arc{{0, 0, 0}, false, {}}, b},
      {Arc{{0, 0, 0}, true, {}}, b},
      {Arc{{0, 0, 0}, false, blockfsi::geometry::Point{0, 0, 1}}, opposite}};
  for (const auto& [curve, end] : curves)
    for (const Affine& map :
         {translation({1, 2, 3}), rotation({1, 1, 0}, {1, 2, 2}, 0.7), reflection({0, 0, 0}, {1, 1, 0})})
      for (const double t : {0.25, 0.5, 0.75})
        CHECK(blockfsi::geometry::distance(
                  blockfsi::geometry::evaluate(moved(curve, a, end, map), map(a), map(end), t),
                  map(blockfsi::geometry::evaluate(curve, a, end, t))) < 1e-13);
}
