#pragma once

#include "mesh/mesh.hpp"

#include <span>
#include <vector>

namespace blockfsi::run
{

/// The values of all processes, in the order of ranks; known to each. All must call it together.
std::vector<double> gather_values(std::span<const double> mine);

/// A mesh with a nodal field, all of it on every process; no two cells share a node.
struct Gathered
{
  mesh::Mesh mesh;
  std::vector<double> x;      ///< [m], shape (node_count, 2)
  std::vector<double> field;  ///< shape (node_count, components)
};

/// Gathers the cells of all processes. All must call it together.
///   x [m], shape (node_count, 2);  field, shape (node_count, components).
Gathered gather(const mesh::Mesh& mesh, std::span<const double> x, std::span<const double> field,
                int components);

}  // namespace blockfsi::run
