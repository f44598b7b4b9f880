#pragma once

#include "block/connect.hpp"
#include "case/case.hpp"
#include "coupling/transfer.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace blockfsi::run
{

/// The blocks as the solid divides them.
struct SolidBlocks
{
  block::Layout layout;
  block::Skeleton skeleton;
};

/// Where fluid and solid meet; everything but `own` is empty without the one or the other.
struct Interfaces
{
  /// If the solid's cells are of another order or number; else it shares the skeleton of the fluid.
  std::optional<SolidBlocks> own;
  /// Skeleton numbers of the nodes on the interface, of the fluid and of the solid.
  std::vector<std::int64_t> fluid;
  std::vector<std::int64_t> solid;
  coupling::Transfer transfer;
};

/// `skeleton`: that of the case's layout.
Interfaces match_interfaces(const case_file::Case& description, const block::Skeleton& skeleton);

}  // namespace blockfsi::run
