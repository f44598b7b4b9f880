#include "output/table.hpp"

#include "core/error.hpp"
#include "output/file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <utility>

namespace blockfsi::output
{

namespace
{

std::string join(const std::vector<std::string>& texts, std::string_view separator)
{
  std::string result;
  for (const std::string& text : texts)
    result.append(result.empty() ? "" : separator).append(text);
  return result;
}

std::string header(const std::vector<std::string>& columns)
{
  return join(columns, ",") + "\n";
}

void check_columns(const std::filesystem::path& path, const std::vector<std::string>& columns)
{
  for (const std::string& name : columns)
    if (name.empty() || name.find_first_of(",\"\n\r") != std::string::npos)
      throw Error(
          fmt::format("table '{}' cannot have a column named '{}'; choose a name without commas, quotes "
                      "and line breaks",
                      path.string(), name));
  if (columns.empty() || columns.front() != "step")
    throw Error(fmt::format("the first column of table '{}' must be 'step'", path.string()));
}

/// Takes the text before the next separator off the front.
std::string_view take(std::string_view& text, char separator)
{
  const std::size_t end = text.find(separator);
  const std::string_view front = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return front;
}

std::vector<std::string> split(std::string_view line)
{
  std::vector<std::string> fields;
  const auto count = std::count(line.begin(), line.end(), ',') + 1;
  for (std::ptrdiff_t i = 0; i < count; ++i)
    fields.emplace_back(take(line, ','));
  return fields;
}

std::optional<double> parse(std::string_view field)
{
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc{} || end != field.data() + field.size())
    return std::nullopt;
  return value;
}

/// Content without a last line that has no end.
std::string_view whole_lines(std::string_view content)
{
  return content.substr(0, content.rfind('\n') + 1);
}

/// The rows up to and with step `last`. Rows behind the first later one are dropped whatever they hold.
std::string_view rows_until(std::string_view rows, std::int64_t last)
{
  std::string_view rest = rows;
  while (!rest.empty())
  {
    std::string_view line = rest.substr(0, rest.find('\n'));
    const auto step = parse(take(line, ','));
    if (!step || *step > static_cast<double>(last))
      break;
    rest.remove_prefix(rest.find('\n') + 1);
  }
  return rows.substr(0, rows.size() - rest.size());
}

}  // namespace

Table::Table(std::filesystem::path path, std::vector<std::string> columns)
    : path_(std::move(path)), columns_(std::move(columns))
{
  check_columns(path_, columns_);
  open(header(columns_));
}

Table Table::resume(std::filesystem::path path, std::vector<std::string> columns, std::int64_t last)
{
  if (!std::filesystem::exists(path))
    return {std::move(path), std::move(columns)};
  check_columns(path, columns);
  const std::string content = read_file(path);
  const std::string_view lines = whole_lines(content);
  const std::string expected = header(columns);
  // A process killed before its first row may leave no whole header.
  if (lines.empty())
    return {std::move(path), std::move(columns)};
  if (!lines.starts_with(expected))
    throw Error(fmt::format(
        "table '{}' has the columns '{}', but the case now gives '{}'; restore the case or "
        "start again in another folder",
        path.string(), lines.substr(0, lines.find('\n')), expected.substr(0, expected.size() - 1)));
  Table table;
  table.path_ = std::move(path);
  table.columns_ = std::move(columns);
  table.open(fmt::format("{}{}", expected, rows_until(lines.substr(expected.size()), last)));
  return table;
}

void Table::open(std::string_view content)
{
  replace_file(path_, content);
  stream_.open(path_, std::ios::binary | std::ios::app);
  if (!stream_)
    throw Error(fmt::format("cannot write '{}'; check that the folder is yours", path_.string()));
}

void Table::append(std::int64_t step, std::span<const double> values)
{
  if (values.size() + 1 != columns_.size())
    throw Error(fmt::format("a row of table '{}' has {} values behind the step, but there are {} columns",
                            path_.string(), values.size(), columns_.size() - 1));
  std::string row = fmt::format("{}", step);
  for (const double value : values)
    fmt::format_to(std::back_inserter(row), ",{}", value);
  row += '\n';
  stream_.write(row.data(), static_cast<std::streamsize>(row.size()));
  stream_.flush();
  if (!stream_)
    throw Error(
        fmt::format("cannot write '{}'; the disk may be full: free some space and continue with --restart",
                    path_.string()));
}

const std::vector<double>& TableData::column(std::string_view name) const
{
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end())
    throw Error(fmt::format("the table has no column '{}'; it has {}", name, join(columns, ", ")));
  return values[static_cast<std::size_t>(found - columns.begin())];
}

TableData read_table(const std::filesystem::path& path)
{
  const std::string content = read_file(path);
  std::string_view lines = whole_lines(content);
  if (lines.empty())
    throw Error({path.string()}, "the table is empty; its first line must name the columns");
  TableData data;
  data.columns = split(take(lines, '\n'));
  data.values.resize(data.columns.size());
  for (int number = 2; !lines.empty(); ++number)
  {
    const std::vector<std::string> fields = split(take(lines, '\n'));
    if (fields.size() != data.columns.size())
      throw Error({path.string(), number}, fmt::format("the row has {} fields, but there are {} columns",
                                                       fields.size(), data.columns.size()));
    for (std::size_t c = 0; c < fields.size(); ++c)
    {
      const auto value = parse(fields[c]);
      if (!value)
        throw Error({path.string(), number},
                    fmt::format("'{}' in column '{}' is not a number", fields[c], data.columns[c]));
      data.values[c].push_back(*value);
    }
  }
  return data;
}

}  // namespace blockfsi::output
