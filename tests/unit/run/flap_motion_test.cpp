#include "run/flap_motion.hpp"

#include "geometry/point.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace blockfsi;
using run::FlapMotion;
using run::FlapShape;

namespace
{

using Vector = std::array<double, 3>;

/// The flag of Turek & Hron.
case_file::Prescribed flag()
{
  case_file::Prescribed flap;
  flap.root = {0.25, 0.2, 0.0};
  flap.tip = {0.6, 0.2, 0.0};
  return flap;
}

/// The flap of corners3d.md: along y, thin in x, wide in z.
case_file::Prescribed flap_in_space()
{
  case_file::Prescribed flap;
  flap.root = {1.0, 0.0, 0.2};
  flap.tip = {1.0, 0.5, 0.2};
  flap.bent = 0.3;
  return flap;
}

void check_same(const Vector& a, const Vector& b)
{
  for (int c = 0; c < 3; ++c)
    CHECK(std::abs(a[c] - b[c]) < 1e-12);
}

}  // namespace

TEST_CASE("a bent flap is an arc of a circle that keeps its length")
{
  const FlapMotion flap(flag(), FlapShape::bending);
  const double angle = 1.2;
  const double radius = 0.35 / angle;
  check_same(flap.position({0.6, 0.2, 0.0}, angle),
             {0.25 + radius * std::sin(angle), 0.2 + radius * (1.0 - std::cos(angle)), 0.0});
  // The upper edge is an arc about the same centre.
  const Vector upper = flap.position({0.6, 0.21, 0.0}, angle);
  CHECK(std::hypot(upper[0] - 0.25, upper[1] - 0.2 - radius) == doctest::Approx(radius - 0.01));
}

TEST_CASE("a rotating flap is straight behind its bent share")
{
  const FlapMotion flap(flag(), FlapShape::rotation);
  const double angle = 0.5 * std::numbers::pi;
  const Vector a = flap.position({0.25 + 0.2 * 0.35, 0.2, 0.0}, angle);
  const Vector b = flap.position({0.6, 0.2, 0.0}, angle);
  CHECK(b[0] == doctest::Approx(a[0]));
  CHECK(b[1] - a[1] == doctest::Approx(0.8 * 0.35));
  // The prototype's tip is 0.92 L aside at 90 degrees (formulation.md chapter 9: 0.92).
  CHECK((b[1] - 0.2) / 0.35 == doctest::Approx(0.9).epsilon(0.03));
}

TEST_CASE("the root stays, also that of a flap that points elsewhere, and the opposite angle mirrors")
{
  for (const FlapShape shape : run::flap_shapes(2))
  {
    case_file::Prescribed down;
    down.root = {1.0, 2.0, 0.0};
    down.tip = {1.0, 0.5, 0.0};
    const FlapMotion flap(down, shape);
    for (const double height : {-0.1, 0.0, 0.1})
      check_same(flap.position({1.0 + height, 2.0, 0.0}, 1.0), {1.0 + height, 2.0, 0.0});
    const Vector one = flap.position({1.1, 0.5, 0.0}, 0.8);
    const Vector other = flap.position({0.9, 0.5, 0.0}, -0.8);
    CHECK(one[0] - 1.0 == doctest::Approx(1.0 - other[0]));
    CHECK(one[1] == doctest::Approx(other[1]));
    const std::vector<double> rest = flap.displacement(std::array{1.1, 0.5, 0.9, 1.2}, 2, 0.0);
    for (const double value : rest)
      CHECK(std::abs(value) < 1e-14);
  }
}

TEST_CASE("in space a flap bends about its axis, sideways about the other one, and twists about itself")
{
  const double angle = 0.9;
  const double radius = 0.5 / angle;
  const FlapMotion bending(flap_in_space(), FlapShape::bending);
  check_same(bending.position({1.0, 0.5, 0.2}, angle),
             {1.0 - radius * (1.0 - std::cos(angle)), radius * std::sin(angle), 0.2});
  check_same(bending.position({1.0, 0.5, 0.4}, angle),
             {1.0 - radius * (1.0 - std::cos(angle)), radius * std::sin(angle), 0.4});
  const FlapMotion sideways(flap_in_space(), FlapShape::sideways);
  const Vector tip = sideways.position({1.03, 0.5, 0.2}, angle);
  CHECK(tip[0] == doctest::Approx(1.03));
  CHECK(tip[1] == doctest::Approx(radius * std::sin(angle)));
  CHECK(std::abs(tip[2] - 0.2) == doctest::Approx(radius * (1.0 - std::cos(angle))));
  const FlapMotion twist(flap_in_space(), FlapShape::twist);
  check_same(twist.position({1.0, 0.5, 0.2}, angle), {1.0, 0.5, 0.2});
  const Vector corner = twist.position({1.0, 0.25, 0.4}, angle);
  CHECK(corner[1] == doctest::Approx(0.25));
  CHECK(std::abs(corner[0] - 1.0) == doctest::Approx(0.2 * std::sin(0.5 * angle)));
  CHECK(corner[2] - 0.2 == doctest::Approx(0.2 * std::cos(0.5 * angle)));
}

TEST_CASE("cross sections stay as they are in every shape")
{
  for (const FlapShape shape : run::flap_shapes(3))
  {
    const FlapMotion flap(flap_in_space(), shape);
    for (const double height : {0.1, 0.5})
    {
      const std::array<Vector, 3> before = {{{0.97, height, 0.0}, {1.03, height, 0.0}, {0.97, height, 0.4}}};
      std::array<Vector, 3> after{};
      for (int k = 0; k < 3; ++k)
        after[k] = flap.position(before[k], 1.1);
      for (int k = 0; k < 3; ++k)
        CHECK(geometry::distance(after[k], after[(k + 1) % 3]) ==
              doctest::Approx(geometry::distance(before[k], before[(k + 1) % 3])));
    }
  }
}
