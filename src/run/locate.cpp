#include "run/locate.hpp"

#include "element/line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blockfsi::run
{

namespace
{

/// Points this far outside of the unit cell still count as inside: round-off of neighbours.
constexpr double outside = 1e-9;
/// Points this far inside of a cell are in no other one.
constexpr double well_inside = 1e-6;
/// How far outside of the unit cell its functions may go on, and what a box must hold beyond its nodes.
constexpr double beside = 0.1;

Box box_of(const mesh::Mesh& mesh, std::span<const double> x, std::size_t cell)
{
  Box box;
  for (const std::int32_t node : mesh.cell(cell))
    for (int c = 0; c < 2; ++c)
    {
      box.low[c] = std::min(box.low[c], x[2 * node + c]);
      box.high[c] = std::max(box.high[c], x[2 * node + c]);
    }
  // The edges of a curved cell may bulge out of the box of its nodes.
  for (int c = 0; c < 2; ++c)
  {
    const double margin = beside * std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
    box.low[c] -= margin;
    box.high[c] += margin;
  }
  return box;
}

bool holds(const Box& box, const std::array<double, 2>& point)
{
  return point[0] >= box.low[0] && point[0] <= box.high[0] && point[1] >= box.low[1] &&
         point[1] <= box.high[1];
}

/// Finds the point in one cell; nothing if it is not at least `margin` inside of it, in the unit cell.
std::optional<Located> invert(const mesh::Mesh& mesh, std::span<const double> x, std::size_t cell,
                              const std::array<double, 2>& point, std::span<const double> nodes,
                              double margin)
{
  const int n = mesh.order + 1;
  std::array<double, 2> xi = {0.5, 0.5};
  for (int iteration = 0; iteration < 30; ++iteration)
  {
    const element::Table tables = element::lagrange(nodes, xi);
    Located located{cell, std::vector<double>(n * n)};
    std::array<double, 2> miss = {-point[0], -point[1]};
    std::array<std::array<double, 2>, 2> jacobian{};
    double size = 0.0;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
      {
        const std::size_t node = mesh.cell(cell)[j * n + i];
        located.shape[j * n + i] = tables.value[i] * tables.value[n + j];
        for (int c = 0; c < 2; ++c)
        {
          size = std::max(size, std::abs(x[2 * node + c]));
          miss[c] += located.shape[j * n + i] * x[2 * node + c];
          jacobian[c][0] += tables.first[i] * tables.value[n + j] * x[2 * node + c];
          jacobian[c][1] += tables.value[i] * tables.first[n + j] * x[2 * node + c];
        }
      }
    const double det = jacobian[0][0] * jacobian[1][1] - jacobian[0][1] * jacobian[1][0];
    const std::array<double, 2> change = {(jacobian[1][1] * miss[0] - jacobian[0][1] * miss[1]) / det,
                                          (jacobian[0][0] * miss[1] - jacobian[1][0] * miss[0]) / det};
    // Round-off of the coordinates, which is much in the unit cell if the cell is thin and far from the
    // origin.
    const double blur = 16.0 * std::numeric_limits<double>::epsilon() * size / std::abs(det);
    const std::array<double, 2> least = {
        std::max(1e-13, blur * (std::abs(jacobian[1][1]) + std::abs(jacobian[0][1]))),
        std::max(1e-13, blur * (std::abs(jacobian[0][0]) + std::abs(jacobian[1][0])))};
    if (std::abs(change[0]) < least[0] && std::abs(change[1]) < least[1])
    {
      const auto inside = [&](int c) { return xi[c] > margin - least[c] && xi[c] < 1.0 - margin + least[c]; };
      if (!inside(0) || !inside(1))
        return std::nullopt;
      for (int c = 0; c < 2; ++c)
        located.outside = std::max({located.outside, -xi[c], xi[c] - 1.0});
      return located;
    }
    for (int c = 0; c < 2; ++c)
      xi[c] = std::clamp(xi[c] - change[c], -0.5, 1.5);
  }
  return std::nullopt;
}

}  // namespace

double Located::value(const mesh::Mesh& mesh, std::span<const double> field, int stride, int component) const
{
  double sum = 0.0;
  const auto nodes = mesh.cell(cell);
  for (std::size_t a = 0; a < shape.size(); ++a)
    sum += shape[a] * field[static_cast<std::size_t>(nodes[a]) * stride + component];
  return sum;
}

std::optional<Located> locate(const mesh::Mesh& mesh, std::span<const double> x,
                              const std::array<double, 2>& point, std::size_t first)
{
  const std::vector<double> nodes = element::lobatto(mesh.order);
  const auto attempt = [&](std::size_t cell, double margin) -> std::optional<Located> {
    return holds(box_of(mesh, x, cell), point) ? invert(mesh, x, cell, point, nodes, margin) : std::nullopt;
  };
  if (first < mesh.cell_count())
    if (std::optional<Located> found = attempt(first, well_inside))
      return found;
  for (std::size_t cell = 0; cell < mesh.cell_count(); ++cell)
    if (std::optional<Located> found = attempt(cell, -outside))
      return found;
  return std::nullopt;
}

Finder::Finder(const mesh::Mesh& mesh, std::span<const double> x)
    : mesh_(&mesh), x_(x.begin(), x.end()), nodes_(element::lobatto(mesh.order))
{
  for (std::size_t cell = 0; cell < mesh.cell_count(); ++cell)
  {
    const Box& box = boxes_.emplace_back(box_of(mesh, x, cell));
    for (int c = 0; c < 2; ++c)
    {
      whole_.low[c] = std::min(whole_.low[c], box.low[c]);
      whole_.high[c] = std::max(whole_.high[c], box.high[c]);
    }
  }
  if (boxes_.empty())
    return;
  // About four bins for each cell, as square as may be.
  const double width = whole_.high[0] - whole_.low[0];
  const double height = whole_.high[1] - whole_.low[1];
  const double side = std::sqrt(width * height / (4.0 * static_cast<double>(boxes_.size())));
  bins_ = {static_cast<std::size_t>(width / side) + 1, static_cast<std::size_t>(height / side) + 1};
  cells_.resize(bins_[0] * bins_[1]);
  for (std::size_t cell = 0; cell < boxes_.size(); ++cell)
  {
    const std::size_t first = bin(boxes_[cell].low);
    const std::size_t last = bin(boxes_[cell].high);
    for (std::size_t j = first / bins_[0]; j <= last / bins_[0]; ++j)
      for (std::size_t i = first % bins_[0]; i <= last % bins_[0]; ++i)
        cells_[i + j * bins_[0]].push_back(cell);
  }
}

Located Finder::find(const std::array<double, 2>& point)
{
  std::optional<Located> found = find_near(point);
  return found ? *std::move(found) : nearest_node(point);
}

std::optional<Located> Finder::find_near(const std::array<double, 2>& point)
{
  if (boxes_.empty())
    return std::nullopt;
  std::optional<Located> found;
  if (holds(boxes_[last_], point))
    found = invert(*mesh_, x_, last_, point, nodes_, well_inside);
  if (!found)
    found = among_near(point);
  if (found)
    last_ = found->cell;
  return found;
}

std::size_t Finder::bin(const std::array<double, 2>& point) const
{
  std::array<std::size_t, 2> at{};
  for (int c = 0; c < 2; ++c)
  {
    const double share = (point[c] - whole_.low[c]) / (whole_.high[c] - whole_.low[c]);
    const double last = static_cast<double>(bins_[c] - 1);
    at[c] = static_cast<std::size_t>(std::clamp(share * static_cast<double>(bins_[c]), 0.0, last));
  }
  return at[0] + at[1] * bins_[0];
}

/// In the cell of least number that holds the point, else in that which it is least outside of.
std::optional<Located> Finder::among_near(const std::array<double, 2>& point) const
{
  std::optional<Located> best;
  for (const std::size_t cell : cells_[bin(point)])
  {
    if (!holds(boxes_[cell], point))
      continue;
    std::optional<Located> found = invert(*mesh_, x_, cell, point, nodes_, -beside);
    if (found && found->outside < outside)
      return found;
    if (found && (!best || found->outside < best->outside))
      best = std::move(found);
  }
  return best;
}

Located Finder::nearest_node(const std::array<double, 2>& point) const
{
  double least = std::numeric_limits<double>::infinity();
  Located best{0, {}, least};
  for (std::size_t cell = 0; cell < mesh_->cell_count(); ++cell)
  {
    const auto nodes = mesh_->cell(cell);
    for (std::size_t a = 0; a < nodes.size(); ++a)
    {
      const double distance = std::hypot(x_[2 * nodes[a]] - point[0], x_[2 * nodes[a] + 1] - point[1]);
      if (distance >= least)
        continue;
      least = distance;
      best = {cell, std::vector<double>(nodes.size(), 0.0), distance};
      best.shape[a] = 1.0;
    }
  }
  return best;
}

}  // namespace blockfsi::run
