#include "block/between.hpp"

#include "block/resize.hpp"
#include "layouts.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

using namespace blockfsi;
using namespace blockfsi::block;

namespace
{

/// A flap on a floor: its left side is bent, the cells of its sides are graded.
Layout flap(int order, double ratio = 0.8)
{
  Lattice lattice;
  lattice.name = "box";
  lattice.x = {0.0, 1.0, 1.2, 2.5};
  lattice.y = {1.0, 0.6, 0.0};
  lattice.draw = {"fluid fluid fluid", "fluid flap fluid"};
  lattice.divide_x = {3, 2, 3};
  lattice.divide_y = {2, 5};
  lattice.grade_y = {std::nullopt, Geometric{ratio}};
  const std::array<std::string_view, 1> parameter = {"t"};
  geometry::Formula bent;
  bent.speed = geometry::Speed::own;
  bent.x[0] = Expression("1 - 0.1 * sin(pi * t)", {}, parameter);
  bent.x[1] = Expression("0.6 - 0.6 * t", {}, parameter);
  lattice.curves.push_back({{1, 1}, {1, 2}, bent});
  Layout layout;
  layout.order = order;
  add(layout, lattice);
  testing::close(layout);
  return layout;
}

/// A function of position at the nodes of the interface, in their order.
std::vector<double> at_nodes(const Layout& layout, const Skeleton& skeleton,
                             const std::function<double(double, double)>& function)
{
  std::vector<double> values;
  for (const std::int64_t node : interface_nodes(layout, skeleton, "fluid", "flap"))
    values.push_back(function(skeleton.x[2 * node], skeleton.x[2 * node + 1]));
  return values;
}

std::vector<double> product(const SparseRows& rows, const std::vector<double>& values)
{
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < rows.row_begin.size(); ++i)
  {
    double sum = 0.0;
    for (std::int32_t k = rows.row_begin[i]; k < rows.row_begin[i + 1]; ++k)
      sum += rows.weight[k] * values[rows.column[k]];
    result.push_back(sum);
  }
  return result;
}

/// Greatest difference at the target's nodes.
double evaluation_error(const Layout& layout, int order, double factor,
                        const std::function<double(double, double)>& function)
{
  const Layout other = resized(layout, "flap", order, factor);
  const Skeleton to = make_skeleton(layout), from = make_skeleton(other);
  const SparseRows rows = evaluate_between(layout, from, to, "fluid", "flap");
  const std::vector<double> found = product(rows, at_nodes(layout, from, function));
  const std::vector<double> expected = at_nodes(layout, to, function);
  REQUIRE(found.size() == expected.size());
  double error = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i)
    error = std::max(error, std::abs(found[i] - expected[i]));
  return error;
}

}  // namespace

TEST_CASE("rows that evaluate one skeleton of an interface at the nodes of another sum up to 1")
{
  const Layout layout = flap(3);
  const Skeleton to = make_skeleton(layout), from = make_skeleton(resized(layout, "flap", 2, 1.6));
  const SparseRows rows = evaluate_between(layout, from, to, "flap", "fluid");
  CHECK(rows.row_begin.size() == interface_nodes(layout, to, "flap", "fluid").size() + 1);
  for (const double sum : product(rows, std::vector<double>(1000, 1.0)))
    CHECK(sum == doctest::Approx(1.0).epsilon(1e-14));
}

TEST_CASE("skeletons with the same cells share the values of their interface")
{
  const Layout layout = flap(4);
  const Skeleton skeleton = make_skeleton(layout);
  const SparseRows rows = evaluate_between(layout, skeleton, skeleton, "fluid", "flap");
  for (std::size_t i = 0; i + 1 < rows.row_begin.size(); ++i)
    for (std::int32_t k = rows.row_begin[i]; k < rows.row_begin[i + 1]; ++k)
      CHECK(rows.weight[k] == doctest::Approx(rows.column[k] == static_cast<std::int32_t>(i) ? 1.0 : 0.0));
}

TEST_CASE("polynomials along straight sides pass between skeletons exactly, whatever the numbers of cells")
{
  // x is not straight on the bent side, so only y counts there.
  const auto cubic = [](double, double y) { return 1.0 + y - 3.0 * y * y * y; };
  for (const double factor : {0.4, 1.0, 2.0, 3.0})
    CHECK(evaluation_error(flap(2), 3, factor, cubic) < 1e-14);
}

TEST_CASE("smooth functions pass between skeletons with the order of their source plus one")
{
  const auto smooth = [](double x, double y) { return std::sin(3.0 * x + 4.0 * y); };
  for (const int order : {1, 2, 3})
  {
    const double coarse = evaluation_error(flap(8, 1.0), order, 2.0, smooth);
    const double fine = evaluation_error(flap(8, 1.0), order, 4.0, smooth);
    CHECK(std::log2(coarse / fine) > order + 1 - 0.4);
  }
}
