#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi::output
{

/// A CSV file that grows by one row per step. Numbers are the shortest text that reads back as the same
/// double; each row reaches the system before `append` returns, so that a killed run loses at most the row
/// being written.
class Table
{
public:
  /// A new table; a file at `path` is replaced. The first column must be "step". Makes missing folders.
  /// Throws Error if the file cannot be written, or if a name is empty or has a comma, quote or line break.
  Table(std::filesystem::path path, std::vector<std::string> columns);

  /// Continues the table at `path` behind step `last`: rows of later steps and a torn last row are dropped,
  /// the others stay as they are, byte for byte. Without a file the table is new. Throws Error if the columns
  /// differ.
  static Table resume(std::filesystem::path path, std::vector<std::string> columns, std::int64_t last);

  /// Adds a row; `values` are the columns behind the step. Throws Error if the row cannot be written.
  void append(std::int64_t step, std::span<const double> values);

  const std::vector<std::string>& columns() const { return columns_; }

private:
  Table() = default;
  void open(std::string_view content);

  std::filesystem::path path_;
  std::vector<std::string> columns_;
  std::ofstream stream_;
};

/// Content of a table.
struct TableData
{
  std::vector<std::string> columns;
  std::vector<std::vector<double>> values;  ///< one per column, all of one length

  /// Values of a column. Throws Error, naming the columns that there are, if it does not exist.
  const std::vector<double>& column(std::string_view name) const;
};

/// Reads a table, also one that a run is still writing: a last row without line end is left out. Throws Error
/// with the place of the first field that is not a number or row that has not one field per column.
TableData read_table(const std::filesystem::path& path);

}  // namespace blockfsi::output
