#pragma once

#include "element/shape.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::block
{

/// What a node of the interface contributes to something that moves with it.
struct Share
{
  std::int32_t node = 0;  ///< place in the interface
  double weight = 1.0;
};

/// What a corner of coarse blocks may do.
struct Corner
{
  std::array<double, 3> x{};  ///< position in the first mesh [m]
  bool used = false;          ///< whether a block has it
  /// Number of directions in which nothing prescribes its displacement: dim inside, dim - 1 on a boundary
  /// along which it slides, 0 where it is led.
  int freedom = 0;
  std::array<std::array<double, 3>, 3> direction{};  ///< these, orthonormal
  /// Its displacement where freedom is 0: the weighted sum of those of the interface; none: at rest.
  std::vector<Share> led;
};

/// A block with its map from reference coordinates, known at samples (corner_samples.hpp).
struct CoarseBlock
{
  element::Shape shape = element::Shape::quadrilateral;  ///< or triangle, or hexahedron
  std::vector<int> corners;                              ///< in the order of element::corners
  std::vector<double> x;                                 ///< first mesh [m], shape (sample_count, dim)
  std::vector<double> distance;  ///< to the interface in the first mesh [m], shape (sample_count)
  /// What a moving interface adds to the interpolation of the corners' displacements, so that the block
  /// follows its exact shape: ramp (d - I d) on sides (corners3d.md section 1 for edges in 3D).
  struct Bend
  {
    std::int32_t sample = 0;
    Share share;
  };
  std::vector<Bend> bends;
};

/// The coarse blocks as the rules for moving corners see them, in two or three dimensions.
struct CornerGraph
{
  int dim = 2;
  int degree = 4;  ///< of the samples: degree + 1 per direction
  std::vector<Corner> corners;
  std::vector<CoarseBlock> blocks;
  std::size_t interface_count = 0;
  double size = 1.0;       ///< extent of the interface [m]; lengths are small compared with it
  double thickness = 1.0;  ///< of what moves [m]: blocks nearer than that are kept best
};

/// Place of each corner's first free direction among all unknowns, and at the end their number; shape
/// (corner_count + 1).
std::vector<int> unknown_numbers(const CornerGraph& graph);

/// Orthonormal directions that are perpendicular to some orthonormal ones, within dim components.
std::vector<std::array<double, 3>> complement(std::span<const std::array<double, 3>> base, int dim);

/// Displacement of all corners from that of the interface and from the unknowns.
///   d [m], shape (interface_count, dim);  y [m], shape (unknowns);  U [m], shape (corner_count, dim),
///   written.
void displace_corners(const CornerGraph& graph, const double* d, const double* y, double* U);

}  // namespace blockfsi::block
