#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace blockfsi::command
{

/// The parts of a command and the wall time that each took, one after the other.
class Parts
{
public:
  /// Ends the part that began with the end of the one before; the first one began with this object.
  void end(std::string_view name);

  /// A line for each part with its seconds, its share of the whole and the nodes that it did in a second
  /// ("-" if it took no time that the clock can tell), then the sum.
  std::string table(std::size_t node_count) const;

private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::vector<std::pair<std::string_view, double>> seconds_;
};

}  // namespace blockfsi::command
