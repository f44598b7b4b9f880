#include "block/lattice.hpp"

#include "block/names.hpp"
#include "layouts.hpp"

#include <doctest/doctest.h>

#include <functional>

using namespace blockfsi;
using namespace blockfsi::block;
using namespace blockfsi::block::testing;

namespace
{

Lattice small_lattice()
{
  Lattice lattice;
  lattice.name = "l";
  lattice.x = {0.0, 1.0, 2.0, 4.0};
  lattice.y = {3.0, 2.0, 1.0, 0.0};
  lattice.draw = {"a a b", "a . b", "a a ."};
  lattice.where = {"a.toml", 7, 1};
  return lattice;
}

std::string message_after(const std::function<void(Lattice&)>& change)
{
  Lattice lattice = small_lattice();
  change(lattice);
  Layout layout;
  return message_of([&] { add(layout, lattice); });
}

const Edge* find_info(const Layout& layout, const char* a, const char* b)
{
  for (const Edge& edge : layout.edges)
    if ((edge.a == find_point(layout, a) && edge.b == find_point(layout, b)) ||
        (edge.b == find_point(layout, a) && edge.a == find_point(layout, b)))
      return &edge;
  return nullptr;
}

/// Turek & Hron's channel with a flap behind a cylinder, as the last paragraph of the case-file sketch draws
/// it.
Layout turek_layout(int order)
{
  const double root = 0.2 + std::sqrt(0.05 * 0.05 - 0.01 * 0.01);
  Lattice lattice;
  lattice.name = "channel";
  lattice.x = {0.0, 0.15, 0.25, 0.6, 1.0, 2.5};
  lattice.y = {0.41, 0.25, 0.21, 0.19, 0.15, 0.0};
  lattice.draw = {"fluid fluid fluid fluid fluid", "fluid . fluid fluid fluid", "fluid . flap fluid fluid",
                  "fluid . fluid fluid fluid", "fluid fluid fluid fluid fluid"};
  lattice.divide_x = {4, 4, 8, 4, 6};
  lattice.divide_y = {4, 2, 1, 2, 4};
  lattice.places = {{2, 2, {root, 0.21}}, {2, 3, {root, 0.19}}};
  lattice.circles = {{1, {0.2, 0.2}, 0.05}};
  Layout layout;
  layout.order = order;
  add(layout, lattice);
  layout.boundaries = {{"inlet", ByCondition{{"x = 0", {}}}, {}},
                       {"outlet", ByCondition{{"x = 2.5", {}}}, {}},
                       {"walls", ByCondition{{"y = 0 or y = 0.41", {}}}, {}},
                       {"cylinder", ByHole{"channel", 1}, {}}};
  layout.grade_towards = {{{"cylinder", "flap"}, 4e-3, {}}};
  return layout;
}

}  // namespace

TEST_CASE("a drawing becomes points, blocks in counter-clockwise order and numbered holes")
{
  Layout layout;
  add(layout, small_lattice());
  CHECK(layout.blocks.size() == 7);
  CHECK(layout.points.size() == 15);
  CHECK(layout.points[find_point(layout, "l x2 y1")].x == geometry::Point{2.0, 2.0, 0.0});
  CHECK_THROWS_AS(find_point(layout, "l x3 y3"), Error);
  CHECK(layout.blocks[2].name == "block (2, 0) of l");
  CHECK(layout.blocks[2].region == "b");
  const std::vector<int> corners{find_point(layout, "x2 y1"), find_point(layout, "x3 y1"),
                                 find_point(layout, "x3 y0"), find_point(layout, "x2 y0")};
  CHECK(layout.blocks[2].points == corners);
  const auto of_hole = [&layout](int number)
  {
    return std::count_if(layout.hole_edges.begin(), layout.hole_edges.end(),
                         [number](const HoleEdge& edge) { return edge.number == number; });
  };
  CHECK(of_hole(1) == 4);
  CHECK(of_hole(2) == 2);
  CHECK(layout.edges.empty());
}

TEST_CASE("a drawing may start with its lowest row")
{
  Lattice lattice = small_lattice();
  lattice.y = {0.0, 1.0, 2.0, 3.0};
  lattice.divide_y = {2, 3, 4};
  lattice.grade_y = {Geometric{2.0}, std::nullopt, std::nullopt};
  Layout layout;
  layout.default_divisions = 2;
  add(layout, lattice);
  close(layout);
  const Skeleton skeleton = make_skeleton(layout);
  // 24 sides of a full lattice, less the two of the corner left out.
  CHECK(skeleton.edges.size() == 22);
  const Edge* lowest = find_info(layout, "x0 y0", "x0 y1");
  REQUIRE(lowest != nullptr);
  CHECK(*lowest->divisions == 2);
  CHECK(lowest->grading == Grading{Geometric{2.0}});
}

