#include "block/edge_lines.hpp"

#include "block/face_shape.hpp"
#include "block/message.hpp"
#include "block/numbering.hpp"
#include "block/topology.hpp"
#include "element/line.hpp"

#include <algorithm>

namespace blockfsi::block
{

namespace
{

/// Where cells of a skeleton's edge end.
std::vector<std::array<double, 3>> cell_ends(const Skeleton& skeleton, const PlacedEdge& edge)
{
  std::vector<std::array<double, 3>> ends;
  for (int i = 1; i < edge.divisions; ++i)
    ends.push_back(node_position(skeleton, edge.first + static_cast<std::int64_t>(i) * skeleton.order - 1));
  return ends;
}

}  // namespace

std::vector<EdgeLine> edge_lines(const Layout& given, const Skeleton& skeleton, int order, int pieces)
{
  const Layout layout = with_curves_on_faces(given);
  const Topology topology = make_topology(layout);
  const std::vector<double> inner = element::lobatto(order);
  std::vector<EdgeLine> lines;
  for (std::size_t e = 0; e < topology.edges.size(); ++e)
  {
    EdgeLine line;
    line.pieces = is_straight(layout, topology, static_cast<int>(e)) ? 1 : pieces;
    const geometry::Path path = edge_path(layout, topology, static_cast<int>(e));
    line.x.push_back(path.evaluate(0.0));
    for (int piece = 0; piece < line.pieces; ++piece)
      for (int i = 1; i <= order; ++i)
        line.x.push_back(path.evaluate((piece + inner[i]) / line.pieces));
    if (!std::all_of(line.x.begin(), line.x.end(), geometry::is_finite))
      throw mistake(layout.edges[topology.info[e]].where,
                    "the curve of the edge " + edge_text(layout, topology.edges[e].a, topology.edges[e].b) +
                        " has no finite value somewhere between its ends; correct its formula");
    line.cell_ends = cell_ends(skeleton, skeleton.edges[e]);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace blockfsi::block
