#include "geometry/project.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace blockfsi::geometry
{

namespace
{

constexpr double relative_tolerance = 1e-13;  ///< of the local size
constexpr double growth = 1.3;                ///< of the steps towards a bracket
constexpr double smallest_share = 1.0 / 256;  ///< of the way that the first step goes
constexpr int most_iterations = 200;          ///< bisection alone needs about 60
constexpr double flat_share = 1e-6;           ///< slope at the root over mean slope on the way to it

bool positive(double value)
{
  return value > 0.0 && std::isfinite(value);
}

/// No search can tell points apart that differ by the rounding of their coordinates.
double step_tolerance(const SearchLimits& limits, const Point& start)
{
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() *
                          std::max({std::abs(start[0]), std::abs(start[1]), std::abs(start[2])});
  return std::max(relative_tolerance * limits.size, rounding);
}

double reach(const SearchLimits& limits)
{
  return limits.farthest > 0.0 ? limits.farthest : limits.size;
}

/// φ and its derivative at a place on the line.
struct Slope
{
  double value;
  double derivative;
};

/// φ along a line, counting evaluations.
struct Line
{
  const LevelSet& surface;
  Point start;
  Point unit;
  int evaluations = 0;

  Point at(double s) const { return add_scaled(start, s, unit); }
  double value(double s)
  {
    ++evaluations;
    return surface.value(at(s));
  }
  Slope level(double s)
  {
    ++evaluations;
    const Level found = surface(at(s));
    return {found.value, dot(found.gradient, unit)};
  }
};

/// Two places on the line between which φ changes its sign.
struct Bracket
{
  double low = 0.0;
  double high = 0.0;
  double value_low = 0.0;
  double value_high = 0.0;
};

/// One of the two ways to go from the start.
struct Way
{
  double sign;
  bool open;
  double s = 0.0;
  double value = 0.0;
};

/// Searches in growing steps for a change of sign; without one, the bracket's ends are those of the search.
std::pair<bool, Bracket> find_bracket(Line& line, const Slope& first, double farthest, bool both_ways)
{
  const double downhill = first.value * first.derivative > 0.0 ? -1.0 : 1.0;
  std::array<Way, 2> ways{
      {{both_ways ? downhill : 1.0, true, 0.0, first.value}, {-downhill, both_ways, 0.0, first.value}}};
  const double expected = 1.5 * std::abs(first.value) / std::abs(first.derivative);
  double step = std::isfinite(expected) ? std::clamp(expected, smallest_share * farthest, farthest)
                                        : smallest_share * farthest;
  for (double s = 0.0; s < farthest && (ways[0].open || ways[1].open); step *= growth)
  {
    s = std::min(s + step, farthest);
    for (Way& way : ways)
    {
      if (!way.open)
        continue;
      const double value = line.value(way.sign * s);
      way.open = std::isfinite(value);
      if (!way.open)
        continue;
      if (value == 0.0 || (value < 0.0) != (way.value < 0.0))
        return {true, {way.s, way.sign * s, way.value, value}};
      way.s = way.sign * s;
      way.value = value;
    }
  }
  return {false, {std::min(ways[0].s, ways[1].s), std::max(ways[0].s, ways[1].s), 0.0, 0.0}};
}

/// The place in a bracket where a straight φ would vanish.
double secant(const Bracket& bracket)
{
  const double share = bracket.value_low / (bracket.value_low - bracket.value_high);
  return bracket.low + share * (bracket.high - bracket.low);
}

struct Root
{
  double s = 0.0;
  Slope last{};  ///< where φ was evaluated last
};

/// Newton's method inside the bracket, with bisection where it leaves the bracket or does not halve its steps
/// (as "rtsafe" of Press et al. 2007, section 9.4).
Root find_root(Line& line, Bracket& bracket, double tolerance)
{
  Root root{secant(bracket)};
  double before = std::abs(bracket.high - bracket.low);
  double step = before;
  for (int iteration = 0; iteration < most_iterations; ++iteration)
  {
    root.last = line.level(root.s);
    const auto [value, derivative] = root.last;
    if (value == 0.0)
    {
      bracket.low = bracket.high = root.s;
      break;
    }
    ((value < 0.0) == (bracket.value_low < 0.0) ? bracket.low : bracket.high) = root.s;
    double next = root.s - value / derivative;
    const bool inside = (next - bracket.low) * (next - bracket.high) < 0.0;
    if (!inside || std::abs(2.0 * value) > std::abs(before * derivative))
      next = 0.5 * (bracket.low + bracket.high);
    before = step;
    step = std::abs(next - root.s);
    root.s = next;
    if (step < tolerance)
      break;
  }
  return root;
}

/// Whether φ jumps over 0 or has a pole at the "root": there |φ| stays large beside its slope and beside what
/// it was at the ends of the bracket.
bool jumps(const Root& root, double ends, double tolerance)
{
  const double value = std::abs(root.last.value);
  if (!std::isfinite(value) || value > 1e3 * ends)
    return true;
  return value > 0.1 * ends && value > 1e3 * tolerance * std::abs(root.last.derivative);
}

Found failure(SearchStatus status, const Point& start, int evaluations)
{
  Found found;
  found.status = status;
  found.x = start;
  found.evaluations = evaluations;
  return found;
}

/// A level set's value and its gradient, or that gradient's part in a plane.
Level level_in_plane(const LevelSet& surface, const Point& x, const std::optional<Point>& normal)
{
  Level level = surface(x);
  if (normal)
    level.gradient = add_scaled(level.gradient, -dot(level.gradient, *normal), *normal);
  return level;
}

/// The shortest step that would make both linearised level sets vanish; nothing if their gradients are
/// (nearly) parallel.
std::optional<Point> least_step(const Level& a, const Level& b)
{
  const double aa = dot(a.gradient, a.gradient);
  const double bb = dot(b.gradient, b.gradient);
  const double ab = dot(a.gradient, b.gradient);
  const Point normal = cross(a.gradient, b.gradient);
  const double determinant = dot(normal, normal);
  if (!(determinant > 1e-16 * aa * bb))
    return {};
  const double p = (a.value * bb - b.value * ab) / determinant;
  const double q = (b.value * aa - a.value * ab) / determinant;
  return combine(-p, a.gradient, -q, b.gradient);
}

/// Distance-like measure of how far both level sets are from 0.
double excess(const Level& a, const Level& b, double scale_a, double scale_b)
{
  return std::hypot(a.value / scale_a, b.value / scale_b);
}

}  // namespace

std::string text(SearchStatus status)
{
  switch (status)
  {
  case SearchStatus::converged:
    return "converged";
  case SearchStatus::no_gradient:
    return "no gradient";
  case SearchStatus::no_bracket:
    return "no change of sign";
  case SearchStatus::jump:
    return "a jump instead of a root";
  case SearchStatus::too_far:
    return "too far away";
  default:
    return "no progress";
  }
}

Found project(const LevelSet& surface, const Point& start, const Point& direction, const SearchLimits& limits)
{
  const double size = norm(direction);
  if (!positive(size))
    return failure(SearchStatus::no_gradient, start, 0);
  Line line{surface, start, scaled(1.0 / size, direction)};
  const double tolerance = step_tolerance(limits, start);
  const Slope first = line.level(0.0);
  Found found = failure(SearchStatus::no_bracket, start, 1);
  if (!std::isfinite(first.value))
    return found;
  if (std::abs(first.value) <= tolerance * std::abs(first.derivative))
  {
    found.status = SearchStatus::converged;
    return found;
  }
  auto [crossed, bracket] = find_bracket(line, first, reach(limits), limits.both_ways);
  const double ends = std::max(std::abs(bracket.value_low), std::abs(bracket.value_high));
  if (crossed)
  {
    const Root root = find_root(line, bracket, tolerance);
    const double mean = std::abs(first.value) / std::abs(root.s);
    const bool jump = jumps(root, ends, tolerance);
    found.status = jump ? SearchStatus::jump : SearchStatus::converged;
    found.moved = jump ? 0.0 : root.s;
    found.x = line.at(found.moved);
    found.flat = !jump && std::abs(root.last.derivative) < flat_share * mean;
  }
  found.low = std::min(bracket.low, bracket.high);
  found.high = std::max(bracket.low, bracket.high);
  found.evaluations = line.evaluations;
  return found;
}

Found project_along_gradient(const LevelSet& surface, const Point& start, const SearchLimits& limits)
{
  Found found = project(surface, start, surface(start).gradient, limits);
  found.evaluations += 1;
  return found;
}

Found project(const LevelSet& a, const LevelSet& b, const Point& start, const SearchLimits& limits,
              const std::optional<Point>& plane)
{
  std::optional<Point> normal;
  if (plane)
    normal = scaled(1.0 / norm(*plane), *plane);
  const double tolerance = step_tolerance(limits, start);
  Point x = start;
  Level level_a = level_in_plane(a, x, normal);
  Level level_b = level_in_plane(b, x, normal);
  int evaluations = 2;
  const double scale_a = norm(level_a.gradient);
  const double scale_b = norm(level_b.gradient);
  if (!positive(scale_a) || !positive(scale_b))
    return failure(SearchStatus::no_gradient, start, evaluations);
  for (int iteration = 0; iteration < most_iterations; ++iteration)
  {
    std::optional<Point> step = least_step(level_a, level_b);
    if (!step)
      return failure(SearchStatus::no_gradient, start, evaluations);
    const double length = norm(*step);
    if (length <= tolerance)
    {
      Found found = failure(SearchStatus::converged, add(x, *step), evaluations);
      found.moved = distance(found.x, start);
      const double shrink = std::min(norm(level_a.gradient) / scale_a, norm(level_b.gradient) / scale_b);
      found.flat = shrink < flat_share;
      if (found.moved <= reach(limits))
        return found;
      return failure(SearchStatus::too_far, start, evaluations);
    }
    // Steps longer than the local size leave the neighbourhood where the linearisation means anything.
    double share = std::min(1.0, 0.5 * limits.size / length);
    const double now = excess(level_a, level_b, scale_a, scale_b);
    Point next = x;
    for (bool better = false; !better; share *= 0.5)
    {
      if (share * length < 0.1 * tolerance || !std::isfinite(length))
        return failure(SearchStatus::no_progress, start, evaluations);
      next = add_scaled(x, share, *step);
      level_a = level_in_plane(a, next, normal);
      level_b = level_in_plane(b, next, normal);
      evaluations += 2;
      better = excess(level_a, level_b, scale_a, scale_b) < now;
    }
    x = next;
  }
  return failure(SearchStatus::no_progress, start, evaluations);
}

ProjectionReport project_nodes(const LevelSet& surface, std::span<const Point> start,
                               std::span<const Point> normal, const SearchLimits& limits, std::span<Point> x)
{
  ProjectionReport report;
  for (std::size_t i = 0; i < start.size(); ++i)
  {
    const Found found = project(surface, start[i], normal[i], limits);
    report.note(i, found);
    x[i] = found.x;
  }
  return report;
}

void ProjectionReport::note(std::size_t index, const Found& found)
{
  evaluations += found.evaluations;
  farthest = std::max(farthest, std::abs(found.moved));
  if (found.flat && flat_count++ == 0)
    flat_index = index;
  if (!found.ok())
    failures.push_back({index, found});
}

}  // namespace blockfsi::geometry
