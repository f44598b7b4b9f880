#include "run/results.hpp"

#include "fem/boundary.hpp"
#include "linalg/communicator.hpp"
#include "output/vtu.hpp"
#include "run/locate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <system_error>

namespace blockfsi::run
{

/// A nodal field with its name.
struct NamedField
{
  std::string name;
  int components;
  std::span<const double> values;
};

namespace
{

const std::array<std::string, 2> axes = {"x", "y"};

output::Table open(const std::filesystem::path& path, std::vector<std::string> columns, bool resume,
                   std::int64_t step)
{
  return resume ? output::Table::resume(path, std::move(columns), step)
                : output::Table(path, std::move(columns));
}

}  // namespace

Results::Results(const std::filesystem::path& folder, Simulation& simulation, bool resume)
    : folder_(folder), simulation_(&simulation)
{
  const bool first = linalg::part().rank == 0;
  for (const output::Probe& probe : simulation.description().output.probes)
    followers_.push_back({probe, 0});
  if (simulation.fluid() != nullptr)
    find_force_nodes();
  probe_values();  // throws for probes that are nowhere
  if (!first)
    return;
  // What an earlier run left would be taken for results of this one.
  std::error_code ignored;
  for (const char* name : {"probes.csv", "forces.csv", "quality.csv", "fields.pvd"})
    if (!resume)
      std::filesystem::remove(folder_ / name, ignored);
  const std::int64_t step = simulation.step();
  if (!followers_.empty())
    probes_ = open(folder_ / "probes.csv", probe_columns(), resume, step);
  if (!force_nodes_.empty())
    forces_ = open(folder_ / "forces.csv", force_columns(), resume, step);
  quality_ = open(folder_ / "quality.csv",
                  {"step", "time", "scaled_jacobian", "smallest_angle", "largest_angle", "smallest_change",
                   "largest_change", "certified", "coupling_iterations", "fluid_iterations",
                   "solid_iterations", "factorisations", "pieces"},
                  resume, step);
  series_ = resume ? output::Series::resume(folder_ / "fields.pvd", simulation.time())
                   : output::Series(folder_ / "fields.pvd");
  if (resume && !series_->snapshots().empty())
    fields_time_ = series_->snapshots().back().time;
}

std::vector<std::string> Results::probe_columns() const
{
  std::vector<std::string> columns = {"step", "time"};
  for (const Follower& follower : followers_)
  {
    const output::Probe& probe = follower.probe;
    if (probe.of == "pressure")
      columns.push_back(probe.name + "_p");
    else
      for (const std::string& axis : axes)
        columns.push_back(probe.name + (probe.of == "velocity" ? "_v" : "_u") + axis);
  }
  return columns;
}

std::vector<std::string> Results::force_columns() const
{
  std::vector<std::string> columns = {"step", "time"};
  for (const output::Force& force : simulation_->description().output.forces)
    for (const std::string& axis : axes)
      columns.push_back(force.name + "_" + axis);
  return columns;
}

/// Which owned nodes belong to each force; a node where boundaries meet counts once.
void Results::find_force_nodes()
{
  const FluidSide& fluid = *simulation_->fluid();
  const auto& solid = simulation_->description().solid;
  for (const output::Force& force : simulation_->description().output.forces)
  {
    std::vector<std::uint8_t> marks(fluid.mesh().node_count(), 0);
    for (const std::string& name : force.on)
    {
      const bool is_solid = solid && name == solid->region;
      const auto more = fem::nodes_on(fluid.mesh(), fluid.numbering(), is_solid ? "interface" : name);
      for (std::size_t node = 0; node < marks.size(); ++node)
        marks[node] |= more[node];
    }
    std::vector<std::int32_t>& nodes = force_nodes_.emplace_back();
    for (const std::int32_t node : fluid.numbering().owned())
      if (marks[node] != 0)
        nodes.push_back(node);
  }
}

std::vector<double> Results::at(Follower& follower, const mesh::Mesh& mesh, std::span<const double> x,
                                std::span<const double> field, int components)
{
  const auto found = locate(mesh, x, {follower.probe.at[0], follower.probe.at[1]}, follower.cell);
  const Part me = linalg::part();
  // Where cells of several processes meet, the first of them answers.
  const double winner = linalg::minimum(found ? me.rank : me.size);
  std::vector<double> values(components, 0.0);
  if (winner == me.size && simulation_->step() == 0)
    throw Error(follower.probe.where,
                fmt::format("probe '{}' at ({:g}, {:g}) lies outside of the {} at t = {:g} s",
                            follower.probe.name, follower.probe.at[0], follower.probe.at[1],
                            follower.probe.of == "displacement" ? "solid" : "fluid", simulation_->time()));
  // What moves may leave a probe behind for a while: no reason to end a long run.
  if (winner == me.size)
    return std::vector<double>(components, std::nan(""));
  if (found)
    follower.cell = found->cell;
  if (winner == me.rank)
    for (int c = 0; c < components; ++c)
      values[c] = found->value(mesh, field, components, c);
  linalg::sum(values);
  return values;
}

std::vector<double> Results::probe_values()
{
  std::vector<double> values = {simulation_->time()};
  const FluidSide* fluid = simulation_->fluid();
  const SolidSide* solid = simulation_->solid();
  const std::vector<double> pressure =
      fluid != nullptr ? fluid->state().pressure_now() : std::vector<double>{};
  for (Follower& follower : followers_)
  {
    std::vector<double> more;
    if (follower.probe.of == "displacement")
      more = at(follower, solid->mesh(), solid->X(), solid->state().d, 2);
    else if (follower.probe.of == "velocity")
      more = at(follower, fluid->mesh(), fluid->x(), fluid->state().u, 2);
    else
      more = at(follower, fluid->mesh(), fluid->x(), pressure, 1);
    values.insert(values.end(), more.begin(), more.end());
  }
  return values;
}

std::vector<double> Results::force_values() const
{
  const FluidSide& fluid = *simulation_->fluid();
  std::vector<double> values;
  for (const std::vector<std::int32_t>& nodes : force_nodes_)
    for (int c = 0; c < 2; ++c)
    {
      double sum = 0.0;
      for (const std::int32_t node : nodes)
        sum -= fluid.reaction()[3 * static_cast<std::size_t>(node) + c];
      values.push_back(sum);
    }
  linalg::sum(values);
  values.insert(values.begin(), fluid.reaction_time());
  return values;
}

void Results::add_step(const StepReport& report)
{
  const std::int64_t step = simulation_->step();
  if (!followers_.empty())
  {
    const std::vector<double> values = probe_values();
    if (probes_)
      probes_->append(step, values);
  }
  if (!force_nodes_.empty())
  {
    const std::vector<double> values = force_values();
    if (forces_)
      forces_->append(step, values);
  }
  if (quality_)
  {
    const mesh::Quality& q = report.quality;
    quality_->append(step, std::array<double, 12>{
                               simulation_->time(), q.scaled_jacobian, q.smallest_angle, q.largest_angle,
                               q.smallest_change, q.largest_change, report.certified ? 1.0 : 0.0,
                               static_cast<double>(report.coupling_iterations),
                               static_cast<double>(report.fluid_iterations),
                               static_cast<double>(report.solid_iterations),
                               static_cast<double>(report.renewals), static_cast<double>(report.pieces)});
  }
}

output::Snapshot Results::write(const mesh::Mesh& mesh, std::span<const double> x, const std::string& region,
                                const std::string& stem, const std::vector<NamedField>& named)
{
  const Part me = linalg::part();
  std::vector<output::Field> fields;
  fields.reserve(named.size());
  for (const NamedField& field : named)
    fields.push_back({field.name, field.components, field.values});
  const std::vector<output::CellField> cell_fields = {{"block", std::span(mesh.cell_block)}};
  const auto piece = [&](int rank)
  { return me.size == 1 ? fmt::format("{}.vtu", stem) : fmt::format("{}-{}.vtu", stem, rank); };
  output::write_vtu(folder_ / "fields" / piece(me.rank), mesh, x, fields, cell_fields);
  std::string file = piece(0);
  if (me.size > 1)
  {
    file = stem + ".pvtu";
    std::vector<std::string> pieces;
    pieces.reserve(me.size);
    for (int rank = 0; rank < me.size; ++rank)
      pieces.push_back(piece(rank));
    linalg::barrier();
    if (me.rank == 0)
      output::write_pvtu(folder_ / "fields" / file, pieces, fields, cell_fields);
  }
  return {simulation_->time(), region, "fields/" + file};
}

void Results::add_fields()
{
  if (linalg::maximum(fields_time_) == simulation_->time())
    return;
  fields_time_ = simulation_->time();
  std::vector<output::Snapshot> snapshots;
  const std::string number = fmt::format("{:06}", simulation_->step());
  if (const FluidSide* fluid = simulation_->fluid())
  {
    const std::vector<double> pressure = fluid->state().pressure_now();
    snapshots.push_back(write(fluid->mesh(), fluid->x(), simulation_->description().fluid->region,
                              "fluid-" + number,
                              {{"velocity", 2, fluid->state().u}, {"pressure", 1, pressure}}));
  }
  if (const SolidSide* solid = simulation_->solid())
  {
    std::vector<double> x(solid->X().begin(), solid->X().end());
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] += solid->state().d[i];
    snapshots.push_back(write(solid->mesh(), x, simulation_->description().solid->region, "solid-" + number,
                              {{"displacement", 2, solid->state().d}, {"velocity", 2, solid->state().v}}));
  }
  linalg::barrier();
  if (series_)
    series_->add(snapshots);
}

}  // namespace blockfsi::run
