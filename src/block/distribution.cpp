#include "block/distribution.hpp"

#include "block/grading.hpp"
#include "block/message.hpp"
#include "core/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

namespace blockfsi::block
{

namespace
{

/// Points and edges on the boundaries and regions that a grading names.
struct Target
{
  std::vector<bool> points;
  std::vector<bool> edges;
};

/// Relative sizes asked for at the start and the end of a strip; 1: nobody asks.
using EndSizes = std::array<double, 2>;

void enter(const Topology& topology, int edge, Target& target)
{
  target.edges[edge] = true;
  target.points[topology.edges[edge].a] = true;
  target.points[topology.edges[edge].b] = true;
}

/// Enters the edges of a boundary or a region; returns whether it exists.
bool enter(const Layout& layout, const Topology& topology, const std::string& name, Target& target)
{
  bool found = false;
  for (int side = 0; side < side_count(topology); ++side)
  {
    const int boundary = side_boundary(topology, side);
    if (boundary < 0 || layout.boundaries[boundary].name != name)
      continue;
    found = true;
    for (const int edge : side_edges(topology, side))
      enter(topology, edge, target);
  }
  for (std::size_t b = 0; b < layout.blocks.size(); ++b)
  {
    if (layout.blocks[b].region != name)
      continue;
    found = true;
    for (const int edge : topology.block_edges[b])
      enter(topology, edge, target);
  }
  return found;
}

Error unknown_name(const Layout& layout, const GradeTowards& grade, const std::string& name)
{
  std::vector<std::string> known;
  for (const Boundary& boundary : layout.boundaries)
    known.push_back(boundary.name);
  for (const Block& block : layout.blocks)
    if (std::find(known.begin(), known.end(), block.region) == known.end())
      known.push_back(block.region);
  return mistake(grade.where,
                 fmt::format("the grading goes towards '{}', which is neither a boundary nor a region; "
                             "known are {}{}",
                             name, listed(known), did_you_mean(name, known)));
}

Target find_target(const Layout& layout, const Topology& topology, const GradeTowards& grade)
{
  Target target{std::vector<bool>(layout.points.size(), false),
                std::vector<bool>(topology.edges.size(), false)};
  for (const std::string& name : grade.names)
    if (!enter(layout, topology, name, target))
      throw unknown_name(layout, grade, name);
  return target;
}

bool has_own_grading(const Layout& layout, const Topology& topology, int edge)
{
  const int info = topology.info[edge];
  return info >= 0 && layout.edges[info].grading;
}

/// What one edge asks of its strip, in the direction of the strip's first edge.
void ask(const Layout& layout, const Topology& topology, const Strip& strip, std::size_t k,
         const Target& target, double first, EndSizes& sizes)
{
  const int e = strip.edges[k];
  if (target.edges[e] || has_own_grading(layout, topology, e))
    return;
  const PlacedEdge& edge = topology.edges[e];
  const std::array<int, 2> ends{strip.reversed[k] ? edge.b : edge.a, strip.reversed[k] ? edge.a : edge.b};
  for (std::size_t end = 0; end < 2; ++end)
    if (target.points[ends[end]])
      sizes[end] = std::min(sizes[end], first / edge_length(layout, topology, e));
}

std::vector<EndSizes> asked_sizes(const Layout& layout, const Topology& topology,
                                  const std::vector<Strip>& strips)
{
  std::vector<EndSizes> sizes(strips.size(), EndSizes{1.0, 1.0});
  for (const GradeTowards& grade : layout.grade_towards)
  {
    if (!(grade.first > 0.0))
      throw mistake(grade.where,
                    fmt::format("the first cell of the grading has a size of {:.9g} m; it must be positive",
                                grade.first));
    const Target target = find_target(layout, topology, grade);
    for (std::size_t s = 0; s < strips.size(); ++s)
      for (std::size_t k = 0; k < strips[s].edges.size(); ++k)
        ask(layout, topology, strips[s], k, target, grade.first, sizes[s]);
  }
  return sizes;
}

/// The grading of the unit edge with n cells that meets the sizes which are smaller than equal cells.
Grading strip_grading(const EndSizes& sizes, int n)
{
  const bool at_start = sizes[0] * n < 1.0;
  const bool at_end = sizes[1] * n < 1.0;
  if (at_start && at_end && n > 2)
    return TwoSided{sizes[0], sizes[1]};
  // Two cells cannot meet two sizes: the smaller one matters more.
  if (at_start && (!at_end || sizes[0] <= sizes[1]))
    return FirstCell{sizes[0], false};
  if (at_end)
    return FirstCell{sizes[1], true};
  return Uniform{};
}

std::vector<double> own_distribution(const Layout& layout, const Topology& topology, int e)
{
  const Edge& edge = layout.edges[topology.info[e]];
  try
  {
    return parameters(*edge.grading, topology.edges[e].divisions, edge_length(layout, topology, e));
  }
  catch (const Error& error)
  {
    throw mistake(edge.where, error.within("the edge " + edge_text(layout, edge.a, edge.b)).message());
  }
}

std::vector<double> strip_distribution(const Layout& layout, const Topology& topology, const Strip& strip,
                                       const Grading& grading)
{
  const PlacedEdge& edge = topology.edges[strip.edges[0]];
  try
  {
    return parameters(grading, edge.divisions, 1.0);
  }
  catch (const Error& error)
  {
    throw mistake(layout.grade_towards.front().where,
                  error.within("grading of the unit edge " + edge_text(layout, edge.a, edge.b)).message());
  }
}

}  // namespace

std::vector<std::vector<double>> distribute(const Layout& layout, const Topology& topology,
                                            const std::vector<Strip>& strips)
{
  const std::vector<EndSizes> sizes = asked_sizes(layout, topology, strips);
  std::vector<std::vector<double>> t(topology.edges.size());
  for (std::size_t s = 0; s < strips.size(); ++s)
  {
    const Strip& strip = strips[s];
    const Grading grading = strip_grading(sizes[s], topology.edges[strip.edges[0]].divisions);
    const std::vector<double> along = strip_distribution(layout, topology, strip, grading);
    const std::vector<double> against = strip_distribution(layout, topology, strip, reversed(grading));
    for (std::size_t k = 0; k < strip.edges.size(); ++k)
    {
      const int edge = strip.edges[k];
      t[edge] = has_own_grading(layout, topology, edge) ? own_distribution(layout, topology, edge)
                : strip.reversed[k]                     ? against
                                                        : along;
    }
  }
  return t;
}

}  // namespace blockfsi::block
