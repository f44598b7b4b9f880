#include "case/curve.hpp"

#include "case/level_set.hpp"
#include "geometry/cad.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>

namespace blockfsi::case_file
{

namespace
{

constexpr const char* point_type = "[number, number] or [number, number, number]";

std::vector<geometry::Point> points(const Value& value, Reading& reading)
{
  std::vector<geometry::Point> result;
  for (const Value& entry : list(value))
    result.push_back(point_in_space(entry, reading.constants));
  if (result.empty())
    fail(value, "found an empty list, allowed are points [x, y] or [x, y, z]");
  return result;
}

geometry::Speed speed(const Value& value)
{
  static constexpr std::array<std::string_view, 2> words = {"constant", "own"};
  return choice(value, words) == 0 ? geometry::Speed::constant : geometry::Speed::own;
}

constexpr const char* speed_meaning = "own: gradings divide the curve's own parameter, not its length";

struct Circle
{
  std::optional<geometry::Point> center;
  std::optional<geometry::Point> through;
  std::optional<geometry::Point> axis;
  std::optional<double> radius;
  bool longer = false;
};

const Keys<Circle>& circle_keys()
{
  static const Keys<Circle> keys = {
      {{"center", point_type, "", "m", "centre of the circle"},
       [](const Value& v, Reading& r, Circle& c) { c.center = point_in_space(v, r.constants); }},
      {{"through", point_type, "", "m", "a point of the arc between the ends, instead of center"},
       [](const Value& v, Reading& r, Circle& c) { c.through = point_in_space(v, r.constants); }},
      {{"longer", "true", "", "", "the longer way round"},
       [](const Value& v, Reading&, Circle& c)
       {
         yes(v);
         c.longer = true;
       }},
      {{"axis", "[number, number, number]", "", "-",
        "turn right-handed about it from the first point to the second, as half circles need"},
       [](const Value& v, Reading& r, Circle& c) { c.axis = point_in_space(v, r.constants); }},
      {{"radius", "number", "from the ends", "m", "needed for the sides of a hole, whose points it moves"},
       [](const Value& v, Reading& r, Circle& c) { c.radius = number(v, r.constants, positive); }}};
  return keys;
}

void read_circle(const Value& value, Reading& reading, EdgeData& edge)
{
  Circle circle;
  read_keys(value, circle_keys(), reading, circle);
  if (circle.center.has_value() == circle.through.has_value())
    fail(value, "allowed is exactly one of center and through");
  if (circle.through && (circle.longer || circle.axis || circle.radius))
    fail(value, "a circle through a point needs no longer, axis or radius");
  if (circle.longer && circle.axis)
    fail(value, "allowed is at most one of longer and axis");
  if (circle.through)
    edge.curve = geometry::ArcThrough{*circle.through};
  else
    edge.curve = geometry::Arc{*circle.center, circle.longer, circle.axis};
  edge.radius = circle.radius;
}

const Keys<geometry::Ellipse>& ellipse_keys()
{
  static const Keys<geometry::Ellipse> keys = {
      {{"center", point_type, "required", "m", "centre of the ellipse"},
       [](const Value& v, Reading& r, geometry::Ellipse& e) { e.center = point_in_space(v, r.constants); }},
      {{"axes", "list of two points", "required", "m", "both half-axes as vectors"},
       [](const Value& v, Reading& r, geometry::Ellipse& e)
       {
         const std::vector<geometry::Point> axes = points(v, r);
         if (axes.size() != 2)
           fail(v, fmt::format("found {}, allowed are two vectors [[x, y], [x, y]]", found(v)));
         e.first = axes[0];
         e.second = axes[1];
       }},
      {{"longer", "true", "", "", "the longer way round"},
       [](const Value& v, Reading&, geometry::Ellipse& e)
       {
         yes(v);
         e.longer = true;
       }}};
  return keys;
}

void read_ellipse(const Value& value, Reading& reading, EdgeData& edge)
{
  geometry::Ellipse ellipse;
  read_keys(value, ellipse_keys(), reading, ellipse);
  edge.curve = ellipse;
}

const Keys<geometry::Through>& through_keys()
{
  static const Keys<geometry::Through> keys = {
      {{"points", "list of points", "required", "m", "between the ends"},
       [](const Value& v, Reading& r, geometry::Through& t) { t.points = points(v, r); }},
      {{"parameters", "list of numbers", "from the chords", "-",
        "of these points, ascending between 0 at the start and 1 at the end"},
       [](const Value& v, Reading& r, geometry::Through& t) { t.parameters = numbers(v, r.constants); }},
      {{"speed", "\"constant\" or \"own\"", "constant", "", speed_meaning},
       [](const Value& v, Reading&, geometry::Through& t) { t.speed = speed(v); }}};
  return keys;
}

void read_through(const Value& value, Reading& reading, EdgeData& edge)
{
  geometry::Through through;
  if (std::holds_alternative<Value::Table>(value.content))
    read_keys(value, through_keys(), reading, through);
  else
    through.points = points(value, reading);
  edge.curve = through;
}

const Keys<geometry::Spline>& bspline_keys()
{
  static const Keys<geometry::Spline> keys = {
      {{"degree", "whole number", "required", "", "degree of the polynomials"},
       [](const Value& v, Reading& r, geometry::Spline& s)
       { s.curve.degree = integer(v, r.constants, 1, geometry::max_degree); }},
      {{"points", "list of points", "required", "m",
        "control points, the ends included, in either direction"},
       [](const Value& v, Reading& r, geometry::Spline& s) { s.curve.points = points(v, r); }},
      {{"knots", "list of numbers", "equal spans", "-",
        "not decreasing, the first and the last as often as degree + 1"},
       [](const Value& v, Reading& r, geometry::Spline& s) { s.curve.knots = numbers(v, r.constants); }},
      {{"part", "true", "", "", "only the part between the ends, which lie on the curve"},
       [](const Value& v, Reading&, geometry::Spline& s)
       {
         yes(v);
         s.part = true;
       }},
      {{"longer", "true", "", "", "the longer part of a closed curve"},
       [](const Value& v, Reading&, geometry::Spline& s)
       {
         yes(v);
         s.longer = true;
       }},
      {{"speed", "\"constant\" or \"own\"", "constant", "", speed_meaning},
       [](const Value& v, Reading&, geometry::Spline& s) { s.speed = speed(v); }}};
  return keys;
}

const Keys<geometry::Spline>& nurbs_keys()
{
  static const Keys<geometry::Spline> keys = []
  {
    Keys<geometry::Spline> all = bspline_keys();
    all.insert(all.begin() + 2,
               {{"weights", "list of numbers", "required", "-", "one > 0 for each control point"},
                [](const Value& v, Reading& r, geometry::Spline& s)
                { s.curve.weights = numbers(v, r.constants); }});
    return all;
  }();
  return keys;
}

void finish_spline(const Value& value, geometry::Spline spline, EdgeData& edge)
{
  if (spline.longer && !spline.part)
    fail(value, "longer goes with part only");
  if (!value.find("knots") && spline.curve.points.size() > static_cast<std::size_t>(spline.curve.degree))
    spline.curve.knots = geometry::clamped_knots(spline.curve.degree, spline.curve.points.size());
  placed(value,
         [&]
         {
           geometry::check(spline.curve.weights.empty() ? "the B-spline" : "the NURBS", spline.curve);
           return 0;
         });
  edge.curve = std::move(spline);
}

void read_bspline(const Value& value, Reading& reading, EdgeData& edge)
{
  geometry::Spline spline;
  read_keys(value, bspline_keys(), reading, spline);
  finish_spline(value, std::move(spline), edge);
}

void read_nurbs(const Value& value, Reading& reading, EdgeData& edge)
{
  geometry::Spline spline;
  read_keys(value, nurbs_keys(), reading, spline);
  if (spline.curve.weights.empty())
    fail(*value.find("weights"), "found an empty list, allowed is a weight > 0 for each control point");
  finish_spline(value, std::move(spline), edge);
}

/// Undefined values would only show as a broken mesh later.
void check_formula(const Value& value, const Expression& formula)
{
  constexpr int samples = 32;
  for (int i = 0; i <= samples; ++i)
  {
    const double t = static_cast<double>(i) / samples;
    const double result = formula(0.0, 0.0, 0.0, t);
    if (!std::isfinite(result))
      fail(value, fmt::format("\"{}\" is {} at t = {}; it must be finite from t = 0 to 1", formula.text(),
                              number_text(result), t));
  }
}

void read_formula(const Value& value, Reading& reading, EdgeData& edge)
{
  const auto* components = std::get_if<Value::List>(&value.content);
  if (!components || components->size() < 2 || components->size() > 3)
    fail(value,
         fmt::format("found {}, allowed is a list of two or three numbers or formulas in t", found(value)));
  geometry::Formula formula;
  for (std::size_t i = 0; i < components->size(); ++i)
  {
    formula.x[i] = expression((*components)[i], reading.constants, along_curve);
    check_formula((*components)[i], formula.x[i]);
  }
  edge.curve = formula;
}

struct CadEdge
{
  const Value* file = nullptr;
  int number = 0;
  bool longer = false;
};

const Keys<CadEdge>& cad_keys()
{
  static const Keys<CadEdge> keys = {
      {{"file", "text", "required", "", "the file, seen from the folder of this one"},
       [](const Value& v, Reading&, CadEdge& c)
       {
         static_cast<void>(text(v));
         c.file = &v;
       }},
      {{"edge", "whole number", "required", "", "number of the edge in the file, on which both points lie"},
       [](const Value& v, Reading& r, CadEdge& c) { c.number = integer(v, r.constants, 1, 1000000000); }},
      {{"longer", "true", "", "", "the longer part of a closed edge"},
       [](const Value& v, Reading&, CadEdge& c)
       {
         yes(v);
         c.longer = true;
       }}};
  return keys;
}

void read_cad(const Value& value, Reading& reading, EdgeData& edge)
{
  CadEdge cad;
  read_keys(value, cad_keys(), reading, cad);
  const std::filesystem::path path =
      std::filesystem::path(cad.file->where.file).parent_path() / text(*cad.file);
  auto known = reading.cad_files.find(path.string());
  if (known == reading.cad_files.end())
    known = placed(*cad.file,
                   [&] { return reading.cad_files.emplace(path.string(), geometry::CadFile(path)).first; });
  const geometry::CadCurve curve = placed(value, [&] { return known->second.edge(cad.number); });
  edge.curve = geometry::Spline{
      .curve = curve.curve, .speed = geometry::Speed::constant, .part = true, .longer = cad.longer};
}

}  // namespace

const Keys<EdgeData>& explicit_curve_keys()
{
  static const Keys<EdgeData> keys = {
      {{"circle", "table", "", "", "an arc between the ends"}, read_circle},
      {{"ellipse", "table", "", "", "a part of an ellipse"}, read_ellipse},
      {{"through", "list of points or table", "", "m",
        "Lagrange's curve through these points between the ends"},
       read_through},
      {{"bspline", "table", "", "", "a B-spline curve, or a part of it"}, read_bspline},
      {{"nurbs", "table", "", "", "a NURBS curve, or a part of it"}, read_nurbs},
      {{"formula", "list of two or three formulas in t", "", "m",
        "x, y and z for t from 0 to 1, from one end to the other"},
       read_formula},
      {{"step", "table", "", "", "on an edge of a STEP file"}, read_cad},
      {{"iges", "table", "", "", "on an edge of an IGES file"}, read_cad}};
  return keys;
}

std::vector<Section> explicit_curve_sections()
{
  return {section("circle = { ... }", "center or through", circle_keys()),
          section("ellipse = { ... }", "", ellipse_keys()),
          section("through = { ... }", "", through_keys()),
          section("bspline = { ... }", "", bspline_keys()),
          section("nurbs = { ... }", "", nurbs_keys()),
          section("step = { ... }, iges = { ... }", "of edges", cad_keys())};
}

}  // namespace blockfsi::case_file
