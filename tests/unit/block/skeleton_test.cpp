#include "block/connect.hpp"

#include "layouts.hpp"

#include <doctest/doctest.h>

#include <functional>

using namespace blockfsi;
using namespace blockfsi::block;
using namespace blockfsi::block::testing;

namespace
{

/// A row of three unit squares, closed but for what `open` leaves out: points 0..3 below, 4..7 above.
Layout three_squares()
{
  Layout layout;
  layout.order = 2;
  layout.default_divisions = 4;
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 4; ++i)
      layout.points.push_back({"p" + std::to_string(i + 4 * j), {1.0 * i, 1.0 * j, 0.0}, {}});
  for (int i = 0; i < 3; ++i)
    layout.blocks.push_back(
        {"b" + std::to_string(i), "fluid", {i, i + 1, i + 5, i + 4}, {"a.toml", 10 + i, 1}});
  layout.boundaries.push_back({"wall", ByCondition{{"y = 0 or y = 1", {}}}, {"a.toml", 20, 1}});
  layout.boundaries.push_back({"ends", ByEdges{{{0, 4}, {3, 7}}}, {"a.toml", 21, 1}});
  return layout;
}

std::string message_after(const std::function<void(Layout&)>& change)
{
  Layout layout = three_squares();
  change(layout);
  return message_of([&] { make_skeleton(layout); });
}

const PlacedEdge& edge_between(const Skeleton& skeleton, int a, int b)
{
  const auto found = std::find_if(skeleton.edges.begin(), skeleton.edges.end(),
                                  [=](const PlacedEdge& edge)
                                  { return (edge.a == a && edge.b == b) || (edge.a == b && edge.b == a); });
  REQUIRE(found != skeleton.edges.end());
  return *found;
}

/// Length of the cell at an end of an edge relative to the edge.
double end_cell(const Skeleton& skeleton, int at, int to)
{
  const PlacedEdge& edge = edge_between(skeleton, at, to);
  if (edge.a == at)
    return skeleton.parameter[edge.first + skeleton.order - 1];
  return 1.0 - skeleton.parameter[edge.first + edge.count - skeleton.order];
}

}  // namespace

TEST_CASE("the sound layout of these tests is accepted")
{
  CHECK(message_after([](Layout&) {}) == "");
}

TEST_CASE("points, edges and blocks are numbered one after the other without gaps")
{
  const Layout layout = flap_layout(3);
  const Skeleton skeleton = make_skeleton(layout);
  std::int64_t next = skeleton.point_count;
  CHECK(next == static_cast<std::int64_t>(layout.points.size()));
  for (const PlacedEdge& edge : skeleton.edges)
  {
    CHECK(edge.first == next);
    CHECK(edge.count == edge.divisions * 3 - 1);
    next += edge.count;
  }
  CHECK(skeleton.count == next);
  CHECK(skeleton.block_first.size() == layout.blocks.size() + 1);
  CHECK(skeleton.block_first[0] == next);
  CHECK(skeleton.x.size() == 2u * skeleton.count);
}

TEST_CASE("division counts spread over opposite edges, across turned blocks and around rings")
{
  Layout row = three_squares();
  row.blocks[1].points = {6, 5, 1, 2};
  add_edge(row, 7, 3).divisions = 6;
  const Skeleton skeleton = make_skeleton(row);
  for (int i = 0; i < 4; ++i)
    CHECK(edge_between(skeleton, i, i + 4).divisions == 6);
  CHECK(edge_between(skeleton, 0, 1).divisions == 4);

  Layout closed = ring(0.5, 1.0, 1, 2, 5);
  add_edge(closed, 4, 5).divisions = 7;
  for (const PlacedEdge& edge : make_skeleton(closed).edges)
    CHECK(edge.divisions == (edge.b - edge.a == 1 && edge.a % 2 == 0 ? 7 : 2));
}

TEST_CASE("conflicting divisions name both edges, both counts, both places and the blocks between")
{
  CHECK(message_after(
            [](Layout& layout)
            {
              Edge& first = add_edge(layout, 0, 4);
              first.divisions = 8;
              first.where = {"a.toml", 30, 5};
              Edge& second = add_edge(layout, 7, 3);
              second.divisions = 10;
              second.where = {"a.toml", 31, 5};
            }) == "a.toml:31:5: the edge from 'p0' (0, 0) to 'p4' (0, 1) is divided into 8 cells "
                  "(a.toml:30:5) and the edge from "
                  "'p7' (3, 1) to 'p3' (3, 0) into 10 (a.toml:31:5), but they are opposite each other across "
                  "the blocks 'b0', "
                  "'b1' and 'b2', so both need the same number; change one of them or give only one");
}

