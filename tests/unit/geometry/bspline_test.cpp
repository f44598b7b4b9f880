#include "geometry/bspline.hpp"

#include "core/error.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <string>

using namespace blockfsi;

namespace
{

std::string message_of(int degree, const std::vector<double>& knots, std::size_t points)
{
  try
  {
    geometry::check_knots("the B-spline", degree, knots, points);
  }
  catch (const Error& error)
  {
    return error.message();
  }
  return "";
}

/// Sum of coefficients times basis functions (0), or their first or second derivatives.
std::array<double, 3> spline(int degree, const std::vector<double>& knots,
                             const std::vector<double>& coefficients, double t)
{
  const int span = geometry::find_span(knots, degree, t, 0);
  geometry::BasisValues N;
  geometry::basis<2>(knots, degree, span, t, N);
  std::array<double, 3> sum{};
  for (int j = 0; j <= degree; ++j)
  {
    const double c = coefficients[span - degree + j];
    sum[0] += N.value[j] * c;
    sum[1] += N.first[j] * c;
    sum[2] += N.second[j] * c;
  }
  return sum;
}

std::vector<double> uneven_knots(int degree)
{
  std::vector<double> knots(degree + 1, -1.0);
  knots.insert(knots.end(), {-0.3, 0.1, 0.15});
  knots.insert(knots.end(), degree, 0.7);  // as often as allowed
  knots.insert(knots.end(), degree + 1, 2.0);
  return knots;
}

}  // namespace

TEST_CASE("B-spline basis functions are not negative and sum to one, their derivatives to zero")
{
  for (const int degree : {1, 2, 3, 5, 8})
  {
    const std::vector<double> knots = uneven_knots(degree);
    const std::vector<double> ones(knots.size() - degree - 1, 1.0);
    for (const double t : {-1.0, -0.9, -0.3, 0.0, 0.12, 0.5, 0.7, 1.3, 2.0})
    {
      const auto sum = spline(degree, knots, ones, t);
      CHECK(sum[0] == doctest::Approx(1.0).epsilon(1e-14));
      CHECK(std::abs(sum[1]) < 1e-11);
      CHECK(std::abs(sum[2]) < 1e-9);
      geometry::BasisValues N;
      geometry::basis<0>(knots, degree, geometry::find_span(knots, degree, t, 0), t, N);
      for (int j = 0; j <= degree; ++j)
        CHECK(N.value[j] >= 0.0);
    }
  }
}

TEST_CASE("B-splines reproduce t and t squared with both derivatives")
{
  for (const int degree : {2, 3, 4, 7})
  {
    const std::vector<double> knots = uneven_knots(degree);
    // Coefficients by the polar forms (blossoms) of t and t^2 at the inner knots of each function.
    std::vector<double> linear;
    std::vector<double> square;
    for (std::size_t i = 0; i + degree + 1 < knots.size(); ++i)
    {
      double sum = 0.0;
      double pairs = 0.0;
      for (int j = 1; j <= degree; ++j)
      {
        sum += knots[i + j];
        for (int k = j + 1; k <= degree; ++k)
          pairs += knots[i + j] * knots[i + k];
      }
      linear.push_back(sum / degree);
      square.push_back(2.0 * pairs / (degree * (degree - 1)));
    }
    for (const double t : {-1.0, -0.8, -0.3, 0.0, 0.11, 0.6, 0.7, 1.9, 2.0})
    {
      const auto a = spline(degree, knots, linear, t);
      const auto b = spline(degree, knots, square, t);
      CHECK(a[0] == doctest::Approx(t).epsilon(1e-14));
      CHECK(a[1] == doctest::Approx(1.0).epsilon(1e-12));
      CHECK(std::abs(a[2]) < 1e-10);
      CHECK(b[0] == doctest::Approx(t * t).epsilon(1e-13));
      CHECK(b[1] == doctest::Approx(2.0 * t).epsilon(1e-11));
      CHECK(b[2] == doctest::Approx(2.0).epsilon(1e-9));
    }
  }
}

TEST_CASE("the span of a parameter is found with any guess, and at the end it is the last")
{
  const std::vector<double> knots{0, 0, 0, 0.25, 0.5, 0.5, 1, 1, 1};
  for (int guess = -1; guess < 10; ++guess)
  {
    CHECK(geometry::find_span(knots, 2, 0.0, guess) == 2);
    CHECK(geometry::find_span(knots, 2, 0.25, guess) == 3);
    CHECK(geometry::find_span(knots, 2, 0.5, guess) == 5);
    CHECK(geometry::find_span(knots, 2, 1.0, guess) == 5);
  }
}

TEST_CASE("clamped knots have equal spans")
{
  CHECK(geometry::clamped_knots(2, 5) == std::vector<double>{0, 0, 0, 1.0 / 3, 2.0 / 3, 1, 1, 1});
  CHECK(message_of(3, geometry::clamped_knots(3, 4), 4) == "");
}

TEST_CASE("wrong knots are refused by name")
{
  CHECK(message_of(2, {0, 0, 0, 0.5, 1, 1, 1}, 4) == "");
  CHECK(message_of(0, {0, 1}, 1) == "the B-spline: the degree is 0; it must be from 1 to 25");
  CHECK(message_of(3, {0, 0, 0, 1, 1, 1}, 3) ==
        "the B-spline: found 3 control points; degree 3 needs at least 4");
  CHECK(message_of(2, {0, 0, 0, 1, 1, 1}, 4) ==
        "the B-spline: found 6 knots; 4 control points of degree 2 need 7");
  CHECK(message_of(2, {0, 0, 0, 0.6, 0.5, 1, 1, 1}, 5) ==
        "the B-spline: knot 5 is 0.5, less than knot 4, 0.6; knots must not decrease");
  CHECK(message_of(2, {0, 0, 0.5, 0.5, 1, 1, 1}, 4) ==
        "the B-spline: the first knot, 0, is listed 2 times; degree 2 needs it 3 times, so that the curve "
        "ends at "
        "its control point");
  CHECK(message_of(2, {0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1}, 6) ==
        "the B-spline: knot 4, 0.5, is listed 3 times; degree 2 allows that 2 times, else the curve is torn "
        "there");
  CHECK(message_of(2, {0, 0, 0, 0.5, 1, 1, 2}, 4) == "the B-spline: the last knot, 2, is listed once; "
                                                     "degree 2 needs it 3 times, so that the curve ends at "
                                                     "its control point");
  CHECK(message_of(1, {0, 0, std::numeric_limits<double>::quiet_NaN(), 1, 1}, 3) ==
        "the B-spline: knot 3 is nan; it must be finite");
  CHECK(message_of(1, {1, 1, 1, 1}, 2) != "");
}
