#pragma once

#include <optional>
#include <variant>
#include <vector>

namespace blockfsi::block
{

/// Cells of equal size.
struct Uniform
{
  bool operator==(const Uniform&) const = default;
};

/// Each cell is `ratio` times as long as the one before it.
struct Geometric
{
  double ratio = 1.0;

  bool operator==(const Geometric&) const = default;
};

/// The cell at the start (or the end) has the given size; sizes grow geometrically from there.
struct FirstCell
{
  double size = 0.0;  ///< [m]
  bool at_end = false;

  bool operator==(const FirstCell&) const = default;
};

/// The first and the last cell have the given sizes (Vinokur 1983, corrected so that both are hit).
struct TwoSided
{
  double first = 0.0;  ///< [m]
  double last = 0.0;   ///< [m]

  bool operator==(const TwoSided&) const = default;
};

/// The cell at the start (or the end) has the given size; sizes grow as a hyperbolic tangent and level off at
/// the other end: t = 1 + tanh(δ (i/n - 1)) / tanh(δ), tan where the first cell is larger than equal ones.
struct OneSided
{
  double size = 0.0;  ///< [m]
  bool at_end = false;

  bool operator==(const OneSided&) const = default;
};

/// Chebyshev's points, t = (1 - cos(pi i / n)) / 2: fine at both ends.
struct Cosine
{
  bool operator==(const Cosine&) const = default;
};

/// Cell corners where the list has them, ascending, on any scale: the first is the start of the edge, the
/// last its end.
struct Positions
{
  std::vector<double> values;  ///< shape (n + 1)

  bool operator==(const Positions&) const = default;
};

/// Cells as long as the list says, relative to each other.
struct Sizes
{
  std::vector<double> values;  ///< shape (n)

  bool operator==(const Sizes&) const = default;
};

/// How cells are distributed along an edge.
using Grading = std::variant<Uniform, Geometric, FirstCell, TwoSided, OneSided, Cosine, Positions, Sizes>;

/// The number of cells that a list is made for; nothing for laws that suit any number.
std::optional<int> cell_count(const Grading& grading);

/// Parameters of the n + 1 cell corners along an edge of the given length [m]: ascending from 0 to 1.
/// Throws Error where the grading cannot be met (a first cell as long as the edge, n < 1, ...).
std::vector<double> parameters(const Grading& grading, int n, double length);

/// The same distribution seen from the other end of the edge.
Grading reversed(const Grading& grading);

}  // namespace blockfsi::block