TEST_CASE("gradings point upwards also where the drawing starts with its top row")
{
  Lattice lattice = small_lattice();
  lattice.grade_y = {FirstCell{0.1, false}, std::nullopt, std::nullopt};
  lattice.grade_x = {FirstCell{0.2, false}, std::nullopt, std::nullopt};
  Layout layout;
  layout.order = 1;
  layout.default_divisions = 3;
  add(layout, lattice);
  close(layout);
  const Skeleton skeleton = make_skeleton(layout);
  for (const PlacedEdge& edge : skeleton.edges)
  {
    const auto& a = layout.points[edge.a].x;
    const auto& b = layout.points[edge.b].x;
    double lowest = 1e300;
    for (std::int64_t node = edge.first; node < edge.first + edge.count; ++node)
      lowest = std::min(lowest, a[0] == b[0] ? skeleton.x[2 * node + 1] : skeleton.x[2 * node]);
    if (a[0] == b[0] && std::max(a[1], b[1]) == 3.0)
      CHECK(lowest == doctest::Approx(2.1).epsilon(1e-9));
    if (a[1] == b[1] && std::max(a[0], b[0]) == 1.0)
      CHECK(lowest == doctest::Approx(0.2).epsilon(1e-9));
  }
}

TEST_CASE("the points of a circular hole move radially onto it, its sides become arcs, given places stay")
{
  Lattice lattice = small_lattice();
  lattice.circles = {{1, {1.5, 1.5}, 0.6}};
  lattice.places = {{1, 1, {1.5 - 0.6 * 0.8, 1.5 + 0.6 * 0.6}}};
  Layout layout;
  layout.order = 4;
  layout.default_divisions = 2;
  add(layout, lattice);
  close(layout);
  CHECK(layout.points[find_point(layout, "x1 y1")].x ==
        geometry::Point{1.5 - 0.6 * 0.8, 1.5 + 0.6 * 0.6, 0.0});
  const double diagonal = 0.6 / std::sqrt(2.0);
  CHECK(layout.points[find_point(layout, "x2 y2")].x[0] == doctest::Approx(1.5 + diagonal).epsilon(1e-15));
  CHECK(layout.points[find_point(layout, "x2 y2")].x[1] == doctest::Approx(1.5 - diagonal).epsilon(1e-15));
  const Skeleton skeleton = make_skeleton(layout);
  int arc_nodes = 0;
  for (std::int64_t node = 0; node < skeleton.count; ++node)
    if (std::abs(std::hypot(skeleton.x[2 * node] - 1.5, skeleton.x[2 * node + 1] - 1.5) - 0.6) < 1e-14)
      ++arc_nodes;
  CHECK(arc_nodes == 4 * 8);
}

TEST_CASE("a given curve keeps its direction and turns the grading of its column")
{
  Lattice lattice = small_lattice();
  lattice.grade_x = {FirstCell{0.1, false}, std::nullopt, std::nullopt};
  lattice.curves = {{{1, 0}, {0, 0}, geometry::Through{{{0.7, 3.2, 0.0}}}}};
  Layout layout;
  layout.default_divisions = 3;
  add(layout, lattice);
  const Edge* edge = find_info(layout, "x0 y0", "x1 y0");
  REQUIRE(edge != nullptr);
  CHECK(edge->a == find_point(layout, "x1 y0"));
  CHECK(edge->grading == Grading{FirstCell{0.1, true}});
  CHECK(std::holds_alternative<geometry::Through>(edge->curve));
}

TEST_CASE("the flap's mesh has the size of the sketch and covers its area")
{
  const Layout layout = flap_layout(3);
  CHECK(layout.blocks.size() == 17);
  const Skeleton skeleton = make_skeleton(layout);
  const Connected all = connect(layout, skeleton, "", {});
  const Measure found = measure(all.mesh, place(all, skeleton));
  CHECK(found.area == doctest::Approx(0.195 * 0.12 - 0.01 * 0.01).epsilon(1e-13));
  CHECK(found.smallest > 0.0);
}

