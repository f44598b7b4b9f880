#include "block/corner_samples.hpp"

#include "element/line.hpp"

#include <Eigen/LU>

#include <cmath>

namespace blockfsi::block
{

namespace
{

/// Weights of the points of a line: integrals of their Lagrange functions.
std::vector<double> line_weights(const std::vector<double>& points)
{
  const element::Rule rule = element::gauss(static_cast<int>(points.size()));
  const element::Table table = element::lagrange(points, rule.points);
  std::vector<double> weights(points.size(), 0.0);
  for (int q = 0; q < table.point_count; ++q)
    for (int i = 0; i < table.node_count; ++i)
      weights[i] += rule.weights[q] * table.value[q * table.node_count + i];
  return weights;
}

/// Products of linear functions of the coordinates.
void add_box_basis(element::Shape shape, CornerSamples& samples)
{
  for (const auto& r : samples.point)
    for (const auto& corner : element::corners(shape))
    {
      const auto value = [&](int k) { return corner[k] == 1.0 ? r[k] : 1.0 - r[k]; };
      double product = 1.0;
      for (int k = 0; k < samples.dim; ++k)
        product *= value(k);
      samples.basis.push_back(product);
      for (int k = 0; k < samples.dim; ++k)
      {
        double gradient = corner[k] == 1.0 ? 1.0 : -1.0;
        for (int l = 0; l < samples.dim; ++l)
          gradient *= l == k ? 1.0 : value(l);
        samples.basis_gradient.push_back(gradient);
      }
    }
}

/// Tensor product of a line: square or cube.
CornerSamples box(element::Shape shape, int degree)
{
  CornerSamples samples;
  samples.dim = shape == element::Shape::hexahedron ? 3 : 2;
  samples.corner_count = element::corner_count(shape);
  const std::vector<double> line = element::lobatto(degree);
  const std::vector<double> weights = line_weights(line);
  const element::Table table = element::lagrange(line, line);
  const int n = degree + 1;
  const int last = samples.dim == 3 ? n : 1;
  samples.count = n * n * last;
  samples.derivative.assign(static_cast<std::size_t>(samples.dim) * samples.count * samples.count, 0.0);
  const auto index = [&](std::array<int, 3> i) { return (i[0] * n + i[1]) * last + i[2]; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < last; ++k)
      {
        const bool flat = samples.dim == 2;
        samples.point.push_back({line[i], line[j], flat ? 0.0 : line[k]});
        samples.weight.push_back(weights[i] * weights[j] * (flat ? 1.0 : weights[k]));
        const std::array<int, 3> here = {i, j, k};
        for (int axis = 0; axis < samples.dim; ++axis)
          for (int m = 0; m < n; ++m)
          {
            std::array<int, 3> there = here;
            there[axis] = m;
            samples
                .derivative[(static_cast<std::size_t>(axis) * samples.count + index(here)) * samples.count +
                            index(there)] = table.first[here[axis] * n + m];
          }
      }
  add_box_basis(shape, samples);
  return samples;
}

/// Lattice of a triangle; derivatives by the polynomials of that degree through it.
CornerSamples triangle(int degree)
{
  CornerSamples samples;
  samples.corner_count = 3;
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree - i; ++j)
      samples.point.push_back({static_cast<double>(i) / degree, static_cast<double>(j) / degree, 0.0});
  const int n = samples.count = static_cast<int>(samples.point.size());
  samples.weight.assign(n, 1.0 / n);
  Eigen::MatrixXd value(n, n);
  std::array<Eigen::MatrixXd, 2> first = {Eigen::MatrixXd(n, n), Eigen::MatrixXd(n, n)};
  for (int s = 0; s < n; ++s)
  {
    const auto& [x, y, z] = samples.point[s];
    samples.basis.insert(samples.basis.end(), {1.0 - x - y, x, y});
    samples.basis_gradient.insert(samples.basis_gradient.end(), {-1.0, -1.0, 1.0, 0.0, 0.0, 1.0});
    int column = 0;
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; j <= degree - i; ++j, ++column)
      {
        value(s, column) = std::pow(x, i) * std::pow(y, j);
        first[0](s, column) = i == 0 ? 0.0 : i * std::pow(x, i - 1) * std::pow(y, j);
        first[1](s, column) = j == 0 ? 0.0 : j * std::pow(x, i) * std::pow(y, j - 1);
      }
  }
  const Eigen::MatrixXd inverse = value.inverse();
  for (const Eigen::MatrixXd& gradient : first)
  {
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> map = gradient * inverse;
    samples.derivative.insert(samples.derivative.end(), map.data(), map.data() + map.size());
  }
  return samples;
}

}  // namespace

CornerSamples corner_samples(element::Shape shape, int degree)
{
  return shape == element::Shape::triangle ? triangle(degree) : box(shape, degree);
}

const CornerSamples& SamplesByShape::of(element::Shape shape)
{
  CornerSamples& samples = samples_[static_cast<std::size_t>(shape)];
  if (samples.count == 0)
    samples = corner_samples(shape, degree_);
  return samples;
}

}  // namespace blockfsi::block
