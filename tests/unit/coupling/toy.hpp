#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <span>
#include <vector>

namespace blockfsi::coupling::test
{

using Vector = std::vector<double>;

/// d~ = b(t) - T d, with T symmetric and eigenvalues mu_0, mu_0 / 2, mu_0 / 3, ... for random eigenvectors:
/// an incompressible fluid with added-mass ratio mu_0 acts so on a light solid (Causin, Gerbeau & Nobile
/// 2005). Plain iteration diverges for mu_0 > 1. The solution is d = sum_i b_i / (1 + mu_i) q_i.
class AddedMass
{
public:
  AddedMass(std::size_t size, double mu_0, unsigned seed = 1) : size_(size), q_(size, Vector(size)), mu_(size)
  {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (std::size_t i = 0; i < size; ++i)
    {
      std::generate(q_[i].begin(), q_[i].end(), [&] { return normal(random); });
      for (int sweep = 0; sweep < 2; ++sweep)
        for (std::size_t j = 0; j < i; ++j)
          add(-along(j, q_[i]), j, q_[i]);
      const double length = std::sqrt(along(i, q_[i]));
      for (double& entry : q_[i])
        entry /= length;
      mu_[i] = mu_0 / static_cast<double>(i + 1);
    }
  }

  /// Load with the given parts along the first eigenvectors.
  void set_load(const Vector& parts) { parts_ = parts; }

  bool operator()(std::span<const double> d, std::span<double> d_tilde) const
  {
    std::fill(d_tilde.begin(), d_tilde.end(), 0.0);
    for (std::size_t i = 0; i < size_; ++i)
      add(part(i) - mu_[i] * along(i, d), i, d_tilde);
    return true;
  }

  Vector solution() const
  {
    Vector d(size_, 0.0);
    for (std::size_t i = 0; i < size_; ++i)
      add(part(i) / (1.0 + mu_[i]), i, d);
    return d;
  }

  std::size_t size() const { return size_; }

private:
  double part(std::size_t i) const { return i < parts_.size() ? parts_[i] : 0.0; }
  double along(std::size_t i, std::span<const double> v) const
  {
    return std::inner_product(v.begin(), v.end(), q_[i].begin(), 0.0);
  }
  void add(double factor, std::size_t i, std::span<double> v) const
  {
    for (std::size_t k = 0; k < v.size(); ++k)
      v[k] += factor * q_[i][k];
  }

  std::size_t size_;
  std::vector<Vector> q_;
  Vector mu_, parts_;
};

inline double distance(const Vector& a, const Vector& b)
{
  double square = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    square += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(square);
}

}  // namespace blockfsi::coupling::test
