#include "case/check.hpp"

#include "block/connect.hpp"
#include "block/corner_layout.hpp"
#include "case/outline.hpp"
#include "case/value.hpp"
#include "core/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace blockfsi::case_file
{

namespace
{

const Value& section_value(const Value& root, std::string_view name)
{
  const Value* value = root.find(name);
  return value ? *value : root;
}

/// The key that names the region, or its section where the default holds.
const Value& region_value(const Value& root, std::string_view name)
{
  const Value& section = section_value(root, name);
  const Value* region = section.find("region");
  return region ? *region : section;
}

void check_region(const Outline& outline, const Value& where, const std::string& region)
{
  if (!outline.has_region(region))
    fail(where, fmt::format("no block belongs to the region '{}'; the regions are {}{}", region,
                            listed(outline.regions()), did_you_mean(region, outline.regions())));
}

void check_regions(const Case& read, const Outline& outline, const Value& root)
{
  if (!read.fluid && !read.solid)
    return;
  if (read.fluid)
    check_region(outline, region_value(root, "fluid"), read.fluid->region);
  if (read.solid)
    check_region(outline, region_value(root, "solid"), read.solid->region);
  if (read.fluid && read.solid && read.fluid->region == read.solid->region)
    fail(
        region_value(root, "solid"),
        fmt::format("the region '{}' is fluid already; a solid needs blocks of its own", read.solid->region));
  for (const block::Block& block : read.layout.blocks)
    if (!(read.fluid && read.fluid->region == block.region) &&
        !(read.solid && read.solid->region == block.region))
      throw Error(block.where,
                  fmt::format("[blocks]: the region '{}' is neither fluid nor solid; name it as the "
                              "region in [fluid] or [solid], or leave out its blocks",
                              block.region));
  if (read.fluid && read.solid && !outline.neighbours(read.fluid->region, read.solid->region))
    fail(section_value(root, "solid"),
         fmt::format("the regions '{}' and '{}' have no edge in common, so nothing couples them",
                     read.fluid->region, read.solid->region));
}

/// The boundaries that touch a region are those that have conditions.
template <typename Conditions>
void check_conditions(const Case& read, const Outline& outline, const Value& section,
                      const std::string& region, const Conditions& conditions, std::string_view example)
{
  for (std::size_t i = 0; i < read.layout.boundaries.size(); ++i)
  {
    const std::string& name = read.layout.boundaries[i].name;
    const auto condition =
        std::find_if(conditions.begin(), conditions.end(), [&](const auto& c) { return c.boundary == name; });
    const bool touches = outline.touches(i, region);
    if (touches && condition == conditions.end())
      fail(section,
           fmt::format("the boundary '{}' touches the region '{}' but has no condition; add one, such as "
                       "{} = {}",
                       name, region, name, example));
    if (!touches && condition != conditions.end())
      throw Error(condition->where,
                  fmt::format("{} {}: the boundary '{}' does not touch the region '{}'; remove "
                              "this condition",
                              section.path, name, name, region));
  }
}

void check_slip(const Case& read, const Outline& outline)
{
  for (const fluid::BoundaryCondition& condition : read.fluid->boundaries)
  {
    if (!std::holds_alternative<fluid::Slip>(condition.condition))
      continue;
    if (const block::PlacedEdge* edge = outline.oblique_edge(condition.boundary))
    {
      const block::Point& a = read.layout.points[edge->a];
      const block::Point& b = read.layout.points[edge->b];
      throw Error(
          condition.where,
          fmt::format("[fluid] {}: slip is allowed only along straight lines in x or y; the edge from '{}' "
                      "({:.6g}, {:.6g}) to '{}' ({:.6g}, {:.6g}) is not one",
                      condition.boundary, a.name, a.x[0], a.x[1], b.name, b.x[0], b.x[1]));
    }
  }
}

void check_enclosed(const Case& read, const Value& root)
{
  const auto lets_out = [](const fluid::BoundaryCondition& c)
  {
    return std::holds_alternative<fluid::Traction>(c.condition) ||
           std::holds_alternative<fluid::Outflow>(c.condition);
  };
  if (read.fluid && read.solid &&
      std::none_of(read.fluid->boundaries.begin(), read.fluid->boundaries.end(), lets_out))
    fail(section_value(root, "fluid"), "every boundary prescribes the velocity, but an enclosed "
                                       "incompressible fluid keeps its volume and cannot "
                                       "make room for a moving solid (the incompressibility dilemma); give "
                                       "one boundary traction or outflow");
}

void check_held(const Case& read, const Value& root)
{
  const auto holds = [](const solid::BoundaryCondition& c)
  { return !std::holds_alternative<solid::Traction>(c.condition); };
  if (read.solid && read.time.scheme == fem::Scheme::steady &&
      std::none_of(read.solid->boundaries.begin(), read.solid->boundaries.end(), holds))
    fail(section_value(root, "solid"),
         "nothing holds the body, so it has no steady state; give one boundary fixed or displacement");
}

/// Cells of its own may not fit the gradings.
void check_solid_blocks(const Case& read, const Value& root)
{
  if (!read.solid_differs())
    return;
  try
  {
    block::make_skeleton(read.solid_layout());
  }
  catch (const Error& error)
  {
    throw error.within("order or divide of [solid]").at(section_value(root, "solid").where);
  }
}

/// Rules that run in a circle or move the interface would only show when the run begins.
void check_follows(const Case& read, const block::Skeleton& skeleton, const Motion& motion,
                   const std::string& path)
{
  if (!read.fluid || !read.solid || motion.corners.follows.empty())
    return;
  try
  {
    block::corner_graph(read.layout, skeleton, read.fluid->region,
                        block::interface_nodes(read.layout, skeleton, read.fluid->region, read.solid->region),
                        motion.corners);
  }
  catch (const Error& error)
  {
    throw error.within(path).at(motion.where);
  }
}

void check_sliding(const Case& read, const Outline& outline, const Motion& motion, const std::string& path)
{
  std::vector<std::string> known;
  for (std::size_t i = 0; i < read.layout.boundaries.size(); ++i)
    if (read.fluid && outline.touches(i, read.fluid->region))
      known.push_back(read.layout.boundaries[i].name);
  for (const std::string& name : motion::sliding(motion.update))
  {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Error(motion.where, fmt::format("{} slide: '{}' is no boundary that the fluid touches{}", path,
                                            name, suggestion(name, known)));
    if (const block::PlacedEdge* edge = outline.oblique_edge(name))
      throw Error(motion.where,
                  fmt::format("{} slide: nodes slide only along straight lines in x or y; the edge of '{}' "
                              "from '{}' to '{}' is not one",
                              path, name, read.layout.points[edge->a].name,
                              read.layout.points[edge->b].name));
  }
}

void check_motion(const Case& read, const block::Skeleton& skeleton, const Outline& outline,
                  const Motion& motion, const std::string& path)
{
  check_follows(read, skeleton, motion, path);
  check_sliding(read, outline, motion, path);
}

void check_samples(const Case& read, const Reading& reading, const Outline& outline)
{
  for (const Sample& sample : reading.samples)
    for (const auto& [x, y] :
         sample.on_boundary ? outline.boundary_nodes(sample.name) : outline.region_corners(sample.name))
      for (const double t : {0.0, read.time.end})
      {
        const double value = sample.expression(x, y, 0.0, t);
        if (!std::isfinite(value))
          throw Error(sample.where,
                      fmt::format("{}: \"{}\" is {} at x = {:.6g}, y = {:.6g}, t = {:.6g}; it must be "
                                  "finite wherever it is used",
                                  sample.path, sample.expression.text(), number_text(value), x, y, t));
      }
}

void check_probes(const Case& read, const Outline& outline)
{
  for (const output::Probe& probe : read.output.probes)
  {
    const bool of_solid = probe.of == "displacement";
    const std::string path = fmt::format("[output] probes.{}", probe.name);
    if (of_solid ? !read.solid : !read.fluid)
      throw Error(probe.where, fmt::format("{}: '{}' needs a section [{}], which this case lacks", path,
                                           probe.of, of_solid ? "solid" : "fluid"));
    const std::string& region = of_solid ? read.solid->region : read.fluid->region;
    if (!outline.contains(region, probe.at[0], probe.at[1]))
      throw Error(probe.where,
                  fmt::format("{}: the point ({:.6g}, {:.6g}) lies outside of the region '{}', where "
                              "the {} lives",
                              path, probe.at[0], probe.at[1], region, probe.of));
  }
}

void check_force(const Case& read, const Outline& outline, const output::Force& force)
{
  std::vector<std::string> known;
  for (std::size_t i = 0; i < read.layout.boundaries.size(); ++i)
    if (outline.touches(i, read.fluid->region))
      known.push_back(read.layout.boundaries[i].name);
  if (read.solid)
    known.push_back(read.solid->region);
  for (const std::string& name : force.on)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Error(force.where,
                  fmt::format("[output] forces: '{}' is no boundary that the fluid touches{}{}", name,
                              read.solid ? " and not the solid's region" : "", suggestion(name, known)));
}

void check_forces(const Case& read, const Outline& outline)
{
  std::set<std::string, std::less<>> seen;
  for (const output::Force& force : read.output.forces)
  {
    if (!read.fluid)
      throw Error(force.where,
                  "[output] forces: a force is that of the fluid, but this case has no section [fluid]");
    if (!seen.insert(force.name).second)
      throw Error(force.where, fmt::format("[output] forces: '{}' is asked for twice", force.name));
    check_force(read, outline, force);
  }
}

}  // namespace

block::Skeleton check(const Case& read, const Reading& reading, const Value& root)
{
  block::Skeleton skeleton = block::make_skeleton(read.layout);
  const Outline outline(read.layout, skeleton);
  check_regions(read, outline, root);
  if (read.fluid)
  {
    check_conditions(read, outline, section_value(root, "fluid"), read.fluid->region, read.fluid->boundaries,
                     "{ wall = true }");
    check_slip(read, outline);
  }
  if (read.solid)
    check_conditions(read, outline, section_value(root, "solid"), read.solid->region, read.solid->boundaries,
                     "{ free = true }");
  check_solid_blocks(read, root);
  check_enclosed(read, root);
  check_held(read, root);
  check_motion(read, skeleton, outline, read.motion, "[motion]");
  for (const auto& [name, variant] : read.variants)
    check_motion(read, skeleton, outline, variant, fmt::format("[compare.{}]", name));
  check_samples(read, reading, outline);
  check_probes(read, outline);
  check_forces(read, outline);
  return skeleton;
}

}  // namespace blockfsi::case_file
