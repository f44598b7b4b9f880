#include "block/grading.hpp"

#include "core/error.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace blockfsi;
using namespace blockfsi::block;

namespace
{

bool ascends_from_0_to_1(const std::vector<double>& t)
{
  for (std::size_t i = 1; i < t.size(); ++i)
    if (!(t[i] > t[i - 1]))
      return false;
  return t.front() == 0.0 && t.back() == 1.0;
}

/// Largest deviation of the ratios of neighbouring cells from one another.
double ratio_spread(const std::vector<double>& t)
{
  double low = 1e300;
  double high = 0.0;
  for (std::size_t i = 2; i < t.size(); ++i)
  {
    const double ratio = (t[i] - t[i - 1]) / (t[i - 1] - t[i - 2]);
    low = std::min(low, ratio);
    high = std::max(high, ratio);
  }
  return high / low - 1.0;
}

std::string message_of(const Grading& grading, int n, double length)
{
  try
  {
    parameters(grading, n, length);
  }
  catch (const Error& error)
  {
    return error.message();
  }
  return "";
}

}  // namespace

TEST_CASE("uniform cells are equal and the ends exact")
{
  for (int n = 1; n < 50; ++n)
  {
    const std::vector<double> t = parameters(Uniform{}, n, 3.0);
    CHECK(t.size() == n + 1u);
    CHECK(ascends_from_0_to_1(t));
    const int half = n / 2;
    CHECK(t[half] == static_cast<double>(half) / n);
  }
}

TEST_CASE("geometric cells grow by their ratio, strong ratios included")
{
  for (const double ratio : {0.5, 0.99, 1.0, 1.0 + 1e-12, 1.3, 2.0})
  {
    const std::vector<double> t = parameters(Geometric{ratio}, 20, 1.0);
    CHECK(ascends_from_0_to_1(t));
    CHECK((t[2] - t[1]) / t[1] == doctest::Approx(ratio).epsilon(1e-9));
    CHECK(ratio_spread(t) < 1e-8);
  }
}

TEST_CASE("a first cell gets its size, at the start and at the end, finer and coarser than equal cells")
{
  for (const int n : {2, 3, 7, 20, 200})
    for (const double size : {1e-6, 1e-3, 0.4 / n, 1.0 / n, 1.01 / n, 1.4 / n})
    {
      const double length = 2.5;
      const std::vector<double> start = parameters(FirstCell{size * length, false}, n, length);
      const std::vector<double> end = parameters(FirstCell{size * length, true}, n, length);
      CHECK(ascends_from_0_to_1(start));
      CHECK(start[1] == doctest::Approx(size).epsilon(1e-12));
      CHECK(std::abs(1.0 - end[n - 1] - size) < 1e-12 * size + 2e-16);
      CHECK(ratio_spread(start) < 1e-8);
    }
}

TEST_CASE("20 cells of which the first is a thousandth grow by the factor that solves the geometric sum")
{
  // (q^20 - 1) / (q - 1) = 1000, solved by bisection to all digits.
  const std::vector<double> t = parameters(FirstCell{1e-3, false}, 20, 1.0);
  CHECK((t[2] - t[1]) / t[1] == doctest::Approx(1.338206781225746).epsilon(1e-12));
}

TEST_CASE("two-sided cells meet both targets and change smoothly")
{
  struct Target
  {
    int n;
    double first;
    double last;
  };
  for (const auto& [n, first, last] : {Target{20, 1e-3, 1e-2},
                                       {40, 1e-4, 1e-4},
                                       {10, 0.2, 0.15},
                                       {12, 0.02, 0.3},
                                       {3, 0.2, 0.3},
                                       {5, 0.2, 0.2},
                                       {100, 1e-6, 0.05}})
  {
    const std::vector<double> t = parameters(TwoSided{4.0 * first, 4.0 * last}, n, 4.0);
    CHECK(ascends_from_0_to_1(t));
    // To rounding: the last cell is a difference from 1.
    CHECK(std::abs(t[1] - first) < 2e-12 * first);
    CHECK(std::abs(1.0 - t[n - 1] - last) < 2e-12 * last + 2e-16);
  }
}

TEST_CASE("a one-sided hyperbolic tangent meets its first cell and levels off at the other end")
{
  for (const int n : {2, 3, 20, 200})
    for (const double size : {1e-9, 1e-3 / n, 0.5 / n, 1.0 / n, 1.2 / n})
    {
      const std::vector<double> start = parameters(OneSided{3.0 * size, false}, n, 3.0);
      const std::vector<double> end = parameters(OneSided{3.0 * size, true}, n, 3.0);
      CHECK(ascends_from_0_to_1(start));
      CHECK(std::abs(start[1] - size) < 1e-12 * size);
      CHECK(std::abs(1.0 - end[n - 1] - size) < 1e-12 * size + 2e-16);
    }
  // t = 1 + tanh(δ (i/n - 1)) / tanh(δ) with δ from its own first cell; the last two cells are nearly equal.
  const std::vector<double> t = parameters(OneSided{0.01, false}, 20, 1.0);
  double low = 0.1;
  double high = 10.0;
  for (int i = 0; i < 100; ++i)
  {
    const double middle = 0.5 * (low + high);
    (1.0 - std::tanh(middle * 0.95) / std::tanh(middle) > 0.01 ? low : high) = middle;
  }
  for (int i = 1; i < 20; ++i)
    CHECK(t[i] == doctest::Approx(1.0 + std::tanh(low * (i / 20.0 - 1.0)) / std::tanh(low)).epsilon(1e-10));
  CHECK((t[20] - t[19]) / (t[19] - t[18]) == doctest::Approx(1.0).epsilon(0.03));
}

