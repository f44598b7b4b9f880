#pragma once

#include "block/grading.hpp"
#include "block/layout.hpp"

#include <array>
#include <optional>
#include <string>

namespace blockfsi::block
{

/// A disc as an O-grid: a square in the middle and four blocks around it.
/// Points: "NAME core sw", "se", "ne", "nw" of the square, "NAME wall sw", ... on the circle. Boundary
/// "NAME wall". In three dimensions it lies across the z axis.
struct Disc
{
  std::string name;
  std::string region;
  std::array<double, 3> center{};  ///< [m]
  double radius = 1.0;             ///< [m]
  double core = 0.5;               ///< distance of the square's corners from the centre over the radius
  int around = 4;                  ///< cells along each side of the square
  int radial = 4;                  ///< cells between square and circle
  std::optional<Grading> grading;  ///< from the square to the circle
  Location where;
};

/// The ring between two circles, or a part of it. Points "NAME inner 0", ..., "NAME outer 0", ... by angle.
/// Boundaries "NAME inner", "NAME outer", of a part also "NAME start", "NAME end".
struct Annulus
{
  std::string name;
  std::string region;
  std::array<double, 3> center{};  ///< [m]
  std::array<double, 2> radii{};   ///< inner and outer [m], inner > 0
  double from = 0.0;               ///< where it starts, against the x axis [degrees]
  double to = 360.0;               ///< where it ends; 360 more than the start: a whole ring
  int sectors = 4;                 ///< blocks around
  int around = 8;                  ///< cells along each of them
  int radial = 4;                  ///< cells between the circles
  std::optional<Grading> grading;  ///< from the inner to the outer circle
  Location where;
};

/// What the flow goes round in a channel.
enum class Obstacle
{
  round,
  square
};

/// How the blocks lie about it.
enum class ObstacleGrid
{
  ring,  ///< O: blocks all round
  wake   ///< C: blocks at the front and the sides, which go on downstream on both sides of a wake
};

/// A channel along x from (0, 0) with an obstacle in it. A box around the obstacle is cut out of a lattice of
/// blocks; from it to the obstacle go four blocks, or, with a wake, three.
/// Boundaries "NAME inlet", "outlet", "bottom", "top", "obstacle".
struct Channel
{
  std::string name;
  std::string region;
  double length = 1.0;             ///< [m]
  double height = 1.0;             ///< [m]
  std::array<double, 2> center{};  ///< of the obstacle [m]
  double size = 0.1;               ///< diameter, or side of the square [m]
  double box = 0.2;                ///< side of the box around it [m]
  Obstacle obstacle = Obstacle::round;
  ObstacleGrid grid = ObstacleGrid::ring;
  int around = 4;                          ///< cells along each quarter of the obstacle
  int radial = 4;                          ///< cells from the obstacle to the box
  std::optional<Grading> grading;          ///< from the obstacle to the box
  std::array<int, 4> outside{4, 8, 4, 4};  ///< cells before, behind, below and above the box
  Location where;
};

/// A ball as an O-grid: a cube in the middle and six blocks around it. Boundary "NAME wall".
struct Ball
{
  std::string name;
  std::string region;
  std::array<double, 3> center{};  ///< [m]
  double radius = 1.0;             ///< [m]
  double core = 0.5;               ///< distance of the cube's corners from the centre over the radius
  int around = 4;                  ///< cells along each edge of the cube
  int radial = 4;                  ///< cells between cube and sphere
  std::optional<Grading> grading;  ///< from the cube to the sphere
  Location where;
};

/// What lies between two spheres, as six blocks. Boundaries "NAME inner" and "NAME outer".
struct Shell
{
  std::string name;
  std::string region;
  std::array<double, 3> center{};  ///< [m]
  std::array<double, 2> radii{};   ///< inner and outer [m], inner > 0
  int around = 4;                  ///< cells along each edge of a block on a sphere
  int radial = 4;                  ///< cells between the spheres
  std::optional<Grading> grading;  ///< from the inner to the outer sphere
  Location where;
};

/// A cuboid, in 2D a rectangle, of one block. Points "NAME 0" to "NAME 7" in the order of element::corners;
/// boundaries "NAME x0", "NAME x1", "NAME y0", ....
struct Box
{
  std::string name;
  std::string region;
  std::array<double, 3> from{};  ///< lowest corner [m]
  std::array<double, 3> to{};    ///< highest corner [m]
  std::array<int, 3> divisions{1, 1, 1};
  std::array<std::optional<Grading>, 3> gradings;
  Location where;
};

/// Add the blocks of these to a layout. Throw Error for sizes that make no sense, naming the piece.
void add(Layout& layout, const Disc& disc);
void add(Layout& layout, const Annulus& annulus);
void add(Layout& layout, const Channel& channel);
void add(Layout& layout, const Ball& ball);
void add(Layout& layout, const Shell& shell);
void add(Layout& layout, const Box& box);

}  // namespace blockfsi::block
