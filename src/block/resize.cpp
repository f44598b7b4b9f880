#include "block/resize.hpp"

#include "block/message.hpp"
#include "block/strips.hpp"
#include "geometry/overloaded.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace blockfsi::block
{

namespace
{

/// The grading of cells that are larger by `ratio`.
Grading scaled(const Grading& grading, double ratio)
{
  return std::visit(geometry::Overloaded{[&](Geometric law) -> Grading
                                         {
                                           law.ratio = std::pow(law.ratio, ratio);
                                           return law;
                                         },
                                         [&](FirstCell law) -> Grading
                                         {
                                           law.size *= ratio;
                                           return law;
                                         },
                                         [&](TwoSided law) -> Grading
                                         {
                                           law.first *= ratio;
                                           law.last *= ratio;
                                           return law;
                                         },
                                         [&](OneSided law) -> Grading
                                         {
                                           law.size *= ratio;
                                           return law;
                                         },
                                         [](const auto& law) -> Grading { return law; }},
                    grading);
}

/// Gives an edge another number of cells.
void resize(Edge& edge, int before, int after, const Layout& layout)
{
  if (edge.grading && cell_count(*edge.grading))
    throw mistake(edge.where, fmt::format("the cells of the edge {} are listed one by one, so they cannot "
                                          "become {} where they are {}; grade it by a law",
                                          edge_text(layout, edge.a, edge.b), after, before));
  edge.divisions = after;
  if (edge.grading && after == 1)
    edge.grading.reset();
  else if (edge.grading)
    edge.grading = scaled(*edge.grading, static_cast<double>(before) / after);
}

bool belongs(const Layout& layout, const Topology& topology, const Strip& strip, std::string_view region)
{
  return std::any_of(strip.edges.begin(), strip.edges.end(),
                     [&](int e)
                     {
                       const std::vector<int>& blocks = topology.edges[e].blocks;
                       return std::any_of(blocks.begin(), blocks.end(),
                                          [&](int b) { return layout.blocks[b].region == region; });
                     });
}

}  // namespace

Layout resized(const Layout& layout, std::string_view region, int order, double factor)
{
  Layout result = layout;
  result.order = order;
  if (factor == 1.0)
    return result;
  const Topology topology = make_topology(layout);
  const std::vector<int> divisions = divide(layout, topology);
  for (const Strip& strip : make_strips(layout, topology))
  {
    const int before = divisions[strip.edges.front()];
    const int after = std::max(1, static_cast<int>(std::lround(before * factor)));
    if (after == before || !belongs(layout, topology, strip, region))
      continue;
    for (const int e : strip.edges)
      if (topology.info[e] >= 0)
        resize(result.edges[topology.info[e]], before, after, layout);
    // One edge is enough to divide all, but perhaps nobody speaks of any.
    if (const int first = strip.edges.front(); topology.info[first] < 0)
    {
      Edge& edge = result.edges.emplace_back();
      edge.a = topology.edges[first].a;
      edge.b = topology.edges[first].b;
      edge.divisions = after;
    }
  }
  for (GradeTowards& grade : result.grade_towards)
    grade.first *= std::max(1.0, 1.0 / factor);
  return result;
}

}  // namespace blockfsi::block
