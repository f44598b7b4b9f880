#include "case/primitives.hpp"

#include "case/level_set.hpp"
#include "geometry/primitive.hpp"

#include <limits>

namespace blockfsi::case_file
{

using geometry::LevelSet;
using geometry::Point;

namespace
{

struct Ball
{
  Point center{};
  double radius = 0.0;
};

const Keys<Ball>& ball_keys()
{
  static const Keys<Ball> keys = {
      {{"center", "[number, number] or [number, number, number]", "required", "m", "centre"},
       [](const Value& v, Reading& r, Ball& b) { b.center = point_in_space(v, r.constants); }},
      {{"radius", "number", "required", "m", "radius"},
       [](const Value& v, Reading& r, Ball& b) { b.radius = number(v, r.constants, positive); }}};
  return keys;
}

struct Rod
{
  Point point{};
  Point axis{};
  double radius = 0.0;
};

const Keys<Rod>& rod_keys()
{
  static const Keys<Rod> keys = {
      {{"point", "[number, number, number]", "required", "m", "a point of the axis"},
       [](const Value& v, Reading& r, Rod& c) { c.point = point_in_space(v, r.constants); }},
      {{"axis", "[number, number, number]", "required", "-", "direction of the axis"},
       [](const Value& v, Reading& r, Rod& c) { c.axis = point_in_space(v, r.constants); }},
      {{"radius", "number", "required", "m", "radius"},
       [](const Value& v, Reading& r, Rod& c) { c.radius = number(v, r.constants, positive); }}};
  return keys;
}

struct Corners
{
  Point low{};
  Point high{};
  bool flat = false;  ///< given in the plane
};

const Keys<Corners>& box_keys()
{
  static const Keys<Corners> keys = {{{"low", "[number, number] or [number, number, number]", "required", "m",
                                       "corner with the least coordinates"},
                                      [](const Value& v, Reading& r, Corners& b)
                                      {
                                        b.low = point_in_space(v, r.constants);
                                        b.flat = b.flat || list(v).size() == 2;
                                      }},
                                     {{"high", "[number, number] or [number, number, number]", "required",
                                       "m", "corner with the largest coordinates"},
                                      [](const Value& v, Reading& r, Corners& b)
                                      {
                                        b.high = point_in_space(v, r.constants);
                                        b.flat = b.flat || list(v).size() == 2;
                                      }}};
  return keys;
}

struct Half
{
  Point point{};
  Point normal{};
};

const Keys<Half>& plane_keys()
{
  static const Keys<Half> keys = {
      {{"point", "[number, number] or [number, number, number]", "required", "m",
        "a point of the plane or line"},
       [](const Value& v, Reading& r, Half& h) { h.point = point_in_space(v, r.constants); }},
      {{"normal", "[number, number] or [number, number, number]", "required", "-",
        "direction out of the domain behind it"},
       [](const Value& v, Reading& r, Half& h) { h.normal = point_in_space(v, r.constants); }}};
  return keys;
}

struct Ring
{
  Point center{};
  Point axis{0.0, 0.0, 1.0};
  double ring = 0.0;
  double tube = 0.0;
};

const Keys<Ring>& torus_keys()
{
  static const Keys<Ring> keys = {
      {{"center", "[number, number, number]", "required", "m", "centre of the ring"},
       [](const Value& v, Reading& r, Ring& t) { t.center = point_in_space(v, r.constants); }},
      {{"axis", "[number, number, number]", "[0, 0, 1]", "-", "normal of the ring's plane"},
       [](const Value& v, Reading& r, Ring& t) { t.axis = point_in_space(v, r.constants); }},
      {{"ring", "number", "required", "m", "radius of the ring"},
       [](const Value& v, Reading& r, Ring& t) { t.ring = number(v, r.constants, positive); }},
      {{"tube", "number", "required", "m", "radius of the tube about it"},
       [](const Value& v, Reading& r, Ring& t) { t.tube = number(v, r.constants, positive); }}};
  return keys;
}

}  // namespace

LevelSet read_sphere(const Value& value, Reading& reading)
{
  Ball ball;
  read_keys(value, ball_keys(), reading, ball);
  return placed(value, [&] { return geometry::sphere(ball.center, ball.radius); });
}

LevelSet read_cylinder(const Value& value, Reading& reading)
{
  Rod rod;
  read_keys(value, rod_keys(), reading, rod);
  return placed(value, [&] { return geometry::cylinder(rod.point, rod.axis, rod.radius); });
}

LevelSet read_box(const Value& value, Reading& reading)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Corners corners;
  read_keys(value, box_keys(), reading, corners);
  if (corners.flat)
  {
    corners.low[2] = -infinity;
    corners.high[2] = infinity;
  }
  return placed(value, [&] { return geometry::box(corners.low, corners.high); });
}

LevelSet read_plane(const Value& value, Reading& reading)
{
  Half half;
  read_keys(value, plane_keys(), reading, half);
  return placed(value, [&] { return geometry::plane(half.point, half.normal); });
}

LevelSet read_torus(const Value& value, Reading& reading)
{
  Ring ring;
  read_keys(value, torus_keys(), reading, ring);
  return placed(value, [&] { return geometry::torus(ring.center, ring.axis, ring.ring, ring.tube); });
}

std::vector<Section> primitive_sections()
{
  return {section("sphere = { ... }", "", ball_keys()), section("cylinder = { ... }", "", rod_keys()),
          section("box = { ... }", "", box_keys()), section("plane = { ... }", "", plane_keys()),
          section("torus = { ... }", "", torus_keys())};
}

}  // namespace blockfsi::case_file