TEST_CASE("missing and impossible division counts are refused")
{
  CHECK(
      message_after([](Layout& layout) { layout.default_divisions = 0; }) ==
      "a.toml:10:1: nobody says into how many cells the edge from 'p0' (0, 0) to 'p1' (1, 0) of the block "
      "'b0' and those that need the same number are divided; give one of them a number or a default for all");
  CHECK(message_after([](Layout& layout) { add_edge(layout, 0, 1).divisions = 0; }) ==
        "the edge from 'p0' (0, 0) to 'p1' (1, 0) is divided into 0 cells; it needs at least 1");
}

TEST_CASE("impossible orders, dimensions and empty layouts are refused")
{
  CHECK(message_after([](Layout& layout) { layout.order = 0; }) ==
        "the order of the mesh is 0; it must be 1 to 8");
  CHECK(message_after([](Layout& layout) { layout.order = 9; }) ==
        "the order of the mesh is 9; it must be 1 to 8");
  CHECK(message_after([](Layout& layout) { layout.dim = 4; }) ==
        "the layout has 4 dimensions; only 2 or 3 are possible");
  CHECK(message_after([](Layout& layout) { layout.blocks.clear(); }) ==
        "the layout has no blocks; draw a lattice or give single blocks");
}

TEST_CASE("wrong points and blocks are named")
{
  CHECK(message_after(
            [](Layout& layout) {
              layout.points.push_back({"lost", {5.0, 5.0, 0.0}, {"a.toml", 3, 1}});
            }) == "a.toml:3:1: the point 'lost' (5, 5) is used by no block; use it or remove it");
  CHECK(message_after(
            [](Layout& layout) {
              layout.blocks[1].points = {1, 5, 6, 2};
            }) == "a.toml:11:1: the block 'b1' is inside out: its points run clockwise; list them "
                  "counter-clockwise, that is "
                  "'p1' (1, 0), 'p2' (2, 0), 'p6' (2, 1), 'p5' (1, 1)");
  CHECK(message_after(
            [](Layout& layout) {
              layout.points[1].x = {2.0, 2.0, 0.0};
            }) == "a.toml:10:1: the block 'b0' is inside out at its corner 'p5' (1, 1): the angle there must "
                  "be between 0 and "
                  "180 degrees; move or reorder its points");
  CHECK(message_after(
            [](Layout& layout)
            {
              layout.points.push_back({"top", {1.5, 2.0, 0.0}, {}});
              layout.points.push_back({"far", {1.0, 3.0, 0.0}, {}});
              layout.blocks.push_back({"extra", "fluid", {1, 2, 8, 9}, {"a.toml", 13, 1}});
            }) == "a.toml:13:1: the blocks 'b1' and 'extra' lie on the same side of their common edge from "
                  "'p1' (1, 0) to 'p2' "
                  "(2, 0), so they overlap; remove or reorder one of them");
  CHECK(message_after(
            [](Layout& layout)
            {
              layout.points.push_back({"q0", {3.0, 0.5, 0.0}, {}});
              layout.points.push_back({"q1", {2.5, 2.0, 0.0}, {}});
              layout.blocks.push_back({"extra", "fluid", {1, 8, 9, 5}, {"a.toml", 13, 1}});
            }) == "a.toml:13:1: the edge from 'p1' (1, 0) to 'p5' (1, 1) is shared by three blocks, 'b0', "
                  "'b1' and 'extra'; at "
                  "most two can meet at an edge");
}

TEST_CASE("wrong entries for edges are named")
{
  CHECK(message_after(
            [](Layout& layout) {
              add_edge(layout, 0, 6).where = {"a.toml", 40, 1};
            }) == "a.toml:40:1: no block has an edge from 'p0' (0, 0) to 'p6' (2, 1); correct the points or "
                  "remove the entry");
  CHECK(message_after(
            [](Layout& layout)
            {
              add_edge(layout, 0, 1).where = {"a.toml", 40, 1};
              add_edge(layout, 1, 0).where = {"a.toml", 41, 1};
            }) == "a.toml:41:1: the edge from 'p1' (1, 0) to 'p0' (0, 0) is described twice, here and before "
                  "(a.toml:40:1); describe it once");
  CHECK(message_after([](Layout& layout) { add_edge(layout, 0, 1).curve = geometry::Arc{}; }) ==
        "the edge from 'p0' (0, 0) to 'p1' (1, 0): the arc's end points (0, 0) and (1, 0) are 0 m and 1 m "
        "away from "
        "its centre (0, 0); both must have the same distance, so correct the centre or an end point");
  CHECK(message_after(
            [](Layout& layout) {
              add_edge(layout, 0, 1).grading = FirstCell{1.5, false};
            }) == "the edge from 'p0' (0, 0) to 'p1' (1, 0): a cell of 1.5 m is asked for on an edge of 1 m; "
                  "it must be shorter "
                  "than the edge");
}

