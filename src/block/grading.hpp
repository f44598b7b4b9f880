#pragma once

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

/// How cells are distributed along an edge.
using Grading = std::variant<Uniform, Geometric, FirstCell, TwoSided>;

/// Parameters of the n + 1 cell corners along an edge of the given length [m]: ascending from 0 to 1.
/// Throws Error where the grading cannot be met (a first cell as long as the edge, n < 1, ...).
std::vector<double> parameters(const Grading& grading, int n, double length);

/// The same distribution seen from the other end of the edge.
Grading reversed(const Grading& grading);

}  // namespace blockfsi::block
