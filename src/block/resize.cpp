#include "block/resize.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace blockfsi::block
{

namespace
{

int times(int divisions, double factor)
{
  return std::max(1, static_cast<int>(std::lround(divisions * factor)));
}

}  // namespace

Layout resized(const Layout& layout, int order, double factor)
{
  Layout result = layout;
  result.order = order;
  if (factor == 1.0)
    return result;
  for (Edge& edge : result.edges)
  {
    if (edge.grading && cell_count(*edge.grading))
      throw Error(edge.where,
                  fmt::format("the cells of the edge {} - {} are listed one by one, so there cannot "
                              "be {:g} times as many; grade it by a law",
                              layout.points[edge.a].name, layout.points[edge.b].name, factor));
    if (edge.divisions)
      edge.divisions = times(*edge.divisions, factor);
  }
  if (result.default_divisions > 0)
    result.default_divisions = times(result.default_divisions, factor);
  return result;
}

}  // namespace blockfsi::block
