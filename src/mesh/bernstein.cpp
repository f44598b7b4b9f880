#include "mesh/bernstein.hpp"

#include "element/nodes.hpp"
#include "mesh/tensor.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <map>

namespace blockfsi::mesh
{

namespace
{

using element::Shape;
using Extended = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Exponents = Bernstein::Exponents;

/// A row of a matrix from control points, by column.
using Row = std::map<std::int64_t, long double>;

/// Largest degree of a line of coefficients: that of the Jacobian of a hexahedron or prism.
constexpr int longest_line = 3 * max_order;

double binomial(int n, int k)
{
  double result = 1.0;
  for (int i = 1; i <= k; ++i)
    result = result * (n - i + 1) / i;
  return result;
}

/// n! / (i! j! k! (n - i - j - k)!).
double multinomial(int n, int i, int j, int k)
{
  return binomial(n, i) * binomial(n - i, j) * binomial(n - i - j, k);
}

int row_length(const Bernstein& space, int j, int k)
{
  switch (space.kind)
  {
  case Bernstein::Kind::tensor:
    return space.a + 1;
  case Bernstein::Kind::prism:
    return space.a - j + 1;
  default:
    return space.a - j - k + 1;
  }
}

int row_count(const Bernstein& space, int k)
{
  switch (space.kind)
  {
  case Bernstein::Kind::tensor:
    return space.b + 1;
  case Bernstein::Kind::prism:
    return space.a + 1;
  default:
    return space.a - k + 1;
  }
}

int level_count(const Bernstein& space)
{
  return (space.kind == Bernstein::Kind::simplex ? space.a : space.c) + 1;
}

long double power(long double base, int exponent)
{
  long double result = 1.0L;
  for (int i = 0; i < exponent; ++i)
    result *= base;
  return result;
}

long double line_function(int degree, int i, long double x)
{
  return binomial(degree, i) * power(x, i) * power(1.0L - x, degree - i);
}

/// Bernstein function of a point of the lattice of a cell. That of a pyramid, with m = order - k, is
/// C(order, m) (1 - zeta)^m zeta^k B_i^m(xi / (1 - zeta)) B_j^m(eta / (1 - zeta)).
long double function(Shape shape, int order, const Exponents& point, const element::Point& at)
{
  const auto [i, j, k] = point;
  const long double x = at[0];
  const long double y = at[1];
  const long double z = at[2];
  switch (shape)
  {
  case Shape::triangle:
    return multinomial(order, i, j, 0) * power(x, i) * power(y, j) * power(1.0L - x - y, order - i - j);
  case Shape::tetrahedron:
    return multinomial(order, i, j, k) * power(x, i) * power(y, j) * power(z, k) *
           power(1.0L - x - y - z, order - i - j - k);
  case Shape::pyramid:
  {
    const int m = order - k;
    const long double height = 1.0L - z;
    if (height == 0.0L)
      return m == 0 ? 1.0L : 0.0L;
    return line_function(order, k, z) * line_function(m, i, x / height) * line_function(m, j, y / height);
  }
  default:
    return line_function(order, i, x);
  }
}

/// From values at the nodes to coefficients: the inverse of the functions at the nodes.
Extended from_nodes(Shape shape, int order)
{
  const std::vector<element::Point> nodes = element::nodes(shape, order);
  const std::vector<Exponents> points = element::lattice_points(shape, order);
  Extended values(nodes.size(), points.size());
  for (std::size_t n = 0; n < nodes.size(); ++n)
    for (std::size_t m = 0; m < points.size(); ++m)
      values(n, m) = function(shape, order, points[m], nodes[n]);
  return values.partialPivLu().inverse();
}

/// The map of points (i, j, k), k slowest, of which the last direction is independent of the others.
Extended product(const Extended& slow, const Extended& fast)
{
  Extended result(slow.rows() * fast.rows(), slow.cols() * fast.cols());
  for (Eigen::Index i = 0; i < slow.rows(); ++i)
    for (Eigen::Index j = 0; j < slow.cols(); ++j)
      result.block(i * fast.rows(), j * fast.cols(), fast.rows(), fast.cols()) = slow(i, j) * fast;
  return result;
}

Extended coefficients(Shape shape, int order)
{
  const Extended line = from_nodes(Shape::segment, order);
  switch (shape)
  {
  case Shape::quadrilateral:
    return product(line, line);
  case Shape::hexahedron:
    return product(line, product(line, line));
  case Shape::prism:
    return product(line, from_nodes(Shape::triangle, order));
  default:
    return from_nodes(shape, order);
  }
}

/// Coefficients of the derivatives of a cell other than a pyramid are differences of control points, times
/// the degree.
Row difference(Shape shape, int order, const Exponents& point, int direction)
{
  Exponents next = point;
  ++next[direction];
  Row row;
  row[element::lattice_index(shape, order, next)] += order;
  row[element::lattice_index(shape, order, point)] -= order;
  return row;
}

/// Weight of coefficient i of degree `from` in coefficient j of the same polynomial of degree `to`.
long double elevation(int from, int to, int i, int j)
{
  if (j < i || j - i > to - from)
    return 0.0L;
  return static_cast<long double>(binomial(from, i)) * binomial(to - from, j - i) / binomial(to, j);
}

/// Adds weight times control point (i, j) of the level with m steps of a pyramid.
void add_control(int order, int m, int i, int j, long double weight, Row& row)
{
  if (weight != 0.0L)
    row[element::lattice_index(Shape::pyramid, order, {i, j, order - m})] += weight;
}

/// With P_m(X, Y) the polynomial of the level with m steps, the derivatives along xi, eta and zeta at the
/// level k of their Bernstein polynomials of zeta, m = order - k, are order times
///   dP_m/dX / m,   dP_m/dY / m   and   P_(m-1) - P_m + (X dP_m/dX + Y dP_m/dY) / m.
Row pyramid_difference(int order, const Exponents& point, int direction)
{
  const auto [s, t, k] = point;
  const int m = order - k;
  Row row;
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= m; ++i)
    {
      const auto add = [&](int i2, int j2, long double weight)
      { add_control(order, m, i2, j2, order * weight, row); };
      if (direction == 0 && i < m)
      {
        const long double weight = elevation(m - 1, order - 1, i, s) * elevation(m, order, j, t);
        add(i + 1, j, weight);
        add(i, j, -weight);
      }
      if (direction == 1 && j < m)
      {
        const long double weight = elevation(m, order, i, s) * elevation(m - 1, order - 1, j, t);
        add(i, j + 1, weight);
        add(i, j, -weight);
      }
      if (direction == 2)
      {
        const long double weight = elevation(m, order, i, s) * elevation(m, order, j, t);
        add(i, j, weight * (static_cast<long double>(i + j) / m - 1.0L));
        if (i > 0)
          add(i - 1, j, -weight * i / m);
        if (j > 0)
          add(i, j - 1, -weight * j / m);
        if (i < m && j < m)
          add_control(order, m - 1, i, j,
                      order * elevation(m - 1, order, i, s) * elevation(m - 1, order, j, t), row);
      }
    }
  return row;
}

Bernstein tangent_space(Shape shape, int k, int direction)
{
  const auto lowered = [&](int d) { return d == direction ? k - 1 : k; };
  switch (shape)
  {
  case Shape::triangle:
    return {Bernstein::Kind::prism, k - 1, 0, 0};
  case Shape::quadrilateral:
    return {Bernstein::Kind::tensor, lowered(0), lowered(1), 0};
  case Shape::tetrahedron:
    return {Bernstein::Kind::simplex, k - 1, 0, 0};
  case Shape::prism:
    return {Bernstein::Kind::prism, direction == 2 ? k : k - 1, 0, lowered(2)};
  case Shape::pyramid:
    return {Bernstein::Kind::tensor, lowered(0), lowered(1), k - 1};
  default:
    return {Bernstein::Kind::tensor, lowered(0), lowered(1), lowered(2)};
  }
}

/// Rows of control points times the map from the nodes to control points. What is zero but for the rounding
/// of extended precision is left out.
SparseRows multiply(const std::vector<Row>& rows, const Extended& control)
{
  SparseRows result;
  result.start.push_back(0);
  Eigen::Matrix<long double, 1, Eigen::Dynamic> dense(control.cols());
  for (const Row& row : rows)
  {
    dense.setZero();
    for (const auto& [column, weight] : row)
      dense += weight * control.row(column);
    const long double negligible = 1e-17L * dense.cwiseAbs().maxCoeff();
    for (Eigen::Index n = 0; n < dense.size(); ++n)
      if (std::abs(dense(n)) > negligible)
      {
        result.column.push_back(static_cast<std::int32_t>(n));
        result.entry.push_back(static_cast<double>(dense(n)));
      }
    result.start.push_back(static_cast<std::int32_t>(result.column.size()));
  }
  return result;
}

/// Steps from a point of a simplex along an edge, corner 0 being the one where all coordinates are 0.
Exponents along_edge(Exponents point, int from, int to, int steps)
{
  if (from > 0)
    point[from - 1] -= steps;
  if (to > 0)
    point[to - 1] += steps;
  return point;
}

/// How often a corner of a triangle or tetrahedron counts in a point.
int share(const Bernstein& space, const Exponents& point, int corner)
{
  if (corner > 0)
    return point[corner - 1];
  return space.a - point[0] - point[1] - (space.kind == Bernstein::Kind::simplex ? point[2] : 0);
}

Halving edge_halving(const Bernstein& space, int from, int to)
{
  Halving halving;
  halving.from = from;
  halving.to = to;
  halving.start.push_back(0);
  for (const Exponents& point : space.points())
    if (share(space, point, to) == 0)
    {
      for (int steps = 0; steps <= share(space, point, from); ++steps)
        halving.index.push_back(static_cast<std::int32_t>(space.index(along_edge(point, from, to, steps))));
      halving.start.push_back(static_cast<std::int32_t>(halving.index.size()));
    }
  return halving;
}

Halving axis_halving(const Bernstein& space, int axis, int degree)
{
  Halving halving;
  halving.axis = axis;
  halving.start.push_back(0);
  for (Exponents point : space.points())
    if (point[axis] == 0)
    {
      for (point[axis] = 0; point[axis] <= degree; ++point[axis])
        halving.index.push_back(static_cast<std::int32_t>(space.index(point)));
      halving.start.push_back(static_cast<std::int32_t>(halving.index.size()));
    }
  return halving;
}

}  // namespace

