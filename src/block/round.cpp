#include "block/round.hpp"

#include "block/piece.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace blockfsi::block
{

namespace
{

using Corner = std::array<double, 3>;
using element::Shape;

constexpr std::array<const char*, 4> diagonals = {"sw", "se", "ne", "nw"};

/// The point at an angle [degrees] about a centre, in the plane across z.
Corner on_circle(const Corner& center, double radius, double degrees)
{
  const double angle = degrees * std::numbers::pi / 180.0;
  return {center[0] + radius * std::cos(angle), center[1] + radius * std::sin(angle), center[2]};
}

/// The four points of a circle or a square on the diagonals, from south-west counter-clockwise.
std::array<int, 4> diagonal_points(Piece& piece, std::string_view what, const Corner& center, double radius)
{
  std::array<int, 4> points{};
  for (int k = 0; k < 4; ++k)
    points[k] =
        piece.point(fmt::format("{} {}", what, diagonals[k]), on_circle(center, radius, -135.0 + 90.0 * k));
  return points;
}

/// The corners of a cube in a sphere, in the order of element::corners.
std::array<int, 8> cube_points(Piece& piece, std::string_view what, const Corner& center, double radius)
{
  std::array<int, 8> points{};
  const double half = radius / std::numbers::sqrt3;
  for (int k = 0; k < 8; ++k)
  {
    const Corner& unit = element::corners(Shape::hexahedron)[k];
    points[k] = piece.point(fmt::format("{} {}", what, k), {center[0] + half * (2.0 * unit[0] - 1.0),
                                                            center[1] + half * (2.0 * unit[1] - 1.0),
                                                            center[2] + half * (2.0 * unit[2] - 1.0)});
  }
  return points;
}

void divide(Piece& piece, int a, int b, int count, const std::optional<Grading>& grading = {})
{
  Edge& edge = piece.edge(a, b);
  edge.divisions = count;
  if (grading)
    edge.grading = edge.a == a ? *grading : reversed(*grading);
}

void check_counts(const Piece& piece, int around, int radial)
{
  piece.require(around >= 1 && radial >= 1,
                fmt::format("found {} cells around and {} across, both must be at least 1", around, radial));
}

/// Of a disc or a ball.
template <typename Round>
void check_o_grid(const Piece& piece, const Round& round)
{
  piece.require(round.radius > 0.0, fmt::format("the radius is {:g} m, it must be positive", round.radius));
  piece.require(round.core > 0.0 && round.core < 1.0,
                fmt::format("the size of the core is {:g} radii, it must lie between 0 and 1", round.core));
  check_counts(piece, round.around, round.radial);
}

/// Six blocks between two cubes of points, with the faces of either cube on a sphere where asked.
std::array<std::vector<std::vector<int>>, 2> between_cubes(Piece& piece, const std::array<int, 8>& inner,
                                                           const std::array<int, 8>& outer, int around,
                                                           int radial, const std::optional<Grading>& grading)
{
  std::array<std::vector<std::vector<int>>, 2> faces;
  constexpr std::array<const char*, 6> names = {"bottom", "south", "east", "north", "west", "top"};
  const auto sides = element::sides(Shape::hexahedron);
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    // Counter-clockwise seen from outside, so that the third direction points outwards.
    std::array<int, 4> corner{};
    std::copy_n(sides[s].corners.begin(), 4, corner.begin());
    if (!sides[s].outward)
      std::swap(corner[1], corner[3]);
    std::vector<int> below;
    std::vector<int> above;
    for (const int c : corner)
    {
      below.push_back(inner[c]);
      above.push_back(outer[c]);
    }
    faces[0].push_back(below);
    faces[1].push_back(above);
    std::vector<int> points = below;
    points.insert(points.end(), above.begin(), above.end());
    piece.block(names[s], Shape::hexahedron, std::move(points));
  }
  for (int k = 0; k < 8; ++k)
    divide(piece, inner[k], outer[k], radial, grading);
  for (const auto& [a, b] : element::edges(Shape::hexahedron))
    divide(piece, outer[a], outer[b], around);
  return faces;
}

/// Puts the faces of a cube of points on a sphere and their edges on great circles.
void onto_sphere(Piece& piece, const std::array<int, 8>& points, const std::vector<std::vector<int>>& faces,
                 const Corner& center, double radius)
{
  for (const auto& [a, b] : element::edges(Shape::hexahedron))
    piece.edge(points[a], points[b]).curve = geometry::Arc{center};
  for (const std::vector<int>& face : faces)
    piece.face(face, OnSurface{geometry::Sphere{center, radius}});
}

}  // namespace

