#pragma once

#include "block/corner_energy.hpp"

#include <Eigen/Core>

#include <span>

namespace blockfsi::block
{

/// How the search for the corners' places went.
struct CornerReport
{
  bool converged = false;
  int iterations = 0;  ///< of Newton's method, all increments together
  int halvings = 0;    ///< of the increment of the interface
  double least = 1.0;  ///< least Jacobian of the deformation at the samples of blocks, <= 0: folded
  double energy = 0.0;
};

/// Minimises the energy from the unknowns y by Newton's method with backtracking. Where the Hessian is not
/// positive, that of each sample is replaced by its positive part. Folded starts are unfolded with
/// epsilon^2 = 1e-6 + 0.04 min(D, 0)^2. Stops when the next step would be less than the tolerance [m], and
/// leaves that out: a minimum as start stays bit for bit.
///   d [m], shape (interface_count, dim);  y [m], shape (unknowns), start and result.
template <int dim>
CornerReport minimise(const CornerEnergy<dim>& energy, std::span<const double> d, Eigen::VectorXd& y,
                      double tolerance, int max_iterations);

extern template CornerReport minimise<2>(const CornerEnergy<2>&, std::span<const double>, Eigen::VectorXd&,
                                         double, int);
extern template CornerReport minimise<3>(const CornerEnergy<3>&, std::span<const double>, Eigen::VectorXd&,
                                         double, int);

}  // namespace blockfsi::block
