#include "coupling/predictor.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <optional>

using namespace blockfsi::coupling;
using Vector = std::vector<double>;

namespace
{

/// Two components of an interface at the ends of steps of length 1: f(t), -f(t) at t = 0, 1, ..., last.
Past sampled(const std::function<double(double)>& f, int last)
{
  Past past{{Vector{f(0.0), -f(0.0)}}};
  for (int t = 1; t <= last; ++t)
    remember(past, Vector{f(t), -f(t)}, 1.0);
  return past;
}

double predicted(const Past& past, std::optional<int> order, double step = 1.0)
{
  Vector out(2);
  predict(order, past, step, out);
  CHECK(out[1] == -out[0]);
  return out[0];
}

}  // namespace

TEST_CASE("a predictor of order k is exact for polynomials of degree k, and misses the next one")
{
  for (int degree = 0; degree <= highest_order + 1; ++degree)
  {
    // The falling factorial t (t - 1) ... : its differences of order `degree` are degree!, exactly.
    const auto f = [degree](double t)
    {
      double value = 1.0;
      for (int i = 0; i < degree; ++i)
        value *= t - i;
      return value;
    };
    const Past past = sampled(f, most_kept);
    for (int order = 0; order <= highest_order; ++order)
    {
      CAPTURE(degree);
      CAPTURE(order);
      const double missed = f(most_kept + 1.0) - predicted(past, order);
      if (order >= degree)
        CHECK(std::abs(missed) < 1e-12 * f(most_kept + 1.0));
      else if (order + 1 == degree)
        CHECK(missed == doctest::Approx(std::tgamma(degree + 1.0)).epsilon(1e-9));
    }
  }
}

TEST_CASE("lower orders are used while fewer steps are known")
{
  const auto square = [](double t) { return t * t; };
  CHECK(predicted(sampled(square, 0), 3) == 0.0);
  CHECK(predicted(sampled(square, 1), 3) == doctest::Approx(2.0));
  CHECK(predicted(sampled(square, 2), 3) == doctest::Approx(9.0));
  CHECK(predicted(sampled(square, 0), {}) == 0.0);
  CHECK(predicted(sampled(square, 1), {}) == doctest::Approx(2.0));
}

TEST_CASE("a step of another length goes on along a straight line, and what lies before it is forgotten")
{
  Past past = sampled([](double t) { return 3.0 + t * t * t; }, 5);
  const double slope = 125.0 - 64.0;
  CHECK(predicted(past, 4, 0.5) == doctest::Approx(128.0 + 0.5 * slope));
  CHECK(predicted(past, {}, 0.5) == doctest::Approx(128.0 + 0.5 * slope));
  CHECK(predicted(past, 0, 0.5) == 128.0);
  remember(past, Vector{150.0, -150.0}, 0.5);
  CHECK(past.d == std::vector<Vector>{{150.0, -150.0}, {128.0, -128.0}});
  CHECK(predicted(past, 4, 0.5) == doctest::Approx(172.0));
}

TEST_CASE("the best order is the one that would have found the newest")
{
  CHECK(best_order(sampled([](double) { return 2.0; }, most_kept)) == 0);
  CHECK(best_order(sampled([](double t) { return 2.0 - t; }, most_kept)) == 1);
  CHECK(best_order(sampled([](double t) { return t * t; }, most_kept)) == 2);
  CHECK(best_order(sampled([](double t) { return std::sin(0.1 * t); }, most_kept)) == highest_order);
  // Order k misses what rings by 2^k times its amplitude from step to step.
  const auto ringing = [](double t) { return std::fmod(t, 2.0) == 0.0 ? 1.0 : 1.1; };
  CHECK(best_order(sampled(ringing, most_kept)) == 0);
}

TEST_CASE("no more is kept than predictions need")
{
  CHECK(sampled([](double t) { return t; }, 20).d.size() == most_kept);
}
