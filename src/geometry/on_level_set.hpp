#pragma once

#include "geometry/arc_length.hpp"
#include "geometry/project.hpp"

#include <memory>
#include <optional>
#include <span>

namespace blockfsi::geometry
{

/// The curve of an edge on a level set, found by projecting the straight line between its ends: along
/// `direction` if given, else along the gradient without its part along the chord (in the plane that is the
/// chord's normal); with `second`, onto the curve of both level sets, within the planes normal to the chord.
struct OnLevelSet
{
  LevelSet surface;
  std::optional<LevelSet> second{};
  std::optional<Point> direction{};
  bool by_length = true;  ///< the parameter is the share of the length, else that of the chord
  /// Of the curve between its ends, made by `measured`; without it, the parameter is that of the chord.
  std::shared_ptr<const ArcLength> lengths{};
};

/// Throws Error if an end does not lie on the level set (1e-9 of the chord), if a search between the ends
/// fails, or if the points found turn back or jump, with the place, the reason and a remedy.
void check(const OnLevelSet& curve, const Point& a, const Point& b);

/// The point at parameter t between the ends. Allocates nothing where the parameter is that of the chord.
[[nodiscard]] Found find(const OnLevelSet& curve, const Point& a, const Point& b, double t);

/// The point at parameter t; throws Error where the search fails.
Point evaluate(const OnLevelSet& curve, const Point& a, const Point& b, double t);

/// The same curve with its lengths. Throws Error where a search fails.
OnLevelSet measured(const OnLevelSet& curve, const Point& a, const Point& b);

/// Length of the curve [m]. Throws Error where a search fails.
double length(const OnLevelSet& curve, const Point& a, const Point& b);

/// The nodes of an edge at ascending parameters t, shape (t.size()), the ends included: exactly a at 0 and b
/// at
/// 1. Nodes whose search failed stay on the chord. The report tells of these, of a node that does not lie
/// ahead of the one before along the chord, and of collapsing gradients.
[[nodiscard]] ProjectionReport project_edge(const OnLevelSet& curve, const Point& a, const Point& b,
                                            std::span<const double> t, std::span<Point> x);

}  // namespace blockfsi::geometry
