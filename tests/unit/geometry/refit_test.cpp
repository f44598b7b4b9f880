#include "geometry/refit.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace blockfsi::geometry;

TEST_CASE("a refit of polynomials of its degree is exact")
{
  const auto curve = [](double t) { return Point{t, std::pow(t, 8) - t, std::pow(1 - t, 7)}; };
  const auto result = refit(curve, std::array{0.0, 0.3, 1.0}, 1e-13);
  CHECK_NOTHROW(check("the refit", result.spline));
  CHECK(result.error < 1e-13);
  CHECK(result.spline.points.size() == 17);
  const auto surface = [](double u, double v) {
    return Point{u * v, std::pow(u, 8) * v, std::pow(v, 8) - u};
  };
  const auto fitted = refit(surface, std::array{0.0, 1.0}, std::array{0.0, 0.4, 1.0}, 1e-13);
  CHECK_NOTHROW(check("the refit", fitted.spline));
  CHECK(fitted.error < 1e-13);
  CHECK(fitted.spline.points.size() == 9 * 17);
  CHECK(distance(evaluate(fitted.spline, 0.123, 0.777), surface(0.123, 0.777)) < 1e-13);
}

TEST_CASE("a refit halves its pieces until the error that it states is small, and states it truly")
{
  const auto curve = [](double t) { return Point{std::cos(9 * t), std::sin(9 * t), 1 / (1 + 4 * t * t)}; };
  const auto result = refit(curve, std::array{0.0, 1.0}, 1e-11);
  CHECK(result.error < 1e-11);
  const auto rough = refit(curve, std::array{0.0, 1.0}, 1e-5);
  CHECK(rough.error < 1e-5);
  CHECK(rough.spline.points.size() < result.spline.points.size());
  for (int i = 0; i <= 100; ++i)
    CHECK(distance(evaluate(rough.spline, i / 100.0), curve(i / 100.0)) <= 2.0 * rough.error);
}

TEST_CASE("a refit of a curve with a corner between its breaks states the error that is left")
{
  const auto corner = [](double t) { return Point{t, std::abs(t - 0.3), 0.0}; };
  const auto result = refit(corner, std::array{0.0, 1.0}, 1e-12);
  CHECK(result.error > 1e-5);
  CHECK(result.error < 1e-2);
  CHECK(refit(corner, std::array{0.0, 0.3, 1.0}, 1e-12).error < 1e-14);
}
