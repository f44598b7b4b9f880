#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>

namespace blockfsi::output
{

/// A nodal field of the mesh's order.
struct Field
{
  std::string name;
  int components = 1;  ///< 1, 2 or 3; two are written with a third that is zero, as VTK expects of vectors
  std::span<const double> values;  ///< shape (node_count, components), at the nodes of the mesh
};

/// A value per cell, such as its block.
struct CellField
{
  std::string name;
  std::variant<std::span<const std::int32_t>, std::span<const double>> values;  ///< shape (cell_count)
};

/// Components as files hold them: vectors always have three.
inline int written_components(const Field& field)
{
  return field.components == 2 ? 3 : field.components;
}

/// Throws Error if a field has not as many values as the mesh needs.
void check_size(const std::string& name, std::size_t found, std::size_t expected);

}  // namespace blockfsi::output
