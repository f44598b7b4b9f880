#pragma once

#include "case/case.hpp"
#include "command/exit.hpp"
#include "mesh/convert.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace blockfsi::command
{

/// What `blockfsi mesh` shall do.
struct MeshOptions
{
  std::filesystem::path output;     ///< .vtu or .msh file to write; empty: none
  std::filesystem::path picture;    ///< of the blocks, see `draw_blocks`; empty: none
  std::vector<mesh::Target> steps;  ///< conversions, one after the other
  int order = 0;                    ///< of the cells in the end; 0: that of the case
  bool sizes = false;               ///< list the cells along every edge of the blocks
};

/// Conversions by their names on the command line.
const std::vector<std::pair<std::string, mesh::Target>>& conversions();

/// Reads a case with some of its values replaced (case_file::read), makes the mesh of all its blocks, draws
/// the blocks, converts the mesh, writes it and prints counts, quality, certified validity and the time that
/// each part took. The blocks are meshed with cells of the order asked for; if cells are then
/// cut so that new nodes come to lie on curved edges or sides, of twice the order (8 at most), which puts
/// these nodes onto the geometry but for the error of that order. Exit::failed if a cell is not proved valid.
/// Throws Error for mistakes in the case and for conversions that the shapes of the blocks do not allow.
[[nodiscard]] Exit make_mesh(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                             const MeshOptions& options);

/// Prints the edges and faces of a STEP or an IGES file (geometry::describe). Throws Error if it cannot be
/// read.
[[nodiscard]] Exit list_cad(const std::filesystem::path& path);

}  // namespace blockfsi::command
