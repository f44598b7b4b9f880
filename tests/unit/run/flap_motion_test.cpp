#include "run/flap_motion.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

using namespace blockfsi;
using run::FlapMotion;
using run::FlapShape;

namespace
{

const std::array<double, 3> root = {0.25, 0.2, 0.0};
const std::array<double, 3> tip = {0.6, 0.2, 0.0};

}  // namespace

TEST_CASE("a bent flap is an arc of a circle that keeps its length")
{
  const FlapMotion flap(root, tip, FlapShape::bending);
  const double angle = 1.2;
  const double radius = 0.35 / angle;
  const std::array<double, 2> end = flap.position({0.6, 0.2}, angle);
  CHECK(end[0] == doctest::Approx(0.25 + radius * std::sin(angle)));
  CHECK(end[1] == doctest::Approx(0.2 + radius * (1.0 - std::cos(angle))));
  // The upper edge is an arc about the same centre.
  const std::array<double, 2> upper = flap.position({0.6, 0.21}, angle);
  CHECK(std::hypot(upper[0] - 0.25, upper[1] - 0.2 - radius) == doctest::Approx(radius - 0.01));
}

TEST_CASE("a rotating flap is straight behind its first fifth")
{
  const FlapMotion flap(root, tip, FlapShape::rotation);
  const double angle = 0.5 * std::numbers::pi;
  const std::array<double, 2> a = flap.position({0.25 + 0.2 * 0.35, 0.2}, angle);
  const std::array<double, 2> b = flap.position({0.6, 0.2}, angle);
  CHECK(b[0] == doctest::Approx(a[0]));
  CHECK(b[1] - a[1] == doctest::Approx(0.8 * 0.35));
  // The prototype's tip is 0.92 L aside at 90 degrees (formulation.md chapter 9: 0.92).
  CHECK((b[1] - 0.2) / 0.35 == doctest::Approx(0.9).epsilon(0.03));
}

TEST_CASE("the root stays, also that of a flap that points elsewhere, and the opposite angle mirrors")
{
  for (const FlapShape shape : run::flap_shapes)
  {
    const FlapMotion down(std::array{1.0, 2.0, 0.0}, std::array{1.0, 0.5, 0.0}, shape);
    for (const double height : {-0.1, 0.0, 0.1})
    {
      const std::array<double, 2> x = down.position({1.0 + height, 2.0}, 1.0);
      CHECK(x[0] == doctest::Approx(1.0 + height));
      CHECK(x[1] == doctest::Approx(2.0));
    }
    const std::array<double, 2> one = down.position({1.1, 0.5}, 0.8);
    const std::array<double, 2> other = down.position({0.9, 0.5}, -0.8);
    CHECK(one[0] - 1.0 == doctest::Approx(1.0 - other[0]));
    CHECK(one[1] == doctest::Approx(other[1]));
    const std::vector<double> rest = down.displacement(std::array{1.1, 0.5, 0.9, 1.2}, 0.0);
    for (const double value : rest)
      CHECK(std::abs(value) < 1e-14);
  }
}
