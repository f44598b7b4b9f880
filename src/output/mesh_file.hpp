#pragma once

#include "mesh/mesh.hpp"
#include "output/field.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi::output
{

/// A field that a file holds.
struct ReadField
{
  std::string name;
  int components = 1;
  std::vector<double> values;  ///< shape (node_count, components) or (cell_count, components)
};

/// A mesh that a file holds, with its coordinates x [m], shape (node_count, dim), and fields at the nodes of
/// the mesh.
struct ReadMesh
{
  mesh::Mesh mesh;
  std::vector<double> x;
  std::vector<ReadField> fields;
  std::vector<ReadField> cell_fields;
};

/// Throws Error unless the ending of the name is one of those that `write_mesh` knows.
void check_mesh_path(const std::filesystem::path& path);

/// Writes a mesh with the names of its blocks, regions and boundaries in the format that the ending of the
/// name asks for: .vtu for VTK and ParaView, .msh for Gmsh (version 4.1, binary). x [m] has shape
/// (node_count, dim). Throws Error for another ending, if the file cannot be written or if a field does not
/// fit the mesh.
void write_mesh(const std::filesystem::path& path, const mesh::Mesh& mesh, std::span<const double> x,
                std::span<const Field> fields = {}, std::span<const CellField> cell_fields = {});

/// Reads a mesh of one order from a .vtu or .msh file, also from those of other programs. Throws Error,
/// naming the file, the place and what would be right, if it cannot be read or does not hold such a mesh.
ReadMesh read_mesh(const std::filesystem::path& path);

/// The same from the content of a file; `name` is for messages.
ReadMesh read_vtu(std::string_view content, const std::string& name);
ReadMesh read_msh(std::string_view content, const std::string& name);

}  // namespace blockfsi::output
