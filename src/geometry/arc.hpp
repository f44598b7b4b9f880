#pragma once

#include "geometry/path.hpp"

namespace blockfsi::geometry
{

/// The arc from a to b as a turn; `reversed`: the user's arc goes from b to a.
raw::Turn make_turn(const Arc& arc, const Point& a, const Point& b, bool reversed);
raw::Turn make_turn(const ArcThrough& arc, const Point& a, const Point& b);
raw::Turn make_turn(const Ellipse& ellipse, const Point& a, const Point& b);

/// Throw Error if the arc does not fit between a and b.
void check(const Arc& arc, const Point& a, const Point& b);
void check(const ArcThrough& arc, const Point& a, const Point& b);
void check(const Ellipse& ellipse, const Point& a, const Point& b);

/// Relative misfit that the user's rounded numbers may have.
inline constexpr double fit_tolerance = 1e-9;

}  // namespace blockfsi::geometry
