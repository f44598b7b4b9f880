#pragma once

#include <array>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi
{

/// Named constants that an expression may use, from the case's [let].
using Constants = std::map<std::string, double, std::less<>>;

/// A formula in x, y, z (metres), t (seconds, or the parameter of a curve) and named constants.
///
/// Grammar: numbers, + - * / ^ (right associative), unary minus, parentheses, comparisons
/// = == != < <= > >=, `and`, `or`, `not`, and the functions abs, sqrt, exp, log, sin, cos, tan, asin, acos,
/// atan, atan2, sinh, cosh, tanh, min, max, pow, floor, step(a) (0 for a < 0, else 1), if(c, a, b) and
/// ramp(t, T) = (1 - cos(pi t / T)) / 2 for 0 <= t <= T, 0 before, 1 after. Constant pi.
/// Comparisons and logic give 1 or 0.
/// A value: cheap to copy, immutable, safe to share.
class Expression
{
public:
  /// The constant 0.
  Expression();
  /// The constant value.
  Expression(double value);  // NOLINT: a number is an expression
  /// Throws Error (without a place) saying the column within the text, what was found, what is allowed.
  /// `variables` lists which of "x", "y", "z", "t" may occur, or "u", "v" for the parameters of a surface,
  /// which are then given as x and y.
  Expression(std::string_view text, const Constants& constants, std::span<const std::string_view> variables);

  /// The value at one point and time. Division by zero and the like give inf or nan as IEEE says.
  double operator()(double x, double y = 0.0, double z = 0.0, double t = 0.0) const;

  /// A value with its derivatives by x, y, z and t.
  struct Derivatives
  {
    double value = 0.0;
    std::array<double, 4> by{};
  };
  /// Value and exact derivatives (forward differentiation). At a kink or a jump they are those of the branch
  /// that gives the value.
  Derivatives derivatives(double x, double y = 0.0, double z = 0.0, double t = 0.0) const;

  /// Values at many points, shape (points.size()), faster than one by one.
  void evaluate(std::span<const std::array<double, 3>> points, double t, std::span<double> values) const;
  /// Values and gradients by x, y, z at many points, shape (points.size()) both.
  void evaluate(std::span<const std::array<double, 3>> points, double t, std::span<double> values,
                std::span<std::array<double, 3>> gradients) const;

  /// True if none of x, y, z, t occurs.
  bool is_constant() const;
  /// True if t occurs.
  bool depends_on_time() const;
  /// The text as the user wrote it ("0.3" for a number).
  const std::string& text() const;

  struct Program;

private:
  std::shared_ptr<const Program> program_;
};

/// A set of points of the plane or space given by equations and comparisons, such as
/// "x = 0", "y = 0 or y = 0.41", "x > 0.2 and y = 0". Equality holds within a given tolerance.
class Condition
{
public:
  /// Throws Error as Expression does.
  Condition(std::string_view text, const Constants& constants);

  /// Whether a point lies in the set; `tolerance` [m] is how far both sides of an equation may differ.
  bool holds(double x, double y, double z, double tolerance) const;
  const std::string& text() const;

  struct Program;

private:
  std::shared_ptr<const Program> program_;
};

}  // namespace blockfsi
