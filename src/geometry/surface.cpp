#include "geometry/surface.hpp"

#include "core/error.hpp"
#include "geometry/difference.hpp"
#include "geometry/overloaded.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cstddef>

namespace blockfsi::geometry
{

namespace
{

Point value(const FormulaSurface& surface, double u, double v)
{
  return {surface.x[0](u, v), surface.x[1](u, v), surface.x[2](u, v)};
}

Point value(const FunctionSurface& surface, double u, double v)
{
  return surface.x(u, v);
}

std::array<Point, 2> derivatives_of(const FormulaSurface& surface, double u, double v)
{
  std::array<Point, 2> result{};
  for (std::size_t c = 0; c < 3; ++c)
  {
    const Expression::Derivatives d = surface.x[c].derivatives(u, v);
    result[0][c] = d.by[0];
    result[1][c] = d.by[1];
  }
  return result;
}

std::array<Point, 2> derivatives_of(const FunctionSurface& surface, double u, double v)
{
  if (surface.derivatives)
    return surface.derivatives(u, v);
  return {differentiate([&](double s) { return surface.x(s, v); }, u),
          differentiate([&](double s) { return surface.x(u, s); }, v)};
}

template <typename AnySurface>
SurfaceJet differenced_jet(const AnySurface& surface, double u, double v)
{
  const auto [first_u, first_v] = derivatives_of(surface, u, v);
  const auto along = [&](int d) { return [&, d](double s) { return derivatives_of(surface, s, v)[d]; }; };
  return {value(surface, u, v),
          first_u,
          first_v,
          differentiate(along(0), u),
          differentiate(along(1), u),
          differentiate([&](double s) { return derivatives_of(surface, u, s)[1]; }, v)};
}

SurfaceJet jet(const FormulaSurface& surface, double u, double v)
{
  return differenced_jet(surface, u, v);
}

SurfaceJet jet(const FunctionSurface& surface, double u, double v)
{
  return differenced_jet(surface, u, v);
}

/// The point alone; surfaces whose points are cheap with their derivatives take these.
template <typename AnySurface>
Point value(const AnySurface& surface, double u, double v)
{
  return jet(surface, u, v).x;
}

Point value(const NurbsSurface& surface, double u, double v)
{
  return evaluate(surface, u, v);
}

/// A formula that is nan somewhere would only show as a broken mesh later.
template <typename AnySurface>
void check_finite(const char* what, const AnySurface& surface)
{
  constexpr int samples = 8;
  for (int i = 0; i <= samples; ++i)
    for (int j = 0; j <= samples; ++j)
    {
      const double u = static_cast<double>(i) / samples;
      const double v = static_cast<double>(j) / samples;
      if (!is_finite(value(surface, u, v)))
        throw Error(
            fmt::format("{} has no finite value at u = {}, v = {}; it must have one for u and v from 0 to 1",
                        what, u, v));
    }
}

}  // namespace

void check(const Surface& surface)
{
  std::visit(Overloaded{[](const Plane& s) { check("the plane", s); },
                        [](const Sphere& s) { check("the sphere", s); },
                        [](const Cylinder& s) { check("the cylinder", s); },
                        [](const Torus& s) { check("the torus", s); },
                        [](const QuadrilateralPatch& s) { check("the patch", s); },
                        [](const TrianglePatch& s) { check("the triangular patch", s); },
                        [](const NurbsSurface& s) { check("the B-spline surface", s); },
                        [](const FormulaSurface& s) { check_finite("the formula of the surface", s); },
                        [](const FunctionSurface& s)
                        {
                          if (!s.x)
                            throw Error("the function of the surface is empty; give one");
                          check_finite("the function of the surface", s);
                        }},
             surface);
}

Point evaluate(const Surface& surface, double u, double v)
{
  return std::visit([&](const auto& s) { return value(s, u, v); }, surface);
}

void evaluate(const Surface& surface, std::span<const double> u, std::span<const double> v,
              std::span<Point> x)
{
  assert(u.size() == x.size() && v.size() == x.size());
  std::visit(Overloaded{[&](const NurbsSurface& s) { evaluate(s, u, v, x); },
                        [&](const auto& s)
                        {
                          for (std::size_t i = 0; i < x.size(); ++i)
                            x[i] = value(s, u[i], v[i]);
                        }},
             surface);
}

SurfaceJet jet(const Surface& surface, double u, double v)
{
  return std::visit([&](const auto& s) { return jet(s, u, v); }, surface);
}

int corner_count(const Surface& surface)
{
  return std::holds_alternative<TrianglePatch>(surface) ? 3 : 4;
}

std::array<double, 2> corner_parameters(const Surface& surface, int corner)
{
  assert(corner >= 0 && corner < corner_count(surface));
  constexpr std::array<std::array<double, 2>, 4> square{{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}};
  return corner_count(surface) == 3 && corner == 2 ? square[3] : square[corner];
}

Point corner(const Surface& surface, int corner)
{
  const auto [u, v] = corner_parameters(surface, corner);
  return evaluate(surface, u, v);
}

}  // namespace blockfsi::geometry
