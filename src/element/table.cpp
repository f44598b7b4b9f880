#include "element/table.hpp"

#include "element/basis.hpp"
#include "element/line.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace blockfsi::element
{

namespace
{

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr std::array<std::array<int, 2>, 6> pairs = {{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

std::vector<Point> nodes_of(Shape shape, Lattice lattice)
{
  // The warped nodes also check the order.
  std::vector<Point> warped = nodes(shape, lattice.order);
  return lattice.kind == NodeKind::warped ? warped : equispaced_nodes(shape, lattice.order);
}

/// Empty tables for the derivatives that the shape has and that are asked for.
CellTable make_table(Shape shape, int order, std::size_t point_count, int derivatives)
{
  CellTable table;
  table.point_count = static_cast<int>(point_count);
  table.node_count = static_cast<int>(lattice_size(shape, order));
  const std::size_t size = point_count * table.node_count;
  const int dim = dimension(shape);
  table.value.resize(size);
  for (int d = 0; d < dim && derivatives > 0; ++d)
    table.first[d].resize(size);
  for (int p = 0; p < 6 && derivatives > 1; ++p)
    if (pairs[p][1] < dim)
      table.second[p].resize(size);
  return table;
}

/// Value (0), first (1) or second (2) derivative of a table of a line.
const std::vector<double>& derivative(const Table& line, int order)
{
  return order == 0 ? line.value : order == 1 ? line.first : line.second;
}

/// Orders of differentiation along each coordinate, for each matrix of a table.
template <class Visitor>
void for_each_matrix(CellTable& table, Visitor visit)
{
  visit(table.value, std::array<int, 3>{0, 0, 0});
  for (int d = 0; d < 3; ++d)
  {
    std::array<int, 3> orders{};
    orders[d] = 1;
    if (!table.first[d].empty())
      visit(table.first[d], orders);
  }
  for (int p = 0; p < 6; ++p)
  {
    std::array<int, 3> orders{};
    ++orders[pairs[p][0]];
    ++orders[pairs[p][1]];
    if (!table.second[p].empty())
      visit(table.second[p], orders);
  }
}

Table line_table(const std::vector<double>& line, std::span<const Point> points, int direction)
{
  std::vector<double> at;
  for (const Point& point : points)
    at.push_back(point[direction]);
  return lagrange(line, at);
}

/// Products of the functions of lines: exact at the nodes.
void fill_product(Shape shape, const std::vector<double>& line, std::span<const Point> points,
                  CellTable& table)
{
  const int dim = dimension(shape);
  const int n = static_cast<int>(line.size());
  std::vector<Table> lines;
  for (int d = 0; d < dim; ++d)
    lines.push_back(line_table(line, points, d));
  const std::vector<LatticePoint> lattice = lattice_points(shape, n - 1);
  for_each_matrix(table,
                  [&](std::vector<double>& matrix, const std::array<int, 3>& orders)
                  {
                    std::fill(matrix.begin(), matrix.end(), 1.0);
                    for (int d = 0; d < dim; ++d)
                      for (int q = 0; q < table.point_count; ++q)
                        for (int m = 0; m < table.node_count; ++m)
                          matrix[q * table.node_count + m] *=
                              derivative(lines[d], orders[d])[q * n + lattice[m][d]];
                  });
}

/// Values of the orthonormal functions at the nodes, shape (node, function).
Matrix vandermonde(Shape shape, int order, std::span<const Point> nodes)
{
  std::vector<Jet> jets(lattice_size(shape, order));
  Matrix result(nodes.size(), jets.size());
  for (std::size_t n = 0; n < nodes.size(); ++n)
  {
    orthonormal(shape, order, nodes[n], jets);
    for (std::size_t f = 0; f < jets.size(); ++f)
      result(n, f) = jets[f].value;
  }
  return result;
}

/// From the orthonormal functions at the points by the inverse of their values at the nodes.
void fill_modal(Shape shape, int order, std::span<const Point> nodes, std::span<const Point> points,
                CellTable& table)
{
  const Eigen::PartialPivLU<Matrix> solver(vandermonde(shape, order, nodes).transpose());
  std::vector<Jet> jets(table.node_count);
  Matrix columns(table.node_count, 10);
  for (int q = 0; q < table.point_count; ++q)
  {
    orthonormal(shape, order, points[q], jets);
    for (int f = 0; f < table.node_count; ++f)
    {
      columns(f, 0) = jets[f].value;
      for (int d = 0; d < 3; ++d)
        columns(f, 1 + d) = jets[f].first[d];
      for (int p = 0; p < 6; ++p)
        columns(f, 4 + p) = jets[f].second[p];
    }
    const Matrix solved = solver.solve(columns);
    const auto copy = [&](std::vector<double>& matrix, int column)
    {
      for (int m = 0; m < table.node_count && !matrix.empty(); ++m)
        matrix[q * table.node_count + m] = solved(m, column);
    };
    copy(table.value, 0);
    for (int d = 0; d < 3; ++d)
      copy(table.first[d], 1 + d);
    for (int p = 0; p < 6; ++p)
      copy(table.second[p], 4 + p);
  }
}

/// Prisms: functions of the triangle times functions of the line.
void fill_prism(int order, NodeKind kind, const std::vector<double>& line, std::span<const Point> points,
                int derivatives, CellTable& table)
{
  const CellTable triangle = tabulate(Shape::triangle, order, points, derivatives, kind);
  const Table up = line_table(line, points, 2);
  const int level = triangle.node_count;
  const auto of_triangle = [&](const std::array<int, 3>& orders) -> const std::vector<double>&
  {
    if (orders[0] + orders[1] == 0)
      return triangle.value;
    if (orders[0] + orders[1] == 1)
      return triangle.first[orders[1]];
    return triangle.second[orders[0] == 2 ? 0 : orders[1] == 2 ? 1 : 3];
  };
  for_each_matrix(table,
                  [&](std::vector<double>& matrix, const std::array<int, 3>& orders)
                  {
                    const std::vector<double>& flat = of_triangle(orders);
                    const std::vector<double>& lift = derivative(up, orders[2]);
                    for (int q = 0; q < table.point_count; ++q)
                      for (int k = 0; k <= order; ++k)
                        for (int m = 0; m < level; ++m)
                          matrix[q * table.node_count + k * level + m] =
                              flat[q * level + m] * lift[q * (order + 1) + k];
                  });
}

std::vector<double> line_nodes(int order, NodeKind kind)
{
  std::vector<double> line;
  for (const Point& point : nodes_of(Shape::segment, {order, kind}))
    line.push_back(point[0]);
  return line;
}

}  // namespace

CellTable tabulate(Shape shape, int order, std::span<const Point> points, int derivatives, NodeKind kind)
{
  const std::vector<Point> at = nodes_of(shape, {order, kind});
  CellTable table = make_table(shape, order, points.size(), derivatives);
  switch (shape)
  {
  case Shape::segment:
  case Shape::quadrilateral:
  case Shape::hexahedron:
    fill_product(shape, line_nodes(order, kind), points, table);
    break;
  case Shape::prism:
    fill_prism(order, kind, line_nodes(order, kind), points, derivatives, table);
    break;
  default:
    fill_modal(shape, order, at, points, table);
  }
  return table;
}

std::vector<double> resample(Shape shape, Lattice from, Lattice to)
{
  const std::vector<Point> before = nodes_of(shape, from);
  const std::vector<Point> after = nodes_of(shape, to);
  std::vector<double> matrix = tabulate(shape, from.order, after, 0, from.kind).value;
  for (std::size_t q = 0; q < after.size(); ++q)
  {
    const auto same = std::find(before.begin(), before.end(), after[q]);
    if (same == before.end())
      continue;
    const auto row = matrix.begin() + static_cast<std::ptrdiff_t>(q * before.size());
    std::fill_n(row, before.size(), 0.0);
    row[same - before.begin()] = 1.0;
  }
  return matrix;
}

}  // namespace blockfsi::element
