#include "run/layouts.hpp"

#include "output/checkpoint.hpp"
#include "output/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

namespace blockfsi::run
{

namespace
{

constexpr const char* transfer_table = "transfer.csv";

}  // namespace

std::vector<std::filesystem::path> layout_folders(const case_file::Case& description,
                                                  const std::filesystem::path& run_folder)
{
  std::vector<std::filesystem::path> result = {run_folder};
  std::vector<std::string> taken = {"fields", "checkpoint"};
  for (const case_file::Switch& next : description.switches)
  {
    const std::string stem = next.path.stem().string();
    std::string name = stem;
    for (int number = 2; std::find(taken.begin(), taken.end(), name) != taken.end(); ++number)
      name = fmt::format("{}-{}", stem, number);
    taken.push_back(name);
    result.push_back(run_folder / name);
  }
  return result;
}

std::vector<std::filesystem::path> reached_folders(const case_file::Case& description,
                                                   const std::filesystem::path& run_folder)
{
  std::vector<std::filesystem::path> result = layout_folders(description, run_folder);
  result.erase(std::find_if(result.begin() + 1, result.end(),
                            [](const auto& folder)
                            { return !std::filesystem::exists(folder / transfer_table); }),
               result.end());
  return result;
}

void forget(const std::filesystem::path& folder)
{
  std::filesystem::remove(folder / transfer_table);
  output::remove_all(folder / "checkpoint");
}

void write_transfer(const std::filesystem::path& folder, const Simulation& from, const HandoverReport& report)
{
  const FlowIntegrals& old = report.before;
  const FlowIntegrals& now = report.after;
  output::Table table(folder / transfer_table,
                      {"step", "time", "scaled_jacobian_before", "scaled_jacobian", "velocity_error",
                       "pressure_error", "area_before", "area", "momentum_x_before", "momentum_x",
                       "momentum_y_before", "momentum_y", "outflow_before", "outflow", "divergence_before",
                       "divergence"});
  table.append(from.step(),
               std::array{from.time(), from.fluid()->quality().scaled_jacobian,
                          report.quality.scaled_jacobian, report.velocity_error, report.pressure_error,
                          old.area, now.area, old.momentum[0], now.momentum[0], old.momentum[1],
                          now.momentum[1], old.outflow, now.outflow, old.divergence, now.divergence});
}

}  // namespace blockfsi::run
