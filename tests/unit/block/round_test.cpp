#include "block/round.hpp"

#include "block/merge.hpp"
#include "core/error.hpp"
#include "layouts.hpp"
#include "measure.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace blockfsi::block;
namespace element = blockfsi::element;
using blockfsi::block::testing::empty;
using std::numbers::pi;

namespace
{

template <typename Piece>
sample::Made made(int dim, int order, const Piece& piece)
{
  Layout layout = empty(dim, order);
  add(layout, piece);
  return sample::make(layout);
}

}  // namespace

TEST_CASE("a disc has the area and the circumference of a circle")
{
  Disc disc;
  disc.name = "d";
  disc.region = "fluid";
  disc.center = {1.0, -2.0, 0.0};
  disc.radius = 0.7;
  const sample::Made mesh = made(2, 6, disc);
  CHECK(sample::volume(mesh) == doctest::Approx(pi * 0.49).epsilon(1e-12));
  CHECK(sample::area(mesh, "d wall") == doctest::Approx(2.0 * pi * 0.7).epsilon(1e-12));
}

TEST_CASE("a ring and a part of it have the areas of rings")
{
  Annulus annulus;
  annulus.name = "ring";
  annulus.region = "fluid";
  annulus.radii = {0.5, 2.0};
  annulus.around = 8;
  CHECK(sample::volume(made(2, 6, annulus)) == doctest::Approx(pi * 3.75).epsilon(1e-11));
  annulus.from = 30.0;
  annulus.to = 130.0;
  annulus.sectors = 1;
  const sample::Made part = made(2, 6, annulus);
  CHECK(sample::volume(part) == doctest::Approx(pi * 3.75 * 100.0 / 360.0).epsilon(1e-11));
  CHECK(sample::area(part, "ring inner") == doctest::Approx(0.5 * 100.0 * pi / 180.0).epsilon(1e-11));
  CHECK(sample::area(part, "ring end") == doctest::Approx(1.5).epsilon(1e-12));
}

TEST_CASE("a channel has its area less that of the obstacle, with either grid")
{
  Channel channel;
  channel.name = "c";
  channel.region = "fluid";
  channel.length = 2.2;
  channel.height = 0.41;
  channel.center = {0.2, 0.2};
  channel.size = 0.1;
  channel.box = 0.2;
  for (const ObstacleGrid grid : {ObstacleGrid::ring, ObstacleGrid::wake})
    for (const Obstacle obstacle : {Obstacle::round, Obstacle::square})
    {
      channel.grid = grid;
      channel.obstacle = obstacle;
      const sample::Made mesh = made(2, 6, channel);
      const bool round = obstacle == Obstacle::round;
      CHECK(sample::volume(mesh) ==
            doctest::Approx(2.2 * 0.41 - (round ? pi * 0.0025 : 0.01)).epsilon(1e-11));
      CHECK(sample::area(mesh, "c obstacle") == doctest::Approx(round ? pi * 0.1 : 0.4).epsilon(1e-11));
      CHECK(sample::area(mesh, "c outlet") == doctest::Approx(0.41).epsilon(1e-12));
      CHECK(sample::area(mesh, "c top") == doctest::Approx(2.2).epsilon(1e-12));
    }
}

TEST_CASE("a ball and a shell converge to the volume and the area of spheres")
{
  Ball ball;
  ball.name = "b";
  ball.region = "solid";
  ball.center = {0.1, 0.2, 0.3};
  ball.radius = 1.5;
  ball.around = 2;
  ball.radial = 2;
  const sample::Made mesh = made(3, 6, ball);
  CHECK(sample::volume(mesh) == doctest::Approx(4.0 / 3.0 * pi * 1.5 * 1.5 * 1.5).epsilon(1e-8));
  CHECK(sample::area(mesh, "b wall") == doctest::Approx(4.0 * pi * 1.5 * 1.5).epsilon(1e-8));
  Shell shell;
  shell.name = "s";
  shell.region = "solid";
  shell.radii = {1.0, 1.5};
  shell.around = 2;
  shell.radial = 2;
  const sample::Made hollow = made(3, 6, shell);
  CHECK(sample::volume(hollow) == doctest::Approx(4.0 / 3.0 * pi * (1.5 * 1.5 * 1.5 - 1.0)).epsilon(1e-8));
  CHECK(sample::area(hollow, "s inner") == doctest::Approx(4.0 * pi).epsilon(1e-8));
}

TEST_CASE("a box has its volume and all its sides")
{
  Box box;
  box.name = "b";
  box.region = "solid";
  box.from = {1.0, 2.0, 3.0};
  box.to = {2.0, 4.0, 6.0};
  box.divisions = {1, 2, 3};
  const sample::Made mesh = made(3, 2, box);
  CHECK(mesh.mesh.cell_count() == 6);
  CHECK(sample::volume(mesh) == doctest::Approx(6.0).epsilon(1e-14));
  CHECK(sample::area(mesh, "b x0") == doctest::Approx(6.0).epsilon(1e-14));
  CHECK(sample::area(mesh, "b y1") == doctest::Approx(3.0).epsilon(1e-14));
  CHECK(sample::area(mesh, "b z1") == doctest::Approx(2.0).epsilon(1e-14));
}

TEST_CASE("pieces with impossible sizes are refused by name")
{
  Layout layout = empty(2, 2);
  Disc disc;
  disc.name = "lid";
  disc.radius = -1.0;
  CHECK_THROWS_WITH_AS(add(layout, disc), "'lid': the radius is -1 m, it must be positive", blockfsi::Error);
  Annulus ring;
  ring.name = "ring";
  ring.radii = {1.0, 2.0};
  ring.sectors = 2;
  CHECK_THROWS_WITH_AS(
      add(layout, ring),
      "'ring': 2 blocks around leave an angle of 180 degrees or more to each; take at least 3",
      blockfsi::Error);
  Ball ball;
  ball.name = "ball";
  CHECK_THROWS_WITH_AS(add(layout, ball), "'ball': a ball needs three dimensions; say dim = 3",
                       blockfsi::Error);
}
