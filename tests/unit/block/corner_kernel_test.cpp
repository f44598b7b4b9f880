#include "block/corner_kernel.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>

#include <random>

using namespace blockfsi::block;

namespace
{

template <int dim>
using Matrix = Eigen::Matrix<double, dim, dim>;

template <int dim>
double value(const Matrix<dim>& F, const DistortionParameters& parameters, double epsilon)
{
  return distortion_value<dim>(F, F.determinant(), parameters, epsilon);
}

/// Compares with differences of the order above, at many deformations.
template <int dim>
void check_derivatives(const DistortionParameters& parameters, double epsilon)
{
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 20; ++trial)
  {
    Matrix<dim> F = Matrix<dim>::Identity();
    for (int i = 0; i < dim * dim; ++i)
      F(i / dim, i % dim) += 0.25 * normal(random);
    if (epsilon == 0.0 && F.determinant() < 0.2)
      continue;
    const Distortion<dim> exact = distortion<dim>(F, parameters, epsilon);
    CHECK(exact.value == doctest::Approx(value<dim>(F, parameters, epsilon)).epsilon(1e-13));
    constexpr double h = 1e-5;
    for (int i = 0; i < dim * dim; ++i)
    {
      Matrix<dim> plus = F;
      Matrix<dim> minus = F;
      plus(i / dim, i % dim) += h;
      minus(i / dim, i % dim) -= h;
      const double first =
          (value<dim>(plus, parameters, epsilon) - value<dim>(minus, parameters, epsilon)) / (2.0 * h);
      const auto second = ((distortion<dim>(plus, parameters, epsilon).first -
                            distortion<dim>(minus, parameters, epsilon).first) /
                           (2.0 * h))
                              .eval();
      CHECK(std::abs(exact.first(i) - first) < 1e-7 * (1.0 + exact.first.norm() + exact.second.norm()));
      CHECK((exact.second.col(i) - second).norm() < 1e-6 * (1.0 + exact.second.norm()));
    }
    CHECK((exact.second - exact.second.transpose()).norm() < 1e-12 * exact.second.norm());
  }
}

}  // namespace

TEST_CASE("the distortion's derivatives agree with differences in 2D and 3D, folded or not")
{
  for (const int power : {1, 2, 4})
    for (const double epsilon : {0.0, 0.3})
    {
      check_derivatives<2>({0.3, power}, epsilon);
      check_derivatives<3>({0.3, power}, epsilon);
    }
}

TEST_CASE("rotations do not distort, everything else does")
{
  const DistortionParameters parameters{0.3, 2};
  Matrix<3> turn;
  turn << 0.36, 0.48, -0.8, -0.8, 0.6, 0.0, 0.48, 0.64, 0.6;
  CHECK(value<3>(turn, parameters, 0.0) == doctest::Approx(1.0).epsilon(1e-14));
  CHECK(distortion<3>(turn, parameters, 0.0).first.norm() < 1e-13);
  for (const double stretch : {0.5, 0.9, 1.1, 2.0})
  {
    CHECK(value<3>(stretch * turn, parameters, 0.0) > 1.0);
    Matrix<3> pulled = turn;
    pulled.col(1) *= stretch;
    CHECK(value<3>(pulled, parameters, 0.0) > 1.0);
  }
}
