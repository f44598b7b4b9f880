#include "run/compare.hpp"

#include "linalg/communicator.hpp"
#include "output/file.hpp"
#include "output/svg.hpp"
#include "output/table.hpp"
#include "run/entries.hpp"
#include "run/measures.hpp"
#include "run/simulation.hpp"
#include "run/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <optional>
#include <utility>

namespace blockfsi::run
{

namespace
{

/// Fluid and body at one time, kept for a picture.
struct Picture
{
  double time = 0.0;
  mesh::Mesh fluid;
  mesh::Mesh solid;
  std::vector<double> fluid_x;
  std::vector<double> solid_x;
  double scaled_jacobian = 1.0;
};

/// What came of one run.
struct Finding
{
  std::string name;
  Outcome outcome;
  std::optional<output::TableData> quality;
  std::vector<Picture> pictures;

  bool is_done() const { return outcome.exit == Exit::done; }
};

Picture picture_of(const Simulation& simulation, const StepReport& report)
{
  Picture picture;
  picture.time = simulation.time();
  picture.fluid = simulation.fluid()->mesh();
  picture.fluid_x.assign(simulation.fluid()->x().begin(), simulation.fluid()->x().end());
  picture.scaled_jacobian = report.quality.scaled_jacobian;
  if (const SolidSide* solid = simulation.solid())
  {
    picture.solid = solid->mesh();
    picture.solid_x.assign(solid->X().begin(), solid->X().end());
    for (std::size_t i = 0; i < picture.solid_x.size(); ++i)
      picture.solid_x[i] += solid->state().d[i];
  }
  return picture;
}

/// Keeps pictures of the steps at some times, and of the last one if none is asked for.
class Photographer
{
public:
  Photographer(const std::vector<double>& times, std::vector<Picture>& pictures)
      : times_(&times), pictures_(&pictures)
  {
  }

