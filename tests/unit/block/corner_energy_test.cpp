#include "block/corner_energy.hpp"

#include "corner_graphs.hpp"
#include "flag.hpp"

#include <doctest/doctest.h>

#include <Eigen/Cholesky>

#include <random>

using namespace blockfsi;
using namespace blockfsi::block;
using namespace blockfsi::block::testing;

namespace
{

/// Gradient and Hessian of the energy, along random directions, against differences.
template <int dim>
void check_derivatives(const CornerGraph& graph, const std::vector<double>& d,
                       const EnergyParameters& parameters, double epsilon)
{
  CornerEnergy<dim> energy(graph, parameters);
  energy.bend(d);
  const int count = energy.unknown_count();
  REQUIRE(count > 0);
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0.0, 0.01 * graph.thickness);
  const auto any = [&]
  {
    Eigen::VectorXd y(count);
    for (double& value : y)
      value = normal(random);
    return y;
  };
  std::vector<double> U(graph.corners.size() * dim);
  const auto place = [&](const Eigen::VectorXd& y) { displace_corners(graph, d.data(), y.data(), U.data()); };
  place(any());
  energy.tether(U);
  const Eigen::VectorXd y = any();
  const Eigen::VectorXd along = any().normalized();
  const double h = 1e-5 * graph.thickness;
  double least = 0.0;
  const auto value_at = [&](double t)
  {
    place(y + t * along);
    return energy.value(U, epsilon, least);
  };
  const auto gradient_at = [&](double t)
  {
    Eigen::VectorXd gradient;
    Eigen::MatrixXd hessian;
    place(y + t * along);
    energy.derivatives(U, epsilon, false, gradient, hessian);
    return gradient;
  };
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;
  place(y);
  energy.derivatives(U, epsilon, false, gradient, hessian);
  const Eigen::VectorXd image = hessian.selfadjointView<Eigen::Lower>() * along;
  const double slope = (value_at(h) - value_at(-h)) / (2.0 * h);
  CHECK(std::abs(gradient.dot(along) - slope) < 1e-6 * gradient.norm());
  CHECK((image - (gradient_at(h) - gradient_at(-h)) / (2.0 * h)).norm() < 1e-5 * image.norm());
  // The projected Hessian is at least as positive in every direction.
  Eigen::MatrixXd projected;
  place(y);
  energy.derivatives(U, epsilon, true, gradient, projected);
  CHECK(along.dot(projected.selfadjointView<Eigen::Lower>() * along) >=
        along.dot(image) - 1e-9 * image.norm());
  CHECK(projected.llt().info() == Eigen::Success);
}

}  // namespace

TEST_CASE("gradient and Hessian of the energy agree with differences in 2D and 3D")
{
  const auto push = [](const std::array<double, 3>& x) {
    return std::array<double, 3>{0.1 * x[1] * x[1], 0.05 * x[0], 0.1 * x[0] * x[1]};
  };
  for (const double epsilon : {0.0, 0.3})
  {
    for (const EnergyParameters& parameters :
         {EnergyParameters{{0.3, 2}, 1.0, 0.0}, EnergyParameters{{0.3, 4}, 1.0, 1.0}})
    {
      for (const int valence : {3, 4, 5, 6})
        check_derivatives<2>(fan(valence), led_by(fan(valence), push), parameters, epsilon);
      const CornerGraph triangles = fan(5, element::Shape::triangle);
      check_derivatives<2>(triangles, led_by(triangles, push), parameters, epsilon);
      CornerGraph box = cubes(2);
      check_derivatives<3>(box, led_by(box, push), parameters, epsilon);
      box.corners[13].freedom = 2;  // slides in an oblique plane
      box.corners[13].direction = {{{0.6, 0.8, 0.0}, {0.0, 0.0, 1.0}, {}}};
      check_derivatives<3>(box, led_by(box, push), parameters, epsilon);
    }
  }
}

TEST_CASE("gradient and Hessian agree with differences where blocks follow a bent interface and walls")
{
  const FlagLayout flag(narrow_channel, 3, 3);
  BentFlag bent(flag.layout, CornerRule::fixed);
  bent.bend(Bending::at_root, 10.0);
  CornerParameters parameters;
  parameters.slide = {{"walls"}};
  const CornerGraph graph = corner_graph(flag.layout, bent.skeleton(), "fluid", bent.interface(), parameters);
  check_derivatives<2>(graph, bent.displacement(), {{0.3, 2}, 1.0, 0.0}, 0.0);
}

TEST_CASE("at rest the energy has its least value and no gradient")
{
  const CornerGraph graph = cubes(3);
  CornerEnergy<3> energy(graph, {});
  const std::vector<double> U(graph.corners.size() * 3, 0.0);
  double least = 0.0;
  CHECK(energy.value(U, 0.0, least) == doctest::Approx(27.0).epsilon(1e-12));  // one per block
  CHECK(least == doctest::Approx(1.0).epsilon(1e-12));
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;
  energy.derivatives(U, 0.0, false, gradient, hessian);
  CHECK(gradient.norm() < 1e-11);
  CHECK(hessian.llt().info() == Eigen::Success);
}
