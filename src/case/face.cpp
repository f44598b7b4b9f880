#include "case/face.hpp"

#include "block/names.hpp"
#include "case/level_set.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>

namespace blockfsi::case_file
{

namespace
{

constexpr std::array<std::string_view, 2> on_surface = {"u", "v"};

struct FaceData
{
  std::optional<block::FaceGeometry> geometry;
};

/// Throws Error for a surface that makes no sense, at its table.
geometry::Surface checked(const Value& value, geometry::Surface surface)
{
  placed(value, [&] { geometry::check(surface); });
  return surface;
}

const Keys<geometry::Sphere>& sphere_keys()
{
  using S = geometry::Sphere;
  static const Keys<S> keys = {
      {{"center", "[number, number, number]", "required", "m", "centre"},
       [](const Value& v, Reading& r, S& s) { s.center = point_in_space(v, r.constants); }},
      {{"radius", "number", "required", "m", "radius"},
       [](const Value& v, Reading& r, S& s) { s.radius = number(v, r.constants, positive); }}};
  return keys;
}

const Keys<geometry::Cylinder>& cylinder_keys()
{
  using S = geometry::Cylinder;
  static const Keys<S> keys = {
      {{"center", "[number, number, number]", "required", "m", "a point of the axis"},
       [](const Value& v, Reading& r, S& s) { s.center = point_in_space(v, r.constants); }},
      {{"axis", "[number, number, number]", "[0, 0, 1]", "", "direction of the axis"},
       [](const Value& v, Reading& r, S& s) { s.axis = point_in_space(v, r.constants); }},
      {{"radius", "number", "required", "m", "radius"},
       [](const Value& v, Reading& r, S& s) { s.radius = number(v, r.constants, positive); }}};
  return keys;
}

const Keys<geometry::Torus>& torus_keys()
{
  using S = geometry::Torus;
  static const Keys<S> keys = {
      {{"center", "[number, number, number]", "required", "m", "centre"},
       [](const Value& v, Reading& r, S& s) { s.center = point_in_space(v, r.constants); }},
      {{"axis", "[number, number, number]", "[0, 0, 1]", "", "direction of the axis"},
       [](const Value& v, Reading& r, S& s) { s.axis = point_in_space(v, r.constants); }},
      {{"ring", "number", "required", "m", "radius of the circle inside the tube"},
       [](const Value& v, Reading& r, S& s) { s.major = number(v, r.constants, positive); }},
      {{"tube", "number", "required", "m", "radius of the tube"},
       [](const Value& v, Reading& r, S& s) { s.minor = number(v, r.constants, positive); }}};
  return keys;
}

template <typename S, const Keys<S>& (*keys)()>
void read_surface(const Value& value, Reading& reading, FaceData& face)
{
  S surface;
  read_keys(value, keys(), reading, surface);
  // The direction from which angles count does not matter, but must not run along the axis.
  if constexpr (requires { surface.from; })
    if (geometry::norm(geometry::cross(surface.axis, surface.from)) < 1e-3 * geometry::norm(surface.axis))
      surface.from = {0.0, 1.0, 0.0};
  face.geometry = block::OnSurface{checked(value, surface)};
}

void read_formula(const Value& value, Reading& reading, FaceData& face)
{
  if (list(value).size() != 3)
    fail(value, fmt::format("found {}, allowed are three formulas in u and v", found(value)));
  geometry::FormulaSurface surface;
  for (std::size_t c = 0; c < 3; ++c)
    surface.x[c] = expression(list(value)[c], reading.constants, on_surface);
  face.geometry = block::Patch{checked(value, surface)};
}

const Keys<FaceData>& face_keys()
{
  static const Keys<FaceData> keys = {
      {{"level_set", "name in [geometry], or formula", "", "", "where the level set is zero"},
       [](const Value& v, Reading& r, FaceData& f) { f.geometry = block::OnLevelSet{level_set(v, r)}; }},
      {{"sphere", "table", "", "", "on a sphere"}, read_surface<geometry::Sphere, sphere_keys>},
      {{"cylinder", "table", "", "", "on a cylinder"}, read_surface<geometry::Cylinder, cylinder_keys>},
      {{"torus", "table", "", "", "on a torus"}, read_surface<geometry::Torus, torus_keys>},
      {{"formula", "[formula, formula, formula] in u and v", "", "m",
        "x, y and z; u and v go from 0 to 1, u from the first corner to the second, v from the first to the "
        "last"},
       read_formula}};
  return keys;
}

/// The corners in "a - b - c - d".
std::vector<int> corners_named(const block::Layout& layout, const Field& field)
{
  std::vector<int> points;
  std::string_view rest = field.name;
  constexpr std::string_view dash = " - ";
  while (true)
  {
    const auto end = rest.find(dash);
    std::string name(rest.substr(0, end));
    while (name.ends_with(' '))
      name.pop_back();
    while (name.starts_with(' '))
      name.erase(0, 1);
    try
    {
      points.push_back(block::find_point(layout, name));
    }
    catch (const Error& error)
    {
      throw error.within(field.value.path).at(field.where);
    }
    if (end == std::string_view::npos)
      break;
    rest.remove_prefix(end + dash.size());
  }
  if (points.size() < 3 || points.size() > 4)
    throw Error(field.where,
                fmt::format("{}: found {} corners, allowed are three or four with dashes between, \"a - b "
                            "- c - d\"",
                            field.value.path, points.size()));
  return points;
}

}  // namespace

void read_faces(const Value& value, Reading& reading, block::Layout& layout)
{
  for (const Field& field : table(value))
  {
    if (layout.dim != 3)
      throw Error(field.where,
                  fmt::format("{}: faces have surfaces of their own in 3D only; say dim = 3 in [blocks]",
                              field.value.path));
    FaceData data;
    read_one(field.value, face_keys(), reading, data);
    layout.faces.push_back({corners_named(layout, field), std::move(*data.geometry), field.where});
  }
}

std::vector<Section> face_sections()
{
  return {section("[blocks.faces] \"a - b - c - d\" = { ... }",
                  "exactly one of these; edges of such a face without a curve lie on its surface, too",
                  face_keys()),
          section("sphere = { ... }", "of a face", sphere_keys()),
          section("cylinder = { ... }", "of a face", cylinder_keys()),
          section("torus = { ... }", "of a face", torus_keys())};
}

}  // namespace blockfsi::case_file
