#include "element/lattice.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

namespace element = blockfsi::element;
using element::Shape;

namespace
{

constexpr std::array<Shape, 7> all_shapes = {Shape::segment,     Shape::triangle,   Shape::quadrilateral,
                                             Shape::tetrahedron, Shape::hexahedron, Shape::prism,
                                             Shape::pyramid};

}  // namespace

TEST_CASE("every point of a lattice has the index of its place in the list")
{
  for (const Shape shape : all_shapes)
    for (int n = 1; n <= 6; ++n)
    {
      const auto points = element::lattice_points(shape, n);
      REQUIRE(static_cast<std::int64_t>(points.size()) == element::lattice_size(shape, n));
      for (std::size_t m = 0; m < points.size(); ++m)
        CHECK(element::lattice_index(shape, n, points[m]) == static_cast<std::int64_t>(m));
    }
}

TEST_CASE("the points on no side are as many as the interior has")
{
  for (const Shape shape : {Shape::triangle, Shape::quadrilateral, Shape::tetrahedron, Shape::hexahedron,
                            Shape::prism, Shape::pyramid})
    for (int n = 1; n <= 7; ++n)
    {
      std::set<std::int32_t> on_sides;
      for (std::size_t side = 0; side < element::sides(shape).size(); ++side)
        for (const std::int32_t index : element::side_lattice(shape, n, static_cast<int>(side)))
          on_sides.insert(index);
      CHECK(element::lattice_size(shape, n) - static_cast<std::int64_t>(on_sides.size()) ==
            element::interior_size(shape, n));
    }
}

TEST_CASE("sides and edges begin and end at their corners")
{
  for (const Shape shape : all_shapes)
  {
    const int n = 3;
    const auto points = element::lattice_points(shape, n);
    const auto corner_of = [&](std::int32_t index)
    {
      for (int c = 0; c < element::corner_count(shape); ++c)
      {
        const auto& x = element::corners(shape)[c];
        if (points[index] == element::LatticePoint{static_cast<int>(x[0]) * n, static_cast<int>(x[1]) * n,
                                                   static_cast<int>(x[2]) * n})
          return c;
      }
      return -1;
    };
    for (std::size_t e = 0; e < element::edges(shape).size(); ++e)
    {
      const auto line = element::edge_lattice(shape, n, static_cast<int>(e));
      CHECK(corner_of(line.front()) == element::edges(shape)[e][0]);
      CHECK(corner_of(line.back()) == element::edges(shape)[e][1]);
    }
    for (std::size_t s = 0; s < element::sides(shape).size(); ++s)
    {
      const element::SideShape& side = element::sides(shape)[s];
      const auto indices = element::side_lattice(shape, n, static_cast<int>(s));
      for (int c = 0; c < element::corner_count(side.shape); ++c)
      {
        const auto& x = element::corners(side.shape)[c];
        const element::LatticePoint at{static_cast<int>(x[0]) * n, static_cast<int>(x[1]) * n, 0};
        CHECK(corner_of(indices[element::lattice_index(side.shape, n, at)]) == side.corners[c]);
      }
    }
  }
}

TEST_CASE("sides marked as outward turn counter-clockwise seen from outside")
{
  for (const Shape shape : {Shape::triangle, Shape::quadrilateral, Shape::tetrahedron, Shape::hexahedron,
                            Shape::prism, Shape::pyramid})
  {
    std::array<double, 3> centre{};
    for (const auto& x : element::corners(shape))
      for (int d = 0; d < 3; ++d)
        centre[d] += x[d] / element::corner_count(shape);
    for (const element::SideShape& side : element::sides(shape))
    {
      const auto& a = element::corners(shape)[side.corners[0]];
      const auto& b = element::corners(shape)[side.corners[1]];
      std::array<double, 3> normal{b[1] - a[1], a[0] - b[0], 0.0};
      if (element::dimension(shape) == 3)
      {
        const auto& c = element::corners(shape)[side.corners[element::corner_count(side.shape) - 1]];
        const std::array<double, 3> u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        const std::array<double, 3> v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
        normal = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
      }
      double away = 0.0;
      for (int d = 0; d < 3; ++d)
        away += normal[d] * (a[d] - centre[d]);
      CHECK((away > 0.0) == side.outward);
    }
  }
}
