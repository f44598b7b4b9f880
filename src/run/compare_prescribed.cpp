#include "run/compare.hpp"

#include "linalg/communicator.hpp"
#include "output/file.hpp"
#include "output/svg.hpp"
#include "output/table.hpp"
#include "output/vtu.hpp"
#include "run/entries.hpp"
#include "run/measures.hpp"
#include "run/prescribed.hpp"
#include "run/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

namespace blockfsi::run
{

namespace
{

/// Everything found about one way of moving the mesh.
struct Finding
{
  std::string name;
  std::unique_ptr<PrescribedMesh> mesh;
  std::vector<Sweep> sweeps;  ///< one for each of flap_shapes
  Cycles cycles;
};

std::string number(double value, int digits)
{
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "-";
}

void write_sweep(const std::filesystem::path& path, const Sweep& sweep)
{
  output::Table table(path, {"step", "angle", "scaled_jacobian", "smallest_angle", "largest_angle",
                             "smallest_change", "largest_change", "certified", "seconds"});
  std::int64_t step = 0;
  for (const SweepPoint& point : sweep.points)
  {
    const mesh::Quality& q = point.quality;
    table.append(step++, std::array<double, 8>{point.angle, q.scaled_jacobian, q.smallest_angle,
                                               q.largest_angle, q.smallest_change, q.largest_change,
                                               point.certified ? 1.0 : 0.0, point.seconds});
  }
}

Finding find_out(const Entry& entry, const std::filesystem::path& folder)
{
  Finding finding{entry.name, std::make_unique<PrescribedMesh>(entry.description), {}, {}};
  for (const FlapShape shape : flap_shapes(entry.description.layout.dim))
  {
    const Sweep& sweep = finding.sweeps.emplace_back(finding.mesh->sweep(shape));
    write_sweep(folder / fmt::format("{}-{}.csv", entry.name, name(sweep.shape)), sweep);
    fmt::print("{}, {}: valid to {:g} degrees{}\n", entry.name, name(sweep.shape), sweep.last_valid,
               sweep.failure.empty() ? "" : " (" + sweep.failure + ")");
    std::fflush(stdout);
  }
  finding.cycles = finding.mesh->cycle(FlapShape::rotation);
  return finding;
}

TextTable table_of(const std::vector<Finding>& findings, const case_file::Prescribed& wanted)
{
  TextTable table;
  table.header = {"motion"};
  for (const Sweep& sweep : findings.front().sweeps)
  {
    table.header.push_back(fmt::format("{} valid to", name(sweep.shape)));
    for (const double angle : wanted.show)
      table.header.push_back(fmt::format("{} SJ at {:g}", name(sweep.shape), angle));
  }
  table.header.emplace_back("ms per update");
  for (int cycle = 1; cycle <= wanted.cycles; ++cycle)
    table.header.push_back(fmt::format("drift after {} [m]", cycle));
  table.header.emplace_back("least SJ in cycles");
  for (const Finding& finding : findings)
  {
    std::vector<std::string> row = {finding.name};
    for (const Sweep& sweep : finding.sweeps)
    {
      row.push_back(fmt::format("{}{:g}", sweep.is_complete ? ">= " : "", sweep.last_valid));
      for (const double angle : wanted.show)
        row.push_back(number(sweep.scaled_jacobian(angle), 3));
    }
    row.push_back(number(1e3 * finding.sweeps[0].seconds(), 3));
    const Cycles& cycles = finding.cycles;
    for (std::size_t k = 0; k < static_cast<std::size_t>(wanted.cycles); ++k)
      row.push_back(k < cycles.drift.size()    ? fmt::format("{:.1e}", cycles.drift[k])
                    : k == cycles.drift.size() ? fmt::format("breaks at {:g}", cycles.broke_at)
                                               : "-");
    row.push_back(
        cycles.scaled_jacobian.empty()
            ? "-"
            : number(*std::min_element(cycles.scaled_jacobian.begin(), cycles.scaled_jacobian.end()), 3));
    table.rows.push_back(std::move(row));
  }
  return table;
}

void draw_measures(const std::vector<Finding>& findings, std::size_t shape,
                   const std::filesystem::path& folder)
{
  for (const Measure& measure : measures)
  {
    std::vector<output::Curve> curves;
    for (const Finding& finding : findings)
    {
      output::Curve curve{finding.name, {}, {}, !finding.sweeps[shape].is_complete};
      for (const SweepPoint& point : finding.sweeps[shape].points)
      {
        curve.x.push_back(point.angle);
        curve.y.push_back(point.quality.*measure.of);
      }
      curves.push_back(std::move(curve));
    }
    const std::string_view kind = name(findings.front().sweeps[shape].shape);
    output::replace_file(folder / fmt::format("{}-{}.svg", measure.column, kind),
                         output::draw(figure_of(measure, fmt::format("Prescribed {} of the flap", kind),
                                                "angle of the tip [degrees]", std::move(curves))));
  }
}

/// Where the interface of the kept meshes is.
output::Window window_of(const std::vector<Finding>& findings, std::size_t shape)
{
  std::vector<double> points;
  for (const Finding& finding : findings)
  {
    const mesh::Mesh& mesh = finding.mesh->mesh();
    const auto found = mesh.boundaries.find("interface");
    for (const Snapshot& snapshot : finding.sweeps[shape].snapshots)
      for (const mesh::Side& side : found->second)
        for (int k = 0; k <= mesh.order; ++k)
        {
          const std::size_t node = mesh.cell(side.cell)[mesh::side_node(mesh.order, side.side, k)];
          points.insert(points.end(), {snapshot.x[2 * node], snapshot.x[2 * node + 1]});
        }
  }
  return points.empty() ? output::Window{{0.0, 0.0}, {1.0, 1.0}} : window_around(points, 0.15);
}

void draw_meshes(const std::vector<Finding>& findings, std::size_t shape, double angle,
                 const std::filesystem::path& folder)
{
  std::vector<output::Panel> panels;
  for (const Finding& finding : findings)
    for (const Snapshot& snapshot : finding.sweeps[shape].snapshots)
      if (snapshot.angle == angle)
        panels.push_back({fmt::format("{}: least scaled Jacobian {:.2f}", finding.name,
                                      finding.sweeps[shape].scaled_jacobian(angle)),
                          {{&finding.mesh->mesh(), snapshot.x, false, {}}}});
  if (panels.empty())
    return;
  const std::string_view kind = name(findings.front().sweeps[shape].shape);
  output::replace_file(folder / fmt::format("meshes-{}-{:g}.svg", kind, angle),
                       output::draw(panels, window_of(findings, shape), 3,
                                    fmt::format("Meshes at {:g} degrees of {}", angle, kind)));
}

/// Meshes in space, for ParaView.
void write_meshes(const std::vector<Finding>& findings, std::size_t shape, double angle,
                  const std::filesystem::path& folder)
{
  for (const Finding& finding : findings)
    for (const Snapshot& snapshot : finding.sweeps[shape].snapshots)
      if (snapshot.angle == angle)
      {
        const mesh::Mesh& mesh = finding.mesh->mesh();
        const std::vector<output::CellField> cells = {{"block", std::span(mesh.cell_block)}};
        output::write_vtu(
            folder / fmt::format("{}-{}-{:g}.vtu", finding.name, name(finding.sweeps[shape].shape), angle),
            mesh, snapshot.x, {}, cells);
      }
}

}  // namespace

Exit compare_prescribed(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                        const CompareOptions& options)
{
  if (linalg::part().size > 1)
    throw Error("blockfsi compare works with one process; leave out mpirun");
  const std::vector<Entry> entries = read_entries(path, overrides, options.motions);
  const case_file::Case& first = entries.front().description;
  if (!first.prescribed || !first.fluid || !first.solid)
    throw Error({path.string()},
                "compare --prescribed needs the sections [prescribed], [fluid] and [solid]: the "
                "flap and who is who");
  const std::filesystem::path folder =
      options.directory.empty() ? result_folder(first, {}) / "prescribed" : options.directory;
  std::vector<Finding> findings;
  for (const Entry& entry : entries)
    findings.push_back(find_out(entry, folder));
  fmt::print(
      "\norder {}, {} nodes; angles in degrees, SJ: least scaled Jacobian, {} cycles of +-{:g} degrees of "
      "rotation\n\n",
      first.layout.order, findings.front().mesh->node_count(), first.prescribed->cycles,
      first.prescribed->amplitude);
  const TextTable table = table_of(findings, *first.prescribed);
  fmt::print("{}", aligned(table));
  output::replace_file(folder / "comparison.csv", csv(table));
  output::replace_file(folder / "comparison.txt", aligned(table));
  for (std::size_t shape = 0; shape < findings.front().sweeps.size(); ++shape)
  {
    draw_measures(findings, shape, folder);
    for (const double angle : first.prescribed->show)
      first.layout.dim == 2 ? draw_meshes(findings, shape, angle, folder)
                            : write_meshes(findings, shape, angle, folder);
  }
  fmt::print("\ntable, curves and pictures are in {}\n", folder.string());
  return Exit::done;
}

}  // namespace blockfsi::run
