#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace blockfsi::output
{

/// One region's fields at one time.
struct Snapshot
{
  double time = 0.0;   ///< [s]
  std::string region;  ///< ParaView makes one block of each region
  std::string file;    ///< relative to the series

  bool operator==(const Snapshot&) const = default;
};

/// Time series of field files for ParaView (.pvd), replaced as a whole at each addition, so that it can be
/// opened while the run goes on.
class Series
{
public:
  /// A new series; a file at `path` is replaced at the first addition.
  explicit Series(std::filesystem::path path);

  /// Continues the series at `path` behind time `last` [s]: later snapshots are dropped. Without a file the
  /// series is new. Throws Error if the file is not such a series.
  static Series resume(std::filesystem::path path, double last);

  /// Adds the snapshots of one time and writes the file. Throws Error if it cannot be written.
  void add(std::span<const Snapshot> snapshots);

  const std::vector<Snapshot>& snapshots() const { return snapshots_; }

private:
  std::filesystem::path path_;
  std::vector<Snapshot> snapshots_;
};

/// The snapshots of a series. Throws Error if the file cannot be read or is not such a series.
std::vector<Snapshot> read_series(const std::filesystem::path& path);

}  // namespace blockfsi::output
