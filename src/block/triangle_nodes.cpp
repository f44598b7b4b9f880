#include "block/triangle_nodes.hpp"

#include "element/lattice.hpp"
#include "element/line.hpp"
#include "element/nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace blockfsi::block
{

namespace
{

using element::Shape;

/// Coordinates nearer to a node than this are its own.
constexpr double rounding = 1e-14;

/// Coordinates of a node in its box, from 0 to 1: of the lower cell, or of the upper one, which is the lower
/// one turned.
std::array<double, 2> in_box(const std::vector<element::Point>& nodes, int order, int i, int j)
{
  const bool upper = i + j > order;
  const auto& lower = nodes[static_cast<std::size_t>(element::lattice_index(
      Shape::triangle, order,
      upper ? element::LatticePoint{order - i, order - j, 0} : element::LatticePoint{i, j, 0}))];
  return upper ? std::array{1.0 - lower[0], 1.0 - lower[1]} : std::array{lower[0], lower[1]};
}

/// The sum of points that follow each other.
template <int dim>
void add_up(const double* weights, std::ptrdiff_t count, const double* x, double* to)
{
  std::array<double, dim> sum{};
  for (std::ptrdiff_t q = 0; q < count; ++q)
    for (int c = 0; c < dim; ++c)
      sum[c] += weights[q] * x[dim * q + c];
  std::copy_n(sum.begin(), dim, to);
}

}  // namespace

TriangleNodes::TriangleNodes(int order) : order_(order)
{
  const std::vector<double> line = element::lobatto(order);
  const std::vector<element::Point> nodes = element::nodes(Shape::triangle, order);
  for (const Coordinate coordinate : {Coordinate::u, Coordinate::v, Coordinate::sum})
    for (int j = 0; j < order; ++j)
      for (int i = 0; i < order; ++i)
      {
        const auto [u, v] = in_box(nodes, order, i, j);
        append(coordinate == Coordinate::u ? u : coordinate == Coordinate::v ? v : u + v, line);
      }
}

void TriangleNodes::append(double t, const std::vector<double>& line)
{
  const bool next = t > 1.0 + rounding;
  if (next)
    t -= 1.0;
  for (const double node : line)
    if (std::abs(t - node) < rounding)
      t = node;
  first_.push_back(next ? order_ : 0);
  const std::vector<double> weights = element::lagrange(line, std::array{t}).value;
  weights_.insert(weights_.end(), weights.begin(), weights.end());
}

template <int dim>
void TriangleNodes::along_row(Coordinate coordinate, std::ptrdiff_t row, const double* edge, std::ptrdiff_t n,
                              double* to) const
{
  for (std::ptrdiff_t run = 0; run < order_; ++run)
  {
    const Point point = at(coordinate, run, row);
    for (std::ptrdiff_t i = run; i <= n - row; i += order_)
      add_up<dim>(point.weights, order_ + 1, edge + dim * (i - run + point.first), to + dim * i);
  }
}

template <int dim>
void TriangleNodes::across(std::ptrdiff_t row, const double* edge, double* to) const
{
  for (std::ptrdiff_t run = 0; run < order_; ++run)
    add_up<dim>(at(Coordinate::v, run, row).weights, order_ + 1, edge, to + dim * run);
}

template void TriangleNodes::along_row<2>(Coordinate, std::ptrdiff_t, const double*, std::ptrdiff_t,
                                          double*) const;
template void TriangleNodes::along_row<3>(Coordinate, std::ptrdiff_t, const double*, std::ptrdiff_t,
                                          double*) const;
template void TriangleNodes::across<2>(std::ptrdiff_t, const double*, double*) const;
template void TriangleNodes::across<3>(std::ptrdiff_t, const double*, double*) const;

}  // namespace blockfsi::block
