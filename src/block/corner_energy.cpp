#include "block/corner_energy.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <limits>

namespace blockfsi::block
{

namespace
{

constexpr double least_eigenvalue = 1e-8;

/// The nearest matrix without negative eigenvalues.
template <int size>
void make_positive(Eigen::Matrix<double, size, size>& A)
{
  if (A.llt().info() == Eigen::Success)
    return;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, size, size>> parts(A);
  A = parts.eigenvectors() * parts.eigenvalues().cwiseMax(least_eigenvalue).asDiagonal() *
      parts.eigenvectors().transpose();
}

/// d(values) / d(reference coordinates) at a sample; values of shape (count, dim).
template <int dim>
Eigen::Matrix<double, dim, dim> reference_gradient(const CornerSamples& samples, int sample,
                                                   const std::vector<double>& values)
{
  Eigen::Matrix<double, dim, dim> J = Eigen::Matrix<double, dim, dim>::Zero();
  for (int axis = 0; axis < dim; ++axis)
    for (int s = 0; s < samples.count; ++s)
    {
      const double weight =
          samples.derivative[(static_cast<std::size_t>(axis) * samples.count + sample) * samples.count + s];
      for (int i = 0; i < dim; ++i)
        J(i, axis) += weight * values[static_cast<std::size_t>(s) * dim + i];
    }
  return J;
}

}  // namespace

template <int dim>
CornerEnergy<dim>::CornerEnergy(const CornerGraph& graph, const EnergyParameters& parameters)
    : graph_(graph), parameters_(parameters), shapes_(graph.degree), unknowns_(unknown_numbers(graph))
{
  for (const CoarseBlock& block : graph.blocks)
    add_block(graph, block, parameters);
}

template <int dim>
void CornerEnergy<dim>::add_block(const CornerGraph& graph, const CoarseBlock& block,
                                  const EnergyParameters& parameters)
{
  const CornerSamples& samples = shapes_.of(block.shape);
  Block entry{block.corners, {}, samples_.size(), samples.count, !block.bends.empty()};
  for (int c = 0; c < samples.corner_count; ++c)
    if (graph.corners[block.corners[c]].freedom > 0)
      entry.free.push_back(c);
  for (int s = 0; s < samples.count; ++s)
  {
    Sample sample;
    sample.plain = samples.weight[s];
    sample.weight = sample.plain * std::pow(1.0 + block.distance[s] / graph.thickness, -parameters.nearness);
    sample.inverse = reference_gradient<dim>(samples, s, block.x).inverse();
    sample.bent = sample.tether = Matrix::Identity();
    samples_.push_back(sample);
    gradient_first_.push_back(gradients_.size());
    for (int c = 0; c < samples.corner_count; ++c)
    {
      Eigen::Map<const Eigen::Matrix<double, dim, 1>> reference(
          samples.basis_gradient.data() + (static_cast<std::size_t>(s) * samples.corner_count + c) * dim);
      const Eigen::Matrix<double, dim, 1> G = sample.inverse.transpose() * reference;
      gradients_.insert(gradients_.end(), G.data(), G.data() + dim);
    }
  }
  blocks_.push_back(std::move(entry));
}

template <int dim>
void CornerEnergy<dim>::bend(std::span<const double> d)
{
  std::vector<double> bent;
  for (std::size_t b = 0; b < blocks_.size(); ++b)
  {
    if (!blocks_[b].bends)
      continue;
    const CoarseBlock& block = graph_.blocks[b];
    const CornerSamples& samples = shapes_.of(block.shape);
    bent.assign(static_cast<std::size_t>(samples.count) * dim, 0.0);
    for (const CoarseBlock::Bend& term : block.bends)
      for (int i = 0; i < dim; ++i)
        bent[term.sample * dim + i] += term.share.weight * d[term.share.node * dim + i];
    for (int s = 0; s < samples.count; ++s)
    {
      Sample& sample = samples_[blocks_[b].first + s];
      sample.bent = Matrix::Identity() + reference_gradient<dim>(samples, s, bent) * sample.inverse;
    }
  }
}

template <int dim>
typename CornerEnergy<dim>::Matrix CornerEnergy<dim>::deformation(const Block& block, int sample,
                                                                  std::span<const double> U) const
{
  Matrix F = samples_[block.first + sample].bent;
  for (std::size_t c = 0; c < block.corners.size(); ++c)
  {
    const Eigen::Map<const Eigen::Matrix<double, dim, 1>> u(U.data() + block.corners[c] * dim);
    F.noalias() += u * gradient(block, sample, static_cast<int>(c)).transpose();
  }
  return F;
}

template <int dim>
void CornerEnergy<dim>::tether(std::span<const double> U)
{
  for (const Block& block : blocks_)
    for (int s = 0; s < block.count; ++s)
      samples_[block.first + s].tether = deformation(block, s, U);
}

template <int dim>
double CornerEnergy<dim>::value(std::span<const double> U, double epsilon, double& least) const
{
  double sum = 0.0;
  least = std::numeric_limits<double>::infinity();
  for (const Block& block : blocks_)
    for (int s = 0; s < block.count; ++s)
    {
      const Sample& sample = samples_[block.first + s];
      const Matrix F = deformation(block, s, U);
      const double D = F.determinant();
      least = std::min(least, std::isfinite(D) ? D : -std::numeric_limits<double>::infinity());
      if (epsilon == 0.0 && !(D > 0.0))
        sum = std::numeric_limits<double>::infinity();
      else
        sum += sample.weight * distortion_value<dim>(F, D, parameters_.distortion, epsilon);
      if (parameters_.tether > 0.0)
        sum += parameters_.tether * sample.plain * (F - sample.tether).squaredNorm();
    }
  return sum;
}

template <int dim>
void CornerEnergy<dim>::add_sample(const Block& block, int s, const Distortion<dim>& point, double weight,
                                   Eigen::VectorXd& gradient_sum, Eigen::MatrixXd& hessian) const
{
  using Half = Eigen::Matrix<double, dim, dim * dim>;
  for (const int c : block.free)
  {
    const Corner& corner = graph_.corners[block.corners[c]];
    const Eigen::Matrix<double, dim, 1> G = weight * gradient(block, s, c);
    Half half = Half::Zero();  // of corner c, by F
    Eigen::Matrix<double, dim, 1> force = Eigen::Matrix<double, dim, 1>::Zero();
    for (int i = 0; i < dim; ++i)
      for (int l = 0; l < dim; ++l)
      {
        half.row(i) += G(l) * point.second.row(i * dim + l);
        force(i) += G(l) * point.first(i * dim + l);
      }
    const int row = unknowns_[block.corners[c]];
    const auto direction = [](const Corner& of, int k)
    { return Eigen::Map<const Eigen::Matrix<double, dim, 1>>(of.direction[k].data()); };
    for (int k = 0; k < corner.freedom; ++k)
      gradient_sum(row + k) += direction(corner, k).dot(force);
    for (const int other : block.free)
    {
      const int column = unknowns_[block.corners[other]];
      if (column > row)
        continue;  // the lower triangle is enough
      const Corner& second = graph_.corners[block.corners[other]];
      const Eigen::Map<const Eigen::Matrix<double, dim, 1>> H = gradient(block, s, other);
      Matrix part;
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          part(i, j) = half.row(i).template segment<dim>(j * dim).dot(H.transpose());
      for (int m = 0; m < second.freedom; ++m)
      {
        const Eigen::Matrix<double, dim, 1> image = part * direction(second, m);
        for (int k = 0; k < corner.freedom; ++k)
          hessian(row + k, column + m) += direction(corner, k).dot(image);
      }
    }
  }
}

template <int dim>
void CornerEnergy<dim>::derivatives(std::span<const double> U, double epsilon, bool project,
                                    Eigen::VectorXd& gradient_sum, Eigen::MatrixXd& hessian) const
{
  gradient_sum.setZero(unknown_count());
  hessian.setZero(unknown_count(), unknown_count());
  for (const Block& block : blocks_)
  {
    if (block.free.empty())
      continue;
    for (int s = 0; s < block.count; ++s)
    {
      const Sample& sample = samples_[block.first + s];
      const Matrix F = deformation(block, s, U);
      Distortion<dim> point = distortion<dim>(F, parameters_.distortion, epsilon);
      if (project)
        make_positive(point.second);
      if (parameters_.tether > 0.0)
      {
        const double stiffness = 2.0 * parameters_.tether * sample.plain / sample.weight;
        point.second.diagonal().array() += stiffness;
        for (int i = 0; i < dim; ++i)
          for (int l = 0; l < dim; ++l)
            point.first(i * dim + l) += stiffness * (F(i, l) - sample.tether(i, l));
      }
      add_sample(block, s, point, sample.weight, gradient_sum, hessian);
    }
  }
}

template class CornerEnergy<2>;
template class CornerEnergy<3>;

}  // namespace blockfsi::block
