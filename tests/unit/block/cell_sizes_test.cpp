#include "block/cell_sizes.hpp"

#include "layouts.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace blockfsi;
using namespace blockfsi::block;
using namespace blockfsi::block::testing;

TEST_CASE("sizes of cells are told per edge with the largest ratio of neighbours")
{
  Layout layout = one_block({{{0.0, 0.0}, {3.0, 0.0}, {3.0, 1.0}, {0.0, 1.0}}}, 3, 3);
  add_edge(layout, 1, 0).grading = Sizes{{2.0, 3.0, 1.0}};
  const std::vector<CellSizes> edges = cell_sizes(make_skeleton(layout));
  REQUIRE(edges.size() == 4);
  const std::string name = layout.points[1].name + " - " + layout.points[0].name;
  const auto graded =
      std::find_if(edges.begin(), edges.end(), [&](const CellSizes& cells) { return cells.edge == name; });
  REQUIRE(graded != edges.end());
  CHECK(graded->count == 3);
  CHECK(graded->first == doctest::Approx(1.0).epsilon(1e-14));
  CHECK(graded->last == doctest::Approx(0.5).epsilon(1e-14));
  CHECK(graded->smallest == doctest::Approx(0.5).epsilon(1e-14));
  CHECK(graded->largest == doctest::Approx(1.5).epsilon(1e-14));
  CHECK(graded->ratio == doctest::Approx(3.0).epsilon(1e-14));
  for (const CellSizes& cells : edges)
    if (cells.edge != name)
      CHECK(cells.ratio == doctest::Approx(1.0).epsilon(1e-14));
}

TEST_CASE("the table of sizes has a line per edge in columns")
{
  CHECK(
      table({{"a - b", 4, 0.25, 0.5, 0.25, 0.5, 1.25}, {"left - right", 10, 1e-3, 1e-3, 1e-3, 1e-3, 1.0}}) ==
      "edge           cells    first [m]     last [m]  largest ratio\n"
      "a - b              4         0.25          0.5          1.250\n"
      "left - right      10        0.001        0.001          1.000\n");
}
