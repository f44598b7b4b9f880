#include "motion/extension.hpp"

#include "fem/side_loop.hpp"

#include "sample.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

using namespace blockfsi;
using motion::Extension;

namespace
{

using Field = std::function<std::array<double, 2>(double, double)>;

/// Lines bent inside and on the sides, so that no cell is a parallelogram.
std::array<double, 2> bent(double x, double y)
{
  return {x + 0.05 * std::sin(3.0 * y + x), y + 0.05 * std::cos(2.0 * x - y)};
}

std::array<double, 2> linear(double x, double y)
{
  return {0.1 + 0.3 * x - 0.2 * y, -0.05 + 0.15 * x - 0.1 * y};
}

/// Turns the plane about the origin by an angle, as a displacement.
Field turn(double angle)
{
  return [angle](double x, double y)
  {
    return std::array{(std::cos(angle) - 1.0) * x - std::sin(angle) * y,
                      std::sin(angle) * x + (std::cos(angle) - 1.0) * y};
  };
}

motion::PseudoSolid with_variable_stiffness()
{
  motion::PseudoSolid parameters;
  parameters.stiffness.base = 0.1;
  parameters.stiffness.points = {1.0, 0.2, 2.0};
  parameters.stiffness.at = {{0.3, 0.4, 0.0}};
  parameters.stiffness.jacobian = 1.5;
  return parameters;
}

double observed_order(const std::function<double(int cells)>& error, int cells)
{
  return std::log2(error(cells) / error(2 * cells));
}

/// Largest error of the displacement inside for one that is given on the whole boundary.
template <class Parameters>
double error_of(const Parameters& parameters, int order, int cells, const Field& exact)
{
  const Square square(order, cells, false, bent);
  Extension extension(parameters, square.domain());
  std::vector<double> x(square.sample.x.size());
  REQUIRE(extension.follow(square.at_interface(exact), x).ok);
  return square.error(x, exact);
}

/// Normal derivative of a field with a given gradient.
struct NormalDerivative
{
  static constexpr int unknowns = 2;
  static constexpr int data = 0;
  std::function<std::array<std::array<double, 2>, 2>(double, double)> gradient;

  template <class S>
  std::array<S, 2> operator()(const fem::SideInput<S, 2, 0>& in) const
  {
    const auto g = gradient(in.x[0], in.x[1]);
    return {S(g[0][0] * in.normal[0] + g[0][1] * in.normal[1]),
            S(g[1][0] * in.normal[0] + g[1][1] * in.normal[1])};
  }
};

/// The same for the biharmonic equation, with the exact normal derivative.
double biharmonic_error(int order, int cells, const Field& exact, const NormalDerivative& derivative)
{
  const Square square(order, cells, false, bent);
  Extension extension(motion::Biharmonic{}, square.domain());
  const std::vector<double>& x = square.sample.x;
  std::vector<double> lift(x.size(), 0.0);
  for (const std::int64_t node : square.interface)
  {
    const auto value = exact(x[2 * node], x[2 * node + 1]);
    lift[2 * node] = value[0];
    lift[2 * node + 1] = value[1];
  }
  std::vector<double> slope(x.size(), 0.0);
  fem::SideLoop sides(square.sample.mesh, order + 2);
  sides.add_residual(derivative, square.sample.mesh.boundaries.at("interface"), x, lift, {}, slope);
  std::vector<double> u(x.size(), 0.0);
  REQUIRE(extension.extend(lift, slope, u).ok);
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] += x[i];
  return square.error(u, exact);
}

}  // namespace

TEST_CASE("a linear displacement of the boundary moves the whole mesh linearly")
{
  for (const int order : {1, 2, 4})
  {
    CAPTURE(order);
    // Constant stresses are in balance only where the stiffness is constant.
    motion::PseudoSolid elastic;
    elastic.stiffness.jacobian = 0.0;
    motion::Harmonic harmonic;
    harmonic.stiffness.jacobian = 0.0;
    CHECK(error_of(elastic, order, 3, linear) < 1e-13);
    CHECK(error_of(harmonic, order, 3, linear) < 1e-13);
    CHECK(biharmonic_error(order, 3, linear, {[](double, double) {
                             return std::array<std::array<double, 2>, 2>{{{0.3, -0.2}, {0.15, -0.1}}};
                           }}) < 1e-12);
  }
}

TEST_CASE("the pseudo-solid moves as a rigid body does when it is shifted, whatever its stiffness")
{
  const Field shift = [](double, double) { return std::array{0.3, -0.2}; };
  CHECK(error_of(with_variable_stiffness(), 3, 3, shift) < 1e-13);
}

