#pragma once

namespace blockfsi::geometry
{

/// Functions for the alternatives of a variant, for std::visit.
template <typename... Functions>
struct Overloaded : Functions...
{
  using Functions::operator()...;
};
template <typename... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace blockfsi::geometry
