#include "case/case.hpp"

#include "block/merge.hpp"
#include "block/topology.hpp"
#include "case/check.hpp"
#include "case/level_set.hpp"
#include "case/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace blockfsi::case_file
{

namespace
{

/// A case on its way from the file.
struct Draft
{
  const Value& root;
  Case result;
  Reading reading;
  block::Layout pieces;  ///< the blocks before they are merged
};

/// Pieces whose points are nearer than this share of the size of the whole are merged.
constexpr double merge_tolerance = 1e-9;

/// Gives an edge on a level set its length. Where that fails, the check of the blocks tells why.
void measure(const block::Layout& layout, block::Edge& edge)
{
  auto* curve = std::get_if<geometry::OnLevelSet>(&edge.curve);
  if (!curve)
    return;
  try
  {
    *curve = geometry::measured(*curve, layout.points[edge.a].x, layout.points[edge.b].x);
  }
  catch (const Error&)
  {
    curve->lengths = nullptr;
  }
}

void merge_blocks(Draft& draft)
{
  draft.result.layout = draft.pieces;
  block::merge(draft.result.layout, merge_tolerance * block::layout_size(draft.pieces));
  for (block::Edge& edge : draft.result.layout.edges)
    measure(draft.result.layout, edge);
}

/// Lets corners slide along walls unless the user says otherwise: what happens there does not depend on where
/// along them.
void slide_along_walls(Case& read)
{
  std::vector<std::string> names;
  if (read.fluid)
    for (const fluid::BoundaryCondition& condition : read.fluid->boundaries)
      if (std::holds_alternative<fluid::Wall>(condition.condition) ||
          std::holds_alternative<fluid::Slip>(condition.condition))
        names.push_back(condition.boundary);
  const auto fill = [&names](Motion& motion)
  {
    if (!motion.corners.slide)
      motion.corners.slide = names;
  };
  fill(read.motion);
  for (auto& [name, motion] : read.variants)
    fill(motion);
}

/// A section: how `describe` shows it and how it is read.
struct Part
{
  std::string_view name;
  std::vector<Section> (*sections)();
  void (*read)(const Value& value, Draft& draft);
};

std::vector<Section> title_sections()
{
  return {{"", "above all sections", {{"title", "text", "", "", "what the case is"}}}};
}

/// In the order in which they build on each other, whatever the order of the file.
constexpr auto parts = std::to_array<Part>(
    {{"title", title_sections, [](const Value& v, Draft& d) { d.result.title = text(v); }},
     {"let", let_sections,
      [](const Value& v, Draft& d)
      {
        d.reading.constants = read_let(v);
        d.result.constants = d.reading.constants;
      }},
     {"geometry", geometry_sections, [](const Value& v, Draft& d) { read_geometry(v, d.reading); }},
     {"blocks", blocks_sections, [](const Value& v, Draft& d) { read_blocks(v, d.reading, d.pieces); }},
     {"boundaries", boundaries_sections,
      [](const Value& v, Draft& d) { read_boundaries(v, d.reading, d.pieces); }},
     {"fluid", fluid_sections,
      [](const Value& v, Draft& d) { read_fluid(v, d.reading, d.result.fluid.emplace()); }},
     {"solid", solid_sections,
      [](const Value& v, Draft& d) { read_solid(v, d.reading, d.result.solid.emplace()); }},
     {"time", time_sections, [](const Value& v, Draft& d) { read_time(v, d.reading, d.result.time); }},
     {"coupling", coupling_sections,
      [](const Value& v, Draft& d) { read_coupling(v, d.reading, d.result.coupling); }},
     {"motion", motion_sections,
      [](const Value& v, Draft& d)
      { read_motion(v, d.reading, d.pieces, d.result.layout, d.result.motion); }},
     {"compare", compare_sections,
      [](const Value& v, Draft& d)
      { read_compare(v, d.reading, d.pieces, d.result.layout, d.result.variants); }},
     {"prescribed", prescribed_sections,
      [](const Value& v, Draft& d) { read_prescribed(v, d.reading, d.result.prescribed.emplace()); }},
     {"switch", switch_sections,
      [](const Value& v, Draft& d) { read_switches(v, d.reading, d.result.path, d.result.switches); }},
     {"output", output_sections,
      [](const Value& v, Draft& d) { read_output(v, d.reading, d.result.output); }},
     {"petsc", petsc_sections,
      [](const Value& v, Draft& d) { read_petsc(v, d.reading, d.result.petsc_options); }}});

void check_sections(const Value& root)
{
  std::vector<std::string> known;
  known.reserve(parts.size());
  for (const Part& part : parts)
    known.emplace_back(part.name);
  for (const Field& field : table(root))
    if (std::find(known.begin(), known.end(), field.name) == known.end())
      unknown_key(field, known);
}

void require_sections(const Value& root)
{
  if (!root.find("blocks"))
    throw Error(root.where, "the section [blocks] is missing; it describes the domain as coarse blocks");
  for (const char* physics : {"fluid", "solid"})
    if (const Value* section = root.find(physics); section && !root.find("time"))
      fail(*section,
           "a case that is solved needs a section [time] with end and step, or with scheme = \"steady\"");
}

}  // namespace

std::vector<Section> all_sections()
{
  std::vector<Section> result;
  for (const Part& part : parts)
    for (Section& section : part.sections())
      result.push_back(std::move(section));
  return result;
}

Case read(const std::filesystem::path& path, const std::vector<std::string>& overrides)
{
  const Value root = load(path, overrides);
  check_sections(root);
  require_sections(root);
  Draft draft{root, {}, {}, {}};
  draft.result.path = path;
  for (const Part& part : parts)
  {
    if (part.name == "motion")
      merge_blocks(draft);
    if (const Value* value = root.find(part.name))
      part.read(*value, draft);
  }
  slide_along_walls(draft.result);
  draft.result.skeleton = std::make_shared<const block::Skeleton>(check(draft.result, draft.reading, root));
  return std::move(draft.result);
}

}  // namespace blockfsi::case_file
