#include "mesh/split.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace blockfsi::mesh
{

namespace
{

using element::Shape;

Mean corner(int c)
{
  return static_cast<Mean>(1U << static_cast<unsigned>(c));
}

Mean join(Mean a, Mean b)
{
  return static_cast<Mean>(a | b);
}

/// Corners of a side in turn, counter-clockwise seen from outside.
std::vector<int> turn(const element::SideShape& side)
{
  std::vector<int> corners(side.corners.begin(), side.corners.begin() + element::corner_count(side.shape));
  if (!side.outward)
    std::reverse(corners.begin() + 1, corners.end());
  return corners;
}

/// Six times the volume of a tetrahedron between corners of a cell.
double volume(Shape shape, const std::array<int, 4>& tetrahedron)
{
  std::array<std::array<double, 3>, 3> edge{};
  const auto corners = element::corners(shape);
  for (int e = 0; e < 3; ++e)
    for (int d = 0; d < 3; ++d)
      edge[e][d] = corners[tetrahedron[e + 1]][d] - corners[tetrahedron[0]][d];
  const auto& [a, b, c] = edge;
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

CellPart tetrahedron(Shape shape, std::array<int, 4> corners)
{
  if (volume(shape, corners) < 0.0)
    std::swap(corners[0], corners[1]);
  CellPart part{Shape::tetrahedron, {}};
  for (int c = 0; c < 4; ++c)
    part.corners[c] = corner(corners[c]);
  return part;
}

/// Triangles of a side, cut through its corner of the lowest number if it is a quadrilateral.
std::vector<std::array<int, 3>> triangles(const element::SideShape& side,
                                          std::span<const std::int32_t> numbers)
{
  std::vector<int> corners = turn(side);
  if (corners.size() == 3)
    return {{corners[0], corners[1], corners[2]}};
  const auto lowest =
      std::min_element(corners.begin(), corners.end(), [&](int a, int b) { return numbers[a] < numbers[b]; });
  std::rotate(corners.begin(), lowest, corners.end());
  return {{corners[0], corners[1], corners[2]}, {corners[0], corners[2], corners[3]}};
}

/// If the cuts of the three sides of a hexahedron away from `lowest` all avoid the corner opposite to it,
/// they are edges of a tetrahedron in the middle, with one more at each corner that is not its own.
std::vector<CellPart> five_tetrahedra(int lowest)
{
  const auto corners = element::corners(Shape::hexahedron);
  const auto is_even = [&](int c)
  { return (static_cast<int>(corners[c][0] + corners[c][1] + corners[c][2]) % 2) == 0; };
  std::array<int, 4> middle{};
  std::vector<CellPart> parts;
  int count = 0;
  for (int c = 0; c < 8; ++c)
    if (is_even(c) == is_even(lowest))
      middle[count++] = c;
  parts.push_back(tetrahedron(Shape::hexahedron, middle));
  for (int c = 0; c < 8; ++c)
  {
    if (is_even(c) == is_even(lowest))
      continue;
    std::array<int, 4> at = {c, 0, 0, 0};
    int next = 1;
    for (const auto& [a, b] : element::edges(Shape::hexahedron))
      if (a == c || b == c)
        at[next++] = a == c ? b : a;
    parts.push_back(tetrahedron(Shape::hexahedron, at));
  }
  return parts;
}

}  // namespace

element::Point mean_point(Shape shape, Mean mean)
{
  element::Point point{};
  const auto corners = element::corners(shape);
  for (std::size_t c = 0; c < corners.size(); ++c)
    for (int d = 0; d < 3 && (mean >> c & 1U) != 0; ++d)
      point[d] += corners[c][d];
  for (double& coordinate : point)
    coordinate /= std::popcount(mean);
  return point;
}

Mean all_corners(Shape shape)
{
  return static_cast<Mean>((1U << static_cast<unsigned>(element::corner_count(shape))) - 1U);
}

Mean side_corners(Shape shape, int side)
{
  const element::SideShape& of = element::sides(shape)[side];
  Mean mean = 0;
  for (int c = 0; c < element::corner_count(of.shape); ++c)
    mean = join(mean, corner(of.corners[c]));
  return mean;
}

std::vector<CellPart> whole(Shape shape)
{
  CellPart part{shape, {}};
  for (int c = 0; c < element::corner_count(shape); ++c)
    part.corners[c] = corner(c);
  return {part};
}

std::vector<CellPart> two_triangles(bool from_first)
{
  if (from_first)
    return {{Shape::triangle, {corner(0), corner(1), corner(2)}},
            {Shape::triangle, {corner(0), corner(2), corner(3)}}};
  return {{Shape::triangle, {corner(0), corner(1), corner(3)}},
          {Shape::triangle, {corner(1), corner(2), corner(3)}}};
}

std::vector<CellPart> four_triangles()
{
  std::vector<CellPart> parts;
  for (int c = 0; c < 4; ++c)
    parts.push_back({Shape::triangle, {corner(c), corner((c + 1) % 4), all_corners(Shape::quadrilateral)}});
  return parts;
}

std::vector<CellPart> quadrilaterals(Shape shape)
{
  const int count = element::corner_count(shape);
  std::vector<CellPart> parts;
  for (int c = 0; c < count; ++c)
    parts.push_back({Shape::quadrilateral,
                     {corner(c), join(corner(c), corner((c + 1) % count)), all_corners(shape),
                      join(corner(c), corner((c + count - 1) % count))}});
  return parts;
}

std::vector<CellPart> tetrahedra(Shape shape, std::span<const std::int32_t> numbers)
{
  if (shape == Shape::tetrahedron)
    return whole(shape);
  const auto count = static_cast<std::size_t>(element::corner_count(shape));
  const int lowest = static_cast<int>(
      std::min_element(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count)) -
      numbers.begin());
  // Cones from the corner of the lowest number over the triangles of the sides away from it.
  std::vector<CellPart> parts;
  std::array<int, 8> uses{};
  for (int side = 0; side < static_cast<int>(element::sides(shape).size()); ++side)
  {
    if ((side_corners(shape, side) & corner(lowest)) != 0)
      continue;
    for (const auto& [a, b, c] : triangles(element::sides(shape)[side], numbers))
    {
      parts.push_back(tetrahedron(shape, {lowest, a, b, c}));
      for (const int used : {a, b, c})
        ++uses[used];
    }
  }
  if (shape != Shape::hexahedron)
    return parts;
  // The corner opposite to the lowest is on all three sides away from it. No cut meets it if it is in just
  // one triangle of each.
  int opposite = 0;
  for (int c = 0; c < 8; ++c)
  {
    double distance = 0.0;
    for (int d = 0; d < 3; ++d)
      distance += std::abs(element::corners(shape)[c][d] - element::corners(shape)[lowest][d]);
    if (distance > 2.5)
      opposite = c;
  }
  return uses[opposite] == 3 ? five_tetrahedra(lowest) : parts;
}

std::vector<CellPart> hexahedra(Shape shape)
{
  if (shape == Shape::pyramid)
    return {};
  // At every corner of a cell three edges meet: the part there has the corner, the middles of the edges, of
  // the sides between them, and of the cell.
  std::vector<CellPart> parts;
  for (int c = 0; c < element::corner_count(shape); ++c)
  {
    std::vector<int> ends;
    for (const auto& [a, b] : element::edges(shape))
      if (a == c || b == c)
        ends.push_back(a == c ? b : a);
    if (volume(shape, {c, ends[0], ends[1], ends[2]}) < 0.0)
      std::swap(ends[0], ends[1]);
    const auto between = [&](int a, int b)
    {
      const Mean three = join(corner(c), join(corner(a), corner(b)));
      for (int side = 0; side < static_cast<int>(element::sides(shape).size()); ++side)
        if ((side_corners(shape, side) & three) == three)
          return side_corners(shape, side);
      return Mean{0};
    };
    const auto middle = [&](int a) { return join(corner(c), corner(a)); };
    parts.push_back({Shape::hexahedron,
                     {corner(c), middle(ends[0]), between(ends[0], ends[1]), middle(ends[1]), middle(ends[2]),
                      between(ends[0], ends[2]), all_corners(shape), between(ends[1], ends[2])}});
  }
  return parts;
}

}  // namespace blockfsi::mesh
