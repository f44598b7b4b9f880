#include "run/shared_field.hpp"

#include "linalg/communicator.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace blockfsi::run
{

namespace
{

constexpr double nowhere = std::numeric_limits<double>::infinity();

std::array<double, 2> point_at(std::span<const double> points, std::size_t k)
{
  return {points[2 * k], points[2 * k + 1]};
}

/// For each entry whether this process is the first one to have the least of all processes.
std::vector<bool> is_first_with_least(const std::vector<double>& mine)
{
  std::vector<double> least = mine;
  linalg::minimum(least);
  const double rank = linalg::part().rank;
  std::vector<double> first(mine.size(), nowhere);
  for (std::size_t k = 0; k < mine.size(); ++k)
    if (mine[k] == least[k] && least[k] < nowhere)
      first[k] = rank;
  linalg::minimum(first);
  std::vector<bool> result(mine.size());
  for (std::size_t k = 0; k < mine.size(); ++k)
    result[k] = first[k] == rank;
  return result;
}

}  // namespace

SharedField::SharedField(const mesh::Mesh& mesh, std::span<const double> x, std::vector<double> field,
                         int components)
    : mesh_(&mesh), finder_(mesh, x), field_(std::move(field)), components_(components)
{
}

std::vector<double> SharedField::at(std::span<const double> points)
{
  std::vector<double> result;
  for (int rank = 0; rank < linalg::part().size; ++rank)
  {
    const bool own = rank == linalg::part().rank;
    std::vector<double> theirs;
    if (own)
      theirs.assign(points.begin(), points.end());
    linalg::from_process(rank, theirs);
    std::vector<double> values = at_points_of_all(theirs);
    if (own)
      result = std::move(values);
  }
  return result;
}

/// The values at points that all processes have alike.
std::vector<double> SharedField::at_points_of_all(std::span<const double> points)
{
  const std::size_t count = points.size() / 2;
  std::vector<std::optional<Located>> places(count);
  std::vector<double> outside(count, nowhere);
  for (std::size_t k = 0; k < count; ++k)
    if ((places[k] = finder_.find_near(point_at(points, k))))
      outside[k] = places[k]->outside;
  std::vector<double> least = outside;
  linalg::minimum(least);
  // What no process has near goes to the nearest node of all.
  for (std::size_t k = 0; k < count; ++k)
    if (least[k] == nowhere)
    {
      places[k] = finder_.nearest_node(point_at(points, k));
      outside[k] = places[k]->outside;
    }
  const std::vector<bool> mine = is_first_with_least(outside);
  std::vector<double> values(count * components_, 0.0);
  for (std::size_t k = 0; k < count; ++k)
    for (int c = 0; mine[k] && c < components_; ++c)
      values[k * components_ + c] = places[k]->value(*mesh_, field_, components_, c);
  linalg::sum(values);
  return values;
}

}  // namespace blockfsi::run
