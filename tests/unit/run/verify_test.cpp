#include "run/verify.hpp"

#include "../output/temporary.hpp"
#include "core/error.hpp"
#include "output/file.hpp"
#include "output/table.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <vector>

using namespace blockfsi;

namespace
{

constexpr double turn = 2.0 * std::numbers::pi;
constexpr std::string_view header = "quantity,statistic,clock,factor,value,tolerance,kind,level,source\n";

using Function = std::function<double(double)>;

/// A folder with reference.csv and the tables of a run.
class Bench
{
public:
  /// A table with the columns step, time and `names`; row k is at time (k + 1 - shift) dt.
  void table(const std::string& file, const std::vector<std::string>& names,
             const std::vector<Function>& functions, double end, double dt, double shift = 0.0)
  {
    std::vector<std::string> columns = {"step", "time"};
    columns.insert(columns.end(), names.begin(), names.end());
    output::Table result(folder_.path() / file, columns);
    const int count = static_cast<int>(std::lround(end / dt));
    for (int k = 0; k < count; ++k)
    {
      std::vector<double> row = {(k + 1 - shift) * dt};
      for (const Function& f : functions)
        row.push_back(f(row.front()));
      result.append(k + 1, row);
    }
  }

  const std::filesystem::path& path() const { return folder_.path(); }

  std::vector<run::Comparison> compare(std::string_view rows, std::string_view level = "full") const
  {
    return compare(rows, level, std::array{folder_.path()});
  }
  std::vector<run::Comparison> compare(std::string_view rows, std::string_view level,
                                       std::span<const std::filesystem::path> results) const
  {
    output::replace_file(folder_.path() / "reference.csv", std::string(header) + std::string(rows));
    return run::compare(folder_.path() / "reference.csv", results, level);
  }

  run::Comparison single(std::string_view row) const { return compare(row).front(); }

  /// The message for a malformed table of references, without the folder.
  std::string mistake(std::string_view content) const
  {
    const std::filesystem::path path = folder_.path() / "reference.csv";
    output::replace_file(path, content);
    try
    {
      run::compare(path, std::array{folder_.path()}, "full");
    }
    catch (const Error& error)
    {
      const std::string text = error.what();
      return text.starts_with(path.string()) ? text.substr(folder_.path().string().size() + 1) : text;
    }
    return "none";
  }
  std::string mistake_in_row(std::string_view row) const
  {
    return mistake(std::string(header) + std::string(row));
  }

private:
  TemporaryFolder folder_;
};

/// A flow that has become steady, and a mesh that is worst at time 4.
void write_steady_flow(Bench& bench)
{
  bench.table("probes.csv", {"front_p", "back_p"}, {[](double) { return 0.7; }, [](double) { return 0.2; }},
              10, 0.1);
  bench.table("forces.csv", {"total_x", "total_y"},
              {[](double t) { return 0.01116 + std::exp(-4.0 * t); }, [](double) { return -2.0; }}, 10, 0.1,
              0.5);
  bench.table("quality.csv", {"scaled_jacobian"},
              {[](double t) { return 0.3 + 0.02 * (t - 4.0) * (t - 4.0); }}, 10, 0.1);
}

/// A flap with 2.5 Hz about 0.1, and a drag of twice its frequency at times within the steps.
void write_flap(Bench& bench, double end)
{
  bench.table("probes.csv", {"tip_ux", "tip_uy"},
              {[](double t) { return -0.2 + 0.03 * std::sin(2 * 2.5 * turn * t); },
               [](double t) { return 0.1 + 1.1 * std::sin(2.5 * turn * t); }},
              end, 0.005);
  bench.table("forces.csv", {"total_x"},
              {[](double t) { return 3.0 + 0.6 * std::sin(2 * 2.5 * turn * t + 0.3); }}, end, 0.005, 0.5);
}

}  // namespace

TEST_CASE("a steady value is the last one, times its factor")
{
  Bench bench;
  write_steady_flow(bench);
  const run::Comparison drag =
      bench.single("total_x,steady,,500,5.58,1e-6,relative,full,\"Nabh 1998, table\"\n");
  CHECK(drag.ok);
  CHECK(drag.computed == doctest::Approx(5.58).epsilon(1e-12));
  CHECK(std::abs(drag.deviation) < 1e-12);
  CHECK(drag.reference.source == "Nabh 1998, table");
  CHECK(bench.single("total_y,last,,,-2,1e-6,relative,full,\n").ok);
}

