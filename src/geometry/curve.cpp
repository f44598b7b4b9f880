#include "geometry/curve.hpp"

#include "core/error.hpp"
#include "geometry/arc.hpp"
#include "geometry/overloaded.hpp"
#include "geometry/path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace blockfsi::geometry
{

namespace
{

void check_parameters(const Through& through)
{
  if (through.parameters.size() != through.points.size())
    throw Error(
        fmt::format("found {} parameters for the {} points that the curve passes through; each needs one",
                    through.parameters.size(), through.points.size()));
  double before = 0.0;
  for (std::size_t i = 0; i < through.parameters.size(); ++i)
  {
    const double t = through.parameters[i];
    if (!(t > before) || !(t < 1.0))
      throw Error(
          fmt::format("parameter {} of the curve's points is {:.9g}, after {:.9g}; they must ascend between "
                      "0 and 1, where the edge starts and ends",
                      i + 1, t, before));
    before = t;
  }
}

void check_through(const Through& through, const Point& a, const Point& b)
{
  constexpr std::size_t most = max_degree - 1;
  if (through.points.size() > most)
    throw Error(
        fmt::format("the curve passes through {} points between its ends; one polynomial takes at most {}, "
                    "so use a B-spline or split the edge",
                    through.points.size(), most));
  std::vector<Point> points{a};
  points.insert(points.end(), through.points.begin(), through.points.end());
  points.push_back(b);
  for (std::size_t i = 1; i < points.size(); ++i)
    if (!(distance(points[i - 1], points[i]) > 0.0))
      throw Error(
          fmt::format("the curve passes through {} twice in a row; each of its points, the ends included, "
                      "must differ from the one before",
                      text(points[i])));
  if (!through.parameters.empty())
    check_parameters(through);
}

/// For curves with ends of their own; `what` names them: "the formula of the curve".
void check_ends(const char* what, const Curve& curve, const Point& a, const Point& b)
{
  const Path path(curve, a, b);
  for (int end = 0; end < 2; ++end)
  {
    const Point& wanted = end == 0 ? a : b;
    if (!(distance(path.own_end(end), wanted) <= fit_tolerance * path.length()))
      throw Error(fmt::format("{} gives {} at t = {} but the edge {} at {}; correct the {} or the point",
                              what, text(path.own_end(end)), end, end == 0 ? "starts" : "ends", text(wanted),
                              std::holds_alternative<Spline>(curve) ? "control point" : "formula"));
  }
  if (!std::isfinite(path.length()))
    throw Error(fmt::format("{} has no finite value somewhere between t = 0 and t = 1", what));
}

/// For the part of a spline.
void check_on_curve(const Curve& curve, const Point& a, const Point& b)
{
  constexpr double tolerance = 1e-6;  // CAD shows its points in few digits
  const Path path(curve, a, b);
  for (int end = 0; end < 2; ++end)
  {
    const Point& wanted = end == 0 ? a : b;
    const Point& found = path.own_end(end);
    if (!(distance(found, wanted) <= tolerance * path.length()))
      throw Error(fmt::format(
          "the edge {} at {}, {:.6g} m off its curve; move the point there, for instance to "
          "({:.12g}, {:.12g}, {:.12g})",
          end == 0 ? "starts" : "ends", text(wanted), distance(found, wanted), found[0], found[1], found[2]));
  }
  if (!(path.length() >= 0.5 * distance(a, b)))
    throw Error(fmt::format("the edge from {} to {} has no length on its curve", text(a), text(b)));
}

}  // namespace

void check(const Curve& curve, const Point& a, const Point& b)
{
  if (a == b)
    throw Error(fmt::format("the edge starts and ends at {}; an edge needs two different ends", text(a)));
  std::visit(Overloaded{[](const Segment&) {}, [&](const Arc& arc) { check(arc, a, b); },
                        [&](const ArcThrough& arc) { check(arc, a, b); },
                        [&](const Ellipse& ellipse) { check(ellipse, a, b); },
                        [&](const Through& through) { check_through(through, a, b); },
                        [&](const OnLevelSet& on_level_set) { check(on_level_set, a, b); },
                        [&](const Formula&) { check_ends("the formula of the curve", curve, a, b); },
                        [&](const Spline& spline)
                        {
                          check("the B-spline", spline.curve);
                          if (spline.part)
                            check_on_curve(curve, a, b);
                          else
                            check_ends("the B-spline", curve, a, b);
                        },
                        [&](const Function& function)
                        {
                          if (!function.x)
                            throw Error("the function of the curve is empty; give one");
                          check_ends("the function of the curve", curve, a, b);
                        }},
             curve);
}

Point evaluate(const Curve& curve, const Point& a, const Point& b, double t)
{
  return Path(curve, a, b).evaluate(t);
}

double length(const Curve& curve, const Point& a, const Point& b)
{
  return Path(curve, a, b).length();
}

}  // namespace blockfsi::geometry
