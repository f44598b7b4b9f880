#pragma once

#include "core/lanes.hpp"
#include "mesh/bernstein.hpp"
#include "mesh/mesh.hpp"
#include "mesh/tensor.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::mesh
{

/// What is proved about the Jacobian of a cell.
enum class Verdict : std::int32_t
{
  valid,      ///< positive everywhere in the cell
  invalid,    ///< somewhere not positive beyond rounding
  undecided,  ///< neither was proved: positive, if at all, by less than the subdivision resolves
};

/// What certifying cells of one shape takes.
struct ShapeValidity
{
  ShapeValidity(element::Shape shape, int order);

  element::Shape shape = element::Shape::quadrilateral;
  std::size_t node_count = 0;
  std::vector<Tangent> tangents;
  /// Mean of the coefficients of each tangent from the nodes, shape (dim, node_count).
  std::vector<double> means;
  /// Bound of the rounding error of the coefficients of each tangent, for a cell of unit size, shape (dim).
  std::vector<double> rounding;
  /// Of the second and the third tangent (3D), then of the first with that or with the second (2D).
  Product cross;
  Product triple;
  std::size_t cross_size = 0;
  std::vector<double> inverse_factors;  ///< of the Jacobian, shape (its size)
  std::vector<std::int32_t> corners;    ///< coefficients that are values of the Jacobian
  std::vector<Halving> halvings;
};

/// Tables to certify cells of one order k, made once (formulation.md chapter 4; Johnen, Remacle and Geuzaine
/// 2013).
///
/// The Jacobian of a cell is a polynomial: of degree 2k - 1 per direction on quadrilaterals, 3k - 1 on
/// hexahedra, 2k - 2 and 3k - 3 on triangles and tetrahedra, (3k - 2, 3k - 1) on prisms, (3k - 1, 3k - 1,
/// 3k - 3) in the collapsed coordinates of pyramids. Its Bernstein coefficients are formed as products of
/// those of the tangents. Interpolating sampled Jacobians instead would solve systems of the degree of the
/// Jacobian, whose condition is the square or cube of what is needed here.
struct ValidityTables
{
  /// For quadrilaterals in the plane. Throws Error unless 1 <= order <= max_order.
  explicit ValidityTables(int order);
  /// For the shapes of a mesh. Throws Error if cells have another dimension than their coordinates.
  explicit ValidityTables(const Mesh& mesh);
  /// For some shapes, all of one dimension.
  ValidityTables(std::span<const element::Shape> shapes, int order);

  const ShapeValidity& of(element::Shape shape) const;

  int order = 1;
  std::vector<ShapeValidity> shapes;
  /// Where certify works, so that it allocates nothing: not for several threads at once.
  struct Memory
  {
    std::vector<Lanes> lanes;      ///< coordinates of eight cells
    std::vector<double> nodes;     ///< coordinates of a cell
    std::vector<double> tangents;  ///< their coefficients, by direction and coordinate
    std::vector<double> crosses;   ///< coefficients of products of two tangents
    std::vector<double> patches;   ///< halves of a cell that wait
  };
  mutable Memory memory;
};

/// Sign of the Jacobian of one cell with nodes x [m], shape (node_count, dim), relative to the cell's size
/// and free of rounding: `valid` is a proof. At the apex of a pyramid the limits from all directions count.
/// Allocates nothing. The first form is for tables of one shape.
Verdict certify(const ValidityTables& tables, std::span<const double> x);
Verdict certify(const ValidityTables& tables, element::Shape shape, std::span<const double> x);

/// Verdicts over the cells of a mesh. The default is that of a mesh without cells. Trivially copyable.
struct Validity
{
  std::int64_t valid = 0;
  std::int64_t invalid = 0;
  std::int64_t undecided = 0;
  /// The cell that is not valid with the lowest number in the whole mesh, and its block; -1: none.
  std::int64_t cell = -1;
  std::int32_t block = -1;

  bool all_valid() const { return invalid == 0 && undecided == 0; }
};

/// Combines the parts of several processes.
Validity merge(const Validity& a, const Validity& b);

/// Certifies all cells of the mesh at coordinates x [m], shape (node_count, dim): eight at a time by how far
/// their tangents are from constant, and those for which that is too far one by one. Where `verdicts` is
/// given it gets the verdict of each cell, shape (cell_count). Allocates nothing.
Validity certify(const ValidityTables& tables, const Mesh& mesh, std::span<const double> x,
                 std::span<Verdict> verdicts = {});

}  // namespace blockfsi::mesh
