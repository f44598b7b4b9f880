#pragma once

#include "geometry/level_set.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace blockfsi::geometry
{

/// Values of a field at the points of a regular grid.
struct Samples
{
  std::array<int, 3> count{1, 1, 1};  ///< points in x, y, z; 1 in z: a field of the plane
  Point origin{};                     ///< the first point [m]
  Point spacing{};                    ///< [m]
  std::vector<double> values;         ///< x runs fastest, then y, then z
};

/// The twice continuously differentiable cubic spline through the samples (uniform B-splines, "not-a-knot" at
/// the ends: exact for cubic polynomials, order 4 otherwise) as a level set. Outside the grid, the value at
/// the nearest point of the grid plus the distance to there. Throws Error for fewer than 4 points in a
/// direction, values that are not finite or not as many as points. `name` is its text.
LevelSet sampled(const Samples& samples, const std::string& name);

/// Reads samples from a VTK image (.vti; XML with one ascii array of a point scalar) or, whatever else the
/// file is called, from numbers in a text: counts nx ny nz, origin x y z, spacing dx dy dz, then the values.
/// Throws Error naming the file and what is wrong.
Samples read_samples(const std::filesystem::path& path);

}  // namespace blockfsi::geometry
