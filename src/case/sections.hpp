#pragma once

#include "case/case.hpp"
#include "case/key.hpp"
#include "case/tree.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace blockfsi::case_file
{

/// Each section of the file: how it is read, and the keys that its reader knows.

Constants read_let(const Value& value);
std::vector<Section> let_sections();

/// Appends all pieces of the blocks; nothing is merged yet, so every name of a point is still known.
void read_blocks(const Value& value, Reading& reading, block::Layout& layout);
std::vector<Section> blocks_sections();
/// One lattice: [blocks.lattice.NAME].
void read_lattice(const Field& field, Reading& reading, block::Layout& layout);
std::vector<Section> lattice_sections();

/// The hole in "hole N in LATTICE", or nothing if the text does not begin with "hole". Throws Error if it
/// only begins so.
std::optional<block::ByHole> hole_named(const Value& value);

/// Needs the pieces of the blocks.
void read_boundaries(const Value& value, Reading& reading, block::Layout& layout);
std::vector<Section> boundaries_sections();

/// Rules in the numbers of `merged`, for names in the pieces that it was merged from.
void read_motion(const Value& value, Reading& reading, const block::Layout& pieces,
                 const block::Layout& merged, Motion& motion);
std::vector<Section> motion_sections();

/// Variants of [motion] by name.
void read_compare(const Value& value, Reading& reading, const block::Layout& pieces,
                  const block::Layout& merged, std::vector<std::pair<std::string, Motion>>& variants);
std::vector<Section> compare_sections();

/// One table or a list of them.
void read_switches(const Value& value, Reading& reading, const std::filesystem::path& file,
                   std::vector<Switch>& switches);
std::vector<Section> switch_sections();

void read_prescribed(const Value& value, Reading& reading, Prescribed& prescribed);
std::vector<Section> prescribed_sections();

void read_fluid(const Value& value, Reading& reading, fluid::Parameters& parameters);
std::vector<Section> fluid_sections();

void read_solid(const Value& value, Reading& reading, solid::Parameters& parameters);
std::vector<Section> solid_sections();

void read_time(const Value& value, Reading& reading, fem::TimeParameters& parameters);
std::vector<Section> time_sections();

void read_coupling(const Value& value, Reading& reading, coupling::Parameters& parameters);
std::vector<Section> coupling_sections();

void read_output(const Value& value, Reading& reading, output::Parameters& parameters);
std::vector<Section> output_sections();

void read_petsc(const Value& value, Reading& reading, std::string& options);
std::vector<Section> petsc_sections();

/// Everything that `describe` shows, in the order of a typical file.
std::vector<Section> all_sections();

}  // namespace blockfsi::case_file
