#include "output/table.hpp"

#include "core/error.hpp"
#include "output/file.hpp"
#include "temporary.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>

using namespace blockfsi;

namespace
{

const std::vector<std::string> columns = {"step", "time", "tip_y"};

void append_text(const std::filesystem::path& path, std::string_view text)
{
  std::ofstream(path, std::ios::app) << text;
}

}  // namespace

TEST_CASE("a table's header stands once and each row is in the file as soon as it is appended")
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "results" / "probes.csv";
  output::Table table(path, columns);
  CHECK(output::read_file(path) == "step,time,tip_y\n");
  table.append(1, std::vector{0.1, -2.5e-7});
  CHECK(output::read_file(path) == "step,time,tip_y\n1,0.1,-2.5e-07\n");
  table.append(2, std::vector{0.2, 3.0});
  CHECK(output::read_file(path) == "step,time,tip_y\n1,0.1,-2.5e-07\n2,0.2,3\n");
}

TEST_CASE("numbers read back from a table are the same doubles")
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "t.csv";
  const std::vector<double> values = {0.1,
                                      1.0 / 3.0,
                                      std::numbers::pi * 1e-200,
                                      std::nextafter(1.0, 2.0),
                                      std::numeric_limits<double>::denorm_min(),
                                      -std::numeric_limits<double>::max(),
                                      -std::numeric_limits<double>::infinity()};
  output::Table table(path, {"step", "value"});
  for (std::size_t k = 0; k < values.size(); ++k)
    table.append(static_cast<std::int64_t>(k), std::span(&values[k], 1));
  table.append(99, std::vector{std::numeric_limits<double>::quiet_NaN()});
  std::vector<double> read = output::read_table(path).column("value");
  CHECK(std::isnan(read.back()));
  read.pop_back();
  CHECK(read == values);
}

TEST_CASE("a resumed table is byte for byte that of a run without interruption")
{
  const TemporaryFolder folder;
  const auto whole = folder.path() / "whole.csv";
  const auto parts = folder.path() / "parts.csv";
  const auto row = [](int step) { return std::vector{0.01 * step, std::sin(0.3 * step)}; };
  {
    output::Table table(whole, columns);
    for (int step = 1; step <= 20; ++step)
      table.append(step, row(step));
  }
  {
    output::Table table(parts, columns);
    for (int step = 1; step <= 13; ++step)
      table.append(step, row(step));
  }
  append_text(parts, "14,0.14,0.4");
  output::Table table = output::Table::resume(parts, columns, 10);
  for (int step = 11; step <= 20; ++step)
    table.append(step, row(step));
  CHECK(output::read_file(parts) == output::read_file(whole));
}

TEST_CASE("a torn last row is dropped even where its step is to be kept")
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "t.csv";
  output::replace_file(path, "step,time,tip_y\n1,0.1,1\n2,0.2,1.2");
  output::Table table = output::Table::resume(path, columns, 5);
  CHECK(output::read_file(path) == "step,time,tip_y\n1,0.1,1\n");
}

TEST_CASE("resuming without a file or with a torn header begins a new table")
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "t.csv";
  {
    output::Table table = output::Table::resume(path, columns, 5);
    CHECK(output::read_file(path) == "step,time,tip_y\n");
  }
  output::replace_file(path, "step,ti");
  output::Table table = output::Table::resume(path, columns, 5);
  CHECK(output::read_file(path) == "step,time,tip_y\n");
}

TEST_CASE("resuming with other columns is refused and leaves the file alone")
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "t.csv";
  output::replace_file(path, "step,time,drag\n1,0.1,1\n");
  CHECK_THROWS_WITH_AS(output::Table::resume(path, columns, 5),
                       doctest::Contains("has the columns 'step,time,drag', but the case now gives "
                                         "'step,time,tip_y'; restore the case or start again"),
                       Error);
  CHECK(output::read_file(path) == "step,time,drag\n1,0.1,1\n");
}

TEST_CASE("reading a table leaves out a row that is still being written")
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "t.csv";
  output::replace_file(path, "step,time\n1,0.5\n2,1.");
  const output::TableData data = output::read_table(path);
  CHECK(data.columns == std::vector<std::string>{"step", "time"});
  CHECK(data.column("time") == std::vector{0.5});
}

TEST_CASE("what is wrong with a table is told with its place")
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "t.csv";
  output::replace_file(path, "step,time\n1,0.5\n2,soon\n");
  CHECK_THROWS_WITH_AS(output::read_table(path),
                       (path.string() + ":3: 'soon' in column 'time' is not a number").c_str(), Error);
  output::replace_file(path, "step,time\n1\n");
  CHECK_THROWS_WITH_AS(output::read_table(path),
                       (path.string() + ":2: the row has 1 fields, but there are 2 columns").c_str(), Error);
  output::replace_file(path, "");
  CHECK_THROWS_AS(output::read_table(path), Error);
  output::replace_file(path, "step,time\n");
  CHECK_THROWS_WITH_AS(output::read_table(path).column("drag"),
                       "the table has no column 'drag'; it has step, time", Error);
  CHECK_THROWS_WITH_AS(output::read_table(folder.path() / "none.csv"),
                       doctest::Contains("none.csv': No such file or directory"), Error);
}

TEST_CASE("columns and rows that would break a table are refused")
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "t.csv";
  CHECK_THROWS_AS(output::Table(path, {"step", "a,b"}), Error);
  CHECK_THROWS_AS(output::Table(path, {"time", "step"}), Error);
  CHECK_FALSE(std::filesystem::exists(path));
  output::Table table(path, columns);
  CHECK_THROWS_AS(table.append(1, std::vector{1.0}), Error);
}
