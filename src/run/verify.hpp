#pragma once

#include "run/reference.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi::run
{

/// A reference and what the run gave.
struct Comparison
{
  Reference reference;
  double computed = 0.0;   ///< NaN if it is not known
  double deviation = 0.0;  ///< computed - reference, divided by |reference| where the tolerance is relative
  bool ok = false;
  std::string reason;  ///< why there is no computed value
};

/// Compares the tables of a run, in one folder or in several of which each goes on where the one before ends,
/// with the references of a level, "short" or "full". Signals are read as output/signal.hpp says. What a run
/// does not give, or not yet (no such column, too few periods), is a missed comparison with its reason.
/// Throws Error if the references or a table are malformed, if the level is unknown, or if it has no
/// references.
std::vector<Comparison> compare(const std::filesystem::path& reference,
                                std::span<const std::filesystem::path> results, std::string_view level);

/// Whether all comparisons are within their tolerance.
bool all_ok(std::span<const Comparison> comparisons);

/// A table for people: quantity, statistic, computed, reference, deviation, tolerance and ok or MISSED with
/// the reason, one line each, and a last line with the count.
std::string report(std::span<const Comparison> comparisons);

}  // namespace blockfsi::run
