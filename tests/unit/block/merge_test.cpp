#include "block/merge.hpp"

#include "block/names.hpp"
#include "layouts.hpp"

#include <doctest/doctest.h>

#include <functional>

using namespace blockfsi;
using namespace blockfsi::block;
using namespace blockfsi::block::testing;

namespace
{

/// Two lattices of two blocks each, side by side; the right one begins at x = 2 + gap.
Layout two_pieces(double gap)
{
  Layout layout;
  layout.order = 2;
  layout.default_divisions = 2;
  for (const bool is_right : {false, true})
  {
    Lattice lattice;
    lattice.name = is_right ? "right" : "left";
    lattice.x = is_right ? std::vector{2.0 + gap, 3.0} : std::vector{0.0, 2.0};
    lattice.y = {2.0, 1.0, 0.0};
    lattice.draw = {"fluid", "fluid"};
    add(layout, lattice);
  }
  return layout;
}

/// The message of merging after entries for the common upper edge have been added to both pieces.
std::string message_after(const std::function<void(Edge&, Edge&)>& change)
{
  Layout layout = two_pieces(0.0);
  add_edge(layout, find_point(layout, "left x1 y0"), find_point(layout, "left x1 y1"));
  add_edge(layout, find_point(layout, "right x0 y1"), find_point(layout, "right x0 y0"));
  layout.edges[0].where = {"a.toml", 5, 1};
  layout.edges[1].where = {"a.toml", 6, 1};
  change(layout.edges[0], layout.edges[1]);
  return message_of([&] { merge(layout, 1e-9); });
}

}  // namespace

TEST_CASE("points of two pieces that coincide become one, and the pieces one mesh")
{
  Layout layout = two_pieces(1e-12);
  CHECK(layout.points.size() == 12);
  merge(layout, 1e-9);
  CHECK(layout.points.size() == 9);
  CHECK(find_point(layout, "left x1 y1") >= 0);
  close(layout);
  const Skeleton skeleton = make_skeleton(layout);
  const Connected all = connect(layout, skeleton, "", {});
  CHECK(all.mesh.node_count() == 9 * 9);
  CHECK(measure(all.mesh, place(all, skeleton)).area == doctest::Approx(6.0).epsilon(1e-14));
}

TEST_CASE("points farther apart than the tolerance stay apart")
{
  Layout layout = two_pieces(1e-6);
  merge(layout, 1e-9);
  CHECK(layout.points.size() == 12);
}

TEST_CASE("boundaries and hole edges follow their points")
{
  Layout layout = two_pieces(0.0);
  const int old = find_point(layout, "right x1 y0");
  layout.boundaries.push_back({"end", ByEdges{{{old, find_point(layout, "right x1 y1")}}}, {}});
  layout.hole_edges.push_back({"right", 1, old, find_point(layout, "right x0 y0")});
  merge(layout, 1e-9);
  const int renumbered = find_point(layout, "right x1 y0");
  CHECK(renumbered != old);
  CHECK(std::get<ByEdges>(layout.boundaries[0].rule).edges[0][0] == renumbered);
  CHECK(layout.hole_edges[0].a == renumbered);
  CHECK(layout.hole_edges[0].b == find_point(layout, "left x1 y0"));
}

TEST_CASE("what two pieces say of one edge is united, whatever its direction")
{
  Layout layout = two_pieces(0.0);
  const int top = find_point(layout, "left x1 y0");
  const int middle = find_point(layout, "left x1 y1");
  Edge& first = add_edge(layout, top, middle);
  first.divisions = 5;
  first.grading = FirstCell{0.1, false};
  Edge& second = add_edge(layout, find_point(layout, "right x0 y1"), find_point(layout, "right x0 y0"));
  second.curve = geometry::Through{{{2.2, 1.4, 0.0}}};
  merge(layout, 1e-9);
  REQUIRE(layout.edges.size() == 1);
  CHECK(layout.edges[0].a == middle);
  CHECK(layout.edges[0].b == top);
  CHECK(layout.edges[0].divisions == 5);
  CHECK(layout.edges[0].grading == Grading{FirstCell{0.1, true}});
  CHECK(std::holds_alternative<geometry::Through>(layout.edges[0].curve));
}

TEST_CASE("pieces that contradict each other are refused")
{
  const std::string begin =
      "a.toml:6:1: two pieces of the layout share the edge from 'left x1 y0' (2, 2) to 'left x1 "
      "y1' (2, 1) but give it different ";
  const std::string end = " (a.toml:5:1); let both agree or only one of them say it";
  CHECK(message_after(
            [](Edge& first, Edge& second)
            {
              first.divisions = 2;
              second.divisions = 3;
            }) == begin + "numbers of cells" + end);
  CHECK(message_after(
            [](Edge& first, Edge& second)
            {
              first.grading = FirstCell{0.1, false};
              second.grading = FirstCell{0.1, false};
            }) == begin + "gradings" + end);
  CHECK(message_after(
            [](Edge& first, Edge& second)
            {
              first.curve = geometry::Through{{{2.2, 1.4, 0.0}}};
              second.curve = geometry::Through{{{2.2, 1.5, 0.0}}};
            }) == begin + "curves" + end);
  CHECK(message_after(
            [](Edge& first, Edge& second)
            {
              first.grading = FirstCell{0.1, false};
              second.grading = FirstCell{0.1, true};
              first.curve = geometry::Through{{{2.2, 1.4, 0.0}}};
              second.curve = geometry::Through{{{2.2, 1.4, 0.0}}};
            }) == "");
}

TEST_CASE("points are found by their full names, or by short ones that are unique")
{
  const Layout layout = two_pieces(0.0);
  CHECK(find_point(layout, "right x0 y2") == 10);
  CHECK(message_of([&] { find_point(layout, "x0 y2"); }) ==
        "'x0 y2' may be any of the points 'left x0 y2', 'right x0 y2'; give the full name");
  CHECK(message_of([&] { find_point(layout, "left x0 y9"); }) ==
        "there is no point 'left x0 y9'; did you mean 'left x0 y0'?");
  CHECK(message_of([&] { find_point(layout, "nose"); }) == "there is no point 'nose'");
  Layout single;
  add(single, {"only", {0.0, 1.0}, {1.0, 0.0}, {"fluid"}, {}, {}, {}, {}, {}, {}, {}, {}});
  CHECK(find_point(single, "x1 y0") == 1);
}
