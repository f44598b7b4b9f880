#pragma once

#include "core/expression.hpp"
#include "geometry/nurbs.hpp"
#include "geometry/patch.hpp"
#include "geometry/quadric.hpp"

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace blockfsi::geometry
{

/// x(u, v), y(u, v), z(u, v) for u and v from 0 to 1.
struct FormulaSurface
{
  std::array<Expression, 3> x;
};

/// Any function of u and v from 0 to 1. Without derivatives these come from differences.
struct FunctionSurface
{
  std::function<Point(double u, double v)> x;
  std::function<std::array<Point, 2>(double u, double v)> derivatives{};  ///< with respect to u and v
};

/// A surface x(u, v) on which faces of blocks may lie.
///
/// Parameters run from 0 to 1 (turns of quadrics too; planes and the axes of cylinders have no bounds); a
/// triangle's from u, v >= 0 to u + v <= 1. A face uses a surface in one of two ways:
/// - by parameters: the face is the whole surface, its corners are corner(surface, 0), corner(surface, 1),
/// ...;
/// - by projection: the face is where its own points are closest to the surface, see `closest`.
using Surface = std::variant<Plane, Sphere, Cylinder, Torus, QuadrilateralPatch, TrianglePatch, NurbsSurface,
                             FormulaSurface, FunctionSurface>;

/// Throws Error if the surface makes no sense, such as wrong knots or a radius that is not positive.
void check(const Surface& surface);

/// The point at u, v.
Point evaluate(const Surface& surface, double u, double v);

/// The points at many parameters, shapes (u.size()): one dispatch for all, fastest for NURBS where neighbours
/// lie near. Allocates nothing.
void evaluate(const Surface& surface, std::span<const double> u, std::span<const double> v,
              std::span<Point> x);

/// The point at u, v with first and second derivatives. First ones of functions without derivatives come from
/// differences (relative errors near 1e-12), second ones of formulas and functions too.
SurfaceJet jet(const Surface& surface, double u, double v);

/// Number of corners: 3 for a triangle, else 4.
int corner_count(const Surface& surface);
/// Parameters of a corner: (0, 0), (1, 0), (1, 1), (0, 1); of a triangle (0, 0), (1, 0), (0, 1).
std::array<double, 2> corner_parameters(const Surface& surface, int corner);
/// The point of a corner.
Point corner(const Surface& surface, int corner);

/// The point of a surface that is closest to another point.
struct Closest
{
  double u = 0.0;
  double v = 0.0;
  Point x{};
  double distance = 0.0;   ///< from the point to x [m]
  bool converged = false;  ///< x is a local minimum of the distance, at least
};

/// The closest point of a surface. Quadrics: without iteration. Others: Newton's method on the square of the
/// distance, kept inside the parameters' bounds and going downhill only, from `start` (for instance the
/// parameters of a neighbour) if given, else, or if it fails or ends at a bound, from the nearest points of a
/// grid.
Closest closest(const Surface& surface, const Point& point,
                std::optional<std::array<double, 2>> start = std::nullopt);

/// The closest points to many points, in order: the grid is evaluated once and each point starts from the
/// grid.
std::vector<Closest> closest(const Surface& surface, std::span<const Point> points);

}  // namespace blockfsi::geometry