TEST_CASE("a wrong value is missed by its signed deviation from the reference")
{
  Bench bench;
  write_steady_flow(bench);
  const run::Comparison relative = bench.single("total_y,steady,,,-2.02,0.005,relative,full,\n");
  CHECK_FALSE(relative.ok);
  CHECK(relative.reason.empty());
  CHECK(relative.deviation == doctest::Approx(0.02 / 2.02));
  CHECK(bench.single("total_y,steady,,,-2.02,0.0101,relative,full,\n").ok);

  const run::Comparison absolute = bench.single("total_y,steady,,,-2.02,0.019,absolute,full,\n");
  CHECK_FALSE(absolute.ok);
  CHECK(absolute.deviation == doctest::Approx(0.02));
  CHECK(bench.single("total_y,steady,,,-2.02,0.021,absolute,full,\n").ok);
}

TEST_CASE("formulas join columns, also of a force and a probe at the end of a run")
{
  Bench bench;
  write_steady_flow(bench);
  CHECK(bench.single("front_p - back_p,steady,,,0.5,1e-12,relative,full,\n").ok);
  CHECK(bench.single("front_p - back_p,steady,,-2,-1,1e-12,relative,full,\n").ok);
  CHECK(bench.single("(1.5 - total_y) / back_p,steady,,,17.5,1e-12,relative,full,\n").ok);
  CHECK(bench.single("\"max(front_p, back_p)\",last,,,0.7,1e-12,relative,full,\n").ok);
}

TEST_CASE("bounds hold on their side only, at the least value of the run between its samples")
{
  Bench bench;
  write_steady_flow(bench);
  const run::Comparison quality = bench.single("scaled_jacobian,least,,,0.1,,at least,full,\n");
  CHECK(quality.ok);
  CHECK(quality.computed == doctest::Approx(0.3).epsilon(1e-10));
  CHECK_FALSE(bench.single("scaled_jacobian,least,,,0.31,,at least,full,\n").ok);
  CHECK(bench.single("scaled_jacobian,least,,,0.31,,at most,full,\n").ok);
  CHECK_FALSE(bench.single("scaled_jacobian,greatest,,,1.01,,at most,full,\n").ok);
  CHECK(bench.single("scaled_jacobian,greatest,,,1.03,,at most,full,\n").ok);
}

TEST_CASE("a signal that still changes is not steady, by the measure of its tolerance")
{
  Bench bench;
  bench.table("probes.csv", {"a_p"}, {[](double t) { return 1.0 + 0.01 * t; }}, 10, 0.1);
  const run::Comparison drifting = bench.single("a_p,steady,,,1.1,0.005,relative,full,\n");
  CHECK_FALSE(drifting.ok);
  CHECK(drifting.reason == "not steady yet: it changed by 0.009 in the last tenth of the run");
  CHECK(bench.single("a_p,steady,,,1.1,0.02,relative,full,\n").ok);
  CHECK(bench.single("a_p,last,,,1.1,0.005,relative,full,\n").ok);
  CHECK_FALSE(bench.single("a_p,steady,,10,11,0.05,absolute,full,\n").ok);
}

TEST_CASE("a single row of a steady solution is steady")
{
  Bench bench;
  bench.table("probes.csv", {"a_p"}, {[](double) { return 4.0; }}, 1, 1);
  CHECK(bench.single("a_p,steady,,,4,1e-12,relative,full,\n").ok);
}

TEST_CASE("mean, amplitude, extrema and frequency of a flap are those of its last periods")
{
  Bench bench;
  write_flap(bench, 6.0);
  const auto rows = bench.compare("tip_uy,amplitude5,,,1.1,1e-4,relative,full,\n"
                                  "tip_uy,mean5,,,0.1,1e-4,absolute,full,\n"
                                  "tip_uy,frequency5,,,2.5,1e-5,relative,full,\n"
                                  "tip_uy,maximum,,,1.2,1e-4,relative,full,\n"
                                  "tip_uy,minimum,,,-1,1e-4,relative,full,\n"
                                  "tip_uy,amplitude,,200,220,1e-4,relative,full,\n");
  for (const run::Comparison& row : rows)
    CHECK_MESSAGE(row.ok, run::report(rows));
  CHECK_FALSE(bench.single("tip_uy,amplitude5,,,1.12,0.01,relative,full,\n").ok);
  CHECK_FALSE(bench.single("tip_uy,frequency5,,,2.52,0.005,relative,full,\n").ok);
}

