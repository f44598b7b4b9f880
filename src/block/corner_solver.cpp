#include "block/corner_solver.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace blockfsi::block
{

namespace
{

/// Share of the predicted decrease that a step must bring (Armijo 1966).
constexpr double sufficient = 1e-4;
constexpr int max_backtracks = 30;
/// Predicted decreases below this share of the energy drown in its rounding errors.
constexpr double rounding = 1e-13;
/// Below this share it is near to a stationary point.
constexpr double nearness = 1e-3;
/// Least curvature that is divided by, relative to the greatest.
constexpr double flat = 1e-10;
/// Steps along negative curvature that rounding may bring about, in tolerances.
constexpr double ridge = 1e4;

/// The energy as a function of the unknowns, for one place of the interface.
template <int dim>
class Landscape
{
public:
  Landscape(const CornerEnergy<dim>& energy, std::span<const double> d, double longest)
      : energy_(energy), d_(d), U_(energy.graph().corners.size() * dim), ridge_(longest)
  {
  }

  double value(const Eigen::VectorXd& y, double epsilon, double& least)
  {
    displace_corners(energy_.graph(), d_.data(), y.data(), U_.data());
    return energy_.value(U_, epsilon, least);
  }

  /// Newton's step; false if there is none. Where the Hessian is not positive, far away that of each sample
  /// is replaced by its positive part, which is robust; near a stationary point the whole one by its absolute
  /// value, with which the steps along its positive directions are Newton's own and converge as fast.
  bool step(const Eigen::VectorXd& y, double epsilon, bool near, Eigen::VectorXd& step, double& slope)
  {
    displace_corners(energy_.graph(), d_.data(), y.data(), U_.data());
    energy_.derivatives(U_, epsilon, false, gradient_, hessian_);
    factor_.compute(hessian_);
    if (factor_.info() == Eigen::Success)
      step = -factor_.solve(gradient_);
    else if (near)
      step = absolute_step();
    else
    {
      energy_.derivatives(U_, epsilon, true, gradient_, hessian_);
      factor_.compute(hessian_);
      if (factor_.info() != Eigen::Success)
        return false;
      step = -factor_.solve(gradient_);
    }
    slope = gradient_.dot(step);
    return step.allFinite() && slope <= 0.0;
  }

private:
  /// - |H|^-1 g from the lower triangle of H. Symmetric blocks may be kept on a ridge by their symmetry;
  /// steps down from it that are no longer than `ridge_` stem from rounding and are left out.
  Eigen::VectorXd absolute_step() const
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(hessian_);
    Eigen::VectorXd size = eigen.eigenvalues().cwiseAbs();
    size = size.cwiseMax(flat * size.maxCoeff());
    Eigen::VectorXd along = (eigen.eigenvectors().transpose() * gradient_).cwiseQuotient(size);
    for (Eigen::Index i = 0; i < along.size(); ++i)
      if (eigen.eigenvalues()(i) < 0.0 && std::abs(along(i)) <= ridge_)
        along(i) = 0.0;
    return -(eigen.eigenvectors() * along);
  }

  const CornerEnergy<dim>& energy_;
  std::span<const double> d_;
  std::vector<double> U_;
  double ridge_;
  Eigen::VectorXd gradient_;
  Eigen::MatrixXd hessian_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

/// Goes along a step as far as the energy falls enough; false if nowhere.
template <int dim>
bool backtrack(Landscape<dim>& landscape, const Eigen::VectorXd& step, double slope, double epsilon,
               Eigen::VectorXd& y, double& energy, double& least)
{
  const bool blind = -slope <= rounding * std::abs(energy);
  double length = 1.0;
  for (int i = 0; i < max_backtracks; ++i, length *= 0.5)
  {
    const Eigen::VectorXd next = y + length * step;
    double next_least = 0.0;
    const double next_energy = landscape.value(next, epsilon, next_least);
    if (next_energy < energy + sufficient * length * slope || (blind && std::isfinite(next_energy)))
    {
      y = next;
      energy = next_energy;
      least = next_least;
      return true;
    }
  }
  return false;
}

double regularisation(double least)
{
  return least > 0.0 ? 0.0 : std::sqrt(1e-6 + 0.04 * least * least);
}

}  // namespace

template <int dim>
CornerReport minimise(const CornerEnergy<dim>& energy, std::span<const double> d, Eigen::VectorXd& y,
                      double tolerance, int max_iterations)
{
  CornerReport report;
  Landscape<dim> landscape(energy, d, ridge * tolerance);
  Eigen::VectorXd step;
  report.energy = landscape.value(y, 1e-3, report.least);
  double epsilon = regularisation(report.least);
  report.energy = landscape.value(y, epsilon, report.least);
  bool near = false;
  for (; report.iterations < max_iterations; ++report.iterations)
  {
    double slope = 0.0;
    if (!std::isfinite(report.energy) || !landscape.step(y, epsilon, near, step, slope))
      return report;
    near = -slope < nearness * report.energy;
    if (epsilon == 0.0 && step.template lpNorm<Eigen::Infinity>() <= tolerance)
    {
      report.converged = true;
      return report;
    }
    if (!backtrack(landscape, step, slope, epsilon, y, report.energy, report.least))
      return report;
    const double next = regularisation(report.least);
    if (next != epsilon)
      report.energy = landscape.value(y, next, report.least);
    epsilon = next;
  }
  return report;
}

template CornerReport minimise<2>(const CornerEnergy<2>&, std::span<const double>, Eigen::VectorXd&, double,
                                  int);
template CornerReport minimise<3>(const CornerEnergy<3>&, std::span<const double>, Eigen::VectorXd&, double,
                                  int);

}  // namespace blockfsi::block
