#include "block/piece.hpp"

#include "block/message.hpp"

#include <fmt/format.h>

#include <utility>

namespace blockfsi::block
{

void Piece::fail(const std::string& message) const
{
  throw mistake(where_, fmt::format("'{}': {}", name_, message));
}

void Piece::require(bool condition, const std::string& message) const
{
  if (!condition)
    fail(message);
}

int Piece::point(std::string_view what, const std::array<double, 3>& x)
{
  layout_.points.push_back({fmt::format("{} {}", name_, what), x, where_});
  return static_cast<int>(layout_.points.size()) - 1;
}

void Piece::block(std::string_view what, element::Shape shape, std::vector<int> points)
{
  Block block;
  block.name = fmt::format("{} {}", name_, what);
  block.region = region_;
  block.points = std::move(points);
  block.where = where_;
  block.shape = shape;
  layout_.blocks.push_back(std::move(block));
}

Edge& Piece::edge(int a, int b)
{
  for (Edge& edge : layout_.edges)
    if ((edge.a == a && edge.b == b) || (edge.a == b && edge.b == a))
      return edge;
  Edge edge;
  edge.a = a;
  edge.b = b;
  edge.where = where_;
  layout_.edges.push_back(std::move(edge));
  return layout_.edges.back();
}

void Piece::boundary(std::string_view what, std::vector<std::array<int, 2>> edges)
{
  layout_.boundaries.push_back({fmt::format("{} {}", name_, what), ByEdges{std::move(edges)}, where_, true});
}

void Piece::boundary(std::string_view what, std::vector<std::vector<int>> faces)
{
  layout_.boundaries.push_back({fmt::format("{} {}", name_, what), ByFaces{std::move(faces)}, where_, true});
}

void Piece::face(std::vector<int> points, FaceGeometry geometry)
{
  layout_.faces.push_back({std::move(points), std::move(geometry), where_});
}

}  // namespace blockfsi::block
