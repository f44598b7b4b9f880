#include "block/resample.hpp"

#include "element/table.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

using namespace blockfsi::block;
namespace element = blockfsi::element;
using element::Shape;

namespace
{

constexpr int cells = 3;  // along each edge, so that there are even and odd layers
constexpr std::array<Shape, 4> shapes{Shape::triangle, Shape::tetrahedron, Shape::prism, Shape::pyramid};

Grid lattice(Shape shape, int order)
{
  return {shape, {cells * order, cells * order, element::dimension(shape) == 2 ? 0 : cells * order}};
}

/// Where a node lies, in sizes of cells: warped within its cell.
std::array<double, 3> warped(Shape shape, int order, const BlockCells& all, const element::LatticePoint& node)
{
  const BlockCells corners({shape, {cells, cells, element::dimension(shape) == 2 ? 0 : cells}}, 1, 0);
  const BlockCells::Found found = all.find(node);
  const std::vector<element::LatticePoint>& corner = corners.kinds()[found.kind].nodes;
  const Shape cell = all.kinds()[found.kind].shape;
  const auto weights =
      element::resample(cell, {1, element::NodeKind::warped}, {order, element::NodeKind::warped});
  std::array<double, 3> x{};
  for (std::size_t c = 0; c < corner.size(); ++c)
    for (int d = 0; d < 3; ++d)
      x[d] += weights[found.local * corner.size() + c] * (found.box[d] + corner[c][d]);
  return x;
}

/// A polynomial of the order in the directions that are resampled; a prism's last is not, so it is left out.
std::array<double, 3> polynomial(Shape shape, int order, const std::array<double, 3>& x)
{
  const double z = shape == Shape::prism ? 0.0 : x[2];
  return {std::pow(x[0] - 0.4 * x[1] + 0.3 * z - 1.0, order), x[0] * x[1] + z * z,
          std::pow(0.5 * x[1] + 0.2 * x[0] - z, order - 1)};
}

/// Largest error at wanted rows if only the rows from level (in 2D row) `first` on are added.
double error(Shape shape, int order, std::span<const BlockPlan::Row> wanted, int first)
{
  const Grid grid = lattice(shape, order);
  const BlockCells all({shape, {cells, cells, grid.steps[2] / order}}, order, 0);
  const LatticeResampler resampler(grid, order, 0, LatticeResampler::Direction::to_warped,
                                   shape == Shape::prism);
  std::vector<double> work(resampling_work(resampler), std::nan(""));
  std::vector<double> x(3 * static_cast<std::size_t>(size(grid)), std::nan(""));
  ResampledRows rows(resampler, wanted, work.data(), x.data());
  for (const BlockPlan::Row& row : all_rows(grid))
  {
    std::vector<double> values;
    for (int i = row.begin; i < row.end; ++i)
    {
      const double h = 1.0 / order;
      const auto at = polynomial(shape, order, {i * h, row.j * h, row.k * h});
      values.insert(values.end(), at.begin(), at.end());
    }
    if ((grid.steps[2] == 0 ? row.j : row.k) >= first)
      rows.add(row, values.data());
  }
  double largest = 0.0;
  for (const BlockPlan::Row& row : wanted)
    for (int i = row.begin; i < row.end; ++i)
    {
      const auto expected = polynomial(shape, order, warped(shape, order, all, {i, row.j, row.k}));
      for (int c = 0; c < 3; ++c)
      {
        const double found = x[3 * (row.node + i - row.begin) + c];
        largest = std::max(largest, std::isnan(found) ? 1.0 : std::abs(found - expected[c]));
      }
    }
  return largest;
}

}  // namespace

TEST_CASE("resampling row by row is exact for polynomials of the order of the cells")
{
  for (const Shape shape : shapes)
    for (const int order : {3, 4, 7})
    {
      CAPTURE(element::name(shape));
      CAPTURE(order);
      const std::vector<BlockPlan::Row> wanted = inner_rows(lattice(shape, order));
      CHECK(error(shape, order, wanted, 0) < 2e-12);
    }
}

TEST_CASE("rows may be resampled in part, from the rows of their own layer of cells alone")
{
  for (const Shape shape : shapes)
    for (const int order : {3, 4})
    {
      CAPTURE(element::name(shape));
      CAPTURE(order);
      const int first = shape == Shape::prism ? order + 1 : order;
      std::vector<BlockPlan::Row> wanted;
      for (BlockPlan::Row row : inner_rows(lattice(shape, order)))
      {
        const int plane = element::dimension(shape) == 2 ? row.j : row.k;
        if (plane <= order || row.end - row.begin < 3)
          continue;
        ++row.begin;
        ++row.node;
        --row.end;
        wanted.push_back(row);
      }
      REQUIRE(!wanted.empty());
      CHECK(error(shape, order, wanted, first) < 1e-12);
    }
}
