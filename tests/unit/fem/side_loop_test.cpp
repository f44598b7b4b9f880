#include "fem/side_loop.hpp"

#include "../mesh/structured.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace blockfsi;

namespace
{

/// n and x . n / 2: what must add up to nothing, and to the area.
struct Normals
{
  static constexpr int unknowns = 3;
  static constexpr int data = 0;

  std::array<double, 3> operator()(const fem::SideInput<double, 3, 0>& in) const
  {
    return {in.normal[0], in.normal[1], 0.5 * (in.x[0] * in.normal[0] + in.x[1] * in.normal[1])};
  }
};

/// (value, d/dx, d/dy) of the first unknown and an entry of data, as fluxes through the side.
struct Fluxes
{
  static constexpr int unknowns = 3;
  static constexpr int data = 2;

  std::array<double, 3> operator()(const fem::SideInput<double, 3, 2>& in) const
  {
    return {in.gradient[0][0] * in.normal[0] + in.gradient[0][1] * in.normal[1], in.value[1],
            in.data[0] * in.normal[0] + in.data[1] * in.normal[1]};
  }
};

/// Nonlinear in values and gradients.
struct Tangled
{
  static constexpr int unknowns = 2;
  static constexpr int data = 0;

  template <class S>
  std::array<S, 2> operator()(const fem::SideInput<S, 2, 0>& in) const
  {
    return {in.value[0] * in.gradient[1][0] * in.normal[0],
            in.value[1] * in.value[0] + in.gradient[0][1] * in.gradient[1][1]};
  }
};

std::array<double, 2> bent(double x, double y)
{
  return {x + 0.2 * y * (1.0 - y) + 0.1 * x * y, y - 0.15 * x * x + 0.1 * x * y};
}

/// Every side of every cell that no other cell has.
std::vector<mesh::Side> outline(const mesh::Mesh& mesh)
{
  std::vector<mesh::Side> sides;
  for (std::int32_t c = 0; c < static_cast<std::int32_t>(mesh.cell_count()); ++c)
    for (std::int32_t s = 0; s < 4; ++s)
    {
      const auto ends = [&](std::int32_t cell, std::int32_t side)
      {
        std::array<std::int32_t, 2> result = {mesh.cell(cell)[mesh::side_node(mesh.order, side, 0)],
                                              mesh.cell(cell)[mesh::side_node(mesh.order, side, mesh.order)]};
        return std::array<std::int32_t, 2>{std::min(result[0], result[1]), std::max(result[0], result[1])};
      };
      int count = 0;
      for (std::int32_t other = 0; other < static_cast<std::int32_t>(mesh.cell_count()); ++other)
        for (std::int32_t k = 0; k < 4; ++k)
          count += ends(other, k) == ends(c, s) ? 1 : 0;
      if (count == 1)
        sides.push_back({c, s});
    }
  return sides;
}

std::array<double, 3> totals(const std::vector<double>& values)
{
  std::array<double, 3> sums{};
  for (std::size_t i = 0; i < values.size(); ++i)
    sums[i % 3] += values[i];
  return sums;
}

}  // namespace

TEST_CASE("outward normals of a closed curved outline add up to nothing and give the area")
{
  constexpr double area =
      1.05 * 1.05 - (0.2 * (0.05 - 0.15) - 0.4 * (0.1 / 3.0 - 0.3 / 4.0) + 0.1 * (0.1 / 4.0 - 0.3 / 3.0));
  for (int order = 2; order <= 6; ++order)
  {
    const SampleMesh sample = structured(order, 3, 2, bent, true);
    fem::SideLoop loop(sample.mesh, order + 2);
    const std::vector<mesh::Side> sides = outline(sample.mesh);
    REQUIRE(sides.size() == 10);
    const std::vector<double> unknown(3 * sample.mesh.node_count(), 0.0);
    std::vector<double> residual(unknown.size(), 0.0);
    loop.add_residual(Normals{}, sides, sample.x, unknown, {}, residual);
    const auto sums = totals(residual);
    CHECK(std::abs(sums[0]) < 1e-14);
    CHECK(std::abs(sums[1]) < 1e-14);
    CHECK(sums[2] == doctest::Approx(area).epsilon(1e-13));
  }
}

TEST_CASE("the fluxes of gradients and of data through an outline obey the divergence theorem")
{
  const SampleMesh sample = structured(4, 3, 2, bent, true);
  std::vector<double> unknown(3 * sample.mesh.node_count(), 0.0);
  std::vector<double> field(2 * sample.mesh.node_count());
  for (std::size_t i = 0; i < sample.mesh.node_count(); ++i)
  {
    const double x = sample.x[2 * i];
    const double y = sample.x[2 * i + 1];
    unknown[3 * i] = x * x - x * y + 2.0 * y * y;  // laplace: 6
    unknown[3 * i + 1] = 1.0;
    field[2 * i] = 3.0 * x + y;  // divergence: 5
    field[2 * i + 1] = 2.0 * y - x;
  }
  fem::SideLoop loop(sample.mesh, 6);
  const std::vector<mesh::Side> sides = outline(sample.mesh);
  std::vector<double> normals(unknown.size(), 0.0);
  loop.add_residual(Normals{}, sides, sample.x, unknown, {}, normals);
  const double area = totals(normals)[2];
  std::vector<double> residual(unknown.size(), 0.0);
  const std::array<fem::NodalField, 1> data = {{{field.data(), 2}}};
  loop.add_residual(Fluxes{}, sides, sample.x, unknown, data, residual);
  CHECK(totals(residual)[0] == doctest::Approx(6.0 * area).epsilon(1e-12));
  CHECK(totals(residual)[2] == doctest::Approx(5.0 * area).epsilon(1e-12));
}

TEST_CASE("the tangent of curved sides is the derivative of the residual")
{
  const SampleMesh sample = structured(3, 2, 2, bent, true);
  const mesh::Mesh& mesh = sample.mesh;
  fem::SideLoop loop(mesh, 5);
  const std::vector<mesh::Side> sides = outline(mesh);
  const std::size_t size = 2 * mesh.node_count();
  std::vector<double> z(size);
  std::vector<double> direction(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    z[i] = std::sin(0.7 * static_cast<double>(i));
    direction[i] = std::cos(1.3 * static_cast<double>(i));
  }
  const auto residual = [&](double change)
  {
    std::vector<double> moved = z;
    for (std::size_t i = 0; i < size; ++i)
      moved[i] += change * direction[i];
    std::vector<double> result(size, 0.0);
    loop.add_residual(Tangled{}, sides, sample.x, moved, {}, result);
    return result;
  };
  const std::size_t n = 2 * static_cast<std::size_t>(mesh.nodes_per_cell());
  std::vector<double> matrices(mesh.cell_count() * n * n, 0.0);
  loop.add_tangent(Tangled{}, sides, sample.x, z, {}, matrices);
  std::vector<double> product(size, 0.0);
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        product[2 * mesh.cell(c)[i / 2] + i % 2] +=
            matrices[(c * n + i) * n + j] * direction[2 * mesh.cell(c)[j / 2] + j % 2];
  // Exact for a quadratic residual.
  const auto ahead = residual(0.5);
  const auto behind = residual(-0.5);
  for (std::size_t i = 0; i < size; ++i)
    CHECK(product[i] == doctest::Approx(ahead[i] - behind[i]).epsilon(1e-11));
}
