#include "motion/boundary.hpp"

#include "fem/boundary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace blockfsi::motion
{

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

using Point = std::array<double, 2>;

/// Squared distance of p to the segment from a to b.
double squared_distance(const Point& p, const Point& a, const Point& b)
{
  const Point along = {b[0] - a[0], b[1] - a[1]};
  const Point from = {p[0] - a[0], p[1] - a[1]};
  const double length = along[0] * along[0] + along[1] * along[1];
  const double t =
      length > 0.0 ? std::clamp((from[0] * along[0] + from[1] * along[1]) / length, 0.0, 1.0) : 0.0;
  const Point off = {from[0] - t * along[0], from[1] - t * along[1]};
  return off[0] * off[0] + off[1] * off[1];
}

/// The lines between neighbouring nodes of the edges all of whose nodes are on the interface.
std::vector<std::array<Point, 2>> segments(const block::Skeleton& skeleton,
                                           std::span<const std::int64_t> interface)
{
  const auto on_interface = [&](std::int64_t node)
  { return std::binary_search(interface.begin(), interface.end(), node); };
  const auto place = [&](std::int64_t node) {
    return Point{skeleton.x[node * skeleton.dim], skeleton.x[node * skeleton.dim + 1]};
  };
  std::vector<std::array<Point, 2>> result;
  for (const block::PlacedEdge& edge : skeleton.edges)
  {
    std::vector<std::int64_t> nodes = {edge.a};
    for (std::int64_t k = 0; k < edge.count; ++k)
      nodes.push_back(edge.first + k);
    nodes.push_back(edge.b);
    if (!std::all_of(nodes.begin(), nodes.end(), on_interface))
      continue;
    for (std::size_t k = 1; k < nodes.size(); ++k)
      result.push_back({place(nodes[k - 1]), place(nodes[k])});
  }
  return result;
}

}  // namespace

Boundary find_boundary(const mesh::Mesh& mesh, const linalg::Numbering& numbering, std::span<const double> x,
                       std::span<const std::int64_t> interface, std::span<const std::string> slide)
{
  Boundary result;
  result.fixed.assign(2 * mesh.node_count(), 0);
  for (const auto& [name, sides] : mesh.boundaries)
  {
    if (std::find(slide.begin(), slide.end(), name) != slide.end())
    {
      const std::vector<std::uint8_t> marks = fem::normal_components(mesh, numbering, name, x);
      for (std::size_t i = 0; i < marks.size(); ++i)
        result.fixed[i] |= marks[i];
      continue;
    }
    const std::vector<std::uint8_t> marks = fem::nodes_on(mesh, numbering, name);
    for (std::size_t i = 0; i < result.fixed.size(); ++i)
      result.fixed[i] |= marks[i / 2];
  }
  for (std::size_t index = 0; index < interface.size(); ++index)
  {
    const auto found = std::lower_bound(mesh.lattice.begin(), mesh.lattice.end(), interface[index]);
    if (found == mesh.lattice.end() || *found != interface[index])
      continue;
    const auto node = static_cast<std::int32_t>(found - mesh.lattice.begin());
    result.moving.push_back({node, static_cast<std::int32_t>(index)});
    for (int c = 0; c < 2; ++c)
      result.fixed[2 * static_cast<std::size_t>(node) + c] = 1;
  }
  return result;
}

std::vector<double> distance_to_interface(const block::Skeleton& skeleton,
                                          std::span<const std::int64_t> interface, std::span<const double> x)
{
  const std::vector<std::array<Point, 2>> lines = segments(skeleton, interface);
  std::vector<double> result(x.size() / 2, infinity);
  for (std::size_t node = 0; node < result.size(); ++node)
  {
    double least = infinity;
    for (const auto& [a, b] : lines)
      least = std::min(least, squared_distance({x[2 * node], x[2 * node + 1]}, a, b));
    result[node] = std::sqrt(least);
  }
  return result;
}

std::vector<double> distance_to_points(std::span<const std::array<double, 3>> points,
                                       std::span<const double> x)
{
  std::vector<double> result(x.size() / 2, infinity);
  for (std::size_t node = 0; node < result.size(); ++node)
    for (const std::array<double, 3>& point : points)
      result[node] = std::min(result[node], std::hypot(x[2 * node] - point[0], x[2 * node + 1] - point[1]));
  return result;
}

}  // namespace blockfsi::motion
