#pragma once

#include "mesh/mesh.hpp"
#include "output/field.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace blockfsi::output
{

/// Whether a file holds the names of blocks, regions and boundaries and the sides of these.
enum class Names
{
  left_out,  ///< fields of a run: they would be the same in each file
  kept,      ///< meshes that are to be read again
};

/// Writes one process's share of a mesh as VTK unstructured grid (version 2.2, inline base64, zlib) of
/// Lagrange cells. VTK's Lagrange cells have equispaced nodes, ours warped ones, so coordinates and fields
/// are evaluated there: the file holds the same functions. Nodes keep their numbers, so cells share them.
/// Pyramids of order 2 and more become hexahedra with collapsed top, with points of their own behind the
/// nodes. x [m] has shape (node_count, dim). Replaces the file at once. Throws Error if it cannot be written
/// or if a field's size does not fit the mesh.
void write_vtu(const std::filesystem::path& path, const mesh::Mesh& mesh, std::span<const double> x,
               std::span<const Field> fields, std::span<const CellField> cell_fields,
               Names names = Names::left_out);

/// Writes the file that joins the pieces of several processes. `pieces` are names of .vtu files relative to
/// the folder of `path`; of the fields only names, components and types matter. Throws Error if it cannot be
/// written.
void write_pvtu(const std::filesystem::path& path, std::span<const std::string> pieces,
                std::span<const Field> fields, std::span<const CellField> cell_fields);

}  // namespace blockfsi::output
