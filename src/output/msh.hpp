#pragma once

#include "mesh/mesh.hpp"
#include "output/field.hpp"

#include <filesystem>
#include <span>

namespace blockfsi::output
{

enum class MshEncoding
{
  binary,
  text
};

/// Writes a mesh in Gmsh's format 4.1. Each block is one entity of the dimension of the mesh, in the physical
/// group of its region; the sides of a boundary on one block are one entity of one dimension less that bounds
/// it, in the physical group of the boundary, their normals pointing out of the mesh. Names of blocks stand
/// in a section $BlockNames, which Gmsh passes over. Coordinates and fields are evaluated at the equispaced
/// nodes that Gmsh means; nodes keep their numbers (counted from 1). x [m] has shape (node_count, dim).
/// Replaces the file at once. Throws Error if it cannot be written, if a field does not fit the mesh or if a
/// name has a quote or line break, which the format cannot hold.
void write_msh(const std::filesystem::path& path, const mesh::Mesh& mesh, std::span<const double> x,
               std::span<const Field> fields, std::span<const CellField> cell_fields,
               MshEncoding encoding = MshEncoding::binary);

}  // namespace blockfsi::output