TEST_CASE("wrong boundaries are named")
{
  CHECK(message_after([](Layout& layout) { layout.boundaries.pop_back(); }) ==
        "a.toml:10:1: the outer edge from 'p0' (0, 0) to 'p4' (0, 1) of the block 'b0' belongs to no "
        "boundary (as do 1 "
        "others); add it to one, or join the blocks if there should be another beside it");
  CHECK(message_after(
            [](Layout& layout) {
              layout.boundaries.push_back({"top", ByCondition{{"y = 2", {}}}, {}});
            }) == "the boundary 'top': no outer edge lies on \"y = 2\": at least one edge must fulfil it "
                  "with all its nodes");
  CHECK(message_after(
            [](Layout& layout) {
              layout.boundaries.push_back({"top", ByCondition{{"y = 1", {}}}, {"a.toml", 22, 1}});
            }) == "a.toml:22:1: the boundary 'top': the edge from 'p4' (0, 1) to 'p5' (1, 1) belongs to the "
                  "boundary 'wall' "
                  "(a.toml:20:1) as well; an edge can belong to one boundary only");
  CHECK(message_after(
            [](Layout& layout) {
              layout.boundaries.push_back({"cut", ByEdges{{{1, 5}}}, {}});
            }) == "the boundary 'cut': the edge from 'p1' (1, 0) to 'p5' (1, 1) lies inside the region "
                  "'fluid', between the "
                  "blocks 'b0' and 'b1'; a boundary can only lie where a region ends");
  CHECK(message_after(
            [](Layout& layout) {
              layout.boundaries.push_back({"cut", ByEdges{{{0, 5}}}, {}});
            }) == "the boundary 'cut': no block has an edge from 'p0' (0, 0) to 'p5' (1, 1)");
  CHECK(message_after(
            [](Layout& layout) {
              layout.boundaries.push_back({"none", ByEdges{}, {}});
            }) == "the boundary 'none': it lists no edges; list at least one or remove the boundary");
  CHECK(message_after(
            [](Layout& layout) {
              layout.boundaries.push_back({"hole", ByHole{"chanel", 1}, {}});
            }) == "the boundary 'hole': no lattice 'chanel' with holes exists");
  CHECK(message_after(
            [](Layout& layout)
            {
              layout.hole_edges.push_back({"channel", 1, 0, 1});
              layout.boundaries.push_back({"hole", ByHole{"chanel", 1}, {}});
            }) == "the boundary 'hole': no lattice 'chanel' with holes exists; did you mean 'channel'?");
  CHECK(message_after(
            [](Layout& layout)
            {
              layout.hole_edges.push_back({"channel", 1, 0, 1});
              layout.boundaries.push_back({"hole", ByHole{"channel", 2}, {}});
            }) ==
        "the boundary 'hole': the lattice 'channel' has no hole 2; its holes are numbered from 1 to 1");
  CHECK(message_after([](Layout& layout) { layout.boundaries[1].name = "wall"; }) ==
        "a.toml:21:1: the boundary 'wall': a boundary of this name exists already (a.toml:20:1); choose "
        "another");
  CHECK(message_after([](Layout& layout) { layout.boundaries[1].name = "interface"; }) ==
        "a.toml:21:1: the boundary 'interface': this name is reserved for the sides between two regions; "
        "choose "
        "another");
}

TEST_CASE("an edge between two regions needs no boundary but may have one")
{
  CHECK(message_after([](Layout& layout) { layout.blocks[2].region = "solid"; }) == "");
  CHECK(message_after(
            [](Layout& layout)
            {
              layout.blocks[2].region = "solid";
              layout.boundaries.push_back({"contact", ByEdges{{{2, 6}}}, {}});
            }) == "");
}

