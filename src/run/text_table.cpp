#include "run/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace blockfsi::run
{

namespace
{

std::string quoted(const std::string& field)
{
  if (field.find_first_of(",\"\n") == std::string::npos)
    return field;
  std::string result = "\"";
  for (const char letter : field)
    result += letter == '"' ? "\"\"" : std::string(1, letter);
  return result + "\"";
}

std::string line(const std::vector<std::string>& fields)
{
  std::string result;
  for (const std::string& field : fields)
    result += (result.empty() ? "" : ",") + quoted(field);
  return result + "\n";
}

}  // namespace

std::string aligned(const TextTable& table)
{
  std::vector<std::size_t> widths;
  for (const std::string& name : table.header)
    widths.push_back(name.size());
  for (const std::vector<std::string>& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], row[i].size());
  std::string result;
  const auto add = [&](const std::vector<std::string>& row)
  {
    for (std::size_t i = 0; i < row.size(); ++i)
      result +=
          i == 0 ? fmt::format("{:<{}}", row[i], widths[i]) : fmt::format("  {:>{}}", row[i], widths[i]);
    result += "\n";
  };
  add(table.header);
  for (const std::vector<std::string>& row : table.rows)
    add(row);
  return result;
}

std::string csv(const TextTable& table)
{
  std::string result = line(table.header);
  for (const std::vector<std::string>& row : table.rows)
    result += line(row);
  return result;
}

}  // namespace blockfsi::run
