#include "linalg/system.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace blockfsi::linalg;

namespace
{

/// A line of five nodes joined by four springs, one unknown per node.
struct Chain
{
  std::vector<std::int64_t> lattice = {0, 1, 2, 3, 4};
  std::vector<std::int32_t> owner = {0, 0, 0, 0, 0};
  std::vector<std::int32_t> cells = {0, 1, 1, 2, 2, 3, 3, 4};
  Numbering numbering{lattice, owner};
};

void set_springs(System& system, const std::vector<double>& stiffness)
{
  const std::span<double> matrices = system.cell_matrices();
  REQUIRE(matrices.size() == 4 * stiffness.size());
  for (std::size_t c = 0; c < stiffness.size(); ++c)
    for (std::size_t k = 0; k < 4; ++k)
      matrices[4 * c + k] = k % 3 == 0 ? stiffness[c] : -stiffness[c];
  system.assemble();
}

}  // namespace

TEST_CASE("a chain of springs held at its ends finds its equilibrium and the ends stay")
{
  const Chain chain;
  const std::vector<std::uint8_t> fixed = {1, 0, 0, 0, 1};
  System system(chain.numbering, 1, chain.cells, 2, fixed, "test_");
  set_springs(system, {1.0, 1.0, 1.0, 1.0});
  REQUIRE(system.factorise() == Status::ok);
  // What the residual says at fixed unknowns does not matter.
  const std::vector<double> residual = {7.0, 0.0, 1.0, 0.0, -7.0};
  std::vector<double> increment(5, 9.0);
  REQUIRE(system.solve(residual, increment) == Status::ok);
  const std::vector<double> expected = {0.0, 0.5, 1.0, 0.5, 0.0};
  for (std::size_t i = 0; i < 5; ++i)
    CHECK(increment[i] == doctest::Approx(expected[i]));
}

TEST_CASE("factors stay until they are renewed")
{
  const Chain chain;
  const std::vector<std::uint8_t> fixed = {1, 0, 0, 0, 1};
  System system(chain.numbering, 1, chain.cells, 2, fixed, "test_");
  const std::vector<double> residual = {0.0, 0.0, 1.0, 0.0, 0.0};
  std::vector<double> increment(5);
  for (const double stiffness : {1.0, 2.0, 4.0})
  {
    set_springs(system, std::vector<double>(4, stiffness));
    REQUIRE(system.factorise() == Status::ok);
    REQUIRE(system.solve(residual, increment) == Status::ok);
    CHECK(increment[2] == doctest::Approx(1.0 / stiffness));
    system.cell_matrices()[0] = 1e9;
    REQUIRE(system.solve(residual, increment) == Status::ok);
    CHECK(increment[2] == doctest::Approx(1.0 / stiffness));
  }
}

TEST_CASE("two unknowns per node, one of them fixed everywhere, are told apart")
{
  const Chain chain;
  const std::vector<std::uint8_t> fixed = {1, 1, 0, 1, 0, 1, 0, 1, 0, 1};
  System system(chain.numbering, 2, chain.cells, 2, fixed, "test_");
  const std::span<double> matrices = system.cell_matrices();
  // Rows and columns of a cell: (node 0, a), (node 0, b), (node 1, a), (node 1, b).
  for (std::size_t c = 0; c < 4; ++c)
    for (const auto& [row, column, value] :
         {std::tuple{0, 0, 1.0}, {0, 2, -1.0}, {2, 0, -1.0}, {2, 2, 1.0}, {0, 1, 5.0}})
      matrices[16 * c + 4 * row + column] = value;
  system.assemble();
  REQUIRE(system.factorise() == Status::ok);
  std::vector<double> residual(10, 3.0);
  residual[2] = residual[4] = residual[6] = 0.0;
  residual[8] = 1.0;  // pulled at the free end
  std::vector<double> increment(10);
  REQUIRE(system.solve(residual, increment) == Status::ok);
  for (std::size_t node = 0; node < 5; ++node)
  {
    CHECK(increment[2 * node] == doctest::Approx(static_cast<double>(node)));
    CHECK(increment[2 * node + 1] == 0.0);
  }
}

TEST_CASE("a singular matrix is reported and the next regular one is factorised")
{
  const Chain chain;
  const std::vector<std::uint8_t> fixed = {1, 0, 0, 0, 1};
  System system(chain.numbering, 1, chain.cells, 2, fixed, "test_");
  set_springs(system, {1.0, 0.0, 0.0, 1.0});
  CHECK(system.factorise() == Status::singular);
  set_springs(system, {1.0, 1.0, 1.0, 1.0});
  CHECK(system.factorise() == Status::ok);
  std::vector<double> increment(5);
  REQUIRE(system.solve(std::vector<double>{0.0, 0.0, 1.0, 0.0, 0.0}, increment) == Status::ok);
  CHECK(increment[2] == doctest::Approx(1.0));
}

TEST_CASE("systems can be moved and made anew")
{
  const Chain chain;
  const std::vector<std::uint8_t> fixed = {1, 0, 0, 0, 1};
  System first(chain.numbering, 1, chain.cells, 2, fixed, "test_");
  set_springs(first, {1.0, 1.0, 1.0, 1.0});
  REQUIRE(first.factorise() == Status::ok);
  System second = std::move(first);
  first = System(chain.numbering, 1, chain.cells, 2, fixed, "test_");
  std::vector<double> increment(5);
  REQUIRE(second.solve(std::vector<double>{0.0, 0.0, 1.0, 0.0, 0.0}, increment) == Status::ok);
  CHECK(increment[2] == doctest::Approx(1.0));
}
