#pragma once

#include "run/simulation.hpp"

#include <filesystem>
#include <string_view>

namespace blockfsi::run
{

/// Name of the picture in the folder of results.
inline constexpr std::string_view refused_picture = "refused.svg";

/// Draws the cells of the blocks around the faulty cell of a mesh that was refused, block by block, and that
/// cell filled. The process that owns the cell draws its share of the mesh; all processes together.
void draw_refused(const std::filesystem::path& path, const Simulation& simulation,
                  const RefusedMesh& refused);

}  // namespace blockfsi::run
