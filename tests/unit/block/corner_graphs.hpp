#pragma once

#include "block/corner_graph.hpp"
#include "block/corner_samples.hpp"

#include <array>
#include <cmath>
#include <vector>

// Coarse blocks made from plain arrays, without a layout.
namespace blockfsi::block::testing
{

/// A corner that moves freely in all directions.
inline void release(Corner& corner, int dim)
{
  corner.freedom = dim;
  corner.direction = {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
}

/// A straight block, its samples from its corners; corners as element::Shape says.
inline CoarseBlock straight_block(const CornerGraph& graph, element::Shape shape, std::vector<int> corners)
{
  CoarseBlock block;
  block.shape = shape;
  block.corners = std::move(corners);
  const CornerSamples samples = corner_samples(shape, graph.degree);
  for (int s = 0; s < samples.count; ++s)
    for (int i = 0; i < graph.dim; ++i)
    {
      double x = 0.0;
      for (int c = 0; c < samples.corner_count; ++c)
        x += samples.basis[s * samples.corner_count + c] * graph.corners[block.corners[c]].x[i];
      block.x.push_back(x);
    }
  block.distance.assign(samples.count, 0.0);
  return block;
}

/// A fan of `valence` quadrilaterals about an inner corner: 1 + 2 valence corners, of which the outer ones
/// are led each by an interface node of its own. The inner one is free.
inline CornerGraph fan(int valence, element::Shape shape = element::Shape::quadrilateral)
{
  CornerGraph graph;
  const int rim = shape == element::Shape::triangle ? valence : 2 * valence;
  graph.corners.resize(1 + rim);
  release(graph.corners[0], 2);
  graph.corners[0].x = {0.05, -0.03, 0.0};
  for (int k = 0; k < rim; ++k)
  {
    const double angle = 2.0 * std::acos(-1.0) * k / rim;
    const double radius = shape != element::Shape::triangle && k % 2 == 1 ? 1.3 : 1.0;
    graph.corners[1 + k].x = {radius * std::cos(angle), radius * std::sin(angle), 0.0};
    graph.corners[1 + k].led = {{k, 1.0}};
  }
  graph.interface_count = rim;
  for (Corner& corner : graph.corners)
    corner.used = true;
  for (int k = 0; k < valence; ++k)
    if (shape == element::Shape::triangle)
      graph.blocks.push_back(straight_block(graph, shape, {0, 1 + k, 1 + (k + 1) % rim}));
    else
      graph.blocks.push_back(straight_block(graph, shape, {0, 1 + 2 * k, 2 + 2 * k, 1 + (2 * k + 2) % rim}));
  return graph;
}

/// A cube of n^3 cubes: corners on the outside are led, each by an interface node of its own.
inline CornerGraph cubes(int n)
{
  CornerGraph graph;
  graph.dim = 3;
  const auto index = [n](int i, int j, int k) { return (i * (n + 1) + j) * (n + 1) + k; };
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= n; ++k)
      {
        Corner& corner = graph.corners.emplace_back();
        corner.used = true;
        corner.x = {1.0 * i / n, 1.0 * j / n, 1.0 * k / n};
        const auto inside = [n](int m) { return m > 0 && m < n; };
        if (inside(i) && inside(j) && inside(k))
          release(corner, 3);
        else
          corner.led = {{static_cast<std::int32_t>(graph.interface_count++), 1.0}};
      }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
      {
        std::vector<int> corners;
        for (const auto& r : element::corners(element::Shape::hexahedron))
          corners.push_back(index(i + (r[0] == 1.0), j + (r[1] == 1.0), k + (r[2] == 1.0)));
        graph.blocks.push_back(straight_block(graph, element::Shape::hexahedron, corners));
      }
  return graph;
}

/// The interface displacements that give every led corner of such a graph u(x).
template <typename Field>
std::vector<double> led_by(const CornerGraph& graph, Field u)
{
  std::vector<double> d(graph.interface_count * graph.dim, 0.0);
  for (const Corner& corner : graph.corners)
    for (const Share& share : corner.led)
    {
      const std::array<double, 3> value = u(corner.x);
      for (int i = 0; i < graph.dim; ++i)
        d[share.node * graph.dim + i] = value[i];
    }
  return d;
}

}  // namespace blockfsi::block::testing
