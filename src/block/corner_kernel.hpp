#pragma once

#include <Eigen/Core>

#include <cmath>

namespace blockfsi::block
{

/// Form of the energy by which corners find their place (formulation.md chapter 9, corners3d.md section 3).
struct DistortionParameters
{
  double volume = 0.3;  ///< share of the change of volume, the rest is change of shape [-]
  int power = 2;        ///< power of the distortion: higher ones even out the worst places
};

/// Derivatives of the distortion by the deformation gradient F, entry (i, l) at i * dim + l.
template <int dim>
struct Distortion
{
  double value = 0.0;
  Eigen::Matrix<double, dim * dim, 1> first;
  Eigen::Matrix<double, dim * dim, dim * dim> second;
};

/// Cofactors of F: the derivative of its determinant.
template <int dim>
Eigen::Matrix<double, dim, dim> cofactors(const Eigen::Matrix<double, dim, dim>& F)
{
  Eigen::Matrix<double, dim, dim> cof;
  if constexpr (dim == 2)
    cof << F(1, 1), -F(1, 0), -F(0, 1), F(0, 0);
  else
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
      {
        const int k = (i + 1) % 3;
        const int l = (i + 2) % 3;
        const int m = (j + 1) % 3;
        const int n = (j + 2) % 3;
        cof(i, j) = F(k, m) * F(l, n) - F(k, n) * F(l, m);
      }
  return cof;
}

/// The scalar functions of I = |F|^2 and D = det F of which the distortion is made:
///   W = (1 - kappa) I / (dim chi^(2/dim)) + kappa (D^2 + 1) / (2 chi),  chi = (D + sqrt(D^2 + epsilon^2))
///   / 2.
/// W = 1 at rest and where nothing but a rotation happens. With epsilon = 0 it is infinite at a fold, with
/// epsilon > 0 it is smooth across (regularisation: Garanzha, Kaporin, Kudryavtseva, Protais, Ray, Sokolov
/// 2021).
struct DistortionScalars
{
  double W, W_I, W_D, W_ID, W_DD;

  DistortionScalars(int dim, double kappa, double I, double D, double epsilon)
  {
    const double r = std::sqrt(D * D + epsilon * epsilon);
    const double chi = 0.5 * (D + r);
    const double chi1 = r > 0.0 ? 0.5 * (1.0 + D / r) : 0.5;
    const double chi2 = r > 0.0 ? 0.5 * epsilon * epsilon / (r * r * r) : 0.0;
    const double a = 2.0 / dim;
    const double b = (1.0 - kappa) / dim;
    const double root = dim == 2 ? 1.0 / chi : 1.0 / (std::cbrt(chi) * std::cbrt(chi));  // chi^-a
    const double q = D * D + 1.0;
    W = b * I * root + kappa * q / (2.0 * chi);
    W_I = b * root;
    W_ID = -a * b * root / chi * chi1;
    W_D = W_ID * I + kappa * D / chi - kappa * q * chi1 / (2.0 * chi * chi);
    W_DD = b * I * root * (a * (a + 1.0) * chi1 * chi1 / (chi * chi) - a * chi2 / chi) + kappa / chi -
           2.0 * kappa * D * chi1 / (chi * chi) - kappa * q * chi2 / (2.0 * chi * chi) +
           kappa * q * chi1 * chi1 / (chi * chi * chi);
  }
};

inline double integer_power(double x, int n)
{
  double power = 1.0;
  for (int i = 0; i < n; ++i)
    power *= x;
  return power;
}

/// W^power at F; infinite at a fold without regularisation.
template <int dim>
double distortion_value(const Eigen::Matrix<double, dim, dim>& F, double D, const DistortionParameters& p,
                        double epsilon)
{
  const DistortionScalars w(dim, p.volume, F.squaredNorm(), D, epsilon);
  return integer_power(w.W, p.power);
}

/// W^power with first and second derivatives by F.
template <int dim>
Distortion<dim> distortion(const Eigen::Matrix<double, dim, dim>& F, const DistortionParameters& p,
                           double epsilon)
{
  using Flat = Eigen::Matrix<double, dim * dim, 1>;
  const Eigen::Matrix<double, dim, dim> cofactor = cofactors<dim>(F);
  const double D = F.row(0).dot(cofactor.row(0));
  const DistortionScalars w(dim, p.volume, F.squaredNorm(), D, epsilon);
  Flat f;
  Flat c;
  for (int i = 0; i < dim; ++i)
    for (int l = 0; l < dim; ++l)
    {
      f(i * dim + l) = F(i, l);
      c(i * dim + l) = cofactor(i, l);
    }
  Distortion<dim> result;
  result.first = 2.0 * w.W_I * f + w.W_D * c;
  // 2 W_I 1 + 2 W_ID (F x cof + cof x F) + W_DD cof x cof + W_D dcof/dF
  const Flat mixed = 2.0 * w.W_ID * f + w.W_DD * c;
  result.second.noalias() = c * mixed.transpose();
  result.second.noalias() += 2.0 * w.W_ID * f * c.transpose();
  result.second.diagonal().array() += 2.0 * w.W_I;
  if constexpr (dim == 2)
  {
    result.second(0, 3) += w.W_D;
    result.second(3, 0) += w.W_D;
    result.second(1, 2) -= w.W_D;
    result.second(2, 1) -= w.W_D;
  }
  else
    // d cof_ij / d F_kl = eps_ikb eps_jld F_bd: for k = i + 1 it is + or - the remaining entry.
    for (int i = 0; i < 3; ++i)
      for (int s : {1, 2})
        for (int j = 0; j < 3; ++j)
          for (int t : {1, 2})
          {
            const int k = (i + s) % 3;
            const int l = (j + t) % 3;
            result.second(i * 3 + j, k * 3 + l) += (s == t ? w.W_D : -w.W_D) * F(3 - i - k, 3 - j - l);
          }
  const double lower = p.power * integer_power(w.W, p.power - 1);  // derivative of W^p by W
  if (p.power > 1)
  {
    const double second = p.power * (p.power - 1) * integer_power(w.W, p.power - 2);
    result.second *= lower;
    result.second.noalias() += second * result.first * result.first.transpose();
    result.first *= lower;
  }
  result.value = integer_power(w.W, p.power);
  return result;
}

}  // namespace blockfsi::block
