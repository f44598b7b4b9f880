#pragma once

#include "linalg/numbering.hpp"
#include "mesh/mesh.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace blockfsi::fem
{

/// Marks the nodes on a boundary with 1, also those of which this process has no side there.
/// All processes must call it together. Shape (node_count).
std::vector<std::uint8_t> nodes_on(const mesh::Mesh& mesh, const linalg::Numbering& numbering,
                                   std::string_view boundary);

/// Makes marks agree: a node marked by any process is marked by all that have it.
void agree(const linalg::Numbering& numbering, std::vector<std::uint8_t>& marks, int components);

}  // namespace blockfsi::fem
