#pragma once

#include "geometry/level_set.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace blockfsi::geometry
{

/// How a search for a point of a level set ended.
enum class SearchStatus
{
  converged,
  no_gradient,  ///< no direction: the gradient (or what the rule leaves of it) is zero or not finite
  no_bracket,   ///< φ keeps its sign as far as the search may go
  jump,         ///< φ changes its sign in a jump or at a pole, not at a root
  too_far,      ///< the point found is farther away than allowed
  no_progress   ///< two level sets: Newton's method stalled, as where they touch or do not meet
};

/// "no bracket" and so on, for messages.
std::string text(SearchStatus status);

/// How far to look and how exactly.
struct SearchLimits
{
  double size = 0.0;  ///< local size [m], as the length of the chord: steps below 1e-13 of it end the search
  double farthest = 0.0;  ///< largest distance from the start [m]; 0: `size`
  bool both_ways = true;  ///< also against the direction
};

/// What a search found. Where it failed, `x` is the start.
struct Found
{
  SearchStatus status = SearchStatus::converged;
  Point x{};           ///< the point
  double moved = 0.0;  ///< signed distance from the start along the direction [m]
  double low = 0.0;    ///< ends of the last bracket, or of the part that was searched [m]
  double high = 0.0;
  int evaluations = 0;  ///< of φ, with or without its gradient
  bool flat = false;    ///< the gradient collapses at the root, as of φ³: the search is slow there

  bool ok() const { return status == SearchStatus::converged; }
};

/// The point of φ = 0 on the line through `start` along `direction` that a search in growing steps meets
/// first: steps from 1.5 |φ| / |∂φ| growing by 1.3, downhill first, until φ changes its sign; then Newton's
/// method kept inside the bracket by bisection. Allocates nothing.
[[nodiscard]] Found project(const LevelSet& surface, const Point& start, const Point& direction,
                            const SearchLimits& limits);

/// The point of φ = 0 along the gradient at the start.
[[nodiscard]] Found project_along_gradient(const LevelSet& surface, const Point& start,
                                           const SearchLimits& limits);

/// The point where φ_a = φ_b = 0 near `start`, by damped Newton steps of least length; with `plane`, a
/// normal, within the plane through `start`, as for the edge between two faces whose chord is the normal.
/// `moved` is the distance from the start. Allocates nothing.
[[nodiscard]] Found project(const LevelSet& a, const LevelSet& b, const Point& start,
                            const SearchLimits& limits, const std::optional<Point>& plane = {});

/// A node whose search failed.
struct Failure
{
  std::size_t index = 0;
  Found found;
};

/// What became of many searches.
struct ProjectionReport
{
  std::vector<Failure> failures;
  std::size_t flat_count = 0;           ///< nodes where the gradient collapses
  std::size_t flat_index = 0;           ///< the first of them
  std::optional<std::size_t> reversal;  ///< of edges: the first node that does not lie behind the one before
  double farthest = 0.0;                ///< largest distance of a node from its start [m]
  double spacing_error = 0.0;           ///< of redistributed edges: largest miss of a parameter, relative
  long evaluations = 0;

  bool ok() const { return failures.empty() && !reversal; }
  /// Adds what became of a node.
  void note(std::size_t index, const Found& found);
};

/// Projects the nodes of a face: x[i] on the line through start[i] along normal[i] (the normal of the Coons
/// face). `x` may be `start`. Nodes that fail stay at their start and are reported.
[[nodiscard]] ProjectionReport project_nodes(const LevelSet& surface, std::span<const Point> start,
                                             std::span<const Point> normal, const SearchLimits& limits,
                                             std::span<Point> x);

}  // namespace blockfsi::geometry
