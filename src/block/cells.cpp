#include "block/cells.hpp"

#include <algorithm>

namespace blockfsi::block
{

namespace
{

using element::LatticePoint;
using element::Shape;

LatticePoint difference(const LatticePoint& a, const LatticePoint& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Corner of a cell at reference coordinates, or its first corner if there is none.
int corner_at(Shape shape, const std::array<double, 3>& x)
{
  const auto all = element::corners(shape);
  const auto found = std::find(all.begin(), all.end(), x);
  return found == all.end() ? 0 : static_cast<int>(found - all.begin());
}

/// What coordinates of a box tell whether it reaches a wall: weights of i, j and k.
LatticePoint reach(Shape block, Wall wall)
{
  const bool triangular = block == Shape::triangle || block == Shape::prism;
  switch (wall)
  {
  case Wall::right:
    if (block == Shape::tetrahedron)
      return {1, 1, 1};
    if (block == Shape::pyramid)
      return {1, 0, 1};
    return triangular ? LatticePoint{1, 1, 0} : LatticePoint{1, 0, 0};
  case Wall::back:
    return block == Shape::pyramid ? LatticePoint{0, 1, 1} : LatticePoint{0, 1, 0};
  case Wall::top:
  case Wall::bottom:
    return {0, 0, 1};
  case Wall::front:
    return {0, 1, 0};
  case Wall::left:
    return {1, 0, 0};
  }
  return {};
}

int dot(const LatticePoint& a, const LatticePoint& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Sides of the cell that may lie on sides of the block.
std::vector<CellKind::OnWall> find_walls(Shape block, Shape cell, const std::vector<LatticePoint>& corners)
{
  std::vector<CellKind::OnWall> walls;
  const auto sides = element::sides(cell);
  for (int w = 0; w < wall_count; ++w)
  {
    const auto wall = static_cast<Wall>(w);
    if (side_at(block, wall) < 0)
      continue;
    const LatticePoint weights = reach(block, wall);
    const bool low = wall == Wall::bottom || wall == Wall::front || wall == Wall::left;
    for (std::size_t s = 0; s < sides.size(); ++s)
    {
      const int first = dot(weights, corners[sides[s].corners[0]]);
      bool level = !low || first == 0;
      for (int c = 0; c < element::corner_count(sides[s].shape); ++c)
        level = level && dot(weights, corners[sides[s].corners[c]]) == first;
      if (level)
        walls.push_back({wall, static_cast<int>(s), first});
    }
  }
  return walls;
}

/// A cell over some corners of the lattice, relative to its box.
CellKind make_kind(Shape block, Shape cell, const std::vector<LatticePoint>& corners, int order)
{
  CellKind kind;
  kind.shape = cell;
  const LatticePoint origin = corners[0];
  const LatticePoint xi = difference(corners[corner_at(cell, {1, 0, 0})], origin);
  const LatticePoint eta = difference(corners[corner_at(cell, {0, 1, 0})], origin);
  const LatticePoint zeta = difference(corners[corner_at(cell, {0, 0, 1})], origin);
  for (const LatticePoint& p : element::lattice_points(cell, order))
  {
    LatticePoint node{};
    for (int d = 0; d < 3; ++d)
      node[d] = order * origin[d] + p[0] * xi[d] + p[1] * eta[d] + p[2] * zeta[d];
    kind.nodes.push_back(node);
  }
  kind.walls = find_walls(block, cell, corners);
  return kind;
}

CellKind shortened(CellKind kind, int shorter, bool in_last_row = true)
{
  kind.shorter = shorter;
  kind.in_last_row = in_last_row;
  return kind;
}

int volume(const std::vector<LatticePoint>& p)
{
  const LatticePoint a = difference(p[1], p[0]);
  const LatticePoint b = difference(p[2], p[0]);
  const LatticePoint c = difference(p[3], p[0]);
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

std::vector<CellKind> tetrahedron_kinds(int order, int diagonal)
{
  constexpr auto T = Shape::tetrahedron;
  std::vector<CellKind> kinds{make_kind(T, T, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, order)};
  // The octahedron between four upright ones: a unit vector and the sum of the other two are opposite.
  constexpr std::array<std::array<LatticePoint, 2>, 3> pairs{
      {{{{1, 0, 0}, {0, 1, 1}}}, {{{0, 1, 0}, {1, 0, 1}}}, {{{0, 0, 1}, {1, 1, 0}}}}};
  const auto& [from, to] = pairs[diagonal];
  const auto& [b, d] = pairs[(diagonal + 1) % 3];
  const auto& [c, e] = pairs[(diagonal + 2) % 3];
  for (const auto& [p, q] : {std::array{b, c}, std::array{c, d}, std::array{d, e}, std::array{e, b}})
  {
    std::vector<LatticePoint> corners{from, to, p, q};
    if (volume(corners) < 0)
      std::swap(corners[2], corners[3]);
    kinds.push_back(shortened(make_kind(T, T, corners, order), 1));
  }
  kinds.push_back(shortened(make_kind(T, T, {{1, 1, 0}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, order), 2));
  return kinds;
}

std::vector<CellKind> pyramid_kinds(int order)
{
  constexpr auto P = Shape::pyramid;
  constexpr auto T = Shape::tetrahedron;
  std::vector<CellKind> kinds;
  kinds.push_back(make_kind(P, P, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}}, order));
  kinds.push_back(shortened(make_kind(P, T, {{1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}}, order), 0, false));
  kinds.push_back(shortened(make_kind(P, T, {{1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}}, order), 1));
  kinds.push_back(
      shortened(make_kind(P, P, {{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}, {1, 1, 0}}, order), 1, false));
  return kinds;
}

std::vector<CellKind> make_kinds(Shape shape, int order, int diagonal)
{
  switch (shape)
  {
  case Shape::triangle:
    return {make_kind(shape, shape, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, order),
            shortened(make_kind(shape, shape, {{1, 1, 0}, {0, 1, 0}, {1, 0, 0}}, order), 1)};
  case Shape::prism:
    return {
        make_kind(shape, shape, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, order),
        shortened(make_kind(shape, shape, {{1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 1}, {1, 0, 1}},
                            order),
                  1)};
  case Shape::tetrahedron:
    return tetrahedron_kinds(order, diagonal);
  case Shape::pyramid:
    return pyramid_kinds(order);
  default:
  {
    std::vector<LatticePoint> corners;
    for (const auto& x : element::corners(shape))
      corners.push_back({static_cast<int>(x[0]), static_cast<int>(x[1]), static_cast<int>(x[2])});
    return {make_kind(shape, shape, corners, order)};
  }
  }
}

}  // namespace

BlockCells::BlockCells(const Grid& cells, int order, int diagonal)
    : cells_(cells), order_(order), levels_(std::max(cells.steps[2], 1)),
      kinds_(make_kinds(cells.shape, order, diagonal))
{
  for (int k = 0; k < levels_; ++k)
  {
    level_begin_.push_back(static_cast<std::int32_t>(row_begin_.size()));
    for (int j = 0; j < row_count(k); ++j)
    {
      row_begin_.push_back(count_);
      for (const CellKind& kind : kinds_)
        count_ += count_in_row(kind, j, k);
    }
  }
  row_begin_.push_back(count_);

  const std::size_t n = static_cast<std::size_t>(order) + 1;
  local_.assign(kinds_.size() * n * n * n, -1);
  for (std::size_t q = 0; q < kinds_.size(); ++q)
    for (std::size_t m = 0; m < kinds_[q].nodes.size(); ++m)
    {
      const LatticePoint& p = kinds_[q].nodes[m];
      local_[p[0] + n * (p[1] + n * (p[2] + n * q))] = static_cast<std::int16_t>(m);
    }
}

int BlockCells::row_count(int k) const
{
  return cells_.shape == Shape::segment ? 1 : block::row_count(cells_, k) - 1;
}

int BlockCells::box_count(int j, int k) const
{
  return row_length(cells_, j, k) - 1;
}

int BlockCells::count_in_row(const CellKind& kind, int j, int k) const
{
  if (!kind.in_last_row && j + 1 == row_count(k))
    return 0;
  return std::max(box_count(j, k) - kind.shorter, 0);
}

std::int64_t BlockCells::count_of(const CellKind& kind) const
{
  std::int64_t count = 0;
  for (int k = 0; k < levels_; ++k)
    for (int j = 0; j < row_count(k); ++j)
      count += count_in_row(kind, j, k);
  return count;
}

std::int64_t BlockCells::number(int i, int j, int k, std::size_t kind) const
{
  std::int64_t result = row_begin(j, k);
  for (std::size_t q = 0; q < kinds_.size(); ++q)
  {
    const int in_row = count_in_row(kinds_[q], j, k);
    result += std::min(i, in_row) + (q < kind && i < in_row ? 1 : 0);
  }
  return result;
}

BlockCells::Found BlockCells::find(const LatticePoint& node) const
{
  const int n = order_ + 1;
  LatticePoint low{};
  LatticePoint high{};
  for (int d = 0; d < 3; ++d)
  {
    low[d] = std::max((node[d] - 1) / order_, 0);
    high[d] = node[d] / order_;
  }
  for (int k = low[2]; k <= std::min(high[2], levels_ - 1); ++k)
    for (int j = low[1]; j <= std::min(high[1], row_count(k) - 1); ++j)
      for (int i = low[0]; i <= std::min(high[0], box_count(j, k) - 1); ++i)
      {
        const int offset = (node[0] - order_ * i) + n * ((node[1] - order_ * j) + n * (node[2] - order_ * k));
        for (std::size_t q = 0; q < kinds_.size(); ++q)
        {
          const int local = local_[offset + static_cast<std::size_t>(n) * n * n * q];
          if (local >= 0 && i < count_in_row(kinds_[q], j, k))
            return {{i, j, k}, static_cast<int>(q), local};
        }
      }
  return {{}, -1, -1};
}

std::int64_t BlockCells::lowest_cell(const LatticePoint& node) const
{
  const Found found = find(node);
  return number(found.box[0], found.box[1], found.box[2], static_cast<std::size_t>(found.kind));
}

BlockCells::Boxes BlockCells::on_wall(const CellKind::OnWall& side, const CellKind& kind, int j, int k) const
{
  const int last = count_in_row(kind, j, k) - 1;
  const LatticePoint weights = reach(cells_.shape, side.wall);
  switch (side.wall)
  {
  case Wall::left:
    return {0, std::min(0, last)};
  case Wall::front:
    return {0, j == 0 ? last : -1};
  case Wall::bottom:
    return {0, k == 0 ? last : -1};
  default:
    break;
  }
  // Along the row the wall is reached by one box (right) or by all of them.
  const int end = side.wall == Wall::top ? cells_.steps[2] : cells_.steps[side.wall == Wall::right ? 0 : 1];
  const int rest = end - side.offset - weights[1] * j - weights[2] * k;
  if (side.wall != Wall::right)
    return {0, rest == 0 ? last : -1};
  return rest >= 0 && rest <= last ? Boxes{rest, rest} : Boxes{};
}

}  // namespace blockfsi::block
