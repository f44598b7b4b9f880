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
  const auto of = [&](int block, int edge) { return skeleton.edges[skeleton.block_edges[block][edge]].divisions; };
  return {of(0, 0), of(1, 0), of(0, 1)};
}

}  // namespace

TEST_CASE("resized blocks have so many times as many cells along each edge, at least one")
{
  const Layout layout = strip({});
  CHECK(counts(resized(layout, 2, 1.0)) == std::array{4, 1, 3});
  CHECK(counts(resized(layout, 2, 2.0)) == std::array{8, 2, 6});
  CHECK(counts(resized(layout, 2, 0.3)) == std::array{1, 1, 1});
  CHECK(make_skeleton(resized(layout, 5, 1.0)).order == 5);
}

TEST_CASE("a graded edge keeps the size of its first cell when it is resized")
{
  const Layout layout = strip(FirstCell{0.02});
  const Skeleton skeleton = make_skeleton(resized(layout, 1, 3.0));
  const PlacedEdge& edge = skeleton.edges[skeleton.block_edges[0][0]];
  CHECK(edge.divisions == 12);
  const double t = skeleton.parameter[edge.first];
  CHECK(std::min(t, 1.0 - skeleton.parameter[edge.first + edge.count - 1]) == doctest::Approx(0.02));
}

TEST_CASE("an edge whose cells are listed cannot be resized")
{
  const Layout layout = strip(Sizes{{1.0, 2.0, 2.0, 1.0}});
  CHECK_NOTHROW(resized(layout, 3, 1.0));
  CHECK_THROWS_WITH_AS(resized(layout, 2, 2.0),
                       "the cells of the edge strip x0 y0 - strip x1 y0 are listed one by one, so there cannot "
                       "be 2 times as many; grade it by a law",
                       Error);
}
