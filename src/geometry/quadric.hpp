#pragma once

#include "geometry/jet.hpp"

#include <array>
#include <string_view>

namespace blockfsi::geometry
{

/// x = origin + u first + v second, without bounds.
struct Plane
{
  Point origin{};
  Point first{1.0, 0.0, 0.0};
  Point second{0.0, 1.0, 0.0};
};

/// u goes once round the axis from the direction `from`, v from the south pole to the north pole at the axis.
struct Sphere
{
  Point center{};
  double radius = 1.0;
  Point axis{0.0, 0.0, 1.0};
  Point from{1.0, 0.0, 0.0};  ///< only its part across the axis counts
};

/// u goes once round the axis from the direction `from`, v from the centre along the axis by its length;
/// without bounds along the axis.
struct Cylinder
{
  Point center{};  ///< where the axis starts
  double radius = 1.0;
  Point axis{0.0, 0.0, 1.0};  ///< with the length that v = 1 means
  Point from{1.0, 0.0, 0.0};  ///< only its part across the axis counts
};

/// u goes once round the axis from the direction `from`, v once round the tube from its outer side towards
/// the axis' direction.
struct Torus
{
  Point center{};
  double major = 1.0;  ///< radius of the circle inside the tube [m]
  double minor = 0.5;  ///< radius of the tube [m]
  Point axis{0.0, 0.0, 1.0};
  Point from{1.0, 0.0, 0.0};  ///< only its part across the axis counts
};

/// Throw Error saying what is wrong.
void check(std::string_view what, const Plane& plane);
void check(std::string_view what, const Sphere& sphere);
void check(std::string_view what, const Cylinder& cylinder);
void check(std::string_view what, const Torus& torus);

/// The point at u, v with its derivatives.
SurfaceJet jet(const Plane& plane, double u, double v);
SurfaceJet jet(const Sphere& sphere, double u, double v);
SurfaceJet jet(const Cylinder& cylinder, double u, double v);
SurfaceJet jet(const Torus& torus, double u, double v);

/// The parameters of the closest point, without iteration; turns are from 0 to 1. Where all directions are
/// equally near (the centre, the axis), that of `from` or of the axis.
std::array<double, 2> closest_parameters(const Plane& plane, const Point& point);
std::array<double, 2> closest_parameters(const Sphere& sphere, const Point& point);
std::array<double, 2> closest_parameters(const Cylinder& cylinder, const Point& point);
std::array<double, 2> closest_parameters(const Torus& torus, const Point& point);

}  // namespace blockfsi::geometry
