#include "run/reference.hpp"

#include "core/expression.hpp"
#include "output/file.hpp"
#include "run/formula.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace blockfsi::run
{

namespace
{

constexpr std::array<std::string_view, 9> statistic_names = {
    "last", "steady", "greatest", "least", "maximum", "minimum", "mean", "amplitude", "frequency"};
constexpr std::array<std::string_view, 4> kind_names = {"relative", "absolute", "at least", "at most"};

/// Columns of the file, in the order of the numbers below.
constexpr std::array<std::string_view, 9> column_names = {
    "quantity", "statistic", "clock", "factor", "value", "tolerance", "kind", "level", "source"};
enum Column : std::size_t
{
  quantity,
  statistic,
  clock_column,
  factor,
  value,
  tolerance,
  kind,
  level,
  source
};

struct Field
{
  std::string text;
  Location where;
};

bool is_periodic(Statistic s)
{
  return s >= Statistic::maximum;
}

std::string_view trim(std::string_view text)
{
  const std::size_t begin = text.find_first_not_of(" \t");
  return begin == std::string_view::npos ? std::string_view{}
                                         : text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// Takes a field in double quotes, in which "" means ", off the front of `rest`, with what is behind it up to
/// the comma.
std::string take_quoted(std::string_view& rest, const Location& where)
{
  std::string text;
  rest.remove_prefix(1);
  for (;; rest.remove_prefix(1))
  {
    if (rest.empty())
      throw Error(where, "the field begins with a double quote, but the line ends without a second one");
    if (rest.front() == '"')
    {
      rest.remove_prefix(1);
      if (!rest.starts_with('"'))
        break;
    }
    text += rest.front();
  }
  const std::string_view behind = trim(rest.substr(0, rest.find(',')));
  if (!behind.empty())
    throw Error(where,
                fmt::format("found '{}' behind the closing double quote; only a comma may follow", behind));
  rest.remove_prefix(std::min(rest.find(','), rest.size()));
  return text;
}

std::vector<Field> split(std::string_view line, const Location& begin)
{
  std::vector<Field> fields;
  for (std::string_view rest = line;;)
  {
    const std::size_t blank = std::min(rest.find_first_not_of(" \t"), rest.size());
    rest.remove_prefix(blank);
    const Location where{begin.file, begin.line, static_cast<int>(line.size() - rest.size()) + 1};
    if (rest.starts_with('"'))
      fields.push_back({take_quoted(rest, where), where});
    else
    {
      const std::string_view text = rest.substr(0, rest.find(','));
      fields.push_back({std::string(trim(text)), where});
      rest.remove_prefix(text.size());
    }
    if (rest.empty())
      return fields;
    rest.remove_prefix(1);
  }
}

template <std::size_t count>
std::size_t position(const std::array<std::string_view, count>& names, std::string_view name)
{
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// For each of column_names where it stands in the file.
std::array<std::size_t, column_names.size()> read_header(const std::vector<Field>& header,
                                                         const Location& where)
{
  std::array<std::size_t, column_names.size()> places{};
  places.fill(header.size());
  for (std::size_t i = 0; i < header.size(); ++i)
  {
    const std::size_t column = position(column_names, header[i].text);
    if (column == column_names.size())
      throw Error(header[i].where, fmt::format("unknown column '{}'; the columns are {}", header[i].text,
                                               fmt::join(column_names, ", ")));
    if (places[column] != header.size())
      throw Error(header[i].where, fmt::format("column '{}' stands here a second time", header[i].text));
    places[column] = i;
  }
  for (std::size_t column = 0; column < places.size(); ++column)
    if (places[column] == header.size())
      throw Error(where, fmt::format("column '{}' is missing; the columns are {}", column_names[column],
                                     fmt::join(column_names, ", ")));
  return places;
}

double read_number(const Field& field, std::string_view name)
{
  double number = 0.0;
  const char* const last = field.text.data() + field.text.size();
  const auto [end, error] = std::from_chars(field.text.data(), last, number);
  if (error != std::errc{} || end != last || !std::isfinite(number))
    throw Error(field.where, fmt::format("the {} is '{}', which is not a number", name, field.text));
  return number;
}

void read_statistic(const Field& field, Reference& reference)
{
  const std::size_t digits = std::min(field.text.find_first_of("0123456789"), field.text.size());
  const std::size_t found = position(statistic_names, std::string_view(field.text).substr(0, digits));
  if (found == statistic_names.size())
    throw Error(field.where,
                fmt::format("unknown statistic '{}'; allowed are {}, the last five also followed by a "
                            "number of periods, as in amplitude5",
                            field.text, fmt::join(statistic_names, ", ")));
  reference.statistic = static_cast<Statistic>(found);
  if (digits == field.text.size())
    return;
  const char* const last = field.text.data() + field.text.size();
  const auto [end, error] = std::from_chars(field.text.data() + digits, last, reference.periods);
  if (error != std::errc{} || end != last || reference.periods < 1 || !is_periodic(reference.statistic))
    throw Error(
        field.where,
        fmt::format("found the statistic '{}'; a number of periods, at least 1, may follow maximum, minimum, "
                    "mean, amplitude and frequency only",
                    field.text));
}

void read_tolerance(const Field& kind_field, const Field& field, Reference& reference)
{
  const std::size_t found = position(kind_names, kind_field.text);
  if (found == kind_names.size())
    throw Error(kind_field.where, fmt::format("unknown kind of tolerance '{}'; allowed are {}",
                                              kind_field.text, fmt::join(kind_names, ", ")));
  reference.kind = static_cast<Kind>(found);
  if (reference.kind == Kind::at_least || reference.kind == Kind::at_most)
  {
    if (!field.text.empty())
      throw Error(field.where,
                  fmt::format("the kind '{}' has no tolerance, but found '{}'; leave the field empty",
                              kind_field.text, field.text));
    return;
  }
  reference.tolerance = read_number(field, "tolerance");
  if (reference.tolerance <= 0.0)
    throw Error(field.where, fmt::format("the tolerance is {}; it must be positive", field.text));
  if (reference.kind == Kind::relative && reference.value == 0.0)
    throw Error(kind_field.where,
                "a tolerance relative to the reference 0 allows no error; use the kind absolute");
}

void read_level(const Field& field, Reference& reference)
{
  if (field.text != "short" && field.text != "full" && field.text != "both")
    throw Error(field.where, fmt::format("unknown level '{}'; allowed are short, full, both", field.text));
  reference.in_short = field.text != "full";
  reference.in_full = field.text != "short";
}

/// Checks the grammar of a formula where it is written; which columns exist is known only with the results.
void check_formula(const Field& field, std::string_view name)
{
  if (field.text.empty())
    throw Error(field.where, fmt::format("the {} is empty; name a column of the results", name));
  try
  {
    Constants any;
    for (const std::string& column : formula_names(field.text))
      any[column] = 1.0;
    const Expression parsed(field.text, any, {});
  }
  catch (const Error& error)
  {
    throw error.at(field.where);
  }
}

Reference read_row(const std::vector<Field>& fields,
                   const std::array<std::size_t, column_names.size()>& places)
{
  const auto field = [&](Column column) -> const Field& { return fields[places[column]]; };
  Reference result;
  result.where = fields.front().where;
  check_formula(field(quantity), "quantity");
  result.quantity = field(quantity).text;
  read_statistic(field(statistic), result);
  if (result.clock = field(clock_column).text; !result.clock.empty())
  {
    if (!is_periodic(result.statistic))
      throw Error(field(clock_column).where,
                  fmt::format("found the clock '{}', but the statistic '{}' counts no periods; "
                              "leave the field empty",
                              result.clock, field(statistic).text));
    check_formula(field(clock_column), "clock");
  }
  if (!field(factor).text.empty())
    result.factor = read_number(field(factor), "factor");
  result.value = read_number(field(value), "value");
  read_tolerance(field(kind), field(tolerance), result);
  read_level(field(level), result);
  result.source = field(source).text;
  return result;
}

}  // namespace

std::vector<Reference> read_references(const std::filesystem::path& path)
{
  const std::string content = output::read_file(path);
  std::vector<Reference> references;
  std::array<std::size_t, column_names.size()> places{};
  std::size_t width = 0;
  int number = 0;
  for (std::string_view rest = content; !rest.empty();)
  {
    std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    if (line.ends_with('\r'))
      line.remove_suffix(1);
    const Location where{path.string(), ++number};
    if (trim(line).empty())
      continue;
    const std::vector<Field> fields = split(line, where);
    if (width == 0)
    {
      places = read_header(fields, where);
      width = fields.size();
      continue;
    }
    if (fields.size() != width)
      throw Error(
          where,
          fmt::format("the row has {} fields, but there are {} columns; put double quotes around fields "
                      "that have commas",
                      fields.size(), width));
    references.push_back(read_row(fields, places));
  }
  if (references.empty())
    throw Error({path.string()},
                "the table has no references; its first line names the columns, the others have one "
                "reference each");
  return references;
}

std::string statistic_name(const Reference& reference)
{
  const std::string_view name = statistic_names[static_cast<std::size_t>(reference.statistic)];
  return reference.periods > 1 ? fmt::format("{}{}", name, reference.periods) : std::string(name);
}

}  // namespace blockfsi::run
