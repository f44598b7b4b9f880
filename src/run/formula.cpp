#include "run/formula.hpp"

#include "core/error.hpp"
#include "core/expression.hpp"
#include "core/expression_lexer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace blockfsi::run
{

namespace
{

/// A column and its table.
struct Found
{
  const output::TableData* table = nullptr;
  const std::vector<double>* values = nullptr;
};

Found find(const Tables& tables, std::string_view name)
{
  for (const output::TableData& table : tables.tables)
    if (std::find(table.columns.begin(), table.columns.end(), name) != table.columns.end())
      return {&table, &table.column(name)};
  return {};
}

std::string no_column(const Tables& tables, std::string_view name)
{
  if (tables.names.empty())
    return "there are no results; run the case first";
  return fmt::format("{} {} no column '{}'", fmt::join(tables.names, ", "),
                     tables.names.size() == 1 ? "has" : "have", name);
}

/// Appends the rows of a table, in the columns that both have.
void append(output::TableData& table, const output::TableData& more)
{
  output::TableData both;
  for (const std::string& name : table.columns)
    if (std::find(more.columns.begin(), more.columns.end(), name) != more.columns.end())
    {
      both.columns.push_back(name);
      std::vector<double>& values = both.values.emplace_back(table.column(name));
      const std::vector<double>& rest = more.column(name);
      values.insert(values.end(), rest.begin(), rest.end());
    }
  table = std::move(both);
}

/// Extrema and means of a signal with a gap would hide it.
Series checked(Series series, std::string_view formula)
{
  for (std::size_t k = 0; k < series.value.size() && series.reason.empty(); ++k)
    if (!std::isfinite(series.value[k]))
      series.reason = fmt::format("'{}' is {} at time {:g}", formula, series.value[k], series.time[k]);
  return series;
}

/// The columns of that name, all usable together; otherwise the reason is set.
std::vector<Found> collect(const Tables& tables, const std::vector<std::string>& names, Pairing pairing,
                           std::string& reason)
{
  std::vector<Found> columns;
  for (const std::string& name : names)
  {
    columns.push_back(find(tables, name));
    const Found& column = columns.back();
    const Found& first = columns.front();
    if (column.values == nullptr)
      reason = no_column(tables, name);
    else if (column.values->size() != first.values->size())
      reason = fmt::format("'{}' and '{}' have different numbers of rows", names.front(), name);
    else if (pairing == Pairing::same_time && column.table->column("time") != first.table->column("time"))
      reason = fmt::format("'{}' and '{}' are recorded at different times", names.front(), name);
    if (!reason.empty())
      return {};
  }
  return columns;
}

}  // namespace

Tables read_tables(std::span<const std::filesystem::path> folders)
{
  Tables result;
  for (const char* name : {"probes.csv", "forces.csv", "quality.csv"})
  {
    if (folders.empty() ||
        !std::all_of(folders.begin(), folders.end(),
                     [name](const auto& folder) { return std::filesystem::exists(folder / name); }))
      continue;
    result.names.emplace_back(name);
    output::TableData& table = result.tables.emplace_back(output::read_table(folders.front() / name));
    for (const std::filesystem::path& folder : folders.subspan(1))
      append(table, output::read_table(folder / name));
  }
  return result;
}

std::vector<std::string> formula_names(std::string_view formula)
{
  using expression::Token;
  static constexpr std::array<std::string_view, 4> reserved = {"pi", "and", "or", "not"};
  std::vector<std::string> names;
  expression::Lexer lexer(formula);
  while (lexer.now().kind != Token::Kind::end)
  {
    const Token token = lexer.now();
    lexer.advance();
    const bool is_call = lexer.now().text == "(";
    if (token.kind == Token::Kind::name && !is_call &&
        std::find(reserved.begin(), reserved.end(), token.text) == reserved.end() &&
        std::find(names.begin(), names.end(), token.text) == names.end())
      names.emplace_back(token.text);
  }
  return names;
}

Series evaluate(const Tables& tables, const std::string& formula, Pairing pairing)
{
  if (const Found column = find(tables, formula); column.values != nullptr)
    return checked({column.table->column("time"), *column.values, {}}, formula);
  const std::vector<std::string> names = formula_names(formula);
  if (names.empty())
    return {{}, {}, fmt::format("'{}' uses no column of the results", formula)};
  Series result;
  const std::vector<Found> columns = collect(tables, names, pairing, result.reason);
  if (!result.reason.empty())
    return result;
  result.time = columns.front().table->column("time");
  Constants row;
  for (std::size_t k = 0; k < result.time.size(); ++k)
  {
    for (std::size_t c = 0; c < columns.size(); ++c)
      row[names[c]] = (*columns[c].values)[k];
    result.value.push_back(Expression(formula, row, {})(0.0));
  }
  return checked(std::move(result), formula);
}

}  // namespace blockfsi::run