std::size_t Bernstein::index(const Exponents& point) const
{
  const auto [i, j, k] = point;
  switch (kind)
  {
  case Kind::tensor:
    return i + (a + 1) * (j + static_cast<std::size_t>(b + 1) * k);
  case Kind::prism:
    return element::lattice_index(Shape::triangle, a, {i, j, 0}) +
           k * element::lattice_size(Shape::triangle, a);
  default:
    return element::lattice_index(Shape::tetrahedron, a, point);
  }
}

std::size_t Bernstein::size() const
{
  return points().size();
}

std::vector<Exponents> Bernstein::points() const
{
  std::vector<Exponents> result;
  for (int k = 0; k < level_count(*this); ++k)
    for (int j = 0; j < row_count(*this, k); ++j)
      for (int i = 0; i < row_length(*this, j, k); ++i)
        result.push_back({i, j, k});
  return result;
}

std::vector<double> Bernstein::factors() const
{
  std::vector<double> result;
  for (const auto& [i, j, k] : points())
    switch (kind)
    {
    case Kind::tensor:
      result.push_back(binomial(a, i) * binomial(b, j) * binomial(c, k));
      break;
    case Kind::prism:
      result.push_back(multinomial(a, i, j, 0) * binomial(c, k));
      break;
    default:
      result.push_back(multinomial(a, i, j, k));
    }
  return result;
}

