#pragma once

#include "block/layout.hpp"
#include "core/error.hpp"

#include <string>
#include <vector>

namespace blockfsi::block
{

/// "'nose' (0.15, 0.2)": how messages name a point of a layout.
std::string point_text(const Layout& layout, int point);

/// "from 'a' (0, 0) to 'b' (1, 0)": how messages name an edge.
std::string edge_text(const Layout& layout, int a, int b);

/// "edge from 'a' (0, 0) to 'b' (1, 0)" or "face over 'a' (0, 0, 0), 'b' (1, 0, 0) and 'c' (0, 1, 0)": how
/// messages name a side of a block.
std::string side_text(const Layout& layout, const std::vector<int>& points);

/// " (flap.toml:12:3)", or nothing if the place is unknown.
std::string place_text(const Location& where);

/// An error at a place, or without one if the place is unknown.
Error mistake(const Location& where, std::string message);

}  // namespace blockfsi::block
