#pragma once

#include "linalg/numbering.hpp"
#include "mesh/mesh.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace blockfsi::fem
{

/// Marks the nodes on a boundary with 1, also those of which this process has no side there.
/// All processes must call it together. Shape (node_count).
std::vector<std::uint8_t> nodes_on(const mesh::Mesh& mesh, const linalg::Numbering& numbering,
                                   std::string_view boundary);

/// Marks the component normal to each side of a boundary that is straight along an axis, shape (node_count,
/// 2). Throws Error where it is not. All processes must call it together.
///   x [m], shape (node_count, 2).
std::vector<std::uint8_t> normal_components(const mesh::Mesh& mesh, const linalg::Numbering& numbering,
                                            std::string_view boundary, std::span<const double> x);

/// Makes marks agree: a node marked by any process is marked by all that have it.
void agree(const linalg::Numbering& numbering, std::vector<std::uint8_t>& marks, int components);

}  // namespace blockfsi::fem
