#include "block/face_shape.hpp"

#include "block/blend.hpp"
#include "block/face_plan.hpp"
#include "block/message.hpp"
#include "block/numbering.hpp"
#include "block/reference.hpp"
#include "geometry/project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <variant>

namespace blockfsi::block
{

namespace
{

using geometry::Point;

/// Edges may miss the surface of their face by so much of the face's size.
constexpr double fit_tolerance = 1e-8;

/// One shaped face with all its nodes, boundary included, in the order of its lattice.
class ShapedFace
{
public:
  ShapedFace(const Layout& layout, const Face& said, const PlacedFace& face, Skeleton& skeleton)
      : layout_(layout), said_(said), face_(face), skeleton_(skeleton), numbers_(face_numbers(skeleton, face))
  {
    make_plan();
    x_.resize(numbers_.size());
    for (std::size_t n = 0; n < numbers_.size(); ++n)
      for (int c = 0; c < 3; ++c)
        x_[n][c] = skeleton.x[3 * static_cast<std::size_t>(numbers_[n]) + c];
    for (const Point& x : x_)
      size_ = std::max(size_, geometry::distance(x, x_[0]));
  }

  void shape(const Interpolated&) {}

  void shape(const Patch& patch)
  {
    const std::vector<std::array<double, 2>> at = parameters_on(patch.surface);
    std::vector<Point> move(x_.size());
    double miss = 0.0;
    for (std::size_t n = 0; n < x_.size(); ++n)
      if (!is_inner(n))
      {
        move[n] = geometry::subtract(x_[n], geometry::evaluate(patch.surface, at[n][0], at[n][1]));
        if (geometry::norm(move[n]) > fit_tolerance * size_)
          miss = std::max(miss, geometry::closest(patch.surface, x_[n], at[n]).distance);
      }
    require_fit(miss);
    // Edges whose parameters are not the surface's take the inside along.
    std::vector<double> work(work_size(plan_, 3));
    blend(plan_, 3, move.front().data(), work.data(), move.front().data());
    for (const std::size_t n : inner_)
    {
      x_[n] = geometry::add(geometry::evaluate(patch.surface, at[n][0], at[n][1]), move[n]);
      if (geometry::norm(move[n]) > 1e-14 * size_)
        x_[n] = geometry::closest(patch.surface, x_[n], at[n]).x;
    }
    write();
  }

  void shape(const OnSurface& on)
  {
    double miss = 0.0;
    for (std::size_t n = 0; n < x_.size(); ++n)
    {
      const geometry::Closest closest = geometry::closest(on.surface, x_[n]);
      if (!closest.converged)
        fail_at(n, "no closest point of the surface was found");
      if (is_inner(n))
        x_[n] = closest.x;
      else
        miss = std::max(miss, closest.distance);
    }
    require_fit(miss);
    write();
  }

  void shape(const OnLevelSet& on)
  {
    std::vector<Point> start;
    std::vector<Point> normal;
    for (const std::size_t n : inner_)
    {
      start.push_back(x_[n]);
      normal.push_back(normal_at(n));
    }
    std::vector<Point> found(start.size());
    const geometry::ProjectionReport report =
        geometry::project_nodes(on.level_set, start, normal, {size_, size_, true}, found);
    if (!report.failures.empty())
    {
      const geometry::Failure& failure = report.failures.front();
      fail_at(inner_[failure.index],
              fmt::format(
                  "the search for the level set {} failed: {} between {:.3g} and {:.3g} m along the normal",
                  on.level_set.text(), geometry::text(failure.found.status), failure.found.low,
                  failure.found.high));
    }
    for (std::size_t k = 0; k < inner_.size(); ++k)
      x_[inner_[k]] = found[k];
    write();
  }

private:
  /// The face alone, its nodes numbered by its lattice.
  void make_plan()
  {
    plan_.grid = face_grid(face_, skeleton_.order);
    const int corner_count = element::corner_count(face_.shape);
    for (int c = 0; c < corner_count; ++c)
      plan_.corners[c] = static_cast<std::int32_t>(index(plan_.grid, corner_point(plan_.grid, c)));
    const auto sides = element::sides(face_.shape);
    for (std::size_t side = 0; side < sides.size(); ++side)
    {
      const element::LatticePoint from = corner_point(plan_.grid, sides[side].corners[0]);
      const Way way = way_between(plan_.grid, sides[side].corners[0], sides[side].corners[1]);
      plan_.sides.emplace_back();
      for (int s = 0; s <= way.count; ++s)
        plan_.sides.back().push_back(static_cast<std::int32_t>(
            index(plan_.grid, {from[0] + s * way.step[0], from[1] + s * way.step[1], 0})));
    }
    const Grid inner = interior(plan_.grid);
    for (int j = 0; face_.count > 0 && j < row_count(inner, 0); ++j)
    {
      const int length = row_length(inner, j, 0);
      const auto node = static_cast<std::int32_t>(index(plan_.grid, {1, j + 1, 0}));
      plan_.rows.push_back({j + 1, 0, 1, length + 1, node});
      for (int i = 0; i < length; ++i)
      {
        inner_.push_back(static_cast<std::size_t>(node) + i);
        lattice_.push_back({i + 1, j + 1, 0});
      }
    }
    parameters_ = edge_parameters(skeleton_, face_);
    set_reference(parameters_, skeleton_.order, 0, plan_);
  }

