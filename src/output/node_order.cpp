#include "output/node_order.hpp"

#include "core/error.hpp"
#include "element/lattice.hpp"

#include <array>
#include <span>

namespace blockfsi::output
{

namespace
{

using element::LatticePoint;
using element::Shape;
using Edge = std::array<std::int8_t, 2>;
using Face = std::array<std::int8_t, 4>;  ///< the last is -1 for a triangle
using Points = std::vector<LatticePoint>;

/// Edges and faces of a cell in the order and direction in which a format lists their inner nodes. Those of a
/// face are counted from its first corner to its second and to its last.
struct Listing
{
  std::span<const Edge> edges;
  std::span<const Face> faces;
};

constexpr std::array<Edge, 1> segment_edges{{{0, 1}}};
constexpr std::array<Edge, 3> triangle_edges{{{0, 1}, {1, 2}, {2, 0}}};
constexpr std::array<Face, 1> triangle_face{{{0, 1, 2, -1}}};
constexpr std::array<Face, 1> quadrilateral_face{{{0, 1, 2, 3}}};

constexpr std::array<Edge, 4> vtk_quadrilateral{{{0, 1}, {1, 2}, {3, 2}, {0, 3}}};
constexpr std::array<Edge, 6> vtk_tetrahedron{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
constexpr std::array<Face, 4> vtk_tetrahedron_faces{
    {{0, 1, 3, -1}, {2, 3, 1, -1}, {0, 3, 2, -1}, {0, 2, 1, -1}}};
constexpr std::array<Edge, 12> vtk_hexahedron{
    {{0, 1}, {1, 2}, {3, 2}, {0, 3}, {4, 5}, {5, 6}, {7, 6}, {4, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
constexpr std::array<Face, 6> vtk_hexahedron_faces{
    {{0, 3, 7, 4}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 2, 6, 7}, {0, 1, 2, 3}, {4, 5, 6, 7}}};
constexpr std::array<Edge, 9> vtk_prism{
    {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}};
constexpr std::array<Face, 5> vtk_prism_faces{
    {{0, 1, 2, -1}, {3, 4, 5, -1}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};

constexpr std::array<Edge, 4> gmsh_quadrilateral{{{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
constexpr std::array<Edge, 6> gmsh_tetrahedron{{{0, 1}, {1, 2}, {2, 0}, {3, 0}, {3, 2}, {3, 1}}};
constexpr std::array<Face, 4> gmsh_tetrahedron_faces{
    {{0, 2, 1, -1}, {0, 1, 3, -1}, {0, 3, 2, -1}, {3, 1, 2, -1}}};
constexpr std::array<Edge, 12> gmsh_hexahedron{
    {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3}, {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}}};
constexpr std::array<Face, 6> gmsh_hexahedron_faces{
    {{0, 3, 2, 1}, {0, 1, 5, 4}, {0, 4, 7, 3}, {1, 2, 6, 5}, {2, 3, 7, 6}, {4, 5, 6, 7}}};
constexpr std::array<Edge, 9> gmsh_prism{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}}};
constexpr std::array<Face, 5> gmsh_prism_faces{
    {{0, 2, 1, -1}, {3, 4, 5, -1}, {0, 1, 4, 3}, {0, 3, 5, 2}, {1, 2, 5, 4}}};
constexpr std::array<Edge, 8> gmsh_pyramid{{{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {3, 4}}};
constexpr std::array<Face, 5> gmsh_pyramid_faces{
    {{0, 1, 4, -1}, {3, 0, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {0, 3, 2, 1}}};

/// By shape. VTK has no Lagrange pyramid: it has a listing without anything.
constexpr std::array<Listing, element::shape_count> vtk_listings{{{segment_edges, {}},
                                                                  {triangle_edges, triangle_face},
                                                                  {vtk_quadrilateral, quadrilateral_face},
                                                                  {vtk_tetrahedron, vtk_tetrahedron_faces},
                                                                  {vtk_hexahedron, vtk_hexahedron_faces},
                                                                  {vtk_prism, vtk_prism_faces},
                                                                  {}}};
constexpr std::array<Listing, element::shape_count> gmsh_listings{{{segment_edges, {}},
                                                                   {triangle_edges, triangle_face},
                                                                   {gmsh_quadrilateral, quadrilateral_face},
                                                                   {gmsh_tetrahedron, gmsh_tetrahedron_faces},
                                                                   {gmsh_hexahedron, gmsh_hexahedron_faces},
                                                                   {gmsh_prism, gmsh_prism_faces},
                                                                   {gmsh_pyramid, gmsh_pyramid_faces}}};

const Listing& of(const std::array<Listing, element::shape_count>& listings, Shape shape)
{
  return listings[static_cast<std::size_t>(shape)];
}

Points corner_points(Shape shape, int n)
{
  Points points;
  for (const std::array<double, 3>& x : element::corners(shape))
    points.push_back({static_cast<int>(x[0]) * n, static_cast<int>(x[1]) * n, static_cast<int>(x[2]) * n});
  return points;
}

/// a + (s (b - a) + t (c - a)) / n.
LatticePoint between(int n, const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, int s, int t)
{
  LatticePoint point{};
  for (int d = 0; d < 3; ++d)
    point[d] = a[d] + (s * (b[d] - a[d]) + t * (c[d] - a[d])) / n;
  return point;
}

/// Points (s, t) inside a face of a cell in the order of a format, and points inside a cell.
using InsideFace = Points (*)(Shape cell, Shape face, int n);
using InsideCell = Points (*)(Shape cell, int n);

/// Corners, then the inside of edges, faces and the cell.
Points list(Shape shape, int n, const Listing& listing, InsideFace inside_face, InsideCell inside_cell)
{
  const Points corner = corner_points(shape, n);
  if (n == 0)
    return {corner[0]};
  Points points = corner;
  for (const Edge& edge : listing.edges)
    for (int s = 1; s < n; ++s)
      points.push_back(between(n, corner[edge[0]], corner[edge[1]], corner[edge[0]], s, 0));
  for (const Face& face : listing.faces)
  {
    const bool triangle = face[3] < 0;
    for (const LatticePoint& p : inside_face(shape, triangle ? Shape::triangle : Shape::quadrilateral, n))
      points.push_back(
          between(n, corner[face[0]], corner[face[1]], corner[triangle ? face[2] : face[3]], p[0], p[1]));
  }
  if (element::dimension(shape) == 3)
    for (const LatticePoint& p : inside_cell(shape, n))
      points.push_back(p);
  return points;
}

Points shifted(Points points, int dim)
{
  for (LatticePoint& point : points)
    for (int d = 0; d < dim; ++d)
      ++point[d];
  return points;
}

/// Steps of the smaller cell whose lattice is the inside of a cell of n steps; negative: there is none.
int inner_steps(Shape shape, int n)
{
  switch (shape)
  {
  case Shape::triangle:
  case Shape::pyramid:
    return n - 3;
  case Shape::tetrahedron:
    return n - 4;
  default:
    return n - 2;
  }
}

Points gmsh_points(Shape shape, int n);

/// The inside, listed like a smaller cell of the same shape.
Points gmsh_inside(Shape shape, int n)
{
  const int inner = inner_steps(shape, n);
  if (inner < 0)
    return {};
  if (shape != Shape::prism)
    return shifted(gmsh_points(shape, inner), element::dimension(shape));
  Points points;
  for (const LatticePoint& p : gmsh_inside(Shape::triangle, n))
    for (const LatticePoint& q : gmsh_points(Shape::segment, inner))
      points.push_back({p[0], p[1], 1 + q[0]});
  return points;
}

Points gmsh_points(Shape shape, int n)
{
  return list(
      shape, n, of(gmsh_listings, shape),
      [](Shape, Shape face, int steps) { return gmsh_inside(face, steps); }, gmsh_inside);
}

/// The inside row by row.
Points rows(Shape shape, int n)
{
  const int inner = inner_steps(shape, n);
  return inner < 0 ? Points{} : shifted(element::lattice_points(shape, inner), element::dimension(shape));
}

Points vtk_points(Shape shape, int n);

/// Simplices are listed like smaller ones, other cells row by row.
Points vtk_inside(Shape shape, int n)
{
  const int inner = inner_steps(shape, n);
  if (shape == Shape::triangle || shape == Shape::tetrahedron)
    return inner < 0 ? Points{} : shifted(vtk_points(shape, inner), element::dimension(shape));
  if (shape != Shape::prism)
    return rows(shape, n);
  Points points;
  for (int k = 1; k < n; ++k)
    for (const LatticePoint& p : rows(Shape::triangle, n))
      points.push_back({p[0], p[1], k});
  return points;
}

/// The triangles of a prism are listed row by row, those of a tetrahedron like smaller triangles.
Points vtk_inside_face(Shape cell, Shape face, int n)
{
  return cell == Shape::prism ? rows(face, n) : vtk_inside(face, n);
}

Points vtk_points(Shape shape, int n)
{
  if (shape == Shape::pyramid)
    throw Error("VTK has no Lagrange pyramid; write it as a collapsed hexahedron");
  return list(shape, n, of(vtk_listings, shape), vtk_inside_face, vtk_inside);
}

std::vector<std::int32_t> indices(Shape shape, int n, const Points& points)
{
  std::vector<std::int32_t> result;
  result.reserve(points.size());
  for (const LatticePoint& point : points)
    result.push_back(static_cast<std::int32_t>(element::lattice_index(shape, n, point)));
  return result;
}

}  // namespace

std::vector<std::int32_t> vtk_order(Shape shape, int order)
{
  return indices(shape, order, vtk_points(shape, order));
}

std::vector<std::int32_t> gmsh_order(Shape shape, int order)
{
  return indices(shape, order, gmsh_points(shape, order));
}

}  // namespace blockfsi::output
