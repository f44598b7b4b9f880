#include "block/resize.hpp"

#include "layouts.hpp"

#include <doctest/doctest.h>

using namespace blockfsi;
using namespace blockfsi::block;

namespace
{

Layout strip(std::optional<Grading> grading)
{
  Lattice lattice;
  lattice.name = "strip";
  lattice.x = {0.0, 1.0, 3.0};
  lattice.y = {1.0, 0.0};
  lattice.draw = {"a b"};
  lattice.divide_x = {4, 1};
  lattice.grade_x = {grading, std::nullopt};
  Layout layout;
  layout.order = 2;
  layout.default_divisions = 3;
  add(layout, lattice);
  testing::close(layout);
  return layout;
}

/// Cells along the edges of the first and of the second block, and across.
std::array<int, 3> counts(const Layout& layout)
{
  const Skeleton skeleton = make_skeleton(layout);
  const auto of = [&](int block, int edge)
  { return skeleton.edges[skeleton.block_edges[block][edge]].divisions; };
  return {of(0, 0), of(1, 0), of(0, 1)};
}

}  // namespace

TEST_CASE("resized blocks have so many times as many cells along each edge of their region, at least one")
{
  const Layout layout = strip({});
  CHECK(counts(resized(layout, "a", 2, 1.0)) == std::array{4, 1, 3});
  CHECK(counts(resized(layout, "a", 2, 2.0)) == std::array{8, 1, 6});
  CHECK(counts(resized(layout, "b", 2, 2.0)) == std::array{4, 2, 6});
  CHECK(counts(resized(layout, "a", 2, 0.1)) == std::array{1, 1, 1});
  CHECK(make_skeleton(resized(layout, "a", 5, 1.0)).order == 5);
}

TEST_CASE("a graded edge that is resized has a corner of its cells where it had one before")
{
  for (const Grading& grading : {Grading{Geometric{1.5}}, Grading{Uniform{}}, Grading{Cosine{}}})
  {
    const Layout layout = strip(grading);
    const Skeleton before = make_skeleton(layout);
    const Skeleton after = make_skeleton(resized(layout, "a", 2, 2.0));
    const PlacedEdge& coarse = before.edges[before.block_edges[0][0]];
    const PlacedEdge& fine = after.edges[after.block_edges[0][0]];
    REQUIRE(fine.divisions == 8);
    // Order 2: corners are every second node of the coarse edge, every fourth of the fine one.
    for (std::int64_t cell = 1; cell < 4; ++cell)
      CHECK(after.parameter[fine.first + 4 * cell - 1] ==
            doctest::Approx(before.parameter[coarse.first + 2 * cell - 1]).epsilon(1e-12));
  }
}

TEST_CASE("the first cell of a graded edge shrinks as the others do when it is resized")
{
  const Layout layout = strip(FirstCell{0.03});
  const Skeleton skeleton = make_skeleton(resized(layout, "a", 1, 3.0));
  const PlacedEdge& edge = skeleton.edges[skeleton.block_edges[0][0]];
  CHECK(edge.divisions == 12);
  const double first = skeleton.parameter[edge.first];
  const double last = 1.0 - skeleton.parameter[edge.first + edge.count - 1];
  CHECK(std::min(first, last) == doctest::Approx(0.01));
}

TEST_CASE("an edge whose cells are listed cannot be resized")
{
  const Layout layout = strip(Sizes{{1.0, 2.0, 2.0, 1.0}});
  CHECK_NOTHROW(resized(layout, "a", 3, 1.0));
  CHECK_NOTHROW(resized(layout, "b", 3, 1.0));
  CHECK_THROWS_WITH_AS(
      resized(layout, "a", 2, 2.0),
      "the cells of the edge from 'strip x0 y1' (0, 0) to 'strip x1 y1' (1, 0) are listed one "
      "by one, so they cannot become 8 where they are 4; grade it by a law",
      Error);
}