TEST_CASE("a condition is tested at all nodes of an edge, not at its ends only")
{
  // The lower side bulges; its ends still lie on y = 0.
  CHECK(
      message_after(
          [](Layout& layout) {
            add_edge(layout, 1, 2).curve = geometry::Through{{{1.5, -0.2, 0.0}}};
          })
          .find("the outer edge from 'p1' (1, 0) to 'p2' (2, 0) of the block 'b1' belongs to no boundary;") !=
      std::string::npos);
}

TEST_CASE("a grading towards a boundary holds at one end or at both and reaches the whole strip")
{
  Layout layout = three_squares();
  layout.grade_towards.push_back({{"wall"}, 0.05, {}});
  const Skeleton both = make_skeleton(layout);
  for (int i = 0; i < 4; ++i)
  {
    CHECK(end_cell(both, i, i + 4) == doctest::Approx(0.05).epsilon(1e-9));
    CHECK(end_cell(both, i + 4, i) == doctest::Approx(0.05).epsilon(1e-9));
  }
  CHECK(end_cell(both, 0, 1) == doctest::Approx(0.25));

  layout.boundaries[0].rule = ByCondition{{"y = 0", {}}};
  layout.boundaries.push_back({"lid", ByCondition{{"y = 1", {}}}, {}});
  const Skeleton one = make_skeleton(layout);
  for (int i = 0; i < 4; ++i)
  {
    CHECK(end_cell(one, i, i + 4) == doctest::Approx(0.05).epsilon(1e-9));
    CHECK(end_cell(one, i + 4, i) > 0.25);
  }
}

TEST_CASE("the smallest relative size in a strip wins, whatever way its edges run")
{
  Layout layout = three_squares();
  layout.boundaries[0].rule = ByCondition{{"y = 0", {}}};
  layout.boundaries.push_back({"lid", ByEdges{{{4, 5}, {5, 6}, {6, 7}}}, {}});
  layout.points[6].x[1] = 2.0;
  layout.blocks[1].points = {6, 5, 1, 2};
  layout.grade_towards.push_back({{"wall"}, 0.05, {}});
  const Skeleton skeleton = make_skeleton(layout);
  for (int i = 0; i < 4; ++i)
    CHECK(end_cell(skeleton, i, i + 4) == doctest::Approx(0.025).epsilon(1e-9));
}

TEST_CASE("an edge's own grading is kept, and its strip follows the others")
{
  Layout layout = three_squares();
  layout.boundaries[0].rule = ByCondition{{"y = 0", {}}};
  layout.boundaries.push_back({"lid", ByCondition{{"y = 1", {}}}, {}});
  layout.grade_towards.push_back({{"wall"}, 0.05, {}});
  add_edge(layout, 6, 2).grading = Uniform{};
  const Skeleton skeleton = make_skeleton(layout);
  CHECK(end_cell(skeleton, 1, 5) == doctest::Approx(0.05).epsilon(1e-9));
  CHECK(end_cell(skeleton, 2, 6) == doctest::Approx(0.25));
}

TEST_CASE("a grading towards a region acts outside it and never coarsens")
{
  Layout layout = three_squares();
  layout.blocks[1].region = "solid";
  layout.grade_towards.push_back({{"solid"}, 0.1, {}});
  const Skeleton skeleton = make_skeleton(layout);
  CHECK(end_cell(skeleton, 1, 0) == doctest::Approx(0.1).epsilon(1e-9));
  CHECK(end_cell(skeleton, 2, 3) == doctest::Approx(0.1).epsilon(1e-9));
  CHECK(end_cell(skeleton, 1, 2) == doctest::Approx(0.25));
  layout.grade_towards[0].first = 0.4;
  CHECK(end_cell(make_skeleton(layout), 1, 0) == doctest::Approx(0.25));
}

TEST_CASE("gradings towards unknown names and of no size are refused")
{
  CHECK(message_after(
            [](Layout& layout) {
              layout.grade_towards.push_back({{"wal"}, 0.1, {"a.toml", 9, 9}});
            }) == "a.toml:9:9: the grading goes towards 'wal', which is neither a boundary nor a region; "
                  "known are wall, ends, "
                  "fluid; did you mean 'wall'?");
  CHECK(message_after(
            [](Layout& layout) {
              layout.grade_towards.push_back({{"wall"}, 0.0, {"a.toml", 9, 9}});
            }) == "a.toml:9:9: the first cell of the grading has a size of 0 m; it must be positive");
}
