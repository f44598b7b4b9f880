#include "block/corners.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace blockfsi::block
{

namespace
{

double cubed_distance(const std::array<double, 2>& a, const std::array<double, 2>& b)
{
  const double distance = std::hypot(a[0] - b[0], a[1] - b[1]);
  return distance * distance * distance;
}

/// Corners at which the displacement is known.
std::vector<int> known_corners(const Skeleton& skeleton, std::span<const std::int64_t> interface,
                               std::span<const Follow> user)
{
  std::vector<bool> known(skeleton.point_count, false);
  for (const PlacedEdge& edge : skeleton.edges)
    if (edge.boundary >= 0)
    {
      known[edge.a] = true;
      known[edge.b] = true;
    }
  for (const std::int64_t node : interface)
    if (node < skeleton.point_count)
      known[node] = true;
  for (const Follow& rule : user)
    known[rule.point] = true;
  std::vector<int> corners;
  for (int point = 0; point < skeleton.point_count; ++point)
    if (known[point])
      corners.push_back(point);
  return corners;
}

}  // namespace

std::vector<double> radial_weights(std::span<const std::array<double, 2>> centres,
                                   const std::array<double, 2>& x)
{
  const auto count = static_cast<Eigen::Index>(centres.size());
  // Distances relative to the farthest centre keep the system well scaled.
  double scale = 0.0;
  for (const auto& centre : centres)
    scale = std::max(scale, std::hypot(centre[0] - x[0], centre[1] - x[1]));
  const auto scaled = [&](const std::array<double, 2>& point) {
    return std::array<double, 2>{(point[0] - x[0]) / scale, (point[1] - x[1]) / scale};
  };

  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count + 3, count + 3);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(count + 3);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const std::array<double, 2> a = scaled(centres[i]);
    for (Eigen::Index j = 0; j < count; ++j)
      matrix(i, j) = cubed_distance(a, scaled(centres[j]));
    const std::array<double, 3> linear = {1.0, a[0], a[1]};
    for (Eigen::Index k = 0; k < 3; ++k)
    {
      matrix(i, count + k) = linear[k];
      matrix(count + k, i) = linear[k];
    }
    right(i) = cubed_distance(a, {0.0, 0.0});
  }
  right(count) = 1.0;
  const Eigen::VectorXd solution = matrix.partialPivLu().solve(right);
  return {solution.data(), solution.data() + count};
}

std::vector<Follow> automatic_rules(const Layout& layout, const Skeleton& skeleton,
                                    std::span<const std::int64_t> interface, std::span<const Follow> user)
{
  const std::vector<int> known = known_corners(skeleton, interface, user);
  std::vector<std::array<double, 2>> centres;
  centres.reserve(known.size());
  for (const int point : known)
    centres.push_back({layout.points[point].x[0], layout.points[point].x[1]});
  const auto moves = [&](int point)
  {
    return std::binary_search(interface.begin(), interface.end(), std::int64_t{point}) ||
           std::any_of(user.begin(), user.end(), [point](const Follow& rule) { return rule.point == point; });
  };
  std::vector<Follow> rules;
  for (int point = 0; point < skeleton.point_count; ++point)
  {
    if (std::binary_search(known.begin(), known.end(), point))
      continue;
    const std::vector<double> weights =
        radial_weights(centres, {layout.points[point].x[0], layout.points[point].x[1]});
    Follow rule;
    rule.point = point;
    for (std::size_t i = 0; i < known.size(); ++i)
      if (moves(known[i]))
        rule.leaders.push_back({known[i], weights[i]});
    rules.push_back(std::move(rule));
  }
  return rules;
}

}  // namespace blockfsi::block
