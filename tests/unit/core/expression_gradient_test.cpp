#include "core/expression.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

using namespace blockfsi;

namespace
{

constexpr std::array<std::string_view, 4> all_variables{"x", "y", "z", "t"};

Expression formula(std::string_view text)
{
  return Expression(text, {{"k", 2.5}}, all_variables);
}

/// Central difference of order 4.
double difference(const Expression& f, std::array<double, 4> at, int i)
{
  const double h = 1e-3;
  const auto value = [&](double shift)
  {
    std::array<double, 4> moved = at;
    moved[i] += shift;
    return f(moved[0], moved[1], moved[2], moved[3]);
  };
  return (8.0 * (value(h) - value(-h)) - (value(2.0 * h) - value(-2.0 * h))) / (12.0 * h);
}

}  // namespace

TEST_CASE("derivatives of a formula agree with differences of order 4")
{
  const std::array<double, 4> at{0.37, -0.61, 0.83, 0.29};
  for (const char* text : {"x + y - z * t",
                           "-x / (2 + y + z)",
                           "x^2 + y^3 + z^-1",
                           "z^(x + t)",
                           "k^x * 2",
                           "pow(z, t)",
                           "abs(y) * abs(x)",
                           "sqrt(x^2 + y^2 + z^2)",
                           "exp(x * y)",
                           "log(z + t)",
                           "sin(x) * cos(y) * tan(z)",
                           "asin(x) + acos(y) + atan(z)",
                           "atan2(y, x) + atan2(z, t)",
                           "sinh(x) + cosh(y) + tanh(z)",
                           "min(x, y, z) + max(x, y, t)",
                           "floor(10 * x) + step(y)",
                           "if(x > y, x * t, y)",
                           "if(x < y, x, y * z)",
                           "ramp(t, 0.5) * x",
                           "ramp(t, z)",
                           "ramp(z, t)",
                           "(x > 0 and y < 0) + x"})
  {
    const Expression f = formula(text);
    const Expression::Derivatives found = f.derivatives(at[0], at[1], at[2], at[3]);
    INFO(std::string(text));
    CHECK(found.value == f(at[0], at[1], at[2], at[3]));
    for (int i = 0; i < 4; ++i)
      CHECK(std::abs(found.by[i] - difference(f, at, i)) < 1e-9);
  }
}

TEST_CASE("a formula keeps finite derivatives where a part has an infinite slope but does not change")
{
  const Expression::Derivatives root = formula("sqrt(x^2 + y^2) + z").derivatives(0.0, 0.0, 1.0);
  CHECK(root.by == std::array<double, 4>{0.0, 0.0, 1.0, 0.0});
  const Expression::Derivatives power = formula("x * z^0.5 + y^0").derivatives(3.0, 0.0, 0.0);
  CHECK(power.value == 1.0);
  CHECK(power.by[0] == 0.0);
  CHECK(power.by[1] == 0.0);
  CHECK(std::isinf(power.by[2]));
  CHECK(formula("abs(x)").derivatives(0.0).by[0] == 0.0);
}

TEST_CASE("many points at once get the values and gradients of single points, bit for bit")
{
  const Expression f =
      formula("if(x < 0.5, sin(3 * x) * y^2 - z / (1 + x^2), max(x, y) * exp(-z)) + k * x^3 * y + t");
  for (const std::size_t count : {0u, 1u, 15u, 16u, 17u, 100u})
  {
    std::vector<std::array<double, 3>> points(count);
    for (std::size_t i = 0; i < count; ++i)
      points[i] = {0.01 * static_cast<double>(i), std::cos(static_cast<double>(i)), 0.3};
    std::vector<double> values(count);
    std::vector<double> again(count);
    std::vector<std::array<double, 3>> gradients(count);
    f.evaluate(points, 0.7, values);
    f.evaluate(points, 0.7, again, gradients);
    CHECK(values == again);
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto [x, y, z] = points[i];
      const Expression::Derivatives single = f.derivatives(x, y, z, 0.7);
      CHECK(values[i] == f(x, y, z, 0.7));
      CHECK(values[i] == single.value);
      CHECK(gradients[i] == std::array<double, 3>{single.by[0], single.by[1], single.by[2]});
    }
  }
}
