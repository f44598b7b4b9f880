#include "element/quadrature.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace blockfsi::element
{

Rule gauss_jacobi(int n, int alpha)
{
  if (alpha == 0)
    return gauss(n);
  // Golub and Welsch 1969: eigenvalues of the matrix of the recurrence, on [-1, 1] with beta = 0.
  Eigen::MatrixXd recurrence = Eigen::MatrixXd::Zero(n, n);
  const double a = alpha;
  for (int i = 0; i < n; ++i)
  {
    const double m = 2.0 * i + a;
    recurrence(i, i) = -a * a / (m * (m + 2.0));
    if (i == 0)
      continue;
    const double squared = 4.0 * i * i * (i + a) * (i + a) / (m * m * (m + 1.0) * (m - 1.0));
    recurrence(i, i - 1) = recurrence(i - 1, i) = std::sqrt(squared);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(recurrence);
  Rule rule;
  for (int i = 0; i < n; ++i)
  {
    const double component = solver.eigenvectors()(0, i);
    rule.points.push_back(0.5 * (1.0 + solver.eigenvalues()(i)));
    rule.weights.push_back(component * component / (a + 1.0));
  }
  return rule;
}

CellRule quadrature(Shape shape, int degree)
{
  const int n = std::max(degree, 0) / 2 + 1;
  const Rule plain = gauss(n);
  const Rule none{{0.0}, {1.0}};
  Rule xi = plain;
  Rule eta = dimension(shape) > 1 ? plain : none;
  Rule zeta = dimension(shape) > 2 ? plain : none;
  const bool flat = shape == Shape::triangle || shape == Shape::tetrahedron || shape == Shape::prism;
  if (flat)
    eta = gauss_jacobi(n, 1);
  if (shape == Shape::tetrahedron || shape == Shape::pyramid)
    zeta = gauss_jacobi(n, 2);
  CellRule rule;
  for (std::size_t k = 0; k < zeta.points.size(); ++k)
    for (std::size_t j = 0; j < eta.points.size(); ++j)
      for (std::size_t i = 0; i < xi.points.size(); ++i)
      {
        const double height =
            shape == Shape::tetrahedron || shape == Shape::pyramid ? 1.0 - zeta.points[k] : 1.0;
        const double width = flat ? height * (1.0 - eta.points[j]) : height;
        rule.points.push_back({xi.points[i] * width, eta.points[j] * height, zeta.points[k]});
        rule.weights.push_back(xi.weights[i] * eta.weights[j] * zeta.weights[k]);
      }
  return rule;
}

}  // namespace blockfsi::element
