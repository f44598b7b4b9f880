#pragma once

#include "block/layout.hpp"
#include "case/key.hpp"

#include <vector>

namespace blockfsi::case_file
{

/// [blocks.faces]: surfaces of single faces, each named by its corners "a - b - c - d".
void read_faces(const Value& value, Reading& reading, block::Layout& layout);
std::vector<Section> face_sections();

}  // namespace blockfsi::case_file
