#pragma once

#include "block/grading.hpp"
#include "block/layout.hpp"
#include "core/error.hpp"
#include "geometry/curve.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace blockfsi::block
{

/// A rectangular lattice of blocks drawn as text: columns between the x, rows between the y.
///
/// Point (i, j) sits at (x[i], y[j]) and is named "<name> x<i> y<j>", both counted from 0 as given; block (i,
/// j) lies between x[i], x[i + 1] and y[j], y[j + 1] and is named "block (i, j) of <name>". Only points of
/// blocks exist. A hole is a set of "." that touch along a side; holes are numbered from 1 as one reads, line
/// by line.
struct Lattice
{
  std::string name;
  std::vector<double> x;  ///< ascending [m]
  std::vector<double> y;  ///< descending or ascending [m]; the first drawn row lies between the first two
  std::vector<std::string>
      draw;                   ///< a line per row: regions of its blocks with blanks between, "." for no block
  std::vector<int> divide_x;  ///< cells across each column, 0: not said; empty or one per column
  std::vector<int> divide_y;  ///< cells across each row, 0: not said; empty or one per row
  std::vector<std::optional<Grading>>
      grade_x;  ///< of each column towards increasing x; empty or one per column
  std::vector<std::optional<Grading>> grade_y;  ///< of each row towards increasing y; empty or one per row

  /// A point that does not sit at (x[i], y[j]).
  struct Place
  {
    int i = 0;
    int j = 0;
    std::array<double, 2> x{};  ///< [m]
  };
  std::vector<Place> places;

  /// A hole whose sides are arcs of a circle. Its points are moved radially onto the circle, but those in
  /// `places` stay (and must lie on it).
  struct CircleSides
  {
    int hole = 1;
    std::array<double, 2> center{};  ///< [m]
    double radius = 0.0;             ///< [m]
  };
  std::vector<CircleSides> circles;

  /// The curve between two neighbouring points (i, j), instead of a segment or an arc of a hole.
  struct EdgeCurve
  {
    std::array<int, 2> from{};
    std::array<int, 2> to{};
    geometry::Curve curve;
  };
  std::vector<EdgeCurve> curves;
  Location where;
};

/// Appends the points, blocks, edges and hole edges of a drawn lattice to a layout.
/// Throws Error (at the lattice's place) for lines or lists of the wrong length, coordinates out of order, no
/// blocks at all, and for places, circles and curves that refer to what the drawing does not have.
void add(Layout& layout, const Lattice& lattice);

}  // namespace blockfsi::block