  void operator()(const Simulation& simulation, const StepReport& report)
  {
    if (times_->empty())
    {
      pictures_->assign(1, picture_of(simulation, report));
      return;
    }
    while (next_ < times_->size() && simulation.time() >= (*times_)[next_] - 1e-9)
    {
      pictures_->push_back(picture_of(simulation, report));
      pictures_->back().time = (*times_)[next_++];
    }
  }

private:
  const std::vector<double>* times_;
  std::vector<Picture>* pictures_;
  std::size_t next_ = 0;
};

Finding find_out(const Entry& entry, const std::filesystem::path& folder, const std::vector<double>& times)
{
  Finding finding;
  finding.name = entry.name;
  try
  {
    finding.outcome = run_observed(entry.description, {false, folder}, Photographer(times, finding.pictures));
  }
  catch (const Error& error)
  {
    // The others may do better.
    finding.outcome.exit = Exit::user_error;
    finding.outcome.failure = error.what();
    fmt::print(stderr, "{}\n", error.what());
  }
  if (std::filesystem::exists(folder / "quality.csv"))
    finding.quality = output::read_table(folder / "quality.csv");
  return finding;
}

double least(const Finding& finding, std::string_view column)
{
  const std::vector<double>& values = finding.quality->column(column);
  return values.empty() ? NAN : *std::min_element(values.begin(), values.end());
}

double greatest(const Finding& finding, std::string_view column)
{
  const std::vector<double>& values = finding.quality->column(column);
  return values.empty() ? NAN : *std::max_element(values.begin(), values.end());
}

double mean(const Finding& finding, std::string_view column)
{
  const std::vector<double>& values = finding.quality->column(column);
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::string number(double value)
{
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : "-";
}

std::vector<std::string> row_of(const Finding& finding)
{
  const Outcome& outcome = finding.outcome;
  std::vector<std::string> row = {finding.name, finding.is_done() ? "finished" : "failed",
                                  number(outcome.time), fmt::format("{}", outcome.steps)};
  if (!finding.quality || outcome.steps == 0)
  {
    row.resize(13, "-");
    row.push_back(outcome.failure);
    return row;
  }
  constexpr auto place = static_cast<std::size_t>(Task::place);
  const double seconds = outcome.timings.seconds[place];
  row.insert(row.end(),
             {number(least(finding, "scaled_jacobian")), number(least(finding, "smallest_angle")),
              number(greatest(finding, "largest_angle")), number(least(finding, "smallest_change")),
              number(greatest(finding, "largest_change")), least(finding, "certified") > 0.5 ? "yes" : "no",
              number(mean(finding, "coupling_iterations")),
              number(1e3 * seconds / static_cast<double>(std::max(1L, outcome.timings.calls[place]))),
              number(100.0 * seconds / outcome.wall), outcome.failure});
  return row;
}

TextTable table_of(const std::vector<Finding>& findings)
{
  TextTable table;
  table.header = {"motion",
                  "outcome",
                  "time [s]",
                  "steps",
                  "least SJ",
                  "least angle",
                  "greatest angle",
                  "least J",
                  "greatest J",
                  "proved valid",
                  "coupling iterations",
                  "ms per update",
                  "share [%]",
                  "reason"};
  for (const Finding& finding : findings)
    table.rows.push_back(row_of(finding));
  return table;
}

void draw_measure(const std::vector<Finding>& findings, const Measure& measure, const std::string& title,
                  const std::filesystem::path& folder)
{
  std::vector<output::Curve> curves;
  for (const Finding& finding : findings)
    if (finding.quality)
      curves.push_back({finding.name, finding.quality->column("time"),
                        finding.quality->column(measure.column), !finding.is_done()});
  output::replace_file(folder / fmt::format("{}.svg", measure.column),
                       output::draw(figure_of(measure, title, "time [s]", std::move(curves))));
}

/// Where the bodies of all pictures are; where there is none, the whole mesh.
output::Window window_of(const std::vector<Finding>& findings)
{
  std::vector<double> points;
  for (const Finding& finding : findings)
    for (const Picture& picture : finding.pictures)
    {
      const std::vector<double>& x = picture.solid_x.empty() ? picture.fluid_x : picture.solid_x;
      points.insert(points.end(), x.begin(), x.end());
    }
  return window_around(points, 0.3);
}

void draw_meshes(const std::vector<Finding>& findings, double time, const std::filesystem::path& folder)
{
  std::vector<output::Panel> panels;
  for (const Finding& finding : findings)
    for (const Picture& picture : finding.pictures)
    {
      if (picture.time != time)
        continue;
      output::Panel panel{
          fmt::format("{}: least scaled Jacobian {:.2f}", finding.name, picture.scaled_jacobian), {}};
      if (!picture.solid_x.empty())
        panel.layers.push_back({&picture.solid, picture.solid_x, true, {}});
      panel.layers.push_back({&picture.fluid, picture.fluid_x, false, {}});
      panels.push_back(std::move(panel));
    }
  if (!panels.empty())
    output::replace_file(folder / fmt::format("meshes-{:g}.svg", time),
                         output::draw(panels, window_of(findings), panels.size() == 4 ? 2 : 3,
                                      fmt::format("Meshes at t = {:g} s", time)));
}

}  // namespace

Exit compare_runs(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                  const CompareOptions& options)
{
  if (linalg::part().size > 1)
    throw Error("blockfsi compare works with one process; leave out mpirun");
  const std::vector<Entry> entries = read_entries(path, overrides, options.motions);
  const case_file::Case& first = entries.front().description;
  if (!first.fluid || !first.solid)
    throw Error({path.string()}, "compare needs a case with [fluid] and [solid]: nothing else moves a mesh");
  const std::filesystem::path folder =
      options.directory.empty() ? result_folder(first, {}) / "comparison" : options.directory;
  std::vector<Finding> findings;
  for (std::size_t k = 0; k < entries.size(); ++k)
  {
    fmt::print("{}--- {} ({} of {})\n", k == 0 ? "" : "\n", entries[k].name, k + 1, entries.size());
    findings.push_back(find_out(entries[k], folder / entries[k].name, options.times));
    if (findings.back().outcome.exit == Exit::interrupted)
      return Exit::interrupted;
  }
  const TextTable table = table_of(findings);
  fmt::print("\n{}", aligned(table));
  output::replace_file(folder / "comparison.csv", csv(table));
  output::replace_file(folder / "comparison.txt", aligned(table));
  for (const Measure& measure : measures)
    draw_measure(findings, measure, first.title, folder);
  std::vector<double> times;
  for (const Finding& finding : findings)
    for (const Picture& picture : finding.pictures)
      times.push_back(picture.time);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  for (const double time : times)
    draw_meshes(findings, time, folder);
  fmt::print("\ntable, figures and pictures are in {}\n", folder.string());
  return Exit::done;
}

}  // namespace blockfsi::run
