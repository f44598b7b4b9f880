#pragma once

#include "core/lanes.hpp"

#include <array>

namespace blockfsi
{

/// A number with its derivatives with respect to N inputs: forward-mode automatic differentiation.
/// T is double or Lanes. Operations with plain T treat it as a constant.
template <class T, int N>
struct Dual
{
  T value{};
  std::array<T, N> derivative{};

  Dual() = default;
  Dual(const T& constant) : value(constant) {}  // NOLINT: a constant is a dual number

  /// The i-th input itself.
  static Dual input(const T& value, int i)
  {
    Dual result(value);
    result.derivative[i] = T{} + 1.0;
    return result;
  }

  friend Dual operator+(const Dual& a, const Dual& b)
  {
    Dual c(a.value + b.value);
    for (int i = 0; i < N; ++i)
      c.derivative[i] = a.derivative[i] + b.derivative[i];
    return c;
  }
  friend Dual operator-(const Dual& a, const Dual& b)
  {
    Dual c(a.value - b.value);
    for (int i = 0; i < N; ++i)
      c.derivative[i] = a.derivative[i] - b.derivative[i];
    return c;
  }
  friend Dual operator-(const Dual& a) { return a * (T{} - 1.0); }
  friend Dual operator*(const Dual& a, const Dual& b)
  {
    Dual c(a.value * b.value);
    for (int i = 0; i < N; ++i)
      c.derivative[i] = a.derivative[i] * b.value + a.value * b.derivative[i];
    return c;
  }
  friend Dual operator/(const Dual& a, const Dual& b)
  {
    const T inverse = 1.0 / b.value;
    Dual c(a.value * inverse);
    for (int i = 0; i < N; ++i)
      c.derivative[i] = (a.derivative[i] - c.value * b.derivative[i]) * inverse;
    return c;
  }

  friend Dual operator+(const Dual& a, const T& b)
  {
    Dual c = a;
    c.value += b;
    return c;
  }
  friend Dual operator+(const T& a, const Dual& b) { return b + a; }
  friend Dual operator-(const Dual& a, const T& b)
  {
    Dual c = a;
    c.value -= b;
    return c;
  }
  friend Dual operator-(const T& a, const Dual& b) { return Dual(a) - b; }
  friend Dual operator*(const Dual& a, const T& b)
  {
    Dual c(a.value * b);
    for (int i = 0; i < N; ++i)
      c.derivative[i] = a.derivative[i] * b;
    return c;
  }
  friend Dual operator*(const T& a, const Dual& b) { return b * a; }

  friend Dual sqrt(const Dual& a)
  {
    Dual c(T(sqrt(a.value)));
    const T factor = 0.5 / c.value;
    for (int i = 0; i < N; ++i)
      c.derivative[i] = a.derivative[i] * factor;
    return c;
  }
};

}  // namespace blockfsi
