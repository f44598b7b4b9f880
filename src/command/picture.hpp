#pragma once

#include "block/connect.hpp"
#include "block/layout.hpp"

#include <filesystem>
#include <string>

namespace blockfsi::command
{

/// Throws Error unless the name of a picture ends as the dimension of the blocks needs: .svg in the plane,
/// .vtu in space.
void check_picture_path(const std::filesystem::path& path, int dim);

/// Draws the blocks of a layout on the curves of their edges: in the plane as SVG with the names of points,
/// blocks, regions and boundaries and with numbers of cells; in space the edges as curves for ParaView, with
/// `divisions`, `boundary` (-1: none), `blocks` (their number at the edge) and the name of each edge.
void draw_blocks(const std::filesystem::path& path, const block::Layout& layout,
                 const block::Skeleton& skeleton, const std::string& title);

}  // namespace blockfsi::command
