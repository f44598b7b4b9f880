#pragma once

#include "output/series.hpp"
#include "output/table.hpp"
#include "run/simulation.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace blockfsi::run
{

struct NamedField;

/// The files of a run: probes.csv, forces.csv, quality.csv, fields.pvd with its pieces in fields/.
///
/// Process 0 writes the tables; every process writes its own pieces of the fields.
class Results
{
public:
  /// Starts new files in a folder, or continues those there behind the step at which the simulation stands.
  /// Throws Error if a probe is nowhere or the folder cannot be written.
  Results(const std::filesystem::path& folder, Simulation& simulation, bool resume);

  /// Adds a row to each table for the step just done.
  void add_step(const StepReport& report);
  /// Writes the fields of the accepted state, unless they were written at this time already.
  void add_fields();

private:
  struct Follower
  {
    output::Probe probe;
    std::size_t cell = 0;  ///< where it was last
  };
  std::vector<std::string> probe_columns() const;
  std::vector<std::string> force_columns() const;
  std::vector<double> probe_values();
  std::vector<double> force_values() const;
  void find_force_nodes();
  std::vector<double> at(Follower& follower, const mesh::Mesh& mesh, std::span<const double> x,
                         std::span<const double> field, int components);
  output::Snapshot write(const mesh::Mesh& mesh, std::span<const double> x, const std::string& region,
                         const std::string& stem, const std::vector<NamedField>& fields);

  std::filesystem::path folder_;
  Simulation* simulation_;
  std::vector<Follower> followers_;
  /// For each force the marks of owned nodes that belong to it.
  std::vector<std::vector<std::int32_t>> force_nodes_;
  std::optional<output::Table> probes_;
  std::optional<output::Table> forces_;
  std::optional<output::Table> quality_;
  std::optional<output::Series> series_;
  double fields_time_ = -1.0;
};

}  // namespace blockfsi::run
