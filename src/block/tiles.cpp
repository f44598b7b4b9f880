#include "block/tiles.hpp"

#include "block/numbering.hpp"
#include "block/topology.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>
#include <variant>

namespace blockfsi::block
{

namespace
{

using element::Shape;
using geometry::Point;

constexpr double flat_tolerance = 1e-12;  ///< of the size of the layout
constexpr int most_pieces = 16;           ///< of a side in one direction
constexpr int too_few_pieces = 6;
constexpr double safety = 1.5;  ///< for curvature that changes

/// Pieces of equal numbers of steps: as many as may be, or one for each step if no such number divides these.
int piece_count(int steps)
{
  for (int pieces = most_pieces; pieces >= too_few_pieces; --pieces)
    if (steps > 0 && steps % pieces == 0)
      return pieces;
  return steps;
}

/// How far a curve through three points in a row leaves the longer of its chords, for constant curvature k:
/// the middle one is k a b / 2 off the line between the others if it is a and b from them, and a curve leaves
/// a chord of length b by k b^2 / 8.
double bend(const Point& before, const Point& x, const Point& after)
{
  const Point chord = geometry::subtract(after, before);
  const Point first = geometry::subtract(x, before);
  const auto [shorter, longer] = std::minmax({geometry::norm(first), geometry::distance(x, after)});
  const double length = geometry::norm(chord);
  if (!(shorter > 0.0) || !(length > 0.0))
    return 0.0;
  return geometry::norm(geometry::cross(chord, first)) / length * longer / (4.0 * shorter);
}

/// Every so many-th node of an edge or of a face.
class Coarse
{
public:
  Coarse(const Skeleton& skeleton, const Grid& grid, std::vector<std::int32_t> numbers, bool is_curved)
      : skeleton_(skeleton), grid_(grid), numbers_(std::move(numbers)),
        is_curved_(is_curved), pieces_{piece_count(grid.steps[0]), piece_count(grid.steps[1])}
  {
  }

  int pieces(int d) const { return pieces_[d]; }

  /// The piece between some of these nodes.
  Tile tile(Tile::Of of, int entity, std::initializer_list<std::array<int, 2>> corners) const
  {
    Tile tile{of, entity, {}, 0, 0.0};
    double first = 0.0;
    double second = 0.0;
    for (const auto& [i, j] : corners)
    {
      tile.node[tile.count++] = node(i, j);
      first = std::max(first, bend_at(i, j, 1, 0));
      second = std::max(second, bend_at(i, j, 0, 1));
    }
    // Two nodes do not tell how curved is what lies between them.
    const bool is_known = !is_curved_ || (pieces_[0] > 1 && pieces_[1] != 1);
    tile.curvature = is_known ? safety * (first + second) : std::numeric_limits<double>::infinity();
    if (tile.count == 4)
    {
      const auto sum = [&](int a, int b) {
        return geometry::add(node_position(skeleton_, tile.node[a]), node_position(skeleton_, tile.node[b]));
      };
      tile.curvature += 0.25 * geometry::distance(sum(0, 2), sum(1, 3));
    }
    return tile;
  }

private:
  bool contains(int i, int j) const
  {
    return i >= 0 && j >= 0 &&
           (grid_.shape == Shape::triangle ? i + j <= pieces_[0] : i <= pieces_[0] && j <= pieces_[1]);
  }

  std::int32_t node(int i, int j) const
  {
    const int row = pieces_[1] == 0 ? 0 : j * (grid_.steps[1] / pieces_[1]);
    return numbers_[index(grid_, {i * (grid_.steps[0] / pieces_[0]), row, 0})];
  }

  double bend_at(int i, int j, int di, int dj) const
  {
    if (!contains(i - di, j - dj) || !contains(i + di, j + dj))
      return 0.0;
    return bend(node_position(skeleton_, node(i - di, j - dj)), node_position(skeleton_, node(i, j)),
                node_position(skeleton_, node(i + di, j + dj)));
  }

  const Skeleton& skeleton_;
  Grid grid_;
  std::vector<std::int32_t> numbers_;
  bool is_curved_;
  std::array<int, 2> pieces_;
};

class Maker
{
public:
  Maker(const Layout& layout, const Skeleton& skeleton)
      : skeleton_(skeleton), tolerance_(flat_tolerance * layout_size(layout))
  {
    for (const Edge& edge : layout.edges)
      if (!std::holds_alternative<geometry::Segment>(edge.curve))
        curves_.insert(std::minmax(edge.a, edge.b));
  }

