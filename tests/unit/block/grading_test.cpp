#include "block/grading.hpp"

#include "core/error.hpp"

#include <doctest/doctest.h>

#include <cmath>
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
    CHECK(t[1] == doctest::Approx(first).epsilon(1e-9));
    CHECK(1.0 - t[n - 1] == doctest::Approx(last).epsilon(1e-9));
  }
}

TEST_CASE("a reversed grading is the mirrored distribution")
{
  for (const Grading& grading : {Grading{Uniform{}}, Grading{Geometric{1.4}}, Grading{FirstCell{0.01, false}},
                                 Grading{FirstCell{0.01, true}}, Grading{TwoSided{0.01, 0.05}}})
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
  CHECK(message_of(FirstCell{0.9, false}, 40, 1.0).find("vanishes in double precision") != std::string::npos);
  CHECK(message_of(FirstCell{1.0, false}, 1, 1.0) == "");
  CHECK(message_of(TwoSided{0.4, 0.6}, 2, 1.0) == "");
}