TEST_CASE("signals of twice the frequency are read by the clock, also from a table of other times")
{
  Bench bench;
  write_flap(bench, 6.0);
  CHECK(bench.single("total_x,mean,tip_uy,,3,1e-4,relative,full,\n").ok);
  CHECK(bench.single("total_x,amplitude5,tip_uy,,0.6,3e-3,relative,full,\n").ok);
  CHECK(bench.single("tip_ux,amplitude,tip_uy,,0.03,3e-3,relative,full,\n").ok);
  CHECK(bench.single("tip_ux,frequency,tip_uy,2,5,1e-4,relative,full,\n").ok);
  CHECK(bench.single("tip_ux,frequency,,,5,1e-3,relative,full,\n").ok);
}

TEST_CASE("the average over five periods differs from the last period where amplitudes alternate")
{
  Bench bench;
  bench.table("probes.csv", {"tip_uy"}, {[](double t) {
                return (static_cast<int>(std::floor(t)) % 2 == 0 ? 1.0 : 0.99) * std::sin(turn * t);
              }},
              15.25, 0.001);
  CHECK(bench.single("tip_uy,amplitude5,,,0.996,1e-4,relative,full,\n").ok);
  CHECK(bench.single("tip_uy,amplitude,,,1,1e-4,relative,full,\n").ok);
}

TEST_CASE("what is not periodic yet is missed, with the reason")
{
  Bench bench;
  write_flap(bench, 1.9);
  CHECK(bench.single("tip_uy,amplitude,,,1.1,1e-3,relative,full,\n").ok);
  const run::Comparison few = bench.single("tip_uy,amplitude5,,,1.1,1e-3,relative,full,\n");
  CHECK_FALSE(few.ok);
  CHECK(std::isnan(few.computed));
  CHECK(few.reason == "not periodic yet: 3 periods up to the end, at least 5 are needed");

  bench.table("probes.csv", {"tip_uy", "still"},
              {[](double t) { return std::exp(0.1 * t) * std::sin(turn * t); }, [](double) { return 1.0; }},
              20, 0.01);
  const run::Comparison growing = bench.single("tip_uy,frequency,,,1,0.1,relative,full,\n");
  CHECK_FALSE(growing.ok);
  CHECK(growing.reason == "not periodic yet: the last three periods differ by 18 % in amplitude");
  CHECK_FALSE(bench.single("still,mean,tip_uy,,1,0.1,relative,full,\n").ok);
  CHECK_FALSE(bench.single("still,mean,,,1,0.1,relative,full,\n").ok);
}

TEST_CASE("what the results do not hold is missed, with the reason")
{
  Bench bench;
  CHECK(bench.single("tip_uy,last,,,1,0.1,relative,full,\n").reason ==
        "there are no results; run the case first");
  write_flap(bench, 0.0);
  CHECK(bench.single("tip_uy,last,,,1,0.1,relative,full,\n").reason == "the run has written no row yet");
  write_flap(bench, 6.0);
  CHECK(bench.single("tip_uz,last,,,1,0.1,relative,full,\n").reason ==
        "probes.csv, forces.csv have no column 'tip_uz'");
  CHECK(bench.single("tip_uy,mean,tip_uz,,1,0.1,relative,full,\n").reason ==
        "probes.csv, forces.csv have no column 'tip_uz'");
  CHECK(bench.single("total_x - tip_uy,mean,tip_uy,,1,0.1,relative,full,\n").reason ==
        "'total_x' and 'tip_uy' are recorded at different times");
  CHECK(bench.single("2 + 2,last,,,4,0.1,relative,full,\n").reason ==
        "'2 + 2' uses no column of the results");
}

TEST_CASE("a value that is not finite anywhere in the run is missed")
{
  Bench bench;
  bench.table("quality.csv", {"scaled_jacobian"},
              {[](double t) { return t < 1.95 || t > 2.05 ? 0.5 : std::nan(""); }}, 4, 0.1);
  const run::Comparison quality = bench.single("scaled_jacobian,least,,,0.1,,at least,full,\n");
  CHECK_FALSE(quality.ok);
  CHECK(quality.reason == "'scaled_jacobian' is nan at time 2");
  bench.table("probes.csv", {"a_p", "b_p"}, {[](double) { return 1.0; }, [](double) { return 0.0; }}, 4, 0.1);
  CHECK_FALSE(bench.single("a_p / b_p,last,,,1,1,absolute,full,\n").ok);
}

