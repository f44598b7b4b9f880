#pragma once

#include "fluid/parameters.hpp"
#include "linalg/numbering.hpp"
#include "mesh/mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::fluid
{

/// One prescribed velocity component of a node.
struct Prescribed
{
  enum class Kind
  {
    zero,
    expression,
    interface  ///< the mesh velocity
  };
  std::int32_t node = 0;
  int component = 0;
  Kind kind = Kind::zero;
  Expression value;
};

struct Conditions
{
  std::vector<Prescribed> prescribed;
  /// No open boundary: the pressure is known up to a constant only.
  bool enclosed = true;
};

/// The name of the boundary between fluid and solid in a mesh of one region.
inline constexpr std::string_view interface_name = "interface";

/// Which velocity components are prescribed. Where boundaries meet, a wall wins over the interface, that over
/// a prescribed velocity, that over slip.
///   x [m], shape (node_count, 2).
/// Throws Error for slip on a boundary that is not along an axis. All processes must call it together.
Conditions find_conditions(const Parameters& parameters, const mesh::Mesh& mesh,
                           const linalg::Numbering& numbering, std::span<const double> x);

/// Marks fixed degrees of freedom, shape (node_count * 3); for an enclosed flow also one pressure.
std::vector<std::uint8_t> fixed_unknowns(const Conditions& conditions, const mesh::Mesh& mesh);

}  // namespace blockfsi::fluid