TEST_CASE("cosine cells end at Chebyshev's points, symmetric to one rounding")
{
  for (const int n : {1, 2, 7, 16})
  {
    const std::vector<double> t = parameters(Cosine{}, n, 1.0);
    CHECK(ascends_from_0_to_1(t));
    for (int i = 0; i <= n; ++i)
    {
      CHECK(t[i] == doctest::Approx(0.5 * (1.0 - std::cos(std::numbers::pi * i / n))).epsilon(1e-14));
      if (2 * i <= n)
        CHECK(t[n - i] == 1.0 - t[i]);
    }
  }
}

TEST_CASE("lists of positions, on any scale, and of relative sizes are taken as they are")
{
  CHECK(parameters(Positions{{1.0, 1.5, 2.0, 3.0}}, 3, 7.0) == std::vector<double>{0.0, 0.25, 0.5, 1.0});
  CHECK(parameters(Sizes{{1.0, 1.0, 2.0}}, 3, 7.0) == std::vector<double>{0.0, 0.25, 0.5, 1.0});
  CHECK(cell_count(Positions{{0.0, 0.1, 1.0}}) == 2);
  CHECK(cell_count(Sizes{{0.1, 1.0}}) == 2);
  CHECK_FALSE(cell_count(Cosine{}).has_value());
}

TEST_CASE("a reversed grading is the mirrored distribution")
{
  for (const Grading& grading :
       {Grading{Uniform{}}, Grading{Geometric{1.4}}, Grading{FirstCell{0.01, false}},
        Grading{FirstCell{0.01, true}}, Grading{TwoSided{0.01, 0.05}}, Grading{OneSided{0.02, true}},
        Grading{Cosine{}}, Grading{Positions{{0.0, 1.0, 3.0, 4.0, 4.5, 5.0, 7.0, 7.1, 8.0, 10.0}}},
        Grading{Sizes{{1.0, 2.0, 3.0, 2.0, 1.0, 1.0, 1.0, 4.0, 0.5}}}})
  {
    const std::vector<double> t = parameters(grading, 9, 1.0);
    const std::vector<double> s = parameters(reversed(grading), 9, 1.0);
    for (int i = 0; i <= 9; ++i)
      CHECK(s[i] == doctest::Approx(1.0 - t[9 - i]).epsilon(1e-10));
    CHECK(reversed(reversed(grading)) == grading);
  }
}

TEST_CASE("gradings that cannot be met are refused with the reason")
{
  CHECK(message_of(Uniform{}, 0, 1.0) == "an edge has 0 cells; it needs at least 1");
  CHECK(message_of(Geometric{-1.0}, 3, 1.0) == "the ratio of neighbouring cells is -1; it must be positive");
  CHECK(message_of(FirstCell{0.0, false}, 3, 1.0) == "a cell size of 0 m is asked for; it must be positive");
  CHECK(message_of(FirstCell{2.0, false}, 3, 1.0) ==
        "a cell of 2 m is asked for on an edge of 1 m; it must be shorter than the edge");
  CHECK(message_of(FirstCell{1.0, false}, 3, 1.0) ==
        "the first of 3 cells shall be as long as the edge (1 m); give it a smaller size");
  CHECK(message_of(FirstCell{0.5, false}, 1, 1.0) ==
        "the only cell of an edge of 1 m shall have 0.5 m; give the edge more cells or no grading");
  CHECK(message_of(TwoSided{0.1, 0.2}, 2, 1.0) == "first and last cells of 0.1 m and 0.2 m do not fill an "
                                                  "edge of 1 m with 2 cell(s); give the edge at least 3 "
                                                  "cells");
  CHECK(message_of(TwoSided{0.6, 0.5}, 4, 1.0) == "first and last cells of 0.6 m and 0.5 m leave no room for "
                                                  "the other 2 cells of an edge of 1 m; give smaller "
                                                  "sizes");
  CHECK(message_of(TwoSided{0.9, 0.05}, 20, 1.0) == "no smooth distribution of 20 cells on 1 m starts with "
                                                    "0.9 m and ends with 0.05 m; bring the sizes nearer to "
                                                    "0.05 m or change the number of cells");
  CHECK(message_of(OneSided{1.5, false}, 4, 1.0) ==
        "a cell of 1.5 m is asked for on an edge of 1 m; it must be shorter than the edge");
  CHECK(
      message_of(OneSided{1.0, false}, 4, 1.0) ==
      "no 4 cells on 1 m that grow by a hyperbolic tangent start with 1 m; bring the size nearer to 0.25 m");
  CHECK(message_of(Positions{{0.0, 0.2, 1.0}}, 3, 1.0) ==
        "the list has 3 positions, which make 2 cells, but the edge has 3; change the list or the number of "
        "cells");
  CHECK(message_of(Positions{{0.0, 0.2, 0.1, 1.0}}, 3, 1.0) ==
        "position 3 of the list is 0.1 after 0.2; positions must ascend");
  CHECK(
      message_of(Sizes{{0.5, 0.5}}, 3, 1.0) ==
      "the list has 2 sizes, which make 2 cells, but the edge has 3; change the list or the number of cells");
  CHECK(message_of(Sizes{{0.5, 0.0, 0.5}}, 3, 1.0) == "size 2 of the list is 0; sizes must be positive");
  CHECK(message_of(FirstCell{0.9, false}, 40, 1.0).find("vanishes in double precision") != std::string::npos);
  CHECK(message_of(FirstCell{1.0, false}, 1, 1.0) == "");
  CHECK(message_of(TwoSided{0.4, 0.6}, 2, 1.0) == "");
}
