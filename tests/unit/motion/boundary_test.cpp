#include "motion/boundary.hpp"

#include "block/connect.hpp"
#include "block/lattice.hpp"
#include "block/place.hpp"
#include "core/part.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace blockfsi;

TEST_CASE("distances are those to the lines of the interface and to the nearest point")
{
  block::Layout layout;
  layout.order = 2;
  block::Lattice lattice;
  lattice.name = "box";
  lattice.x = {0.0, 1.0, 2.0, 3.0};
  lattice.y = {3.0, 2.0, 1.0, 0.0};
  lattice.draw = {"fluid fluid fluid", "fluid flap fluid", "fluid fluid fluid"};
  lattice.divide_x = {1, 1, 1};
  lattice.divide_y = {1, 1, 1};
  block::add(layout, lattice);
  layout.boundaries.push_back({"outside", block::ByCondition{Condition("x > -1", {})}, {}});
  const block::Skeleton skeleton = block::make_skeleton(layout);
  const std::vector<std::int64_t> interface = block::interface_nodes(layout, skeleton, "fluid", "flap");
  const std::vector<double> x = {0.0, 1.2, 1.3, 3.0, 0.0, 0.0, 1.0, 1.7, 2.5, 2.5};
  const std::vector<double> distance = motion::distance_to_interface(skeleton, interface, x);
  const std::vector<double> expected = {1.0, 1.0, std::sqrt(2.0), 0.0, std::sqrt(0.5)};
  for (std::size_t i = 0; i < expected.size(); ++i)
    CHECK(distance[i] == doctest::Approx(expected[i]));
  const std::vector<std::array<double, 3>> points = {{0.0, 0.0, 0.0}, {3.0, 3.0, 0.0}};
  const std::vector<double> to_points = motion::distance_to_points(points, x);
  CHECK(to_points[2] == 0.0);
  CHECK(to_points[4] == doctest::Approx(std::sqrt(0.5)));
  CHECK(std::isinf(motion::distance_to_points({}, x)[0]));
}
