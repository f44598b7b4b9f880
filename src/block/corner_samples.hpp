#pragma once

#include "block/corner_graph.hpp"

#include <array>
#include <vector>

namespace blockfsi::block
{

/// Points of a reference block at which its map is looked at, and what differentiates a map known there.
struct CornerSamples
{
  int dim = 2;
  int count = 0;
  int corner_count = 0;
  std::vector<std::array<double, 3>> point;  ///< reference coordinates
  std::vector<double> weight;                ///< positive, with sum 1
  std::vector<double> basis;                 ///< functions of the corners, shape (count, corner_count)
  std::vector<double> basis_gradient;        ///< shape (count, corner_count, dim)
  std::vector<double> derivative;            ///< from values at samples, shape (dim, count, count)
};

/// Samples of degree 1 or more: tensor products of the Gauss-Lobatto-Legendre points, first coordinate
/// slowest, with their weights; on triangles the lattice of that degree with equal weights. All contain the
/// corners, where blocks fold first.
CornerSamples corner_samples(element::Shape shape, int degree);

/// The samples of one degree, made for each shape when they are first asked for.
class SamplesByShape
{
public:
  explicit SamplesByShape(int degree) : degree_(degree) {}

  const CornerSamples& of(element::Shape shape);

private:
  int degree_;
  std::array<CornerSamples, element::shape_count> samples_;
};

}  // namespace blockfsi::block