  std::vector<Tile> make()
  {
    for (int p = 0; p < static_cast<int>(skeleton_.point_count); ++p)
      tiles_.push_back({Tile::Of::point, p, {p}, 1, 0.0});
    std::vector<bool> is_outer(skeleton_.edges.size(), false);
    for (int side = 0; side < side_count(skeleton_); ++side)
      if (side_blocks(skeleton_, side).size() == 1)
        for (const int edge : side_edges(skeleton_, side))
          is_outer[edge] = true;
    for (int e = 0; e < static_cast<int>(skeleton_.edges.size()); ++e)
      if (is_outer[e] == (skeleton_.dim == 2))
        add_edge(e);
    for (int f = 0; f < static_cast<int>(skeleton_.faces.size()); ++f)
      if (skeleton_.faces[f].blocks.size() == 1)
        add_face(f);
    return std::move(tiles_);
  }

private:
  Point at(std::int64_t node) const { return node_position(skeleton_, node); }

  bool is_straight(int e) const
  {
    const PlacedEdge& edge = skeleton_.edges[e];
    if (edge.count == 0)
      return !curves_.contains(std::minmax(edge.a, edge.b));
    const Point a = at(edge.a);
    const Point along = geometry::subtract(at(edge.b), a);
    const double length = geometry::norm(along);
    for (std::int64_t node = edge.first; node < edge.first + edge.count; ++node)
      if (!(geometry::norm(geometry::cross(geometry::subtract(at(node), a), along)) <= tolerance_ * length))
        return false;
    return true;
  }

  /// Whether a face is a flat polygon.
  bool is_polygon(const PlacedFace& face) const
  {
    const int corners = element::corner_count(face.shape);
    for (int e = 0; e < corners; ++e)
      if (!is_straight(face.edges[e]))
        return false;
    const Point a = at(face.points[0]);
    const Point normal =
        geometry::cross(geometry::subtract(at(face.points[1]), a), geometry::subtract(at(face.points[2]), a));
    const double size = geometry::norm(normal);
    const auto is_near = [&](std::int64_t node)
    { return std::abs(geometry::dot(geometry::subtract(at(node), a), normal)) <= tolerance_ * size; };
    if (!is_near(face.points[corners - 1]))
      return false;
    for (std::int64_t node = face.first; node < face.first + face.count; ++node)
      if (!is_near(node))
        return false;
    return true;
  }

  void add_edge(int e)
  {
    const PlacedEdge& edge = skeleton_.edges[e];
    if (is_straight(e))
    {
      tiles_.push_back({Tile::Of::edge, e, {edge.a, edge.b}, 2, 0.0});
      return;
    }
    const int steps = static_cast<int>(edge.count) + 1;
    const Coarse coarse(skeleton_, {Shape::segment, {steps, 0, 0}}, edge_numbers(edge), true);
    for (int i = 0; i < coarse.pieces(0); ++i)
      tiles_.push_back(coarse.tile(Tile::Of::edge, e, {{i, 0}, {i + 1, 0}}));
  }

  void add_face(int f)
  {
    const PlacedFace& face = skeleton_.faces[f];
    const bool triangular = face.shape == Shape::triangle;
    if (is_polygon(face))
    {
      tiles_.push_back({Tile::Of::face, f, face.points, triangular ? 3 : 4, 0.0});
      return;
    }
    const bool is_curved = std::any_of(face.edges.begin(), face.edges.begin() + (triangular ? 3 : 4),
                                       [&](int edge) { return !is_straight(edge); });
    const Coarse coarse(skeleton_, face_grid(face, skeleton_.order), face_numbers(skeleton_, face),
                        is_curved);
    const auto add = [&](std::initializer_list<std::array<int, 2>> corners)
    { tiles_.push_back(coarse.tile(Tile::Of::face, f, corners)); };
    for (int j = 0; j < coarse.pieces(1); ++j)
      for (int i = 0; i < coarse.pieces(0) - (triangular ? j : 0); ++i)
        if (!triangular)
          add({{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
        else
        {
          add({{i, j}, {i + 1, j}, {i, j + 1}});
          if (i + j + 2 <= coarse.pieces(0))
            add({{i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
        }
  }

  const Skeleton& skeleton_;
  double tolerance_;
  std::set<std::pair<int, int>> curves_;  ///< ends of the edges that have one
  std::vector<Tile> tiles_;
};

}  // namespace

std::vector<Tile> make_tiles(const Layout& layout, const Skeleton& skeleton)
{
  return Maker(layout, skeleton).make();
}

}  // namespace blockfsi::block
