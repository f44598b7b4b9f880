#include "block/corner_rules.hpp"

#include "corner_graphs.hpp"

#include <doctest/doctest.h>

#include <functional>

using namespace blockfsi;
using namespace blockfsi::block;
using namespace blockfsi::block::testing;

namespace
{

/// Largest error of the free corners, where the others move by u.
template <typename Field>
double error(const CornerGraph& graph, const Eigen::MatrixXd& rule, Field u)
{
  Eigen::VectorXd U = Eigen::VectorXd::Zero(graph.corners.size() * graph.dim);
  const std::vector<int> unknowns = unknown_numbers(graph);
  Eigen::VectorXd wanted(unknowns.back());
  for (std::size_t c = 0; c < graph.corners.size(); ++c)
  {
    const Corner& corner = graph.corners[c];
    const std::array<double, 3> value = u(corner.x);
    for (int i = 0; i < graph.dim; ++i)
      U(c * graph.dim + i) = corner.freedom == 0 ? value[i] : 0.0;
    for (int k = 0; k < corner.freedom; ++k)
    {
      wanted(unknowns[c] + k) = 0.0;
      for (int i = 0; i < graph.dim; ++i)
        wanted(unknowns[c] + k) += corner.direction[k][i] * value[i];
    }
  }
  return (rule * U - wanted).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("the radial rule reproduces linear displacements in 2D and 3D, at inner corners of any valence")
{
  const auto linear = [](const std::array<double, 3>& x)
  {
    return std::array<double, 3>{0.3 - 0.2 * x[0] + 0.5 * x[1] + 0.1 * x[2], 0.1 * x[0] + 0.4 * x[1],
                                 0.7 * x[2] - 0.3 * x[0]};
  };
  std::vector<CornerGraph> graphs = {fan(3),  fan(4), fan(5), fan(6), fan(5, element::Shape::triangle),
                                     cubes(3)};
  for (const CornerGraph& graph : graphs)
    CHECK(error(graph, radial_rule(graph), linear) < 1e-12);
  // Elastic blocks weigh alike whatever their size, so that only translations are kept between unlike ones.
  CHECK(error(graphs.back(), elastic_rule(graphs.back()), linear) < 1e-12);
  for (const CornerGraph& graph : graphs)
    CHECK(error(graph, elastic_rule(graph),
                [](const auto&) {
                  return std::array<double, 3>{0.3, -0.2, 0.5};
                }) < 1e-12);
}

TEST_CASE("the radial rule reproduces linear displacements at a corner that slides, whatever its direction")
{
  CornerGraph graph = fan(5);
  graph.corners[3].freedom = 1;
  graph.corners[3].direction[0] = {0.6, 0.8, 0.0};
  graph.corners[3].led.clear();
  // No displacement across the direction at that corner, as there is none of a wall.
  const std::array<double, 3> still = graph.corners[3].x;
  const auto linear = [&](const std::array<double, 3>& x)
  {
    const double a = x[0] - still[0];
    const double b = x[1] - still[1];
    return std::array<double, 3>{0.6 * 0.4 + 0.3 * a + 0.2 * b, 0.8 * 0.4 - 0.1 * a + 0.2 * b, 0.0};
  };
  CHECK(error(graph, radial_rule(graph), linear) < 1e-12);
}

TEST_CASE("constant rules commute with a rotation of the whole layout")
{
  CornerGraph graph = fan(5);
  CornerGraph turned = fan(5);
  for (CornerGraph* each : {&graph, &turned})
  {
    each->corners[3].freedom = 1;
    each->corners[3].direction[0] = {1.0, 0.0, 0.0};
  }
  const auto turn = [](const std::array<double, 3>& x) {
    return std::array<double, 3>{0.6 * x[0] - 0.8 * x[1], 0.8 * x[0] + 0.6 * x[1], 0.0};
  };
  for (Corner& corner : turned.corners)
    corner.x = turn(corner.x);
  turned.corners[3].direction[0] = turn({1.0, 0.0, 0.0});
  for (CoarseBlock& block : turned.blocks)
    block = straight_block(turned, block.shape, block.corners);
  Eigen::VectorXd U = Eigen::VectorXd::Zero(2 * graph.corners.size());
  Eigen::VectorXd V = U;
  for (std::size_t c = 1; c < graph.corners.size(); ++c)
    if (graph.corners[c].freedom == 0)
    {
      const auto corner = static_cast<double>(c);
      const std::array<double, 3> u = {std::sin(3.0 * corner), std::cos(2.0 * corner), 0.0};
      const std::array<double, 3> v = turn(u);
      for (int i = 0; i < 2; ++i)
      {
        U(2 * c + i) = u[i];
        V(2 * c + i) = v[i];
      }
    }
  for (const auto& rule : {radial_rule, elastic_rule})
  {
    const Eigen::VectorXd y = rule(graph) * U;
    const Eigen::VectorXd z = rule(turned) * V;
    const std::array<double, 3> inner = turn({y(0), y(1), 0.0});
    CHECK(z(0) == doctest::Approx(inner[0]).epsilon(1e-11));
    CHECK(z(1) == doctest::Approx(inner[1]).epsilon(1e-11));
    CHECK(z(2) == doctest::Approx(y(2)).epsilon(1e-11));  // along its own direction
  }
}
