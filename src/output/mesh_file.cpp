#include "output/mesh_file.hpp"

#include "core/error.hpp"
#include "output/file.hpp"
#include "output/msh.hpp"
#include "output/vtu.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace blockfsi::output
{

namespace
{

enum class Format
{
  vtu,
  msh
};

Format format_of(const std::filesystem::path& path)
{
  const std::string ending = path.extension().string();
  if (ending == ".vtu")
    return Format::vtu;
  if (ending == ".msh")
    return Format::msh;
  throw Error(fmt::format("'{}' must end in .vtu (VTK, ParaView) or .msh (Gmsh)", path.string()));
}

}  // namespace

void check_mesh_path(const std::filesystem::path& path)
{
  format_of(path);
}

void write_mesh(const std::filesystem::path& path, const mesh::Mesh& mesh, std::span<const double> x,
                std::span<const Field> fields, std::span<const CellField> cell_fields)
{
  if (format_of(path) == Format::msh)
    return write_msh(path, mesh, x, fields, cell_fields);
  std::vector<CellField> with_block(cell_fields.begin(), cell_fields.end());
  if (std::none_of(with_block.begin(), with_block.end(),
                   [](const CellField& field) { return field.name == "block"; }))
    with_block.insert(with_block.begin(), {"block", std::span<const std::int32_t>(mesh.cell_block)});
  write_vtu(path, mesh, x, fields, with_block, Names::kept);
}

ReadMesh read_mesh(const std::filesystem::path& path)
{
  const Format format = format_of(path);
  const std::string content = read_file(path);
  if (format == Format::msh)
    return read_msh(content, path.string());
  return read_vtu(content, path.string());
}

}  // namespace blockfsi::output