TEST_CASE("Turek and Hron's channel has positive Jacobians and the area of the channel without the cylinder")
{
  for (const int order : {1, 2, 4})
  {
    const Layout layout = turek_layout(order);
    const Skeleton skeleton = make_skeleton(layout);
    const Connected all = connect(layout, skeleton, "", {});
    const Measure found = measure(all.mesh, place(all, skeleton));
    CHECK(found.smallest > 0.0);
    const double exact = 2.5 * 0.41 - std::acos(-1.0) * 0.05 * 0.05;
    CHECK(found.area == doctest::Approx(exact).epsilon(order == 1 ? 1e-3 : order == 2 ? 1e-6 : 1e-12));
    const Connected flap = connect(layout, skeleton, "flap", {});
    CHECK(flap.mesh.boundaries.at("cylinder").size() == 1);
    CHECK(flap.mesh.boundaries.at("interface").size() == 8 + 1 + 8);
  }
}

TEST_CASE("drawings that do not fit their lists are refused")
{
  CHECK(message_after([](Lattice& lattice) { lattice.draw.pop_back(); }) ==
        "a.toml:7:1: the lattice 'l': 2 rows are drawn, but 4 y make 3 rows; draw one line for each");
  CHECK(message_after([](Lattice& lattice) { lattice.draw[1] = "a b"; }) ==
        "a.toml:7:1: the lattice 'l': line 2 of the drawing, \"a b\", has 2 words, but 4 x make 3 columns; "
        "write one "
        "word for each, '.' for a hole");
  CHECK(message_after([](Lattice& lattice) { lattice.x[1] = 2.0; }) ==
        "a.toml:7:1: the lattice 'l': the x are 0, 2, 2, 4; they must ascend");
  CHECK(message_after([](Lattice& lattice) { lattice.y[1] = 0.5; }) ==
        "a.toml:7:1: the lattice 'l': the y are 3, 0.5, 1, 0; they must descend (top row drawn first) or "
        "ascend");
  CHECK(message_after([](Lattice& lattice) { lattice.x = {1.0}; }) ==
        "a.toml:7:1: the lattice 'l': there are 1 x and 4 y; a lattice needs at least 2 of each");
  CHECK(message_after(
            [](Lattice& lattice) {
              lattice.divide_x = {1, 2};
            }) ==
        "a.toml:7:1: the lattice 'l': divide.x has 2 entries, but there are 3 columns; give one for each");
  CHECK(message_after([](Lattice& lattice) { lattice.grade_y.resize(4); }) ==
        "a.toml:7:1: the lattice 'l': grade.y has 4 entries, but there are 3 rows; give one for each");
  CHECK(message_after(
            [](Lattice& lattice) {
              lattice.draw = {". . .", ". . .", ". . ."};
            }) == "a.toml:7:1: the lattice 'l': the drawing has no block, only holes; write the name of a "
                  "region where a block "
                  "is");
}

TEST_CASE("places, circles and curves that the drawing does not have are refused")
{
  CHECK(message_after(
            [](Lattice& lattice) {
              lattice.places = {{3, 3, {0.0, 0.0}}};
            }) == "a.toml:7:1: the lattice 'l': there is no point x3 y3: x runs from 0 to 3, y from 0 to 3, "
                  "and the point must "
                  "be a corner of a block");
  CHECK(message_after(
            [](Lattice& lattice) {
              lattice.circles = {{3, {1.5, 1.5}, 0.6}};
            }) == "a.toml:7:1: the lattice 'l': a circle is given for hole 3, but the drawing has 2 hole(s)");
  CHECK(message_after(
            [](Lattice& lattice) {
              lattice.circles = {{1, {1.5, 1.5}, 0.0}};
            }) ==
        "a.toml:7:1: the lattice 'l': the circle of hole 1 has a radius of 0 m; it must be positive");
  CHECK(message_after(
            [](Lattice& lattice) {
              lattice.circles = {{1, {1.5, 1.5}, 1.0}, {1, {1.5, 1.5}, 0.6}};
            }) == "a.toml:7:1: the lattice 'l': hole 1 has two circles; give it one");
  CHECK(message_after(
            [](Lattice& lattice) {
              lattice.circles = {{1, {1.0, 1.0}, 0.6}};
            }) == "a.toml:7:1: the lattice 'l': the point x1 y2 sits at the centre of the circle, so it "
                  "cannot be moved onto it; "
                  "move the point or the centre");
  CHECK(message_after(
            [](Lattice& lattice) {
              lattice.curves = {{{0, 0}, {1, 1}, geometry::Segment{}}};
            }) ==
        "a.toml:7:1: the lattice 'l': a curve is given between x0 y0 and x1 y1, which is no side of a block");
  CHECK(message_after(
            [](Lattice& lattice) {
              lattice.curves = {{{0, 0}, {1, 0}, geometry::Segment{}}, {{1, 0}, {0, 0}, geometry::Segment{}}};
            }) == "a.toml:7:1: the lattice 'l': two curves are given between x0 y0 and x1 y0; give one");
}
