#pragma once

#include "block/corner_graph.hpp"
#include "block/corner_kernel.hpp"
#include "block/corner_samples.hpp"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace blockfsi::block
{

/// Settings of the energy of coarse blocks.
struct EnergyParameters
{
  DistortionParameters distortion;
  double nearness = 1.0;  ///< power with which the weight falls with the distance from the interface
  double tether = 0.0;    ///< weight of the distance from the deformation under a constant rule
};

/// Energy of the coarse blocks under displacements of their corners,
///   E = sum omega W(F)^p + tau sum w |F - F_R|^2,
/// over the samples of all blocks: F the deformation gradient of the block map, F_R that under a constant
/// rule, w the weight of the sample in its block, omega = w / ((distance + thickness) / thickness)^nearness.
/// Blocks weigh alike whatever their size, so small ones are the stiffer (formulation.md chapter 9,
/// corners3d.md section 3).
template <int dim>
class CornerEnergy
{
public:
  using Matrix = Eigen::Matrix<double, dim, dim>;

  CornerEnergy(const CornerGraph& graph, const EnergyParameters& parameters);

  const CornerGraph& graph() const { return graph_; }
  int unknown_count() const { return unknowns_.back(); }

  /// The interface whose exact shape the blocks at it have: d [m], shape (interface_count, dim).
  void bend(std::span<const double> d);
  /// The displacements of the constant rule at the same interface, shape (corner_count, dim).
  void tether(std::span<const double> U);

  /// Energy at displacements U, shape (corner_count, dim). `least` gets the least det F. With epsilon = 0
  /// infinite where a sample is folded.
  double value(std::span<const double> U, double epsilon, double& least) const;

  /// Gradient and Hessian by the unknowns. `project` replaces the Hessian of each sample by its positive
  /// part.
  void derivatives(std::span<const double> U, double epsilon, bool project, Eigen::VectorXd& gradient,
                   Eigen::MatrixXd& hessian) const;

private:
  struct Sample
  {
    double weight;   ///< omega
    double plain;    ///< w
    Matrix inverse;  ///< of the first Jacobian
    Matrix bent;     ///< F of the bends alone, 1 without
    Matrix tether;   ///< F_R
  };
  struct Block
  {
    std::vector<int> corners;
    std::vector<int> free;  ///< places among the block's corners that have unknowns
    std::size_t first;      ///< its first sample
    int count;
    bool bends;
  };

  Eigen::Map<const Eigen::Matrix<double, dim, 1>> gradient(const Block& block, int sample, int corner) const
  {
    return Eigen::Map<const Eigen::Matrix<double, dim, 1>>(
        gradients_.data() + gradient_first_[block.first + sample] + static_cast<std::size_t>(corner) * dim);
  }
  void add_block(const CornerGraph& graph, const CoarseBlock& block, const EnergyParameters& parameters);
  Matrix deformation(const Block& block, int sample, std::span<const double> U) const;
  void add_sample(const Block& block, int sample, const Distortion<dim>& point, double weight,
                  Eigen::VectorXd& gradient, Eigen::MatrixXd& hessian) const;

  CornerGraph graph_;
  EnergyParameters parameters_;
  SamplesByShape shapes_;
  std::vector<int> unknowns_;
  std::vector<Block> blocks_;
  std::vector<Sample> samples_;
  std::vector<std::size_t> gradient_first_;
  std::vector<double> gradients_;  ///< of the corners' functions in the first mesh, per sample (corner, dim)
};

extern template class CornerEnergy<2>;
extern template class CornerEnergy<3>;

}  // namespace blockfsi::block