TEST_CASE("a biharmonic mesh turns with its boundary by any angle")
{
  for (const double angle : {0.1, 1.5, 3.0})
    CHECK(error_of(motion::Biharmonic{}, 2, 3, turn(angle)) < 1e-12);
  // With a slope of zero it does not.
  CHECK(error_of(motion::Biharmonic{motion::Slope::zero, {}}, 2, 3, turn(0.5)) > 1e-3);
}

TEST_CASE("harmonic, elastic and biharmonic displacements converge with order p + 1")
{
  motion::PseudoSolid elastic;
  elastic.stiffness.jacobian = 0.0;
  motion::Harmonic harmonic;
  harmonic.stiffness.jacobian = 0.0;
  const Field harmonic_field = [](double x, double y) {
    return std::array{std::exp(x) * std::cos(y), std::exp(2.0 * y) * std::sin(2.0 * x)};
  };
  // Papkovich and Neuber: u = 4 (1 - nu) B - grad (x . B) with B = (e^x cos y, 0) harmonic.
  const double nu = elastic.poisson;
  const Field elastic_field = [nu](double x, double y) {
    return std::array{(3.0 - 4.0 * nu - x) * std::exp(x) * std::cos(y), x * std::exp(x) * std::sin(y)};
  };
  // x times a harmonic function is biharmonic.
  const Field biharmonic_field = [](double x, double y) {
    return std::array{x * std::exp(x) * std::cos(y), y * std::exp(2.0 * y) * std::sin(2.0 * x)};
  };
  const NormalDerivative derivative{
      [](double x, double y)
      {
        const double a = std::exp(x);
        const double b = std::exp(2.0 * y);
        return std::array<std::array<double, 2>, 2>{
            {{(1.0 + x) * a * std::cos(y), -x * a * std::sin(y)},
             {2.0 * y * b * std::cos(2.0 * x), (1.0 + 2.0 * y) * b * std::sin(2.0 * x)}}};
      }};
  for (const int order : {2, 3, 4})
  {
    CAPTURE(order);
    const double of_harmonic =
        observed_order([&](int cells) { return error_of(harmonic, order, cells, harmonic_field); }, 4);
    const double of_elastic =
        observed_order([&](int cells) { return error_of(elastic, order, cells, elastic_field); }, 4);
    const double of_biharmonic = observed_order(
        [&](int cells) { return biharmonic_error(order, cells, biharmonic_field, derivative); }, 4);
    CHECK(of_harmonic > order + 0.7);
    CHECK(of_elastic > order + 0.7);
    CHECK(of_biharmonic > order + 0.7);
  }
}

TEST_CASE("total forms do not depend on the path, incremental ones do")
{
  const Square square(3, 3, true);
  const auto bend = [&](double amplitude)
  {
    return square.at_interface(
        [amplitude](double x, double y) {
          return std::array{amplitude * y * y * (1.0 - x), amplitude * x * y};
        });
  };
  const auto drift = [&](auto parameters, motion::From from)
  {
    parameters.from = from;
    Extension extension(parameters, square.domain());
    std::vector<double> x(square.sample.x.size());
    for (const double amplitude : {0.2, 0.4, 0.1, -0.3, 0.0})
    {
      const std::vector<double> d = bend(amplitude);
      REQUIRE(extension.follow(d, x).ok);
      extension.accept(d, x);
    }
    return square.error(x, [](double, double) { return std::array{0.0, 0.0}; });
  };
  CHECK(drift(motion::PseudoSolid{}, motion::From::first) == 0.0);
  CHECK(drift(motion::Harmonic{}, motion::From::first) == 0.0);
  CHECK(drift(motion::PseudoSolid{}, motion::From::last) > 1e-3);
  CHECK(drift(motion::Harmonic{}, motion::From::last) > 1e-3);
}

TEST_CASE("only the accepted mesh counts for the next increment, not the trials between")
{
  const Square square(2, 3, true);
  motion::PseudoSolid parameters;
  parameters.from = motion::From::last;
  const auto push = [&](double amount)
  {
    return square.at_interface([amount](double, double y) { return std::array{amount * y, amount * y * y}; });
  };
  const auto after = [&](const std::vector<double>& trials)
  {
    Extension extension(parameters, square.domain());
    std::vector<double> x(square.sample.x.size());
    REQUIRE(extension.follow(push(0.1), x).ok);
    extension.accept(push(0.1), x);
    for (const double trial : trials)
      REQUIRE(extension.follow(push(trial), x).ok);
    return x;
  };
  CHECK(after({0.2}) == after({0.5, -0.3, 0.2}));
}

