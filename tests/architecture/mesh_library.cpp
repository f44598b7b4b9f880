// Makes a mesh with the mesh library alone: four cells of order 3 on a unit square.

#include "block/connect.hpp"
#include "block/place.hpp"

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace block = blockfsi::block;

int main()
{
  block::Layout layout;
  layout.order = 3;
  layout.points = {{.name = "a", .x = {0, 0, 0}, .where = {}},
                   {.name = "b", .x = {1, 0, 0}, .where = {}},
                   {.name = "c", .x = {1, 1, 0}, .where = {}},
                   {.name = "d", .x = {0, 1, 0}, .where = {}}};
  layout.blocks = {{.name = "square", .region = "fluid", .points = {0, 1, 2, 3}, .where = {}}};
  layout.boundaries = {
      {.name = "walls", .rule = block::ByCondition{{"x = 0 or x = 1 or y = 0 or y = 1", {}}}, .where = {}}};
  layout.default_divisions = 2;
  const block::Skeleton skeleton = block::make_skeleton(layout);
  const block::Connected connected = block::connect(layout, skeleton, "fluid", {});
  const std::size_t count = connected.mesh.node_count();
  std::vector<double> x(2 * count);
  block::place(connected.plan, skeleton.x, x);
  double sum = 0.0;
  for (const double coordinate : x)
    sum += coordinate;
  std::printf("%zu nodes, centre of gravity at %g\n", count, sum / static_cast<double>(x.size()));
  const bool right = count == 49 && std::abs(sum / static_cast<double>(x.size()) - 0.5) < 1e-14;
  return right ? 0 : 1;
}
