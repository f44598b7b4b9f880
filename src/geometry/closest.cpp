#include "geometry/surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace blockfsi::geometry
{

namespace
{

using Parameters = std::array<double, 2>;

constexpr double step_tolerance = 1e-13;  ///< of the last step, relative to the size at hand

Parameters clamped(bool triangle, Parameters p)
{
  p = {std::clamp(p[0], 0.0, 1.0), std::clamp(p[1], 0.0, 1.0)};
  if (triangle && p[0] + p[1] > 1.0)
  {
    const double u = std::clamp(0.5 * (1.0 + p[0] - p[1]), 0.0, 1.0);
    return {u, 1.0 - u};
  }
  return p;
}

/// Half the square of the distance with its derivatives.
struct Model
{
  double value;
  Parameters gradient;
  double uu, uv, vv;  ///< second derivatives
  double metric_uu, metric_uv, metric_vv;
};

Model make_model(const SurfaceJet& s, const Point& point)
{
  const Point d = subtract(s.x, point);
  Model m{};
  m.value = 0.5 * dot(d, d);
  m.gradient = {dot(d, s.u), dot(d, s.v)};
  m.metric_uu = dot(s.u, s.u);
  m.metric_uv = dot(s.u, s.v);
  m.metric_vv = dot(s.v, s.v);
  m.uu = m.metric_uu + dot(d, s.uu);
  m.uv = m.metric_uv + dot(d, s.uv);
  m.vv = m.metric_vv + dot(d, s.vv);
  return m;
}

/// Newton's step, or that of Gauss and Newton where the distance is not convex.
Parameters full_step(const Model& m)
{
  constexpr double flat = 1e-12;
  double a = m.uu, b = m.uv, c = m.vv;
  if (!(a > 0.0) || !(a * c - b * b > flat * m.metric_uu * m.metric_vv))
  {
    const double ridge = 1e-9 * (m.metric_uu + m.metric_vv) + std::numeric_limits<double>::min();
    a = m.metric_uu + ridge;
    b = m.metric_uv;
    c = m.metric_vv + ridge;
  }
  const double determinant = a * c - b * b;
  return {(b * m.gradient[1] - c * m.gradient[0]) / determinant,
          (b * m.gradient[0] - a * m.gradient[1]) / determinant};
}

/// The step along one direction only.
Parameters step_along(const Model& m, const Parameters& t)
{
  const double slope = m.gradient[0] * t[0] + m.gradient[1] * t[1];
  const auto curvature = [&](double uu, double uv, double vv)
  { return uu * t[0] * t[0] + 2.0 * uv * t[0] * t[1] + vv * t[1] * t[1]; };
  const double newton = curvature(m.uu, m.uv, m.vv);
  const double metric = curvature(m.metric_uu, m.metric_uv, m.metric_vv);
  const double size = newton > 1e-12 * metric ? newton : metric;
  if (!(size > 0.0))
    return {0.0, 0.0};
  return {-slope / size * t[0], -slope / size * t[1]};
}

/// The step that does not push against the bounds at which the parameters are.
Parameters bounded_step(bool triangle, const Parameters& p, const Model& m, bool& pushes)
{
  constexpr std::array<Parameters, 4> box{{{-1.0, 0.0}, {0.0, -1.0}, {1.0, 0.0}, {0.0, 1.0}}};
  const std::array<bool, 4> at{p[0] <= 0.0, p[1] <= 0.0, triangle ? false : p[0] >= 1.0,
                               triangle ? false : p[1] >= 1.0};
  std::array<Parameters, 3> active{};
  std::size_t count = 0;
  const auto consider = [&](const Parameters& normal)
  {
    if (m.gradient[0] * normal[0] + m.gradient[1] * normal[1] < 0.0)
      active[count++] = normal;
  };
  for (std::size_t i = 0; i < 4; ++i)
    if (at[i])
      consider(box[i]);
  if (triangle && p[0] + p[1] >= 1.0)
    consider({1.0, 1.0});
  pushes = count > 0;
  if (count == 0)
    return full_step(m);
  return count == 1 ? step_along(m, {-active[0][1], active[0][0]}) : Parameters{0.0, 0.0};
}

Closest newton(const Surface& surface, bool triangle, const Point& point, Parameters p, bool& at_bound)
{
  constexpr int iterations = 80;
  p = clamped(triangle, p);
  SurfaceJet s = jet(surface, p[0], p[1]);
  Model m = make_model(s, point);
  Closest result;
  for (int i = 0; i < iterations && !result.converged; ++i)
  {
    const Parameters step = bounded_step(triangle, p, m, at_bound);
    const double size = std::max({norm(s.x), norm(point), norm(s.u) + norm(s.v)});
    double share = 1.0;
    for (;; share *= 0.5)
    {
      const Parameters next = clamped(triangle, {p[0] + share * step[0], p[1] + share * step[1]});
      const double moved = norm(combine(next[0] - p[0], s.u, next[1] - p[1], s.v));
      const bool last = moved <= step_tolerance * size;
      const SurfaceJet trial = jet(surface, next[0], next[1]);
      const Model trial_model = make_model(trial, point);
      if (trial_model.value < m.value || last)
      {
        // The last step may be lost in the rounding of the distance, but it still sharpens the parameters.
        p = next;
        s = trial;
        m = trial_model;
        result.converged = last && share == 1.0;
        break;
      }
    }
    if (share < 1e-10)
      break;
  }
  result.u = p[0];
  result.v = p[1];
  result.x = s.x;
  result.distance = distance(s.x, point);
  return result;
}

/// Sampled points of a surface from which searches start.
struct Grid
{
  std::array<std::vector<double>, 2> parameters;
  bool triangle = false;
  std::vector<Point> x;  ///< row-major along v; outside a triangle not used
  double spacing = 0.0;  ///< the largest distance of neighbours [m]

  std::size_t count(int direction) const { return parameters[direction].size(); }
  bool inside(std::size_t i, std::size_t j) const
  {
    return !triangle || parameters[0][i] + parameters[1][j] <= 1.0 + 1e-12;
  }
};

/// Each piece between two breaks in `parts` parts.
std::vector<double> subdivided(const std::vector<double>& at, int parts)
{
  std::vector<double> result{at.front()};
  for (std::size_t i = 1; i < at.size(); ++i)
    for (int k = 1; k <= parts; ++k)
      result.push_back(at[i - 1] + (at[i] - at[i - 1]) * k / parts);
  return result;
}

std::array<std::vector<double>, 2> samples(const NurbsSurface& surface)
{
  std::array<std::vector<double>, 2> result;
  for (int d = 0; d < 2; ++d)
  {
    const std::vector<double> at = breaks(surface.knots[d]);
    const int pieces = static_cast<int>(at.size()) - 1;
    result[d] = subdivided(at, std::max(surface.degrees[d] + 1, (7 + pieces) / pieces));
  }
  return result;
}

std::array<std::vector<double>, 2> equal_samples(int u, int v)
{
  return {subdivided({0.0, 1.0}, u), subdivided({0.0, 1.0}, v)};
}

std::array<std::vector<double>, 2> samples(const QuadrilateralPatch& patch)
{
  return equal_samples(2 * static_cast<int>(patch.parameters[0].size()) + 4,
                       2 * static_cast<int>(patch.parameters[1].size()) + 4);
}

std::array<std::vector<double>, 2> samples(const TrianglePatch& patch)
{
  return equal_samples(2 * patch.order + 6, 2 * patch.order + 6);
}

std::array<std::vector<double>, 2> samples(const Surface&)
{
  return equal_samples(24, 24);
}

Grid make_grid(const Surface& surface)
{
  Grid grid;
  grid.triangle = corner_count(surface) == 3;
  grid.parameters = std::visit([](const auto& s) { return samples(s); }, surface);
  grid.x.resize(grid.count(0) * grid.count(1));
  const std::size_t columns = grid.count(1);
  for (std::size_t i = 0; i < grid.count(0); ++i)
    for (std::size_t j = 0; j < columns; ++j)
      if (grid.inside(i, j))
      {
        const Point& x = grid.x[i * columns + j] =
            evaluate(surface, grid.parameters[0][i], grid.parameters[1][j]);
        if (i > 0)
          grid.spacing = std::max(grid.spacing, distance(x, grid.x[(i - 1) * columns + j]));
        if (j > 0)
          grid.spacing = std::max(grid.spacing, distance(x, grid.x[i * columns + j - 1]));
      }
  return grid;
}

struct Start
{
  Parameters p;
  double distance;
};

/// The grid points that are nearer than their neighbours, the nearest first.
std::vector<Start> starts(const Grid& grid, const Point& point)
{
  const auto rows = static_cast<std::ptrdiff_t>(grid.count(0));
  const auto columns = static_cast<std::ptrdiff_t>(grid.count(1));
  std::vector<double> squares(grid.x.size(), std::numeric_limits<double>::infinity());
  for (std::ptrdiff_t i = 0; i < rows; ++i)
    for (std::ptrdiff_t j = 0; j < columns; ++j)
      if (grid.inside(i, j))
      {
        const Point d = subtract(grid.x[i * columns + j], point);
        squares[i * columns + j] = dot(d, d);
      }
  std::vector<Start> result;
  for (std::ptrdiff_t i = 0; i < rows; ++i)
    for (std::ptrdiff_t j = 0; j < columns; ++j)
    {
      const double here = squares[i * columns + j];
      bool lowest = std::isfinite(here);
      for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(i - 1, 0); lowest && k <= std::min(i + 1, rows - 1);
           ++k)
        for (std::ptrdiff_t l = std::max<std::ptrdiff_t>(j - 1, 0);
             lowest && l <= std::min(j + 1, columns - 1); ++l)
          lowest = here <= squares[k * columns + l];
      if (lowest)
        result.push_back({{grid.parameters[0][i], grid.parameters[1][j]}, std::sqrt(here)});
    }
  std::sort(result.begin(), result.end(),
            [](const Start& a, const Start& b) { return a.distance < b.distance; });
  return result;
}

bool better(const Closest& a, const Closest& b)
{
  return a.converged != b.converged ? a.converged : a.distance < b.distance;
}

Closest search(const Surface& surface, const Grid& grid, const Point& point)
{
  constexpr std::size_t most = 12;
  Closest best;
  best.distance = std::numeric_limits<double>::infinity();
  std::size_t tried = 0;
  for (const Start& start : starts(grid, point))
  {
    if (tried++ == most || (best.converged && start.distance - grid.spacing > best.distance))
      break;
    bool at_bound = false;
    const Closest found = newton(surface, grid.triangle, point, start.p, at_bound);
    if (better(found, best))
      best = found;
  }
  return best;
}

/// The closest point of a quadric; false for other surfaces.
bool closest_exactly(const Surface& surface, const Point& point, Closest& result)
{
  return std::visit(
      [&](const auto& s)
      {
        if constexpr (requires { closest_parameters(s, point); })
        {
          const auto [u, v] = closest_parameters(s, point);
          const Point x = jet(s, u, v).x;
          result = {u, v, x, distance(x, point), true};
          return true;
        }
        else
          return false;
      },
      surface);
}

}  // namespace

Closest closest(const Surface& surface, const Point& point, std::optional<std::array<double, 2>> start)
{
  Closest result;
  if (closest_exactly(surface, point, result))
    return result;
  if (start)
  {
    bool at_bound = false;
    result = newton(surface, corner_count(surface) == 3, point, *start, at_bound);
    if (result.converged && !at_bound)
      return result;
  }
  const Closest found = search(surface, make_grid(surface), point);
  return start && better(result, found) ? result : found;
}

std::vector<Closest> closest(const Surface& surface, std::span<const Point> points)
{
  std::vector<Closest> result(points.size());
  std::optional<Grid> grid;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (closest_exactly(surface, points[i], result[i]))
      continue;
    if (!grid)
      grid = make_grid(surface);
    result[i] = search(surface, *grid, points[i]);
  }
  return result;
}

}  // namespace blockfsi::geometry
