#pragma once

#include "block/connect.hpp"
#include "block/corner_layout.hpp"
#include "block/layout.hpp"
#include "coupling/parameters.hpp"
#include "fem/time.hpp"
#include "fluid/parameters.hpp"
#include "motion/parameters.hpp"
#include "output/parameters.hpp"
#include "solid/parameters.hpp"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace blockfsi::case_file
{

/// How the fluid mesh follows the solid; the corners matter where it is regenerated.
struct Motion
{
  motion::Parameters update;
  block::CornerParameters corners;
  Location where;
};

/// A flap that is bent without a fluid, to see how far its mesh follows.
struct Prescribed
{
  std::array<double, 3> root{};  ///< ends of its straight centre line [m]
  std::array<double, 3> tip{};
  std::array<double, 3> axis = {0.0, 0.0, 1.0};  ///< about which it turns, perpendicular to that line
  double bent = 0.2;                             ///< share of the length in which rotation bends it
  double angle = 120.0;                          ///< at which sweeps end [degrees]
  double step = 2.5;                             ///< [degrees]
  std::vector<double> show = {30.0, 60.0, 90.0, 120.0};
  double amplitude = 60.0;  ///< of cycles [degrees]
  int cycles = 3;
};

/// Another layout of blocks that takes over when the one before is at its end.
struct Switch
{
  std::filesystem::path path;  ///< of its case file
  double below = 0.0;        ///< least scaled Jacobian of a step's mesh at which it takes over at the latest
  std::optional<double> at;  ///< time at which it takes over at the latest [s]
  Location where;
};

/// Everything that a case file says, checked: the parameters of all layers and the blocks.
struct Case
{
  std::filesystem::path path;
  std::string title;
  Constants constants;
  block::Layout layout;
  /// Of the layout as it was read: checking it places all nodes on edges and faces, which can take long.
  std::shared_ptr<const block::Skeleton> skeleton;
  Motion motion;
  /// Other ways for `blockfsi compare`, by name.
  std::vector<std::pair<std::string, Motion>> variants;
  std::optional<Prescribed> prescribed;
  std::vector<Switch> switches;  ///< each takes over from the one before
  std::optional<fluid::Parameters> fluid;
  std::optional<solid::Parameters> solid;
  fem::TimeParameters time;
  coupling::Parameters coupling;
  output::Parameters output;
  std::string petsc_options;  ///< passed through to PETSc

  /// Whether the solid divides the blocks otherwise than the layout says.
  bool solid_differs() const;
  /// The blocks as the solid divides them. Throws Error where their gradings do not allow it.
  block::Layout solid_layout() const;
};

/// Reads and checks a case file. `overrides` are assignments "key.path=value" in TOML syntax that replace
/// values of the file, as from the command line. Throws Error with the place of the first mistake.
Case read(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

}  // namespace blockfsi::case_file
