#include "block/corners.hpp"

#include "layouts.hpp"

#include <doctest/doctest.h>

#include <numeric>

using namespace blockfsi;
using namespace blockfsi::block;
using namespace blockfsi::block::testing;

namespace
{

/// A flap 1 long and 0.04 thick in a box, with free corners around it: the lattice that a user would draw
/// first.
Layout flap_in_a_box()
{
  Lattice lattice;
  lattice.name = "box";
  lattice.x = {0.0, 1.0, 1.4, 3.0};
  lattice.y = {0.0, 0.6, 0.98, 1.02, 1.4, 2.0};
  lattice.draw = {"fluid fluid fluid", "fluid fluid fluid", "flap fluid fluid", "fluid fluid fluid",
                  "fluid fluid fluid"};
  lattice.divide_x = {6, 4, 4};
  lattice.divide_y = {4, 4, 1, 4, 4};
  Layout layout;
  layout.order = 2;
  add(layout, lattice);
  close(layout);
  return layout;
}

/// Least Jacobian at the corners of cells, relative to the start, when the flap bends with constant curvature
/// so that its tip turns by an angle.
double least_change(double angle, bool automatic)
{
  const Layout layout = flap_in_a_box();
  const Skeleton skeleton = make_skeleton(layout);
  const Connected connected = connect(layout, skeleton, "fluid", {});
  const std::vector<std::int64_t> interface = interface_nodes(layout, skeleton, "fluid", "flap");
  std::vector<double> displacement(2 * interface.size());
  for (std::size_t k = 0; k < interface.size(); ++k)
  {
    const double s = skeleton.x[2 * interface[k]];
    const double eta = skeleton.x[2 * interface[k] + 1] - 1.0;
    displacement[2 * k] = std::sin(angle * s) / angle - eta * std::sin(angle * s) - s;
    displacement[2 * k + 1] = (1.0 - std::cos(angle * s)) / angle + eta * std::cos(angle * s) - eta;
  }
  const SkeletonMotion motion(skeleton, interface,
                              automatic ? automatic_rules(layout, skeleton, interface, {})
                                        : std::vector<Follow>{});
  std::vector<double> skeleton_x(skeleton.x.size());
  motion.move(displacement, skeleton_x);
  std::vector<double> x(2 * connected.mesh.node_count());
  block::place(connected.plan, skeleton_x, x);
  double least = std::numeric_limits<double>::infinity();
  const int n = connected.mesh.order + 1;
  for (std::size_t c = 0; c < connected.mesh.cell_count(); ++c)
  {
    const auto nodes = connected.mesh.cell(c);
    const auto at = [&](int i, int j) {
      return std::array{x[2 * nodes[i + n * j]], x[2 * nodes[i + n * j] + 1]};
    };
    for (int i : {0, 1})
      for (int j : {0, 1})
      {
        const auto p = at(i, j);
        const auto q = at(i + 1, j);
        const auto r = at(i, j + 1);
        least = std::min(least, (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
      }
  }
  return least;
}

}  // namespace

TEST_CASE("radial weights reproduce linear displacements and the centres themselves")
{
  const std::vector<std::array<double, 2>> centres = {{0, 0}, {2, 0.1}, {0.3, 1.5}, {1.7, 1.4}, {0.9, 0.5}};
  for (const std::array<double, 2> x : {std::array{0.4, 0.2}, std::array{1.2, 1.1}, std::array{3.0, -1.0}})
  {
    const std::vector<double> weights = radial_weights(centres, x);
    double sum = 0.0;
    std::array<double, 2> place{};
    for (std::size_t i = 0; i < centres.size(); ++i)
    {
      sum += weights[i];
      for (int c = 0; c < 2; ++c)
        place[c] += weights[i] * centres[i][c];
    }
    CHECK(sum == doctest::Approx(1.0).epsilon(1e-12));
    CHECK(place[0] == doctest::Approx(x[0]).epsilon(1e-12));
    CHECK(place[1] == doctest::Approx(x[1]).epsilon(1e-12));
  }
  const std::vector<double> weights = radial_weights(centres, centres[3]);
  for (std::size_t i = 0; i < centres.size(); ++i)
    CHECK(weights[i] == doctest::Approx(i == 3 ? 1.0 : 0.0).epsilon(1e-12));
}

TEST_CASE("automatic corners keep a mesh valid where fixed corners fold it")
{
  CHECK(least_change(0.1, false) > 0.0);
  CHECK(least_change(0.1, true) > 0.0);
  // 60 degrees: the tip moves by half the length of the flap.
  CHECK(least_change(1.05, false) < 0.0);
  CHECK(least_change(1.05, true) > 0.0);
}

TEST_CASE("automatic rules leave corners alone that the user, the interface or a boundary moves")
{
  const Layout layout = flap_in_a_box();
  const Skeleton skeleton = make_skeleton(layout);
  const std::vector<std::int64_t> interface = interface_nodes(layout, skeleton, "fluid", "flap");
  const std::vector<Follow> all = automatic_rules(layout, skeleton, interface, {});
  CHECK(all.size() == 6);  // two columns of four inner points less the two on the tip
  const std::vector<Follow> user = {{all.front().point, {{static_cast<int>(interface.front()), 0.5}}}};
  const std::vector<Follow> others = automatic_rules(layout, skeleton, interface, user);
  CHECK(others.size() == 5);
  for (const Follow& rule : others)
    CHECK(rule.point != all.front().point);
}