void add(Layout& layout, const Disc& disc)
{
  Piece piece(layout, disc.name, disc.region, disc.where);
  check_o_grid(piece, disc);
  const auto core = diagonal_points(piece, "core", disc.center, disc.core * disc.radius);
  const auto wall = diagonal_points(piece, "wall", disc.center, disc.radius);
  piece.block("core", Shape::quadrilateral, {core.begin(), core.end()});
  constexpr std::array<const char*, 4> names = {"south", "east", "north", "west"};
  std::vector<std::array<int, 2>> sides;
  for (int k = 0; k < 4; ++k)
  {
    const int next = (k + 1) % 4;
    piece.block(names[k], Shape::quadrilateral, {wall[k], wall[next], core[next], core[k]});
    piece.edge(wall[k], wall[next]).curve = geometry::Arc{disc.center};
    divide(piece, wall[k], wall[next], disc.around);
    divide(piece, core[k], wall[k], disc.radial, disc.grading);
    sides.push_back({wall[k], wall[next]});
  }
  piece.boundary("wall", std::move(sides));
}

void add(Layout& layout, const Annulus& annulus)
{
  Piece piece(layout, annulus.name, annulus.region, annulus.where);
  const double turn = annulus.to - annulus.from;
  const bool whole = std::abs(turn - 360.0) < 1e-9;
  piece.require(annulus.radii[0] > 0.0 && annulus.radii[1] > annulus.radii[0],
                fmt::format("the radii are {:g} and {:g} m; they must ascend from above 0", annulus.radii[0],
                            annulus.radii[1]));
  piece.require(turn > 0.0 && turn < 360.0 + 1e-9,
                fmt::format("it goes from {:g} to {:g} degrees; it must go forward, once round at most",
                            annulus.from, annulus.to));
  piece.require(
      annulus.sectors >= 1 && turn / annulus.sectors < 180.0,
      fmt::format("{} blocks around leave an angle of 180 degrees or more to each; take at least {}",
                  annulus.sectors, static_cast<int>(turn / 180.0) + 1));
  check_counts(piece, annulus.around, annulus.radial);
  const int count = annulus.sectors + (whole ? 0 : 1);
  std::array<std::vector<int>, 2> ring;
  for (int r = 0; r < 2; ++r)
    for (int k = 0; k < count; ++k)
      ring[r].push_back(piece.point(
          fmt::format("{} {}", r == 0 ? "inner" : "outer", k),
          on_circle(annulus.center, annulus.radii[r], annulus.from + turn * k / annulus.sectors)));
  std::array<std::vector<std::array<int, 2>>, 2> sides;
  for (int k = 0; k < annulus.sectors; ++k)
  {
    const int next = (k + 1) % count;
    piece.block(std::to_string(k), Shape::quadrilateral,
                {ring[0][k], ring[1][k], ring[1][next], ring[0][next]});
    for (int r = 0; r < 2; ++r)
    {
      piece.edge(ring[r][k], ring[r][next]).curve = geometry::Arc{annulus.center};
      sides[r].push_back({ring[r][k], ring[r][next]});
    }
    divide(piece, ring[0][k], ring[0][next], annulus.around);
  }
  for (int k = 0; k < count; ++k)
    divide(piece, ring[0][k], ring[1][k], annulus.radial, annulus.grading);
  piece.boundary("inner", std::move(sides[0]));
  piece.boundary("outer", std::move(sides[1]));
  if (whole)
    return;
  piece.boundary("start", std::vector<std::array<int, 2>>{{ring[0].front(), ring[1].front()}});
  piece.boundary("end", std::vector<std::array<int, 2>>{{ring[0].back(), ring[1].back()}});
}

