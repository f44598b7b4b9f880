#pragma once

#include "output/signal.hpp"
#include "output/table.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi::run
{

/// The tables of a run, as far as they exist.
struct Tables
{
  std::vector<std::string> names;  ///< of their files
  std::vector<output::TableData> tables;
};

/// Reads probes.csv, forces.csv and quality.csv of a run, whose later steps may lie in further folders, one
/// behind the other. Tables and columns that one of the folders lacks are left out. Throws Error if a table
/// is damaged.
Tables read_tables(std::span<const std::filesystem::path> folders);

/// Names of columns that a formula uses, each once, in its order. Throws Error if the text holds what no
/// formula contains.
std::vector<std::string> formula_names(std::string_view formula);

/// Values of a formula over time, or why there are none.
struct Series
{
  std::vector<double> time;  ///< [s], of the first column that the formula uses
  std::vector<double> value;
  std::string reason;  ///< empty if the values are known

  output::Signal signal() const { return {time, value}; }
};

/// Which rows of two columns belong together.
enum class Pairing
{
  same_time,  ///< only rows of the same time; columns of other times are refused
  same_row    ///< rows of the same number, for what hardly changes: forces belong to a time within the step
};

/// Evaluates a column, or a formula in columns (grammar of Expression), at each row. A column is looked for
/// in the tables in their order.
Series evaluate(const Tables& tables, const std::string& formula, Pairing pairing);

}  // namespace blockfsi::run