std::vector<std::int32_t> Bernstein::corners() const
{
  std::vector<std::int32_t> result;
  for (const Exponents& point : points())
  {
    const bool flat = kind != Kind::tensor && share(*this, point, 0) != a && point[0] != a && point[1] != a &&
                      (kind == Kind::prism || point[2] != a);
    const bool axes =
        (kind != Kind::tensor || ((point[0] == 0 || point[0] == a) && (point[1] == 0 || point[1] == b))) &&
        (kind == Kind::simplex || point[2] == 0 || point[2] == c);
    if (!flat && axes)
      result.push_back(static_cast<std::int32_t>(index(point)));
  }
  return result;
}

Bernstein operator*(const Bernstein& p, const Bernstein& q)
{
  return {p.kind, p.a + q.a, p.b + q.b, p.c + q.c};
}

double SparseRows::norm() const
{
  double largest = 0.0;
  for (std::size_t row = 0; row + 1 < start.size(); ++row)
  {
    double sum = 0.0;
    for (std::int32_t m = start[row]; m < start[row + 1]; ++m)
      sum += std::abs(entry[m]);
    largest = std::max(largest, sum);
  }
  return largest;
}

int SparseRows::widest() const
{
  int result = 0;
  for (std::size_t row = 0; row + 1 < start.size(); ++row)
    result = std::max(result, start[row + 1] - start[row]);
  return result;
}

