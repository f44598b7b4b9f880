#include "block/corner_rules.hpp"

#include "block/corner_samples.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>

#include <cmath>
#include <span>

namespace blockfsi::block
{

namespace
{

/// A component of the displacement of a corner that is known.
struct Condition
{
  int corner;
  Eigen::Vector3d direction;
};

Eigen::Vector3d vector(const std::array<double, 3>& x)
{
  return {x[0], x[1], x[2]};
}

/// Radial functions and polynomials at a distance and position: what multiplies the unknown coefficients.
class RadialSystem
{
public:
  explicit RadialSystem(const CornerGraph& graph) : dim_(graph.dim)
  {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(HUGE_VAL);
    Eigen::Vector3d high = -low;
    for (std::size_t c = 0; c < graph.corners.size(); ++c)
    {
      const Corner& corner = graph.corners[c];
      if (!corner.used)
        continue;
      low = low.cwiseMin(vector(corner.x));
      high = high.cwiseMax(vector(corner.x));
      const std::span<const std::array<double, 3>> free(corner.direction.data(), corner.freedom);
      for (const auto& direction : complement(free, dim_))
        conditions_.push_back({static_cast<int>(c), vector(direction)});
    }
    middle_ = 0.5 * (low + high);
    scale_ = 0.5 * (high - low).norm();
    for (const Condition& condition : conditions_)
      place_.push_back(scaled(graph.corners[condition.corner]));
  }

  const std::vector<Condition>& conditions() const { return conditions_; }
  Eigen::Index size() const { return static_cast<Eigen::Index>(conditions_.size()) + dim_ * (dim_ + 1); }

  /// The component along a direction, at a corner, of each of the functions.
  Eigen::RowVectorXd row(const Corner& corner, const Eigen::Vector3d& direction) const
  {
    const Eigen::Vector3d x = scaled(corner);
    Eigen::RowVectorXd row(size());
    Eigen::Index column = 0;
    for (std::size_t i = 0; i < conditions_.size(); ++i)
    {
      const double r = (x - place_[i]).norm();
      row(column++) = r * r * r * direction.dot(conditions_[i].direction);
    }
    for (int component = 0; component < dim_; ++component)
    {
      row(column++) = direction(component);
      for (int k = 0; k < dim_; ++k)
        row(column++) = direction(component) * x(k);
    }
    return row;
  }

private:
  Eigen::Vector3d scaled(const Corner& corner) const { return (vector(corner.x) - middle_) / scale_; }

  int dim_;
  std::vector<Condition> conditions_;
  std::vector<Eigen::Vector3d> place_;
  Eigen::Vector3d middle_;
  double scale_ = 1.0;
};

}  // namespace

Eigen::MatrixXd radial_rule(const CornerGraph& graph)
{
  const std::vector<int> unknowns = unknown_numbers(graph);
  const RadialSystem system(graph);
  const auto conditions = static_cast<Eigen::Index>(system.conditions().size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(system.size(), system.size());
  // Known displacements as functions of U.
  Eigen::MatrixXd known =
      Eigen::MatrixXd::Zero(system.size(), static_cast<Eigen::Index>(graph.corners.size()) * graph.dim);
  for (Eigen::Index i = 0; i < conditions; ++i)
  {
    const Condition& condition = system.conditions()[i];
    matrix.row(i) = system.row(graph.corners[condition.corner], condition.direction);
    if (graph.corners[condition.corner].freedom == 0)
      for (int k = 0; k < graph.dim; ++k)
        known(i, condition.corner * graph.dim + k) = condition.direction(k);
  }
  matrix.bottomLeftCorner(system.size() - conditions, conditions) =
      matrix.topRightCorner(conditions, system.size() - conditions).transpose();
  // Too few centres for the polynomials leave them open; then the smallest coefficients are taken.
  const Eigen::MatrixXd coefficients = matrix.completeOrthogonalDecomposition().solve(known);
  Eigen::MatrixXd values(unknowns.back(), system.size());
  for (std::size_t c = 0; c < graph.corners.size(); ++c)
    for (int k = 0; k < graph.corners[c].freedom; ++k)
      values.row(unknowns[c] + k) = system.row(graph.corners[c], vector(graph.corners[c].direction[k]));
  return values * coefficients;
}

namespace
{

constexpr double poisson = -0.4;
constexpr double stiffening = -0.25;

/// Stiffness of the coarse blocks, shape (corner_count * dim) squared.
template <int dim>
Eigen::MatrixXd elastic_stiffness(const CornerGraph& graph)
{
  using Matrix = Eigen::Matrix<double, dim, dim>;
  constexpr double lambda = poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  constexpr double mu = 0.5 / (1.0 + poisson);
  const auto size = static_cast<Eigen::Index>(graph.corners.size()) * dim;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size);
  SamplesByShape by_shape(graph.degree);
  for (const CoarseBlock& block : graph.blocks)
  {
    const CornerSamples& samples = by_shape.of(block.shape);
    using Table = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::Map<const Table> x(block.x.data(), samples.count, dim);
    const Eigen::Map<const Table> derivative(samples.derivative.data(), dim * samples.count, samples.count);
    const Table tangents = derivative * x;
    for (int s = 0; s < samples.count; ++s)
    {
      Matrix J;
      for (int axis = 0; axis < dim; ++axis)
        J.col(axis) = tangents.row(axis * samples.count + s).transpose();
      const double weight = samples.weight[s] * std::pow(std::abs(J.determinant()), stiffening);
      const Eigen::Map<const Table> reference(samples.basis_gradient.data() +
                                                  static_cast<std::size_t>(s) * samples.corner_count * dim,
                                              samples.corner_count, dim);
      const Table G = reference * J.inverse();
      for (int c = 0; c < samples.corner_count; ++c)
        for (int d = 0; d < samples.corner_count; ++d)
        {
          // lambda G_ci G_dj + mu (G_c . G_d delta_ij + G_cj G_di)
          const Matrix outer = G.row(c).transpose() * G.row(d);
          stiffness.block<dim, dim>(block.corners[c] * dim, block.corners[d] * dim) +=
              weight * (lambda * outer + mu * (outer.trace() * Matrix::Identity() + outer.transpose()));
        }
    }
  }
  return stiffness;
}

}  // namespace

Eigen::MatrixXd elastic_rule(const CornerGraph& graph)
{
  const int dim = graph.dim;
  const Eigen::MatrixXd stiffness = dim == 2 ? elastic_stiffness<2>(graph) : elastic_stiffness<3>(graph);
  const std::vector<int> unknowns = unknown_numbers(graph);
  Eigen::MatrixXd free = Eigen::MatrixXd::Zero(stiffness.rows(), unknowns.back());
  Eigen::MatrixXd led = Eigen::MatrixXd::Zero(stiffness.rows(), stiffness.rows());
  for (std::size_t c = 0; c < graph.corners.size(); ++c)
  {
    const auto first = static_cast<Eigen::Index>(c) * dim;
    for (int k = 0; k < graph.corners[c].freedom; ++k)
      for (int i = 0; i < dim; ++i)
        free(first + i, unknowns[c] + k) = graph.corners[c].direction[k][i];
    if (graph.corners[c].freedom == 0)
      led.block(first, first, dim, dim).setIdentity();
  }
  const Eigen::MatrixXd reduced = free.transpose() * stiffness * free;
  return reduced.ldlt().solve(-free.transpose() * stiffness * led);
}

}  // namespace blockfsi::block
