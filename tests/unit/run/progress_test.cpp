#include "run/progress.hpp"

#include <doctest/doctest.h>

#include <sstream>
#include <string>
#include <vector>

using namespace blockfsi;

namespace
{

struct Row
{
  std::string name;
  double seconds = 0.0;
  double share = 0.0;
  double per_step = 0.0;
};

/// Rows of a summary behind its head; only parts of their own have a number of calls.
std::vector<Row> rows_of(const std::string& summary)
{
  std::vector<Row> rows;
  std::istringstream lines(summary);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line))
  {
    // Names may have blanks; they take the first sixteen columns.
    Row& row = rows.emplace_back();
    row.name = line.substr(0, line.find_last_not_of(' ', 15) + 1);
    std::istringstream fields(line.substr(16));
    std::string percent;
    fields >> row.seconds >> percent;
    row.share = std::stod(percent);
    for (std::string field; fields >> field;)
      row.per_step = std::stod(field);
  }
  return rows;
}

}  // namespace

TEST_CASE("durations are told in the unit that fits")
{
  CHECK(run::duration(0.0) == "0.0 s");
  CHECK(run::duration(0.84) == "0.8 s");
  CHECK(run::duration(12.4) == "12 s");
  CHECK(run::duration(252.0) == "4 min 12 s");
  CHECK(run::duration(7500.0) == "2 h 5 min");
  CHECK(run::duration(360000.0) == "100 h 0 min");
}

TEST_CASE("durations that round up go over to the next unit")
{
  CHECK(run::duration(59.4) == "59 s");
  CHECK(run::duration(59.6) == "1 min 0 s");
  CHECK(run::duration(119.7) == "2 min 0 s");
  CHECK(run::duration(3599.6) == "1 h 0 min");
}

TEST_CASE("the timing summary has a row for each part and adds up")
{
  Timings timings;
  for (std::size_t i = 0; i < task_names.size(); ++i)
  {
    timings.seconds[i] = 0.25 * static_cast<double>(i + 1);
    timings.calls[i] = 10;
  }
  const double named = 0.125 * static_cast<double>(task_names.size() * (task_names.size() + 1));
  const std::vector<Row> rows = rows_of(run::timing_summary(timings, 10.0, 4));
  REQUIRE(rows.size() == task_names.size() + 2);
  double share = 0.0;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i)
  {
    share += rows[i].share;
    CHECK(rows[i].per_step == doctest::Approx(250.0 * rows[i].seconds));
  }
  for (std::size_t i = 0; i < task_names.size(); ++i)
  {
    CHECK(rows[i].name == task_names[i]);
    CHECK(rows[i].seconds == timings.seconds[i]);
  }
  CHECK(share == doctest::Approx(100.0));
  CHECK(rows[rows.size() - 2].name == "rest");
  CHECK(rows[rows.size() - 2].seconds == doctest::Approx(10.0 - named));
  CHECK(rows.back().name == "total");
  CHECK(rows.back().seconds == doctest::Approx(10.0));
}

TEST_CASE("a run without a step has a timing summary")
{
  for (const Row& row : rows_of(run::timing_summary({}, 0.5, 0)))
    CHECK(row.per_step == 0.0);
}
