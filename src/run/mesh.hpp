#pragma once

#include "case/case.hpp"
#include "run/run.hpp"

#include <filesystem>

namespace blockfsi::run
{

/// Makes the mesh of all blocks of a case, writes it to a .vtu file (empty: none) and prints counts, quality
/// and certified validity; with `sizes` also those of the cells along every edge. Exit::failed if a cell is
/// not proved valid.
[[nodiscard]] Exit make_mesh(const case_file::Case& description, const std::filesystem::path& output,
                             bool sizes = false);

}  // namespace blockfsi::run
