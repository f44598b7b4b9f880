#pragma once

#include "geometry/level_set.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace blockfsi::geometry
{

/// A line of a skeleton between two nodes: straight, or an arc through a point between them.
struct Bone
{
  int from = 0;
  int to = 0;
  std::optional<Point> through;
};

/// The middle lines of a branching tube with its radii.
struct Skeleton
{
  std::vector<Point> nodes;
  std::vector<double> radii;  ///< of the tube at each node [m]
  std::vector<Bone> bones;
  double sharpness =
      1.0;  ///< s of the kernel [1/m]: bones farther apart than a few 1/s do not feel each other
  double threshold = 1.0;  ///< T; scales the weights and leaves the surface of a single bone as it is
};

/// The field of a skeleton, f(x) = Σ ∫ w(τ) / (1 + s² |x - c(τ)|²)² dτ over its bones (Cauchy kernel,
/// McCormack & Sherstyuk 1998), whose level f = T is a smooth tube. The weight w is linear along each bone
/// between w = 2 s T (1 + s² r²)^(3/2) / π at its nodes, with which an infinite straight bone gets the radius
/// r. Straight bones are integrated in closed form, arcs by Gauss points as fine as the kernel. A value,
/// cheap to copy.
class Convolution
{
public:
  /// Throws Error for radii that are not positive, bones without a length and the like, saying which.
  explicit Convolution(const Skeleton& skeleton);

  /// f and ∇f. Allocates nothing.
  Level operator()(const Point& x) const;
  double threshold() const;
  /// Mean of the radii of the nodes [m].
  double mean_radius() const;

private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

/// The inside f > T of the tube as a level set φ = r ((T / f)^(1/3) - 1) with the mean radius r: near a tube
/// with s r > 1 that is close to a distance, and searches converge from far away.
LevelSet tube(const Convolution& field);

}  // namespace blockfsi::geometry
