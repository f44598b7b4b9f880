#pragma once

#include "case/key.hpp"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi::case_file
{

/// A formula that must be finite at the nodes of a boundary or the corners of a region: it is noted for the
/// check that follows when the blocks are known.
Expression sampled(const Value& value, Reading& reading, std::span<const std::string_view> variables,
                   const std::string& name, bool on_boundary);

/// A list of two such formulas; the third is 0.
std::array<Expression, 3> sampled_vector(const Value& value, Reading& reading,
                                         std::span<const std::string_view> variables, const std::string& name,
                                         bool on_boundary);

/// 0 or a list of two formulas on a boundary.
std::array<Expression, 3> traction(const Value& value, Reading& reading, const std::string& boundary);

/// Throws Error if a key is not the name of a boundary, proposing boundaries and the section's own keys.
void require_boundary(const Field& field, const std::vector<std::string>& keys, const Reading& reading);

}  // namespace blockfsi::case_file