TEST_CASE("a run that goes on in another folder is read as one")
{
  Bench bench;
  const auto sine = [](double t) { return 3.0 * std::sin(2.5 * turn * t); };
  const auto table =
      [&bench, sine](const std::string& file, int first, int last, std::vector<std::string> names)
  {
    names.insert(names.begin(), {"step", "time"});
    output::Table result(bench.path() / file, names);
    for (int step = first; step <= last; ++step)
    {
      std::vector<double> row(names.size() - 1, sine(0.01 * step));
      row.front() = 0.01 * step;
      result.append(step, row);
    }
  };
  table("probes.csv", 1, 80, {"a", "b"});
  table("second/probes.csv", 81, 240, {"b", "c"});
  table("forces.csv", 1, 80, {"f"});
  const std::array folders = {bench.path(), bench.path() / "second"};
  // Neither of the folders has periods enough.
  const std::string rows = "b,frequency4,,,2.5,1e-3,relative,full,\n"
                           "b,last,,,0,1e-9,absolute,full,\n"
                           "b,amplitude4,,,3,1e-2,relative,full,\n";
  for (const run::Comparison& comparison : bench.compare(rows, "full", folders))
  {
    CAPTURE(comparison.reason);
    CHECK(comparison.ok);
  }
  for (const std::string missing : {"a", "c", "f"})
    CHECK(bench.compare(missing + ",last,,,0,1,absolute,full,\n", "full", folders).front().reason ==
          "probes.csv has no column '" + missing + "'");
}

TEST_CASE("the level chooses the references")
{
  Bench bench;
  write_steady_flow(bench);
  const std::string_view rows = "total_y,last,,,-2,0.1,relative,short,\n"
                                "total_y,last,,,-2,0.01,relative,full,\n"
                                "back_p,last,,,0.2,0.01,relative,both,\n";
  CHECK(bench.compare(rows, "short").size() == 2);
  CHECK(bench.compare(rows, "short").front().reference.tolerance == 0.1);
  CHECK(bench.compare(rows, "full").front().reference.tolerance == 0.01);
  CHECK_THROWS_WITH_AS(bench.compare(rows, "long"), "unknown level 'long'; allowed are short, full", Error);
  CHECK(bench.mistake_in_row("total_y,last,,,-2,0.1,relative,short,\n") ==
        "reference.csv: there is no reference of level 'full'");
}

TEST_CASE("the report has one line for each comparison and counts those within tolerance")
{
  Bench bench;
  write_steady_flow(bench);
  const auto rows = bench.compare("total_y,steady,,,-2,1e-4,relative,full,\n"
                                  "front_p - back_p,steady,,2,1.1,0.05,relative,full,\n"
                                  "lift,last,,,1,0.1,absolute,full,\n"
                                  "scaled_jacobian,least,,,0.1,,at least,full,\n");
  CHECK_FALSE(run::all_ok(rows));
  CHECK(run::all_ok(std::span(rows).first(1)));
  CHECK(run::report(rows) ==
        "quantity                statistic  computed  reference  deviation  tolerance\n"
        "total_y                 steady     -2        -2         +0.00e+00  0.0001     ok\n"
        "2 * (front_p - back_p)  steady     1         1.1        -9.09e-02  0.05       MISSED\n"
        "lift                    last       -         1          -          0.1 abs    MISSED: probes.csv, "
        "forces.csv, quality.csv have no column 'lift'\n"
        "scaled_jacobian         least      0.3       0.1        +2.00e-01  at least   ok\n"
        "2 of 4 within tolerance\n");
}

TEST_CASE("columns may stand in any order, fields in quotes, lines end as on Windows or be empty")
{
  Bench bench;
  write_steady_flow(bench);
  CHECK(bench.mistake("source,level,kind,tolerance,value,factor,clock,statistic,quantity\r\n\r\n"
                      "\"say \"\"x\"\", y\" , full,relative,\"1e-6\",-2,,,last,total_y\r\n") == "none");
  CHECK(bench.single("  total_y , last ,,, -2 , 1e-6 , relative , full , \"say \"\"x\"\", y\" \n")
            .reference.source == "say \"x\", y");
}

