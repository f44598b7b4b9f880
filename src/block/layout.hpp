#pragma once

#include "block/grading.hpp"
#include "core/error.hpp"
#include "core/expression.hpp"
#include "element/shape.hpp"
#include "geometry/curve.hpp"
#include "geometry/level_set.hpp"
#include "geometry/surface.hpp"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace blockfsi::block
{

/// A named corner of blocks.
struct Point
{
  std::string name;
  std::array<double, 3> x{};  ///< position [m]; the third is 0 in 2D
  Location where;
};

/// What the user says of one edge; edges that nobody mentions are straight and uniform.
struct Edge
{
  int a = 0;  ///< point at parameter 0
  int b = 0;  ///< point at parameter 1
  geometry::Curve curve = geometry::Segment{};
  std::optional<Grading> grading;
  std::optional<int> divisions;
  Location where;
};

/// The face is the transfinite surface of its edges: where nothing else is said.
struct Interpolated
{
};

/// The face is the whole of a parametric surface: its corners, in the order in which the face lists them, are
/// the surface's corners (geometry::corner). Nodes sit at their graded parameters.
struct Patch
{
  geometry::Surface surface;
};

/// The nodes of the face are the points of a surface closest to its interpolation.
struct OnSurface
{
  geometry::Surface surface;
};

/// The nodes of the face lie where normals of its interpolation meet a level set.
struct OnLevelSet
{
  geometry::LevelSet level_set;
};

/// What shapes a face in 3D. Edges of a shaped face that have no curve of their own lie on its surface, too,
/// or where those of two faces meet.
using FaceGeometry = std::variant<Interpolated, Patch, OnSurface, OnLevelSet>;

/// What the user says of one face in 3D; faces that nobody mentions are interpolated.
struct Face
{
  std::vector<int>
      points;  ///< its three or four corners, one after the other round the face, from any of them
  FaceGeometry geometry;
  Location where;
};

/// A coarse cell over its corners, which have the order of element::corners: those of a quadrilateral run
/// counter-clockwise, u along its side 0 (point 0 to 1), v along its side 3 (point 0 to 3).
struct Block
{
  std::string name;
  std::string region;
  std::vector<int> points;  ///< shape (corner_count of the shape)
  Location where;
  element::Shape shape = element::Shape::quadrilateral;
};

/// Boundary of all sides whose initial nodes fulfil a condition.
struct ByCondition
{
  Condition condition;
};

/// Boundary of the edges around a hole of a drawn lattice, holes counted from 1 in reading order.
struct ByHole
{
  std::string lattice;
  int number = 1;
};

/// Boundary of listed edges, each by its two points.
struct ByEdges
{
  std::vector<std::array<int, 2>> edges;
};

/// Boundary of listed faces in 3D, each by its corners in any order.
struct ByFaces
{
  std::vector<std::vector<int>> faces;
};

/// A named boundary, made of sides of blocks: edges in 2D, faces in 3D. A side can belong to one boundary
/// only. Conditions see outer sides only; holes and lists may also name sides between two regions. The name
/// "interface" is reserved for these.
struct Boundary
{
  std::string name;
  std::variant<ByCondition, ByHole, ByEdges, ByFaces> rule;
  Location where;
  /// It takes only what is left: outer sides that lie on no other boundary, perhaps none. So are the
  /// boundaries that come with a piece, which others can overrule and which vanish where pieces are joined.
  bool gives_way = false;
};

/// An edge of a hole, filled by the lattice that made it.
struct HoleEdge
{
  std::string lattice;
  int number = 1;
  int a = 0;
  int b = 0;
};

/// Grading of all edges that end at a boundary or a region (and do not lie on it): the cell there has the
/// given size. Applies to the whole class of opposite edges in the same relative distribution, unless an
/// edge has a grading of its own. Where several edges of a class ask, the smallest relative size wins at each
/// end; sizes above that of equal cells change nothing.
struct GradeTowards
{
  std::vector<std::string> names;  ///< boundaries or regions
  double first = 0.0;              ///< size of the cell that touches them [m]
  Location where;
};

/// The domain as coarse blocks: everything that the mesh is made from.
struct Layout
{
  int dim = 2;
  int order = 2;  ///< 1..8
  std::vector<Point> points;
  std::vector<Block> blocks;
  std::vector<Edge> edges;
  std::vector<Face> faces;  ///< 3D only
  std::vector<Boundary> boundaries;
  std::vector<HoleEdge> hole_edges;
  std::vector<GradeTowards> grade_towards;
  int default_divisions = 0;  ///< for classes of edges without a count; 0: that is an error
};

}  // namespace blockfsi::block
