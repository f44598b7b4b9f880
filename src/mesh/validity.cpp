#include "mesh/validity.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace blockfsi::mesh
{

static_assert(std::is_trivially_copyable_v<Validity>);

namespace
{

using element::Shape;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Halvings of a cell per direction before the verdict stays open, and patches looked at.
constexpr int levels_per_direction = 20;
constexpr int max_patches = 20000;

Lanes larger(const Lanes& a, const Lanes& b)
{
  return a > b ? a : b;
}

Lanes magnitude(const Lanes& a)
{
  return larger(a, -a);
}

/// Rows of a 3 x 3 or 2 x 2 inverse, and the determinant, from the columns of the matrix.
template <int dim>
Lanes invert(const std::array<std::array<Lanes, dim>, dim>& columns,
             std::array<std::array<Lanes, dim>, dim>& rows)
{
  Lanes determinant{};
  if constexpr (dim == 2)
  {
    rows[0] = {columns[1][1], -columns[1][0]};
    rows[1] = {-columns[0][1], columns[0][0]};
    determinant = columns[0][0] * columns[1][1] - columns[0][1] * columns[1][0];
  }
  else
  {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c)
      {
        const std::array<Lanes, 3>& a = columns[(r + 1) % 3];
        const std::array<Lanes, 3>& b = columns[(r + 2) % 3];
        rows[r][c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
      }
    for (int c = 0; c < 3; ++c)
      determinant += columns[0][c] * rows[0][c];
  }
  for (std::array<Lanes, dim>& row : rows)
    for (Lanes& entry : row)
      entry /= determinant;
  return determinant;
}

/// Proves cells valid whose tangents vary little: with J0 the mean of the Jacobian matrices J and R near its
/// inverse, J is regular wherever |I - R J| < 1 in some norm, and then has the sign of J0. The norm is the
/// largest column sum, and I - R J is a mean of its Bernstein coefficients. Tangents are scaled by their
/// lengths, so that thin cells do not suffer. `x` has shape (node_count, dim), relative to the first node.
/// A lane of the result is 1 where the proof holds.
template <int dim>
Lanes prove(const ShapeValidity& tables, std::span<const Lanes> x)
{
  std::array<std::array<Lanes, dim>, dim> mean{};
  std::array<Lanes, dim> length{};
  Lanes size{};
  for (std::size_t n = 0; n < tables.node_count; ++n)
    for (int c = 0; c < dim; ++c)
    {
      const Lanes& coordinate = x[dim * n + c];
      size = larger(size, magnitude(coordinate));
      for (int d = 0; d < dim; ++d)
        mean[d][c] += tables.means[d * tables.node_count + n] * coordinate;
    }
  for (int d = 0; d < dim; ++d)
  {
    for (int c = 0; c < dim; ++c)
      length[d] += magnitude(mean[d][c]);
    length[d] = 1.0 / length[d];
    for (int c = 0; c < dim; ++c)
      mean[d][c] *= length[d];
  }
  std::array<std::array<Lanes, dim>, dim> inverse;
  const Lanes determinant = invert<dim>(mean, inverse);
  Lanes inverse_norm{};
  for (int c = 0; c < dim; ++c)
  {
    Lanes sum{};
    for (int r = 0; r < dim; ++r)
      sum += magnitude(inverse[r][c]);
    inverse_norm = larger(inverse_norm, sum);
  }
  Lanes farthest{};
  for (int d = 0; d < dim; ++d)
  {
    Lanes distance{};
    Lanes largest{};
    const SparseRows& rows = tables.tangents[d].from_nodes;
    for (std::size_t row = 0; row < rows.row_count(); ++row)
    {
      std::array<Lanes, dim> tangent{};
      for (std::int32_t m = rows.start[row]; m < rows.start[row + 1]; ++m)
        for (int c = 0; c < dim; ++c)
          tangent[c] += rows.entry[m] * x[dim * rows.column[m] + c];
      for (int c = 0; c < dim; ++c)
      {
        tangent[c] *= length[d];
        largest = larger(largest, magnitude(tangent[c]));
      }
      Lanes sum{};
      for (int r = 0; r < dim; ++r)
      {
        Lanes difference = lanes(r == d ? 1.0 : 0.0);
        for (int c = 0; c < dim; ++c)
          difference -= inverse[r][c] * tangent[c];
        sum += magnitude(difference);
      }
      distance = larger(distance, sum);
    }
    // Errors of the tangents, then of their products with the inverse.
    const Lanes error = tables.rounding[d] * size * length[d] + 8.0 * epsilon * largest;
    farthest = larger(farthest, distance + dim * inverse_norm * error);
  }
  // The entries of the scaled mean are at most 1. Whether coordinates are finite is asked elsewhere.
  const Lanes proved = (determinant > 64.0 * epsilon) ? lanes(1.0) : lanes(0.0);
  return (farthest < 0.999) ? proved : lanes(0.0);
}

/// Halves of cells, tried one after the other. A positive number is one above the rounding error;
/// comparisons are such that NaN is not positive.
struct Search
{
  const ShapeValidity& tables;
  std::span<double> patches;
  double rounding = 0.0;
  int patch_count = 0;

  /// Where a patch lies in the reference cell: corners of its triangle or tetrahedron, extent along axes.
  struct Place
  {
    std::array<std::array<double, 3>, 4> corners = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    std::array<double, 3> extent = {1.0, 1.0, 1.0};
  };

  static double length(const Place& place, const Halving& halving)
  {
    if (halving.axis >= 0)
      return place.extent[halving.axis];
    double sum = 0.0;
    for (int d = 0; d < 3; ++d)
      sum += std::pow(place.corners[halving.to][d] - place.corners[halving.from][d], 2);
    return std::sqrt(sum);
  }

  /// The patch is halved along its longest direction; gives the places of both halves.
  const Halving& choose(const Place& place, Place& lower, Place& upper) const
  {
    const Halving* longest = &tables.halvings.front();
    for (const Halving& halving : tables.halvings)
      if (length(place, halving) > length(place, *longest))
        longest = &halving;
    lower = place;
    upper = place;
    if (longest->axis >= 0)
      lower.extent[longest->axis] = upper.extent[longest->axis] = 0.5 * place.extent[longest->axis];
    else
      for (int d = 0; d < 3; ++d)
        lower.corners[longest->to][d] = upper.corners[longest->from][d] =
            0.5 * (place.corners[longest->from][d] + place.corners[longest->to][d]);
    return *longest;
  }

  Verdict certify(std::size_t slot, int level, const Place& place)
  {
    const std::size_t size = tables.inverse_factors.size();
    const std::span<double> patch = patches.subspan(slot * size, size);
    for (const std::int32_t corner : tables.corners)
      if (!(patch[corner] > rounding))
        return Verdict::invalid;
    if (*std::min_element(patch.begin(), patch.end()) > rounding)
      return Verdict::valid;
    const int last_level = levels_per_direction * static_cast<int>(tables.tangents.size());
    if (tables.halvings.empty() || level == last_level || ++patch_count > max_patches)
      return Verdict::undecided;
    Place lower;
    Place upper;
    choose(place, lower, upper).split(patch, patches.subspan((slot + 1) * size, size));
    const Verdict first = certify(slot + 1, level + 1, lower);
    if (first == Verdict::invalid)
      return first;
    const Verdict second = certify(slot, level + 1, upper);
    return second == Verdict::valid ? first : second;
  }
};

/// Coefficients of the tangents of a cell, with their factors; how large they are at most and how wrong.
struct Coefficients
{
  std::array<std::array<std::span<double>, 3>, 3> tangent;  ///< by direction and coordinate
  std::array<double, 3> largest{};
  std::array<double, 3> error{};
};

Coefficients evaluate(const ShapeValidity& tables, std::span<const double> x, ValidityTables::Memory& memory)
{
  const int dim = static_cast<int>(tables.tangents.size());
  // Relative to one node, so that a place far from the origin costs no digits.
  double size = 0.0;
  for (std::size_t n = 0; n < tables.node_count; ++n)
    for (int c = 0; c < dim; ++c)
    {
      memory.nodes[dim * n + c] = x[dim * n + c] - x[c];
      size = std::max(size, std::abs(memory.nodes[dim * n + c]));
    }
  Coefficients result;
  std::span<double> free = memory.tangents;
  for (int d = 0; d < dim; ++d)
  {
    const auto& [space, rows, factors] = tables.tangents[d];
    for (int c = 0; c < dim; ++c)
    {
      const std::span<double> to = result.tangent[d][c] = free.first(factors.size());
      free = free.subspan(factors.size());
      for (std::size_t row = 0; row < factors.size(); ++row)
      {
        double sum = 0.0;
        for (std::int32_t m = rows.start[row]; m < rows.start[row + 1]; ++m)
          sum += rows.entry[m] * memory.nodes[dim * rows.column[m] + c];
        result.largest[d] = std::max(result.largest[d], std::abs(sum));
        to[row] = sum * factors[row];
      }
    }
    result.error[d] = tables.rounding[d] * size;
  }
  return result;
}

/// Coefficients of the Jacobian as the first patch.
void multiply(const ShapeValidity& tables, const Coefficients& of, ValidityTables::Memory& memory)
{
  const std::span<double> jacobian = std::span(memory.patches).first(tables.inverse_factors.size());
  std::fill(jacobian.begin(), jacobian.end(), 0.0);
  if (tables.tangents.size() == 2)
  {
    tables.triple.add(1.0, of.tangent[0][0], of.tangent[1][1], jacobian);
    tables.triple.add(-1.0, of.tangent[0][1], of.tangent[1][0], jacobian);
  }
  else
    for (int c = 0; c < 3; ++c)
    {
      const std::span<double> cross = std::span(memory.crosses).first(tables.cross_size);
      std::fill(cross.begin(), cross.end(), 0.0);
      tables.cross.add(1.0, of.tangent[1][(c + 1) % 3], of.tangent[2][(c + 2) % 3], cross);
      tables.cross.add(-1.0, of.tangent[1][(c + 2) % 3], of.tangent[2][(c + 1) % 3], cross);
      tables.triple.add(1.0, of.tangent[0][c], cross, jacobian);
    }
  for (std::size_t m = 0; m < jacobian.size(); ++m)
    jacobian[m] *= tables.inverse_factors[m];
}

/// Every coefficient is a mean of determinants of three (two) coefficients: errors of the factors, then of
/// the sums.
double rounding_error(const ShapeValidity& tables, const Coefficients& of)
{
  const std::size_t dim = tables.tangents.size();
  double product = 1.0;
  for (std::size_t d = 0; d < dim; ++d)
    product *= of.largest[d];
  double of_factors = 0.0;
  for (std::size_t d = 0; d < dim; ++d)
  {
    double others = of.error[d];
    for (std::size_t e = 0; e < dim; ++e)
      others *= e == d ? 1.0 : of.largest[e];
    of_factors += others;
  }
  const double sums = 2.0 * static_cast<double>(tables.triple.first_size + tables.cross.first_size + 8) +
                      2.0 * levels_per_direction * static_cast<double>(dim);
  const double terms = dim == 2 ? 2.0 : 6.0;
  return terms * (of_factors + sums * epsilon * product);
}

Verdict certify(const ShapeValidity& tables, std::span<const double> x, ValidityTables::Memory& memory)
{
  const Coefficients coefficients = evaluate(tables, x, memory);
  multiply(tables, coefficients, memory);
  Search search{tables, memory.patches, rounding_error(tables, coefficients)};
  return search.certify(0, 0, {});
}

void count(Verdict verdict, std::int64_t cell, std::int32_t block, Validity& validity)
{
  validity.valid += verdict == Verdict::valid;
  validity.invalid += verdict == Verdict::invalid;
  validity.undecided += verdict == Verdict::undecided;
  if (verdict != Verdict::valid && (validity.cell < 0 || cell < validity.cell))
  {
    validity.cell = cell;
    validity.block = block;
  }
}

/// Cells of one shape whose nodes are listed one after the other.
struct Cells
{
  const std::int32_t* nodes;
  std::size_t node_count;

  const std::int32_t* operator[](std::size_t c) const { return nodes + c * node_count; }
};

/// Coordinates of cells `first` to `first` + 7, relative to each cell's first node; the last one stands in
/// for those beyond. Gives the lanes whose coordinates are all finite.
template <int dim>
Lanes gather(const Cells& cells, std::size_t first, std::size_t count, std::span<const double> x,
             std::span<Lanes> to)
{
  for (int lane = 0; lane < lane_count; ++lane)
  {
    const std::int32_t* const nodes = cells[std::min(first + lane, count - 1)];
    const double* const origin = &x[static_cast<std::size_t>(dim) * nodes[0]];
    for (std::size_t n = 0; n < cells.node_count; ++n)
      for (int c = 0; c < dim; ++c)
        to[dim * n + c][lane] = x[static_cast<std::size_t>(dim) * nodes[n] + c] - origin[c];
  }
  Lanes sum{};
  for (std::size_t m = 0; m < dim * cells.node_count; ++m)
    sum += 0.0 * to[m];
  return (sum == 0.0) ? lanes(1.0) : lanes(0.0);
}

template <int dim>
void certify_run(const ValidityTables& tables, const Mesh& mesh, const CellRun& run,
                 std::span<const double> x, std::span<Verdict> verdicts, Validity& validity)
{
  const ShapeValidity& of_shape = tables.of(run.shape);
  ValidityTables::Memory& memory = tables.memory;
  const Cells cells{mesh.cells.data() + run.entry, of_shape.node_count};
  std::array<double, 3 * (max_order + 1) * (max_order + 1) * (max_order + 1)> coordinates;
  const std::span<double> of_cell = std::span(coordinates).first(dim * of_shape.node_count);
  for (std::size_t first = 0; first < static_cast<std::size_t>(run.count); first += lane_count)
  {
    const Lanes finite = gather<dim>(cells, first, run.count, x, memory.lanes);
    const Lanes proved = finite * prove<dim>(of_shape, memory.lanes);
    const int group = static_cast<int>(std::min<std::size_t>(lane_count, run.count - first));
    for (int lane = 0; lane < group; ++lane)
    {
      Verdict verdict = Verdict::valid;
      if (!(proved[lane] > 0.5))
      {
        const std::int32_t* const nodes = cells[first + lane];
        for (std::size_t n = 0; n < of_shape.node_count; ++n)
          for (int c = 0; c < dim; ++c)
            of_cell[dim * n + c] = x[static_cast<std::size_t>(dim) * nodes[n] + c];
        verdict = certify(of_shape, of_cell, memory);
      }
      const std::size_t cell = run.first + first + lane;
      count(verdict, mesh.number_of_cell(cell), mesh.cell_block[cell], validity);
      if (!verdicts.empty())
        verdicts[cell] = verdict;
    }
  }
}

std::vector<double> mean_rows(const std::vector<Tangent>& tangents, std::size_t node_count)
{
  std::vector<double> means(tangents.size() * node_count, 0.0);
  for (std::size_t d = 0; d < tangents.size(); ++d)
  {
    const SparseRows& rows = tangents[d].from_nodes;
    for (std::size_t m = 0; m < rows.column.size(); ++m)
      means[d * node_count + rows.column[m]] += rows.entry[m] / static_cast<double>(rows.row_count());
  }
  return means;
}

}  // namespace

ShapeValidity::ShapeValidity(Shape shape_, int order)
    : shape(shape_), node_count(element::lattice_size(shape_, order)),
      tangents(mesh::tangents(shape_, order)), means(mean_rows(tangents, node_count))
{
  // Rounded entries, coordinates and sums of products.
  for (const Tangent& tangent : tangents)
    rounding.push_back((tangent.from_nodes.widest() + 4) * epsilon * tangent.from_nodes.norm());
  Bernstein second = tangents[1].space;
  if (tangents.size() == 3)
  {
    cross = Product(tangents[1].space, tangents[2].space);
    second = tangents[1].space * tangents[2].space;
    cross_size = second.size();
  }
  triple = Product(tangents[0].space, second);
  const Bernstein jacobian = tangents[0].space * second;
  for (const double factor : jacobian.factors())
    inverse_factors.push_back(1.0 / factor);
  corners = jacobian.corners();
  halvings = mesh::halvings(jacobian);
}

ValidityTables::ValidityTables(int order_) : ValidityTables(std::array{Shape::quadrilateral}, order_) {}

ValidityTables::ValidityTables(const Mesh& mesh) : ValidityTables(shapes_of(mesh), mesh.order) {}

ValidityTables::ValidityTables(std::span<const Shape> shapes_, int order_) : order(order_)
{
  check_order(order);
  const auto enlarge = [](auto& memory_, std::size_t size)
  { memory_.resize(std::max(memory_.size(), size)); };
  for (const Shape shape : shapes_)
  {
    const ShapeValidity& made = shapes.emplace_back(shape, order);
    const std::size_t dim = made.tangents.size();
    std::size_t tangent_size = 0;
    for (const Tangent& tangent : made.tangents)
      tangent_size += dim * tangent.factors.size();
    enlarge(memory.lanes, dim * made.node_count);
    enlarge(memory.nodes, dim * made.node_count);
    enlarge(memory.tangents, tangent_size);
    enlarge(memory.crosses, made.cross_size);
    enlarge(memory.patches, made.inverse_factors.size() * (levels_per_direction * dim + 2));
  }
}

const ShapeValidity& ValidityTables::of(Shape shape) const
{
  for (const ShapeValidity& tables : shapes)
    if (tables.shape == shape)
      return tables;
  throw Error(fmt::format("no tables to certify cells of the shape {} were made", element::name(shape)));
}

Verdict certify(const ValidityTables& tables, std::span<const double> x)
{
  return certify(tables.shapes.front(), x, tables.memory);
}

Verdict certify(const ValidityTables& tables, Shape shape, std::span<const double> x)
{
  return certify(tables.of(shape), x, tables.memory);
}

Validity merge(const Validity& a, const Validity& b)
{
  const bool a_is_first = b.cell < 0 || (a.cell >= 0 && a.cell <= b.cell);
  Validity result = a_is_first ? a : b;
  result.valid = a.valid + b.valid;
  result.invalid = a.invalid + b.invalid;
  result.undecided = a.undecided + b.undecided;
  return result;
}

Validity certify(const ValidityTables& tables, const Mesh& mesh, std::span<const double> x,
                 std::span<Verdict> verdicts)
{
  Validity validity;
  for (const CellRun& run : mesh.runs)
    if (mesh.dim == 2)
      certify_run<2>(tables, mesh, run, x, verdicts, validity);
    else
      certify_run<3>(tables, mesh, run, x, verdicts, validity);
  return validity;
}

}  // namespace blockfsi::mesh