std::vector<Tangent> tangents(Shape shape, int order)
{
  check_order(order);
  const Extended control = coefficients(shape, order);
  std::vector<Tangent> result;
  for (int d = 0; d < element::dimension(shape); ++d)
  {
    Tangent tangent;
    tangent.space = tangent_space(shape, order, d);
    tangent.factors = tangent.space.factors();
    std::vector<Row> rows;
    for (const Exponents& point : tangent.space.points())
      rows.push_back(shape == Shape::pyramid ? pyramid_difference(order, point, d)
                                             : difference(shape, order, point, d));
    tangent.from_nodes = multiply(rows, control);
    result.push_back(std::move(tangent));
  }
  return result;
}

Product::Product(const Bernstein& first, const Bernstein& second)
{
  const Bernstein both = first * second;
  std::vector<Exponents> row_points;
  for (const Exponents& point : second.points())
    if (point[0] == 0)
    {
      row_points.push_back(point);
      row_start.push_back(static_cast<std::int32_t>(second.index(point)));
    }
  row_start.push_back(static_cast<std::int32_t>(second.size()));
  for (const Exponents& point : first.points())
  {
    for (const Exponents& row : row_points)
      target.push_back(
          static_cast<std::int32_t>(both.index({point[0] + row[0], point[1] + row[1], point[2] + row[2]})));
    ++first_size;
  }
}

void Product::add(double sign, std::span<const double> first, std::span<const double> second,
                  std::span<double> result) const
{
  const std::size_t rows = row_start.size() - 1;
  for (std::size_t m = 0; m < first_size; ++m)
  {
    const double factor = sign * first[m];
    const std::int32_t* const targets = &target[m * rows];
    for (std::size_t row = 0; row < rows; ++row)
    {
      const double* const from = second.data() + row_start[row];
      double* const to = result.data() + targets[row];
      const std::int32_t length = row_start[row + 1] - row_start[row];
      for (std::int32_t i = 0; i < length; ++i)
        to[i] += factor * from[i];
    }
  }
}

void Halving::split(std::span<double> patch, std::span<double> lower) const
{
  std::array<double, longest_line + 1> line;
  for (std::size_t l = 0; l + 1 < start.size(); ++l)
  {
    const std::int32_t* const at = &index[start[l]];
    const int count = start[l + 1] - start[l];
    for (int i = 0; i < count; ++i)
      line[i] = patch[at[i]];
    for (int i = 0; i < count; ++i)
    {
      lower[at[i]] = line[0];
      for (int m = 0; m < count - 1 - i; ++m)
        line[m] = 0.5 * (line[m] + line[m + 1]);
      // What is last in each round is a coefficient of the upper half.
      patch[at[count - 1 - i]] = line[count - 1 - i];
    }
  }
}

std::vector<Halving> halvings(const Bernstein& space)
{
  std::vector<Halving> result;
  if (space.kind == Bernstein::Kind::tensor)
  {
    if (space.a > 0)
      result.push_back(axis_halving(space, 0, space.a));
    if (space.b > 0)
      result.push_back(axis_halving(space, 1, space.b));
  }
  else if (space.a > 0)
    for (int to = 1; to < (space.kind == Bernstein::Kind::simplex ? 4 : 3); ++to)
      for (int from = 0; from < to; ++from)
        result.push_back(edge_halving(space, from, to));
  if (space.kind != Bernstein::Kind::simplex && space.c > 0)
    result.push_back(axis_halving(space, 2, space.c));
  return result;
}

}  // namespace blockfsi::mesh
