#pragma once

#include <optional>
#include <span>
#include <vector>

namespace blockfsi::coupling
{

/// Where the interface was: the displacement at the ends of the last steps.
struct Past
{
  /// [m], newest first, each of shape (size); not empty, at most `most_kept`. All steps between them have the
  /// same length.
  std::vector<std::vector<double>> d;
  double step = 0.0;  ///< length of the steps between them [s]
};

constexpr int highest_order = 5;  ///< of a prediction
constexpr int judged = 3;         ///< steps on which orders are compared
constexpr int most_kept = highest_order + 1 + judged;

/// Adds the end of a step of that length; where the length is another one, only the start of the step is
/// kept beside it.
///   d [m], shape (size).
void remember(Past& past, std::span<const double> d, double step);

/// The order whose predictions of the newest `judged` of `past`, each from those before it, would have missed
/// least in the mean square; while not all orders can be compared on so many, on fewer. The highest possible
/// while fewer than three are known.
int best_order(const Past& past);

/// The interface at the end of the next step: the polynomial through the last order + 1 known, extrapolated.
/// Lower orders while fewer are known, and after a step of another length order 1 at most.
///   order: 0..highest_order, none for best_order;  step: length of the next step [s];
///   out [m], shape (size).
void predict(std::optional<int> order, const Past& past, double step, std::span<double> out);

}  // namespace blockfsi::coupling
