#pragma once

#include "geometry/level_set.hpp"

namespace blockfsi::geometry
{

/// Signed distances [m], negative inside. All throw Error for sizes that are not positive and for directions
/// without a length. Where the distance has no gradient (the centre of a sphere, the axis of a cylinder), a
/// gradient of 0 is given.

/// The sphere, in the plane the circle, about a centre.
LevelSet sphere(const Point& center, double radius);
/// The infinite cylinder about the line through `point` along `axis`.
LevelSet cylinder(const Point& point, const Point& axis, double radius);
/// The box between two corners; infinite coordinates leave a side open.
LevelSet box(const Point& low, const Point& high);
/// The half space behind the plane through `point` with a normal that points out of the domain.
LevelSet plane(const Point& point, const Point& normal);
/// The torus whose tube follows the circle with `ring` as radius about `center` in the plane normal to
/// `axis`.
LevelSet torus(const Point& center, const Point& axis, double ring, double tube);

}  // namespace blockfsi::geometry
