#include "geometry/on_level_set.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace blockfsi::geometry
{

namespace
{

constexpr double fit_tolerance =
    1e-9;                    ///< of the chord, that the user's rounded points may miss the level set
constexpr int samples = 32;  ///< between the ends, for checks

/// What is left of a vector without its part along the chord.
Point across(const Point& v, const Point& chord)
{
  return add_scaled(v, -dot(v, chord) / dot(chord, chord), chord);
}

/// Where to search from a point of the chord; zero if no rule gives a direction.
Point search_direction(const OnLevelSet& curve, const Point& a, const Point& b, const Point& start)
{
  if (curve.direction)
    return *curve.direction;
  const Point chord = subtract(b, a);
  const Point gradient = curve.surface(start).gradient;
  // In the plane the chord's normal is what the rule gives, also where the gradient is zero or along it.
  if (chord[2] == 0.0 && gradient[2] == 0.0 && a[2] == 0.0)
    return {-chord[1], chord[0], 0.0};
  const Point direction = across(gradient, chord);
  if (norm(direction) > fit_tolerance * norm(gradient))
    return direction;
  // On an axis of symmetry the ends still know which way is out.
  return across(add(curve.surface(a).gradient, curve.surface(b).gradient), chord);
}

Found search(const OnLevelSet& curve, const Point& a, const Point& b, double chord_parameter)
{
  const Point start = combine(1.0 - chord_parameter, a, chord_parameter, b);
  const SearchLimits limits{.size = distance(a, b)};
  if (curve.second)
    return project(curve.surface, *curve.second, start, limits, subtract(b, a));
  return project(curve.surface, start, search_direction(curve, a, b, start), limits);
}

/// Rounding beside the size of a point is no news.
std::string shown(Point p)
{
  for (double& coordinate : p)
    if (std::abs(coordinate) < 1e-14 * norm(p))
      coordinate = 0.0;
  return text(p);
}

Error search_failed(const OnLevelSet& curve, const Point& a, const Point& b, const Found& found)
{
  const std::string names = curve.second
                                ? fmt::format("'{}' and '{}'", curve.surface.text(), curve.second->text())
                                : fmt::format("'{}'", curve.surface.text());
  const Point direction = curve.second ? Point{} : search_direction(curve, a, b, found.x);
  const double size = norm(direction);
  const std::string along = size > 0.0 ? fmt::format(" along {}", shown(scaled(1.0 / size, direction))) : "";
  return Error(fmt::format(
      "the search from {}{} found no point of the level set {}: {} between {:.6g} m and {:.6g} m; "
      "correct the level set or the ends, give a direction or split the edge",
      shown(found.x), along, names, text(found.status), found.low, found.high));
}

void check_end(const LevelSet& surface, const Point& end, double size)
{
  const Level level = surface(end);
  const double miss = std::abs(level.value) / norm(level.gradient);
  if (miss <= fit_tolerance * size || level.value == 0.0)
    return;
  const Found nearest = project_along_gradient(surface, end, {.size = size});
  const std::string remedy =
      nearest.ok()
          ? fmt::format("move it there, for instance to ({:.15g}, {:.15g}{})", nearest.x[0], nearest.x[1],
                        end[2] == 0.0 && nearest.x[2] == 0.0 ? "" : fmt::format(", {:.15g}", nearest.x[2]))
          : "move it there";
  throw Error(fmt::format(
      "the end {} of the edge does not lie on the level set '{}', whose value there is {:.6g}; {}",
      shown(end), surface.text(), level.value, remedy));
}

/// Follows the larger half of a gap between neighbours: on a curve the gap shrinks, at a jump it stays.
void check_jump(const OnLevelSet& curve, const Point& a, const Point& b, double low, double high)
{
  Point x_low = evaluate(curve, a, b, low);
  Point x_high = evaluate(curve, a, b, high);
  const double first = distance(x_low, x_high);
  for (int halving = 0; halving < 20; ++halving)
  {
    const double middle = 0.5 * (low + high);
    const Point x = evaluate(curve, a, b, middle);
    const bool left = distance(x, x_low) > distance(x, x_high);
    (left ? high : low) = middle;
    (left ? x_high : x_low) = x;
  }
  if (distance(x_low, x_high) > 0.01 * first)
    throw Error(fmt::format(
        "the edge jumps from {} to {} on the level set '{}'; give a direction or split the edge by "
        "points on the level set",
        shown(x_low), shown(x_high), curve.surface.text()));
}

}  // namespace

Found find(const OnLevelSet& curve, const Point& a, const Point& b, double t)
{
  return search(curve, a, b, curve.by_length && curve.lengths ? curve.lengths->parameter(t) : t);
}

Point evaluate(const OnLevelSet& curve, const Point& a, const Point& b, double t)
{
  if (t == 0.0)
    return a;
  if (t == 1.0)
    return b;
  const Found found = find(curve, a, b, t);
  if (!found.ok())
    throw search_failed(curve, a, b, found);
  return found.x;
}

OnLevelSet measured(const OnLevelSet& curve, const Point& a, const Point& b)
{
  OnLevelSet by_chord = curve;
  by_chord.lengths = nullptr;
  OnLevelSet result = curve;
  result.lengths = std::make_shared<const ArcLength>([&](double t) { return evaluate(by_chord, a, b, t); });
  return result;
}

double length(const OnLevelSet& curve, const Point& a, const Point& b)
{
  if (curve.lengths)
    return curve.lengths->length();
  return ArcLength([&](double t) { return evaluate(curve, a, b, t); }).length();
}

ProjectionReport project_edge(const OnLevelSet& curve, const Point& a, const Point& b,
                              std::span<const double> t, std::span<Point> x)
{
  ProjectionReport report;
  const Point chord = subtract(b, a);
  for (std::size_t i = 0; i < t.size(); ++i)
  {
    if (t[i] == 0.0 || t[i] == 1.0)
      x[i] = t[i] == 0.0 ? a : b;
    else
    {
      const Found found = find(curve, a, b, t[i]);
      report.note(i, found);
      x[i] = found.x;
    }
    if (i > 0 && !report.reversal && !(dot(subtract(x[i], x[i - 1]), chord) > 0.0))
      report.reversal = i;
  }
  return report;
}

void check(const OnLevelSet& curve, const Point& a, const Point& b)
{
  const double size = distance(a, b);
  for (const Point& end : {a, b})
  {
    check_end(curve.surface, end, size);
    if (curve.second)
      check_end(*curve.second, end, size);
  }
  std::array<double, samples + 1> t{};
  for (int i = 0; i <= samples; ++i)
    t[i] = static_cast<double>(i) / samples;
  std::array<Point, samples + 1> x{};
  const ProjectionReport report = project_edge(curve, a, b, t, x);
  if (!report.failures.empty())
    throw search_failed(curve, a, b, report.failures.front().found);
  if (report.reversal)
    throw Error(fmt::format(
        "the edge turns back at {} on the level set '{}'; give another direction or split the edge",
        shown(x[*report.reversal]), curve.surface.text()));
  std::size_t widest = 1;
  for (std::size_t i = 1; i < x.size(); ++i)
    if (distance(x[i], x[i - 1]) > distance(x[widest], x[widest - 1]))
      widest = i;
  check_jump(curve, a, b, t[widest - 1], t[widest]);
}

}  // namespace blockfsi::geometry
