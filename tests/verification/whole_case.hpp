#pragma once

#include "case/case.hpp"
#include "run/locate.hpp"
#include "run/simulation.hpp"

#include <doctest/doctest.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace verification
{

/// A case of the folder cases/, with values replaced as by --set.
inline blockfsi::case_file::Case whole_case(const std::string& name, const std::vector<std::string>& settings)
{
  return blockfsi::case_file::read(std::filesystem::path(BLOCKFSI_CASES_FOLDER) / name / "case.toml",
                                   settings);
}

/// Steps to the end of the case; calls after_step() after each.
template <typename AfterStep>
void finish(blockfsi::run::Simulation& simulation, AfterStep&& after_step)
{
  while (!simulation.finished())
  {
    const blockfsi::run::StepReport report = simulation.advance();
    REQUIRE_MESSAGE(report.ok, report.failure);
    after_step();
  }
}

inline void finish(blockfsi::run::Simulation& simulation)
{
  finish(simulation, [] {});
}

/// Both components of a nodal field at a point.
inline std::array<double, 2> at(const blockfsi::mesh::Mesh& mesh, std::span<const double> x,
                                std::span<const double> field, std::array<double, 2> point)
{
  const auto found = blockfsi::run::locate(mesh, x, point, 0);
  REQUIRE(found);
  return {found->value(mesh, field, 2, 0), found->value(mesh, field, 2, 1)};
}

}  // namespace verification
