#include "block/tubes.hpp"

#include "element/line.hpp"
#include "geometry/convolution.hpp"
#include "geometry/primitive.hpp"
#include "geometry/project.hpp"
#include "measure.hpp"
#include "mesh/quality.hpp"
#include "mesh/validity.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

using namespace blockfsi::block;
namespace element = blockfsi::element;
namespace geometry = blockfsi::geometry;
namespace mesh = blockfsi::mesh;
using std::numbers::pi;

namespace
{

/// A joint in the origin of three tubes with these directions and radii, each as long as given.
struct Joint
{
  std::array<geometry::Point, 3> directions;
  std::array<double, 3> radii;
  double length = 4.0;
};

const Joint even_y{{{{1, 0, 0}, {-0.5, 0.5 * std::sqrt(3.0), 0}, {-0.5, -0.5 * std::sqrt(3.0), 0}}},
                   {1, 1, 1}};

/// The tubes of a joint. The skeleton of the wall is longer than the tubes, so that these end in open
/// sections.
Tubes tubes(const Joint& joint)
{
  Tubes result;
  result.name = "vessel";
  result.region = "fluid";
  result.reach = 3.0;
  result.core = 0.5;
  result.around = 1;
  result.radial = 2;
  result.axial_size = 1.0;
  result.nodes.push_back({"joint", {}});
  geometry::Skeleton skeleton;
  skeleton.nodes.push_back({});
  skeleton.radii.push_back((joint.radii[0] + joint.radii[1] + joint.radii[2]) / 3.0);
  skeleton.sharpness = 3.0;
  for (int i = 0; i < 3; ++i)
  {
    const geometry::Point direction =
        geometry::scaled(1.0 / geometry::norm(joint.directions[i]), joint.directions[i]);
    result.nodes.push_back({"end " + std::to_string(i), geometry::scaled(joint.length, direction)});
    result.segments.push_back({0, i + 1, {0.4, 0.7}});
    skeleton.nodes.push_back(geometry::scaled(joint.length + 3.0, direction));
    skeleton.radii.push_back(joint.radii[i]);
    skeleton.bones.push_back({0, i + 1, {}});
  }
  result.wall = geometry::tube(geometry::Convolution(skeleton));
  return result;
}

Layout layout_of(const Tubes& tubes, int order)
{
  Layout layout;
  layout.dim = 3;
  layout.order = order;
  layout.default_divisions = 1;
  add(layout, tubes);
  return layout;
}

/// Largest distance of the nodes of a boundary from the level set [m].
double residual(const sample::Made& made, const std::string& boundary, const geometry::LevelSet& wall)
{
  double largest = 0.0;
  for (const mesh::Side& side : made.mesh.boundaries.at(boundary))
    for (const std::int32_t n : element::side_lattice(made.mesh.shape(side.cell), made.mesh.order, side.side))
    {
      const double* x = made.x.data() + 3 * static_cast<std::size_t>(made.mesh.cell(side.cell)[n]);
      const geometry::Level level = wall({x[0], x[1], x[2]});
      largest = std::max(largest, std::abs(level.value) / geometry::norm(level.gradient));
    }
  return largest;
}

/// Volume of a Y of three equal tubes under 120 degrees in the xy plane, each cut off at a length, one of
/// them along x: of the wedge |y| <= sqrt(3) x of that one, thrice. Straight lines from the cut to the faces
/// of the wedge are parametrised by s, the section by angle and distance rho, up to the wall.
double volume_of_y(const geometry::LevelSet& wall, double length)
{
  const auto rule = element::gauss(24);
  double sum = 0.0;
  for (std::size_t i = 0; i < rule.points.size(); ++i)
    for (std::size_t j = 0; j < rule.points.size(); ++j)
    {
      const double angle = pi * (rule.points[i] - 0.5);
      const double s = rule.points[j];
      const double c = std::cos(angle) / std::sqrt(3.0);
      const geometry::Point direction{(1.0 - s) * c, std::cos(angle), std::sin(angle)};
      const geometry::Found found =
          geometry::project(wall, {s * length, 0.0, 0.0}, direction, {1.0, 5.0, false});
      REQUIRE(found.ok());
      const double R = found.moved / geometry::norm(direction);
      sum += pi * rule.weights[i] * rule.weights[j] * (length * R * R / 2.0 - c * R * R * R / 3.0);
    }
  return 3.0 * 2.0 * sum;
}

}  // namespace

TEST_CASE("three tubes of one plane, a T and a joint in space are meshed to the wall by certified cells")
{
  const std::vector<Joint> joints = {even_y,
                                     {{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}}}, {1, 1, 0.8}},
                                     {{{{1, 0, 0}, {-1, 0.3, 0.4}, {0.2, 1, -0.3}}}, {1, 0.9, 0.7}},
                                     {{{{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0.2}}}, {1, 0.8, 0.8}}};
  for (std::size_t j = 0; j < joints.size(); ++j)
  {
    CAPTURE(j);
    const Tubes vessel = tubes(joints[j]);
    const sample::Made made = sample::make(layout_of(vessel, 3));
    CHECK(mesh::certify(mesh::ValidityTables(made.mesh), made.mesh, made.x).all_valid());
    const mesh::Quality quality = mesh::measure(mesh::QualityTables(made.mesh), made.mesh, made.x);
    CHECK(quality.scaled_jacobian > 0.4);
    CHECK(residual(made, "vessel wall", vessel.wall) < 1e-12);
    for (int i = 0; i < 3; ++i)
    {
      const geometry::Point& at = vessel.nodes[i + 1].x;
      CHECK(residual(made, "end " + std::to_string(i), geometry::plane(at, at)) < 1e-12);
    }
  }
}

TEST_CASE("the volume of a Y converges to that of its level set")
{
  const Tubes vessel = tubes(even_y);
  const double exact = volume_of_y(vessel.wall, even_y.length);
  for (const auto& [order, bound] : {std::pair{2, 1e-3}, {4, 1e-8}, {6, 1e-11}})
  {
    CAPTURE(order);
    CHECK(std::abs(sample::volume(sample::make(layout_of(vessel, order))) / exact - 1.0) < bound);
  }
}
