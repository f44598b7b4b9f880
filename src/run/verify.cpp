#include "run/verify.hpp"

#include "core/error.hpp"
#include "output/signal.hpp"
#include "run/formula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace blockfsi::run
{

namespace
{

/// A number, or why there is none.
struct Outcome
{
  double value = std::numeric_limits<double>::quiet_NaN();
  std::string reason;
};

Outcome unknown(std::string reason)
{
  return {.reason = std::move(reason)};
}

Outcome of_steady(const Series& series, const Reference& reference)
{
  const output::Steady steady = output::read_steady(series.signal());
  const double scale = reference.kind == Kind::relative ? std::abs(reference.value) : 1.0;
  const double drift = std::abs(reference.factor) * steady.drift;
  // Bounds without a tolerance leave no measure of how still a signal must be.
  if (reference.tolerance > 0.0 && !(drift <= reference.tolerance * scale))
    return unknown(fmt::format("not steady yet: it changed by {:.2g} in the last tenth of the run", drift));
  return {steady.value, {}};
}

std::string uneven(double disagreement)
{
  return fmt::format("not periodic yet: the last three periods differ by {:.2g} % in amplitude",
                     100.0 * disagreement);
}

Outcome of_periods(const Series& series, const Series& clock_series, const Reference& reference)
{
  const output::Reading reading{.window = std::max(output::Reading{}.window, reference.periods),
                                .least = std::max(output::Reading{}.least, reference.periods),
                                .averaged = reference.periods};
  const output::Clock clock = output::find_periods(clock_series.signal(), reading);
  const output::Statistics beat = output::read_periods(clock_series.signal(), clock, reading);
  if (!clock.found || std::isnan(beat.amplitude))
    return unknown(fmt::format("not periodic yet: {} periods up to the end, at least {} are needed",
                               std::max(0, clock.periods), reading.least));
  if (!beat.periodic)
    return unknown(uneven(beat.disagreement));
  const output::Statistics statistics = output::read_periods(series.signal(), clock, reading);
  switch (reference.statistic)
  {
  case Statistic::frequency:
    return {clock.frequency, {}};
  case Statistic::maximum:
    return {statistics.maximum, {}};
  case Statistic::minimum:
    return {statistics.minimum, {}};
  case Statistic::mean:
    return {statistics.mean, {}};
  default:
    return {statistics.amplitude, {}};
  }
}

Outcome read(const Tables& tables, const Reference& reference)
{
  const bool still = reference.statistic == Statistic::last || reference.statistic == Statistic::steady;
  const Pairing pairing = still ? Pairing::same_row : Pairing::same_time;
  const Series series = evaluate(tables, reference.quantity, pairing);
  if (!series.reason.empty())
    return unknown(series.reason);
  if (series.value.empty())
    return unknown("the run has written no row yet");
  switch (reference.statistic)
  {
  case Statistic::last:
    return {series.value.back(), {}};
  case Statistic::steady:
    return of_steady(series, reference);
  case Statistic::greatest:
    return {output::find_extrema(series.signal()).greatest.value, {}};
  case Statistic::least:
    return {output::find_extrema(series.signal()).least.value, {}};
  default:
    break;
  }
  if (reference.clock.empty())
    return of_periods(series, series, reference);
  const Series clock = evaluate(tables, reference.clock, pairing);
  return clock.reason.empty() ? of_periods(series, clock, reference) : unknown(clock.reason);
}

bool within(const Comparison& comparison)
{
  switch (comparison.reference.kind)
  {
  case Kind::at_least:
    return comparison.deviation >= 0.0;
  case Kind::at_most:
    return comparison.deviation <= 0.0;
  default:
    return std::abs(comparison.deviation) <= comparison.reference.tolerance;
  }
}

Comparison compare(const Tables& tables, const Reference& reference)
{
  const Outcome outcome = read(tables, reference);
  Comparison result{reference, reference.factor * outcome.value, 0.0, false, outcome.reason};
  result.deviation = result.computed - reference.value;
  if (reference.kind == Kind::relative)
    result.deviation /= std::abs(reference.value);
  result.ok = result.reason.empty() && within(result);
  return result;
}

std::string tolerance(const Reference& reference)
{
  switch (reference.kind)
  {
  case Kind::at_least:
    return "at least";
  case Kind::at_most:
    return "at most";
  case Kind::absolute:
    return fmt::format("{:g} abs", reference.tolerance);
  default:
    return fmt::format("{:g}", reference.tolerance);
  }
}

using Row = std::array<std::string, 7>;

Row row(const Comparison& comparison)
{
  const Reference& reference = comparison.reference;
  const bool known = comparison.reason.empty();
  const std::string factor = reference.factor == 1.0 ? "" : fmt::format("{:g} * ", reference.factor);
  const bool is_sum = factor.empty() || reference.quantity.find(' ') == std::string::npos;
  return {factor + (is_sum ? reference.quantity : fmt::format("({})", reference.quantity)),
          statistic_name(reference),
          known ? fmt::format("{:.9g}", comparison.computed) : "-",
          fmt::format("{:.9g}", reference.value),
          known ? fmt::format("{:+.2e}", comparison.deviation) : "-",
          tolerance(reference),
          comparison.ok ? "ok"
          : known       ? "MISSED"
                        : "MISSED: " + comparison.reason};
}

}  // namespace

std::vector<Comparison> compare(const std::filesystem::path& reference,
                                std::span<const std::filesystem::path> results, std::string_view level)
{
  if (level != "short" && level != "full")
    throw Error(fmt::format("unknown level '{}'; allowed are short, full", level));
  const Tables tables = read_tables(results);
  std::vector<Comparison> comparisons;
  for (const Reference& row : read_references(reference))
    if (level == "short" ? row.in_short : row.in_full)
      comparisons.push_back(compare(tables, row));
  if (comparisons.empty())
    throw Error({reference.string()}, fmt::format("there is no reference of level '{}'", level));
  return comparisons;
}

bool all_ok(std::span<const Comparison> comparisons)
{
  return std::all_of(comparisons.begin(), comparisons.end(), [](const Comparison& c) { return c.ok; });
}

std::string report(std::span<const Comparison> comparisons)
{
  std::vector<Row> rows = {{"quantity", "statistic", "computed", "reference", "deviation", "tolerance", ""}};
  for (const Comparison& comparison : comparisons)
    rows.push_back(row(comparison));
  std::array<std::size_t, std::tuple_size_v<Row>> widths{};
  for (const Row& cells : rows)
    for (std::size_t c = 0; c < cells.size(); ++c)
      widths[c] = std::max(widths[c], cells[c].size());
  std::string text;
  for (const Row& cells : rows)
  {
    std::string line;
    for (std::size_t c = 0; c < cells.size(); ++c)
      line += fmt::format("{:<{}}  ", cells[c], widths[c]);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  const auto held =
      std::count_if(comparisons.begin(), comparisons.end(), [](const Comparison& c) { return c.ok; });
  return text + fmt::format("{} of {} within tolerance\n", held, comparisons.size());
}

}  // namespace blockfsi::run
