#pragma once

#include "mesh/mesh.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace blockfsi::output
{

/// A nodal field of the mesh's order.
struct Field
{
  std::string name;
  int components = 1;  ///< 1, 2 or 3; two are written with a third that is zero, as VTK expects of vectors
  std::span<const double> values;  ///< shape (node_count, components), at the nodes of the mesh
};

/// A value per cell, such as its block.
struct CellField
{
  std::string name;
  std::variant<std::span<const std::int32_t>, std::span<const double>> values;  ///< shape (cell_count)
};

/// Writes one process's share of a mesh as VTK unstructured grid (version 2.2, inline base64, zlib) of
/// Lagrange quadrilaterals. VTK's Lagrange cells have equispaced nodes, ours Gauss-Lobatto-Legendre points,
/// so coordinates and fields are evaluated there: the file holds the same polynomials. Nodes keep their
/// numbers, so cells share them. x [m] has shape (node_count, 2). Replaces the file at once. Throws Error if
/// it cannot be written or if a field's size does not fit the mesh.
void write_vtu(const std::filesystem::path& path, const mesh::Mesh& mesh, std::span<const double> x,
               std::span<const Field> fields, std::span<const CellField> cell_fields);

/// Writes the file that joins the pieces of several processes: `pieces` are their .vtu files, relative to it,
/// all written with the given fields (whose values are not looked at).
void write_pvtu(const std::filesystem::path& path, std::span<const std::string> pieces,
                std::span<const Field> fields, std::span<const CellField> cell_fields);

}  // namespace blockfsi::output