TEST_CASE("mistakes in the references are found where they are")
{
  const Bench bench;
  const std::string_view all = "quantity, statistic, clock, factor, value, tolerance, kind, level, source";
  const auto names = std::string(all);
  CHECK(bench.mistake("") ==
        "reference.csv: the table has no references; its first line names the columns, the "
        "others have one reference each");
  CHECK(bench.mistake("quantity,statistics\n") ==
        "reference.csv:1:10: unknown column 'statistics'; the columns are " + names);
  CHECK(bench.mistake("quantity,quantity\n") ==
        "reference.csv:1:10: column 'quantity' stands here a second time");
  CHECK(bench.mistake("quantity,statistic,clock,factor,value,tolerance,kind,level\n") ==
        "reference.csv:1: column 'source' is missing; the columns are " + names);
  CHECK(bench.mistake_in_row("a,last,,,1,0.1,relative,full\n") ==
        "reference.csv:2: the row has 8 fields, but there are 9 columns; put double quotes around fields "
        "that have "
        "commas");
  CHECK(bench.mistake_in_row("a,\"last,,,1,0.1,relative,full,\n") ==
        "reference.csv:2:3: the field begins with a double quote, but the line ends without a second one");
  CHECK(bench.mistake_in_row("a,\"last\" x,,,1,0.1,relative,full,\n") ==
        "reference.csv:2:3: found 'x' behind the closing double quote; only a comma may follow");
  CHECK(bench.mistake_in_row("a,average,,,1,0.1,relative,full,\n") ==
        "reference.csv:2:3: unknown statistic 'average'; allowed are last, steady, greatest, least, maximum, "
        "minimum, "
        "mean, amplitude, frequency, the last five also followed by a number of periods, as in amplitude5");
  for (const std::string statistic : {"last5", "mean0", "mean5x", "mean99999999999"})
    CHECK(bench.mistake_in_row("a," + statistic + ",,,1,0.1,relative,full,\n") ==
          "reference.csv:2:3: found the statistic '" + statistic +
              "'; a number of periods, at least 1, may follow maximum, minimum, mean, amplitude and "
              "frequency only");
  CHECK(bench.mistake_in_row("a,last,b,,1,0.1,relative,full,\n") ==
        "reference.csv:2:8: found the clock 'b', but the statistic 'last' counts no periods; leave the field "
        "empty");
  CHECK(bench.mistake_in_row("a,last,,two,1,0.1,relative,full,\n") ==
        "reference.csv:2:9: the factor is 'two', which is not a number");
  CHECK(bench.mistake_in_row("a,last,,,1.5 m,0.1,relative,full,\n") ==
        "reference.csv:2:10: the value is '1.5 m', which is not a number");
  CHECK(bench.mistake_in_row("a,last,,,nan,0.1,relative,full,\n") ==
        "reference.csv:2:10: the value is 'nan', which is not a number");
  CHECK(bench.mistake_in_row("a,last,,,1,,relative,full,\n") ==
        "reference.csv:2:12: the tolerance is '', which is not a number");
  CHECK(bench.mistake_in_row("a,last,,,1,-0.1,relative,full,\n") ==
        "reference.csv:2:12: the tolerance is -0.1; it must be positive");
  CHECK(bench.mistake_in_row("a,last,,,1,0.1,at least,full,\n") ==
        "reference.csv:2:12: the kind 'at least' has no tolerance, but found '0.1'; leave the field empty");
  CHECK(bench.mistake_in_row("a,last,,,0,0.1,relative,full,\n") ==
        "reference.csv:2:16: a tolerance relative to the reference 0 allows no error; use the kind absolute");
  CHECK(bench.mistake_in_row("a,last,,,1,0.1,percent,full,\n") ==
        "reference.csv:2:16: unknown kind of tolerance 'percent'; allowed are relative, absolute, at least, "
        "at most");
  CHECK(bench.mistake_in_row("a,last,,,1,0.1,relative,bench,\n") ==
        "reference.csv:2:25: unknown level 'bench'; allowed are short, full, both");
  CHECK(bench.mistake_in_row("\n a - ,last,,,1,0.1,relative,full,\n") ==
        "reference.csv:3:2: column 4 of \"a -\": found the end where a number, a name, '(' or '-' is "
        "allowed");
  CHECK(bench.mistake_in_row(",last,,,1,0.1,relative,full,\n") ==
        "reference.csv:2:1: the quantity is empty; name a column of the results");
}

TEST_CASE("a damaged table of the run and a missing table of references are errors")
{
  Bench bench;
  write_steady_flow(bench);
  TemporaryFolder results;
  output::replace_file(results.path() / "probes.csv", "step,time,a_p\n1,0.1,x\n");
  output::replace_file(results.path() / "reference.csv",
                       std::string(header) + "a_p,last,,,1,0.1,relative,full,\n");
  CHECK_THROWS_AS(run::compare(results.path() / "reference.csv", std::array{results.path()}, "full"), Error);
  CHECK_THROWS_AS(run::compare(results.path() / "absent.csv", std::array{results.path()}, "full"), Error);
}
