#include "block/piece.hpp"
#include "block/round.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blockfsi::block
{

namespace
{

using element::Shape;

class ChannelBuilder
{
public:
  ChannelBuilder(Layout& layout, const Channel& channel)
      : channel_(channel), piece_(layout, channel.name, channel.region, channel.where)
  {
  }

  void build()
  {
    check();
    add_lattice();
    add_obstacle();
    if (channel_.grid == ObstacleGrid::wake)
      add_wake();
    else
      add_behind();
    add_boundaries();
  }

private:
  bool is_round() const { return channel_.obstacle == Obstacle::round; }

  void check() const
  {
    const auto& [x, y] = channel_.center;
    const double half = 0.5 * channel_.box;
    piece_.require(
        x - half > 0.0 && x + half < channel_.length && y - half > 0.0 && y + half < channel_.height,
        fmt::format(
            "the box of side {:g} m around ({:g}, {:g}) must lie within the channel of {:g} m by {:g} m",
            channel_.box, x, y, channel_.length, channel_.height));
    piece_.require(channel_.size > 0.0 && channel_.size < channel_.box,
                   fmt::format("the obstacle of {:g} m must be smaller than the box of {:g} m around it",
                               channel_.size, channel_.box));
  }

  void divide(int a, int b, int count, const std::optional<Grading>& grading = {})
  {
    Edge& edge = piece_.edge(a, b);
    edge.divisions = count;
    if (grading)
      edge.grading = edge.a == a ? *grading : reversed(*grading);
  }

  /// Eight blocks around the box, or seven where the wake goes on.
  void add_lattice()
  {
    const double half = 0.5 * channel_.box;
    const std::array<double, 4> x = {0.0, channel_.center[0] - half, channel_.center[0] + half,
                                     channel_.length};
    const std::array<double, 4> y = {0.0, channel_.center[1] - half, channel_.center[1] + half,
                                     channel_.height};
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i)
        grid_[i][j] = piece_.point(fmt::format("x{} y{}", i, j), {x[i], y[j], 0.0});
    const std::array<int, 3> along_x = {channel_.outside[0], channel_.around, channel_.outside[1]};
    const std::array<int, 3> along_y = {channel_.outside[2], channel_.around, channel_.outside[3]};
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i)
      {
        if (j == 1 && (i == 1 || (i == 2 && channel_.grid == ObstacleGrid::wake)))
          continue;
        piece_.block(fmt::format("({}, {})", i, j), Shape::quadrilateral,
                     {grid_[i][j], grid_[i + 1][j], grid_[i + 1][j + 1], grid_[i][j + 1]});
      }
    for (int i = 0; i < 3; ++i)
      divide(grid_[i][0], grid_[i + 1][0], along_x[i]);
    for (int j = 0; j < 3; ++j)
      divide(grid_[0][j], grid_[0][j + 1], along_y[j]);
  }

  /// The blocks at the south, the north and the west of the obstacle.
  void add_obstacle()
  {
    const double half = 0.5 * channel_.size / (is_round() ? std::numbers::sqrt2 : 1.0);
    constexpr std::array<const char*, 4> names = {"sw", "se", "ne", "nw"};
    constexpr std::array<std::array<double, 2>, 4> signs{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (int k = 0; k < 4; ++k)
      wall_[k] = piece_.point(
          names[k], {channel_.center[0] + signs[k][0] * half, channel_.center[1] + signs[k][1] * half, 0.0});
    box_ = {grid_[1][1], grid_[2][1], grid_[2][2], grid_[1][2]};
    add_ring_block("south", 0);
    add_ring_block("north", 2);
    add_ring_block("west", 3);
    for (int k = 0; k < 4; ++k)
    {
      if (is_round())
        piece_.edge(wall_[k], wall_[(k + 1) % 4]).curve =
            geometry::Arc{{channel_.center[0], channel_.center[1], 0.0}};
      divide(wall_[k], box_[k], channel_.radial, channel_.grading);
    }
  }

  void add_ring_block(const char* name, int k)
  {
    const int next = (k + 1) % 4;
    piece_.block(name, Shape::quadrilateral, {box_[k], box_[next], wall_[next], wall_[k]});
  }

  void add_behind()
  {
    add_ring_block("east", 1);
    outlet_ = {grid_[3][0], grid_[3][1], grid_[3][2], grid_[3][3]};
  }

  /// Strips from the obstacle and the sides of the box to the outlet.
  void add_wake()
  {
    const auto end = [&](const char* name, int k)
    {
      const double half = 0.5 * channel_.size / (is_round() ? std::numbers::sqrt2 : 1.0);
      return piece_.point(name, {channel_.length, channel_.center[1] + (k == 1 ? -half : half), 0.0});
    };
    const int low = end("end s", 1);
    const int high = end("end n", 2);
    piece_.block("wake south", Shape::quadrilateral, {box_[1], grid_[3][1], low, wall_[1]});
    piece_.block("wake", Shape::quadrilateral, {wall_[1], low, high, wall_[2]});
    piece_.block("wake north", Shape::quadrilateral, {wall_[2], high, grid_[3][2], box_[2]});
    divide(wall_[1], wall_[2], channel_.around);
    // The layers beside the wake keep their sizes downstream.
    divide(low, grid_[3][1], channel_.radial, channel_.grading);
    divide(high, grid_[3][2], channel_.radial, channel_.grading);
    outlet_ = {grid_[3][0], grid_[3][1], low, high, grid_[3][2], grid_[3][3]};
  }

  void add_boundaries()
  {
    std::vector<std::array<int, 2>> inlet;
    std::vector<std::array<int, 2>> bottom;
    std::vector<std::array<int, 2>> top;
    std::vector<std::array<int, 2>> outlet;
    std::vector<std::array<int, 2>> obstacle;
    for (int k = 0; k < 3; ++k)
    {
      inlet.push_back({grid_[0][k], grid_[0][k + 1]});
      bottom.push_back({grid_[k][0], grid_[k + 1][0]});
      top.push_back({grid_[k][3], grid_[k + 1][3]});
    }
    for (std::size_t k = 0; k + 1 < outlet_.size(); ++k)
      outlet.push_back({outlet_[k], outlet_[k + 1]});
    for (int k = 0; k < 4; ++k)
      obstacle.push_back({wall_[k], wall_[(k + 1) % 4]});
    piece_.boundary("inlet", std::move(inlet));
    piece_.boundary("bottom", std::move(bottom));
    piece_.boundary("top", std::move(top));
    piece_.boundary("outlet", std::move(outlet));
    piece_.boundary("obstacle", std::move(obstacle));
  }

  const Channel& channel_;
  Piece piece_;
  std::array<std::array<int, 4>, 4> grid_{};
  std::array<int, 4> wall_{};
  std::array<int, 4> box_{};
  std::vector<int> outlet_;
};

}  // namespace

void add(Layout& layout, const Channel& channel)
{
  ChannelBuilder(layout, channel).build();
}

}  // namespace blockfsi::block