TEST_CASE("factors are made once in total forms and once in a step in incremental ones")
{
  const Square square(2, 3, true);
  const auto count = [&](const auto& parameters)
  {
    Extension extension(parameters, square.domain());
    std::vector<double> x(square.sample.x.size());
    int factorisations = 0;
    for (int step = 1; step <= 3; ++step)
    {
      std::vector<double> d;
      for (int iteration = 0; iteration < 4; ++iteration)
      {
        d = square.at_interface(
            [&](double, double y) {
              return std::array{0.02 * y * (step + 0.1 * iteration), 0.0};
            });
        const motion::Report report = extension.follow(d, x);
        REQUIRE(report.ok);
        factorisations += report.factorisations;
      }
      extension.accept(d, x);
    }
    return factorisations;
  };
  motion::PseudoSolid incremental;
  incremental.from = motion::From::last;
  CHECK(count(motion::PseudoSolid{}) == 1);
  CHECK(count(motion::Harmonic{}) == 1);
  CHECK(count(motion::Biharmonic{}) == 1);
  CHECK(count(incremental) == 3);
}

TEST_CASE("what an incremental form remembers makes another one go on bit for bit")
{
  const Square square(3, 2, true);
  motion::PseudoSolid parameters = with_variable_stiffness();
  parameters.from = motion::From::last;
  const auto push = [&](double amount)
  {
    return square.at_interface(
        [amount](double x, double y) {
          return std::array{amount * y, amount * x * y};
        });
  };
  Extension first(parameters, square.domain());
  std::vector<double> x(square.sample.x.size());
  for (const double amount : {0.1, 0.15})
  {
    REQUIRE(first.follow(push(amount), x).ok);
    first.accept(push(amount), x);
  }
  Extension second(parameters, square.domain());
  second.recall(first.memory());
  std::vector<double> y(x.size());
  REQUIRE(second.follow(push(0.15), y).ok);
  CHECK(y == x);
  REQUIRE(first.follow(push(0.3), x).ok);
  REQUIRE(second.follow(push(0.3), y).ok);
  CHECK(y == x);
  CHECK(Extension(motion::PseudoSolid{}, square.domain()).memory().empty());
}

TEST_CASE("nodes slide along a straight boundary that may, and stay on it")
{
  const Square square(2, 3, true);
  const auto pull = [](double x, double y) { return std::array{0.2 * y * (1.0 - y) * x, 0.0}; };
  const auto largest = [&](const auto& parameters, int component)
  {
    Extension extension(parameters, square.domain());
    std::vector<double> x(square.sample.x.size());
    REQUIRE(extension.follow(square.at_interface(pull), x).ok);
    double move = 0.0;
    for (std::size_t i = 0; i < x.size(); i += 2)
      if (square.sample.x[i + 1] == 0.0)
        move = std::max(move, std::abs(x[i + component] - square.sample.x[i + component]));
    return move;
  };
  for (const bool slides : {false, true})
  {
    const std::vector<std::string> slide =
        slides ? std::vector<std::string>{"floor"} : std::vector<std::string>{};
    motion::PseudoSolid elastic;
    elastic.slide = slide;
    motion::Harmonic harmonic;
    harmonic.slide = slide;
    const motion::Biharmonic biharmonic{motion::Slope::turned, slide};
    for (const double move : {largest(elastic, 0), largest(harmonic, 0), largest(biharmonic, 0)})
      CHECK((move > 1e-3) == slides);
    for (const double move : {largest(elastic, 1), largest(harmonic, 1), largest(biharmonic, 1)})
      CHECK(move == 0.0);
  }
}

TEST_CASE("a boundary that is not straight along an axis cannot slide")
{
  const Square square(2, 2, true, bent);
  motion::Harmonic parameters;
  parameters.slide = {"floor"};
  CHECK_THROWS_AS(Extension(parameters, square.domain()), Error);
}

TEST_CASE("stiff regions of a mesh deform less")
{
  const Square square(2, 8, true);
  // A pull at the top; the strain near the floor's middle falls where the mesh is stiff there.
  const Field pull = [](double, double y) { return std::array{0.0, 0.2 * y}; };
  const auto strain = [&](const motion::Stiffness& stiffness)
  {
    motion::Harmonic parameters;
    parameters.stiffness = stiffness;
    Extension extension(parameters, square.domain());
    std::vector<double> x(square.sample.x.size());
    REQUIRE(extension.follow(square.at_interface(pull), x).ok);
    for (std::size_t i = 0; i < x.size(); i += 2)
      if (square.sample.x[i] == 0.5 && square.sample.x[i + 1] == 0.125)
        return x[i + 1] / 0.125 - 1.0;
    return 0.0;
  };
  motion::Stiffness stiff;
  stiff.jacobian = 0.0;
  stiff.base = 0.01;
  stiff.points = {1.0, 0.1, 3.0};
  stiff.at = {{0.5, 0.0, 0.0}};
  motion::Stiffness even;
  even.jacobian = 0.0;
  CHECK(strain(even) == doctest::Approx(0.2).epsilon(1e-9));
  CHECK(strain(stiff) < 0.05);
}