void add(Layout& layout, const Ball& ball)
{
  Piece piece(layout, ball.name, ball.region, ball.where);
  piece.require(layout.dim == 3, "a ball needs three dimensions; say dim = 3");
  check_o_grid(piece, ball);
  const auto core = cube_points(piece, "core", ball.center, ball.core * ball.radius);
  const auto wall = cube_points(piece, "wall", ball.center, ball.radius);
  piece.block("core", Shape::hexahedron, {core.begin(), core.end()});
  auto faces = between_cubes(piece, core, wall, ball.around, ball.radial, ball.grading);
  onto_sphere(piece, wall, faces[1], ball.center, ball.radius);
  piece.boundary("wall", std::move(faces[1]));
}

void add(Layout& layout, const Shell& shell)
{
  Piece piece(layout, shell.name, shell.region, shell.where);
  piece.require(layout.dim == 3, "a shell needs three dimensions; say dim = 3");
  piece.require(shell.radii[0] > 0.0 && shell.radii[1] > shell.radii[0],
                fmt::format("the radii are {:g} and {:g} m; they must ascend from above 0", shell.radii[0],
                            shell.radii[1]));
  check_counts(piece, shell.around, shell.radial);
  const auto inner = cube_points(piece, "inner", shell.center, shell.radii[0]);
  const auto outer = cube_points(piece, "outer", shell.center, shell.radii[1]);
  auto faces = between_cubes(piece, inner, outer, shell.around, shell.radial, shell.grading);
  onto_sphere(piece, inner, faces[0], shell.center, shell.radii[0]);
  onto_sphere(piece, outer, faces[1], shell.center, shell.radii[1]);
  piece.boundary("inner", std::move(faces[0]));
  piece.boundary("outer", std::move(faces[1]));
}

void add(Layout& layout, const Box& box)
{
  Piece piece(layout, box.name, box.region, box.where);
  const Shape shape = layout.dim == 3 ? Shape::hexahedron : Shape::quadrilateral;
  for (int c = 0; c < layout.dim; ++c)
    piece.require(box.to[c] > box.from[c], fmt::format("it goes from {:g} to {:g} m along {}; it must ascend",
                                                       box.from[c], box.to[c], "xyz"[c]));
  std::vector<int> points;
  for (const Corner& unit : element::corners(shape))
  {
    Corner x = box.from;
    for (int c = 0; c < layout.dim; ++c)
      x[c] = unit[c] > 0.0 ? box.to[c] : box.from[c];
    points.push_back(piece.point(std::to_string(points.size()), x));
  }
  const auto edges = element::edges(shape);
  for (const auto& [a, b] : edges)
    for (int c = 0; c < layout.dim; ++c)
      if (element::corners(shape)[a][c] != element::corners(shape)[b][c])
        divide(piece, points[a], points[b], box.divisions[c], box.gradings[c]);
  constexpr std::array<const char*, 4> in_plane = {"y0", "x1", "y1", "x0"};
  constexpr std::array<const char*, 6> in_space = {"z0", "y0", "x1", "y1", "x0", "z1"};
  const auto sides = element::sides(shape);
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    std::vector<int> corners;
    for (int c = 0; c < element::corner_count(sides[s].shape); ++c)
      corners.push_back(points[sides[s].corners[c]]);
    if (layout.dim == 3)
      piece.boundary(in_space[s], std::vector<std::vector<int>>{corners});
    else
      piece.boundary(in_plane[s], std::vector<std::array<int, 2>>{{corners[0], corners[1]}});
  }
  piece.block("block", shape, std::move(points));
}

}  // namespace blockfsi::block
