#pragma once

#include "block/layout.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi::block
{

/// Adds points, blocks, edges and boundaries of one named piece to a layout; what all builders share.
class Piece
{
public:
  Piece(Layout& layout, std::string name, std::string region, Location where)
      : layout_(layout), name_(std::move(name)), region_(std::move(region)), where_(std::move(where))
  {
  }

  /// Throws Error that names the piece.
  [[noreturn]] void fail(const std::string& message) const;
  /// Throws Error unless the condition holds.
  void require(bool condition, const std::string& message) const;

  /// A point "NAME what"; its index.
  int point(std::string_view what, const std::array<double, 3>& x);
  /// A block "NAME what".
  void block(std::string_view what, element::Shape shape, std::vector<int> points);
  /// What is known of the edge from a to b.
  Edge& edge(int a, int b);
  /// A boundary "NAME what" of edges.
  void boundary(std::string_view what, std::vector<std::array<int, 2>> edges);
  /// A boundary "NAME what" of faces.
  void boundary(std::string_view what, std::vector<std::vector<int>> faces);
  /// The geometry of a face.
  void face(std::vector<int> points, FaceGeometry geometry);

private:
  Layout& layout_;
  std::string name_;
  std::string region_;
  Location where_;
};

}  // namespace blockfsi::block
