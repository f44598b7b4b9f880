#include "block/corner_motion.hpp"

#include "block/corner_layout.hpp"
#include "corner_graphs.hpp"
#include "flag.hpp"
#include "layouts.hpp"

#include <doctest/doctest.h>

using namespace blockfsi;
using namespace blockfsi::block;
using namespace blockfsi::block::testing;

TEST_CASE("a nonlinear rule turns a fan of any valence with its rim, without distortion")
{
  const double angle = 2.0;  // more than a constant rule could follow
  const auto turned = [&](double share)
  {
    return [angle = share * angle](const std::array<double, 3>& x)
    {
      return std::array<double, 3>{std::cos(angle) * x[0] - std::sin(angle) * x[1] - x[0],
                                   std::sin(angle) * x[0] + std::cos(angle) * x[1] - x[1], 0.0};
    };
  };
  for (const CornerGraph& graph :
       {fan(3), fan(4), fan(5), fan(6), fan(3, element::Shape::triangle), fan(6, element::Shape::triangle)})
  {
    CornerMotion motion(graph, nonlinear_defaults(2));
    std::vector<double> U(2 * graph.corners.size());
    const CornerReport report = motion.follow(led_by(graph, turned(1.0)), U);
    CHECK(report.converged);
    const std::array<double, 3> wanted = turned(1.0)(graph.corners[0].x);
    CHECK(U[0] == doctest::Approx(wanted[0]).epsilon(1e-9));
    CHECK(U[1] == doctest::Approx(wanted[1]).epsilon(1e-9));
    CHECK(report.energy == doctest::Approx(static_cast<double>(graph.blocks.size())).epsilon(1e-9));
  }
}

TEST_CASE(
    "what a nonlinear rule finds does not depend on the way there, and back at the start is the first mesh")
{
  const FlagLayout flag(narrow_channel, 2, 2);
  BentFlag direct(flag.layout, CornerRule::nonlinear);
  BentFlag round(flag.layout, CornerRule::nonlinear);
  for (const double angle : {-15.0, 20.0, 35.0, 10.0, -30.0})
    CHECK(round.bend(Bending::uniform, angle).converged);
  CHECK(round.bend(Bending::at_root, 25.0).converged);
  CHECK(direct.bend(Bending::at_root, 25.0).converged);
  double difference = 0.0;
  for (std::size_t i = 0; i < direct.x().size(); ++i)
    difference = std::max(difference, std::abs(direct.x()[i] - round.x()[i]));
  CHECK(difference < 1e-10 * 0.35);  // of the flag
  CHECK(round.bend(Bending::at_root, 0.0).converged);
  CHECK(round.drift() < 1e-10 * 0.35);
}

TEST_CASE("a rule that recalls its memory continues bit for bit")
{
  const FlagLayout flag(narrow_channel, 2, 2);
  BentFlag first(flag.layout, CornerRule::nonlinear);
  first.bend(Bending::uniform, 10.0);
  first.bend(Bending::uniform, 14.0);
  BentFlag second(flag.layout, CornerRule::nonlinear);
  second.motion().corners().recall(first.motion().corners().memory());
  CHECK(second.bend(Bending::uniform, 14.0).iterations == 0);
  CHECK(second.x() == first.x());
  first.bend(Bending::at_root, 12.0);
  second.bend(Bending::at_root, 12.0);
  CHECK(second.x() == first.x());
  CHECK(message_of([&] { second.motion().corners().recall(std::vector<double>(3)); }) != "");
  BentFlag constant(flag.layout, CornerRule::elastic);
  constant.bend(Bending::uniform, 10.0);
  CHECK(constant.motion().corners().memory().empty());
}

TEST_CASE("constant rules are linear: the mesh of a sum of displacements is the sum of the meshes")
{
  const FlagLayout flag(narrow_channel, 3, 2);
  for (const CornerRule rule : {CornerRule::fixed, CornerRule::radial, CornerRule::elastic})
  {
    BentFlag bent(flag.layout, rule);
    const std::vector<double> x0 = bent.x();
    bent.bend(Bending::uniform, 20.0);
    const std::vector<double> d1 = bent.displacement();
    const std::vector<double> x1 = bent.x();
    bent.bend(Bending::at_root, -10.0);
    const std::vector<double> x2 = bent.x();
    for (std::size_t i = 0; i < d1.size(); ++i)
      bent.displacement()[i] = 2.0 * d1[i] - 0.5 * bent.displacement()[i];
    bent.follow();
    double difference = 0.0;
    for (std::size_t i = 0; i < x0.size(); ++i)
      difference =
          std::max(difference, std::abs(bent.x()[i] - x0[i] - 2.0 * (x1[i] - x0[i]) + 0.5 * (x2[i] - x0[i])));
    CHECK(difference < 1e-14);
  }
}

TEST_CASE("a way too long for Newton's method is halved")
{
  const FlagLayout flag(wide_channel, 2, 2);
  BentFlag jump(flag.layout, CornerRule::nonlinear);
  BentFlag steps(flag.layout, CornerRule::nonlinear);
  for (double angle = 5.0; angle <= 100.0; angle += 5.0)
    steps.bend(Bending::uniform, angle);
  CHECK(jump.bend(Bending::uniform, 100.0).converged);
  CHECK(jump.certified());
  CHECK(steps.certified());
}