  bool is_inner(std::size_t n) const { return std::binary_search(inner_.begin(), inner_.end(), n); }

  /// The surface's parameters of all nodes. The transfinite map of the edges' parameters is the graded
  /// coordinate.
  std::vector<std::array<double, 2>> parameters_on(const geometry::Surface& surface) const
  {
    const int count = element::corner_count(face_.shape);
    if (geometry::corner_count(surface) != count)
      throw mistake(said_.where,
                    fmt::format("the {} has {} corners, its surface {}", side_text(layout_, said_.points),
                                count, geometry::corner_count(surface)));
    std::array<std::array<double, 2>, 4> at{};
    for (int c = 0; c < count; ++c)
    {
      const auto found = std::find(said_.points.begin(), said_.points.end(), face_.points[c]);
      at[c] = geometry::corner_parameters(surface, static_cast<int>(found - said_.points.begin()));
    }
    std::vector<std::array<double, 2>> result(x_.size());
    const auto edges = element::edges(face_.shape);
    for (std::size_t e = 0; e < edges.size(); ++e)
      for (std::size_t s = 0; s < plan_.sides[e].size(); ++s)
        for (int d = 0; d < 2; ++d)
        {
          const double t = parameters_[e][s];
          result[plan_.sides[e][s]][d] = (1.0 - t) * at[edges[e][0]][d] + t * at[edges[e][1]][d];
        }
    std::vector<double> work(work_size(plan_, 2));
    blend(plan_, 2, result.front().data(), work.data(), result.front().data());
    return result;
  }

  /// Normal of the interpolated face at an inner node, by differences to its neighbours.
  Point normal_at(std::size_t n) const
  {
    const auto [i, j, k] = lattice_[std::lower_bound(inner_.begin(), inner_.end(), n) - inner_.begin()];
    const auto at = [&](int a, int b) { return x_[index(plan_.grid, {a, b, 0})]; };
    return geometry::cross(geometry::subtract(at(i + 1, j), at(i - 1, j)),
                           geometry::subtract(at(i, j + 1), at(i, j - 1)));
  }

  void require_fit(double miss) const
  {
    if (miss > fit_tolerance * size_)
      throw mistake(said_.where,
                    fmt::format("the edges of the {} lie up to {:.3g} m beside its surface; let their "
                                "curves lie on it, or leave them out",
                                side_text(layout_, said_.points), miss));
  }

  [[noreturn]] void fail_at(std::size_t n, const std::string& why) const
  {
    const auto [i, j, k] = lattice_[std::lower_bound(inner_.begin(), inner_.end(), n) - inner_.begin()];
    throw mistake(
        said_.where,
        fmt::format("block '{}', {}, node ({}, {}) near ({:.6g}, {:.6g}, {:.6g}): {}; give the edges "
                    "curves nearer to the surface or divide the block",
                    layout_.blocks[face_.blocks[0]].name, side_text(layout_, said_.points), i, j, x_[n][0],
                    x_[n][1], x_[n][2], why));
  }

  void write()
  {
    for (const std::size_t n : inner_)
      for (int c = 0; c < 3; ++c)
        skeleton_.x[3 * static_cast<std::size_t>(numbers_[n]) + c] = x_[n][c];
  }

  const Layout& layout_;
  const Face& said_;
  const PlacedFace& face_;
  Skeleton& skeleton_;
  std::vector<std::int32_t> numbers_;  ///< skeleton number of each node
  BlockPlan plan_;
  EdgeParameters parameters_;
  std::vector<std::size_t> inner_;              ///< inner nodes, ascending
  std::vector<element::LatticePoint> lattice_;  ///< of each of them
  std::vector<Point> x_;
  double size_ = 0.0;
};

}  // namespace

void shape_faces(const Layout& layout, const Topology& topology, Skeleton& skeleton)
{
  for (std::size_t f = 0; f < skeleton.faces.size(); ++f)
  {
    const int said = topology.face_info[f];
    if (said < 0 || skeleton.faces[f].count == 0)
      continue;
    ShapedFace face(layout, layout.faces[said], skeleton.faces[f], skeleton);
    std::visit([&face](const auto& geometry) { face.shape(geometry); }, layout.faces[said].geometry);
  }
}

}  // namespace blockfsi::block
