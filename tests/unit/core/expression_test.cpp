#include "core/expression.hpp"

#include "core/error.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

using namespace blockfsi;

namespace
{

constexpr std::array<std::string_view, 4> all = {"x", "y", "z", "t"};
const Constants constants = {{"U", 0.5}, {"height", 2.0}};

double value(std::string_view text, double x = 0.0, double y = 0.0, double z = 0.0, double t = 0.0)
{
  return Expression(text, constants, all)(x, y, z, t);
}

std::string complaint(std::string_view text,
                      const std::vector<std::string_view>& variables = {"x", "y", "z", "t"})
{
  try
  {
    Expression(text, constants, variables);
  }
  catch (const Error& error)
  {
    CHECK_FALSE(error.location().has_value());
    return error.message();
  }
  return "accepted";
}

std::string condition_complaint(std::string_view text)
{
  try
  {
    Condition(text, constants);
  }
  catch (const Error& error)
  {
    return error.message();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("products bind tighter than sums and both group from the left")
{
  CHECK(value("1 + 2 * 3") == 7.0);
  CHECK(value("10 - 4 - 3") == 3.0);
  CHECK(value("8 / 4 / 2") == 1.0);
  CHECK(value("8 / 4 * 2") == 4.0);
  CHECK(value("(1 + 2) * 3") == 9.0);
}

TEST_CASE("powers group from the right and bind tighter than unary minus")
{
  CHECK(value("2^3^2") == 512.0);
  CHECK(value("-2^2") == -4.0);
  CHECK(value("(-2)^2") == 4.0);
  CHECK(value("2^-1") == 0.5);
  CHECK(value("-x^2", 3.0) == -9.0);
  CHECK(value("2 * x^2 * 3", 2.0) == 24.0);
  CHECK(value("2 - -x", 1.0) == 3.0);
}

TEST_CASE("numbers are read as written")
{
  CHECK(value("1e-3") == 1e-3);
  CHECK(value(".5") == 0.5);
  CHECK(value("5.") == 5.0);
  CHECK(value("1.25E+2") == 125.0);
}

TEST_CASE("variables and constants take their values")
{
  CHECK(value("x + 10 * y + 100 * z + 1000 * t", 1, 2, 3, 4) == 4321.0);
  CHECK(value("U * height") == 1.0);
  CHECK(value("pi") == std::numbers::pi);
}

TEST_CASE("every function agrees with the standard library")
{
  const double x = 0.3;
  CHECK(value("abs(-x)", x) == x);
  CHECK(value("sqrt(x)", x) == std::sqrt(x));
  CHECK(value("exp(x)", x) == std::exp(x));
  CHECK(value("log(x)", x) == std::log(x));
  CHECK(value("sin(x)", x) == std::sin(x));
  CHECK(value("cos(x)", x) == std::cos(x));
  CHECK(value("tan(x)", x) == std::tan(x));
  CHECK(value("asin(x)", x) == std::asin(x));
  CHECK(value("acos(x)", x) == std::acos(x));
  CHECK(value("atan(x)", x) == std::atan(x));
  CHECK(value("atan2(x, -2)", x) == std::atan2(x, -2.0));
  CHECK(value("sinh(x)", x) == std::sinh(x));
  CHECK(value("cosh(x)", x) == std::cosh(x));
  CHECK(value("tanh(x)", x) == std::tanh(x));
  CHECK(value("min(x, 2)", x) == x);
  CHECK(value("max(x, 2)", x) == 2.0);
  CHECK(value("max(1, x, 7, 2)", x) == 7.0);
  CHECK(value("pow(x, 2.5)", x) == std::pow(x, 2.5));
  CHECK(value("floor(-x)", x) == -1.0);
}

TEST_CASE("a step is 0 before 0 and 1 from there on")
{
  CHECK(value("step(x)", -1e-300) == 0.0);
  CHECK(value("step(x)", 0.0) == 1.0);
  CHECK(value("step(x)", 2.0) == 1.0);
}

TEST_CASE("a ramp rises smoothly from 0 to 1")
{
  CHECK(value("ramp(t, 2)", 0, 0, 0, -1.0) == 0.0);
  CHECK(value("ramp(t, 2)", 0, 0, 0, 0.0) == 0.0);
  CHECK(value("ramp(t, 2)", 0, 0, 0, 1.0) == doctest::Approx(0.5).epsilon(1e-15));
  CHECK(value("ramp(t, 2)", 0, 0, 0, 0.5) == doctest::Approx(0.5 * (1.0 - std::sqrt(0.5))).epsilon(1e-15));
  CHECK(value("ramp(t, 2)", 0, 0, 0, 2.0) == 1.0);
  CHECK(value("ramp(t, 2)", 0, 0, 0, 9.0) == 1.0);
}

TEST_CASE("comparisons and logic give 1 or 0")
{
  CHECK(value("x < 1", 0.5) == 1.0);
  CHECK(value("x < 1", 1.0) == 0.0);
  CHECK(value("x <= 1", 1.0) == 1.0);
  CHECK(value("x > 1", 1.0) == 0.0);
  CHECK(value("x > 1", 1.5) == 1.0);
  CHECK(value("x >= 1", 1.0) == 1.0);
  CHECK(value("x = 1", 1.0) == 1.0);
  CHECK(value("x == 1", 1.0 + 1e-15) == 0.0);
  CHECK(value("x != 1", 1.0) == 0.0);
  CHECK(value("3 * (x > 0)", 1.0) == 3.0);
  CHECK(value("not x = 1", 1.0) == 0.0);
}

TEST_CASE("'and' binds tighter than 'or' and 'not' tighter than both")
{
  CHECK(value("x = 0 or y = 0 and z = 0", 0, 1, 1) == 1.0);
  CHECK(value("(x = 0 or y = 0) and z = 0", 0, 1, 1) == 0.0);
  CHECK(value("not x = 0 and y = 0", 1, 0) == 1.0);
  CHECK(value("not (x = 0 and y = 0)", 0, 0) == 0.0);
}

TEST_CASE("a branch that is not taken cannot spoil the value")
{
  CHECK(value("if(x > 0, 1 / x, 5)", 0.0) == 5.0);
  CHECK(value("if(x > 0, sqrt(x), sqrt(-x))", -4.0) == 2.0);
}

TEST_CASE("division by zero and undefined roots give inf and nan as IEEE says")
{
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(value("1 / x", 0.0) == infinity);
  CHECK(value("-1 / x", 0.0) == -infinity);
  CHECK(std::isnan(value("x / x", 0.0)));
  CHECK(std::isnan(value("sqrt(x)", -1.0)));
  CHECK(value("log(x)", 0.0) == -infinity);
}

TEST_CASE("nan survives minimum, maximum, step, ramp and if")
{
  for (const char* text : {"min(0 / x, 1)", "min(1, 0 / x)", "max(0 / x, 1)", "max(1, 0 / x)", "step(0 / x)",
                           "ramp(0 / x, 1)", "ramp(1, 0 / x)", "if(0 / x, 1, 2)"})
  {
    CAPTURE(text);
    CHECK(std::isnan(value(text, 0.0)));
  }
}

TEST_CASE("an expression knows what it depends on and its text")
{
  const Expression constant("2 * U", constants, all);
  CHECK(constant.is_constant());
  CHECK_FALSE(constant.depends_on_time());
  CHECK(constant.text() == "2 * U");
  CHECK_FALSE(Expression("x", constants, all).is_constant());
  CHECK_FALSE(Expression("x", constants, all).depends_on_time());
  CHECK(Expression("ramp(t, 1)", constants, all).depends_on_time());
  CHECK(Expression(0.3).text() == "0.3");
  CHECK(Expression(0.3)(1.0) == 0.3);
  CHECK(Expression()(1.0, 2.0, 3.0, 4.0) == 0.0);
  CHECK(Expression().text() == "0");
}

TEST_CASE("a mistake is reported with its column, what was found and what is allowed")
{
  CHECK(complaint("1 +") ==
        "column 4 of \"1 +\": found the end where a number, a name, '(' or '-' is allowed");
  CHECK(complaint("") == "column 1 of \"\": found the end where a number, a name, '(' or '-' is allowed");
  CHECK(complaint("2 x") ==
        "column 3 of \"2 x\": found 'x' where an operator (+ - * / ^, a comparison, 'and', "
        "'or') or the end is allowed");
  CHECK(complaint("(x + 1") == "column 7 of \"(x + 1\": found the end where ')' is allowed");
  CHECK(complaint("x ** 2") == "column 3 of \"x ** 2\": found '**', which is written '^' here");
  CHECK(complaint("x && y") == "column 3 of \"x && y\": found '&&', which is written 'and' here");
  CHECK(complaint("x % 2") ==
        "column 3 of \"x % 2\": found '%', which no formula contains; allowed are numbers, "
        "names and + - * / ^ ( ) , = == != < <= > >=");
  CHECK(complaint("1e999") ==
        "column 1 of \"1e999\": the number '1e999' is too large or too small for a double");
  CHECK(complaint("atan2(x)") == "column 1 of \"atan2(x)\": 'atan2' takes 2 arguments, found 1");
  CHECK(complaint("2 + sin(x, y)") == "column 5 of \"2 + sin(x, y)\": 'sin' takes 1 argument, found 2");
  CHECK(complaint("max(x)") == "column 1 of \"max(x)\": 'max' takes at least 2 arguments, found 1");
  CHECK(complaint("sin x") ==
        "column 5 of \"sin x\": found 'x' where '(' after the function 'sin' is allowed");
  CHECK(complaint("sin(x; y)") ==
        "column 6 of \"sin(x; y)\": found ';', which no formula contains; allowed are "
        "numbers, names and + - * / ^ ( ) , = == != < <= > >=");
  CHECK(complaint("0 < x < 1") ==
        "column 7 of \"0 < x < 1\": comparisons cannot be chained; write 0 < x and x < 1");
}

TEST_CASE("columns count letters, not bytes")
{
  CHECK(complaint("é") ==
        "column 1 of \"é\": found 'é', which no formula contains; allowed are numbers, names and "
        "+ - * / ^ ( ) , = == != < <= > >=");
}

TEST_CASE("an unknown name is answered with the nearest known one")
{
  CHECK(complaint("heigth * y") ==
        "column 1 of \"heigth * y\": unknown name 'heigth'; did you mean 'height'? known "
        "are x, y, z, t, U, height, pi");
  CHECK(complaint("rmp(t, 1)") == "column 1 of \"rmp(t, 1)\": unknown function 'rmp'; did you mean 'ramp'?");
  CHECK(complaint("1 + V") == "column 5 of \"1 + V\": unknown name 'V'; known are x, y, z, t, U, height, pi");
}

TEST_CASE("a variable that may not occur is refused")
{
  CHECK(complaint("x + t", {"x", "y"}) ==
        "column 5 of \"x + t\": 't' may not occur here; allowed are x, y, U, height, pi");
}

TEST_CASE("nesting is limited, so that no text can exhaust the stack")
{
  const std::string deep(100000, '(');
  CHECK(complaint(deep).find("nested more than 100 levels deep") != std::string::npos);
  CHECK(complaint(std::string(100000, '-')).find("nested more than 100 levels deep") != std::string::npos);
  std::string right = "x";
  for (int i = 0; i < 80; ++i)
    right.insert(0, "x + (").append(")");
  CHECK(complaint(right).find("more than 64 values wait") != std::string::npos);
}

TEST_CASE("equality in a condition holds within the tolerance")
{
  const Condition left("x = 0", constants);
  CHECK(left.holds(0.0, 5.0, 0.0, 1e-9));
  CHECK(left.holds(-9e-10, 5.0, 0.0, 1e-9));
  CHECK_FALSE(left.holds(2e-9, 5.0, 0.0, 1e-9));
  const Condition sides("y = 0 or y = height", constants);
  CHECK(sides.holds(7.0, 2.0 + 1e-10, 0.0, 1e-9));
  CHECK_FALSE(sides.holds(7.0, 1.0, 0.0, 1e-9));
  CHECK(Condition("x != 0", constants).holds(1.0, 0.0, 0.0, 1e-9));
  CHECK_FALSE(Condition("x != 0", constants).holds(1e-10, 0.0, 0.0, 1e-9));
}

TEST_CASE("a condition's inequalities include the edge of the set")
{
  const Condition part("x > 0.2 and y = 0", constants);
  CHECK(part.holds(0.3, 0.0, 0.0, 1e-9));
  CHECK(part.holds(0.2, 0.0, 0.0, 1e-9));
  CHECK_FALSE(part.holds(0.19, 0.0, 0.0, 1e-9));
  CHECK(Condition("x <= 1", constants).holds(1.0 + 1e-10, 0.0, 0.0, 1e-9));
  CHECK_FALSE(Condition("x <= 1", constants).holds(1.1, 0.0, 0.0, 1e-9));
}

TEST_CASE("a condition that is a number or mixes numbers with logic is refused")
{
  CHECK(condition_complaint("x") == "column 1 of \"x\": this is a number, not a condition; compare it with "
                                    "something, as in x = 0");
  CHECK(condition_complaint("y = 0 or 0.41") ==
        "column 10 of \"y = 0 or 0.41\": found a number beside 'or', where "
        "a comparison such as x = 0 is allowed");
  CHECK(condition_complaint("t = 0") ==
        "column 1 of \"t = 0\": 't' may not occur here; allowed are x, y, z, U, height, pi");
}

TEST_CASE("a surface's u and v are the first and the second argument")
{
  const std::vector<std::string_view> on_surface{"u", "v"};
  CHECK(Expression("u - 3 * v", {}, on_surface)(5.0, 1.0) == 2.0);
  CHECK_FALSE(Expression("u - 3 * v", {}, on_surface).is_constant());
  CHECK_THROWS_AS(Expression("u", {}, std::vector<std::string_view>{"x", "y"}), Error);
}
