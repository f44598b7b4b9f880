#include "output/msh_content.hpp"

#include "core/error.hpp"
#include "element/nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace blockfsi::output
{

namespace
{

constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();

void read_format(MshScanner& scan)
{
  const double version = scan.text_number();
  const std::int64_t binary = scan.text_integer();
  const std::int64_t width = scan.text_integer();
  if (version != 4.1)
    scan.fail(
        fmt::format("version {} of the format is not supported; save the mesh in version 4.1: gmsh in.msh "
                    "-save -format msh41 -o out.msh",
                    version));
  if (width != 8 || (binary != 0 && binary != 1))
    scan.fail(
        fmt::format("'{} {}' must be 0 (text) or 1 (binary) and 8, the bytes of a number", binary, width));
  if (binary == 0)
    return;
  scan.line();
  scan.use_binary();
  if (const int one = scan.integer(); one != 1)
    scan.fail("the numbers are in the byte order of another machine (big-endian), which is not supported");
}

void read_names(MshScanner& scan, std::map<Tagged, std::string>& names)
{
  const std::int64_t count = scan.text_integer();
  for (std::int64_t k = 0; k < count; ++k)
  {
    const std::int64_t dim = scan.text_integer();
    const std::int64_t tag = scan.text_integer();
    if (dim < 0 || dim > 3 || tag < -most || tag > most)
      scan.fail(fmt::format("there is no dimension {} or number {}", dim, tag));
    names[{static_cast<int>(dim), static_cast<int>(tag)}] = scan.quoted();
  }
}

void read_entities(MshScanner& scan, MshContent& content)
{
  std::array<std::uint64_t, 4> counts{};
  for (std::uint64_t& count : counts)
    count = scan.size();
  for (int dim = 0; dim <= 3; ++dim)
    for (std::uint64_t e = 0; e < counts[dim]; ++e)
    {
      const int tag = scan.integer();
      for (int d = 0; d < (dim == 0 ? 3 : 6); ++d)
        scan.number();
      std::vector<int>& groups = content.physical[{dim, tag}];
      const std::size_t group_count = scan.count(4, 1);
      for (std::size_t g = 0; g < group_count; ++g)
        groups.push_back(scan.integer());
      if (dim == 0)
        continue;
      const std::size_t bound_count = scan.count(4, 1);
      for (std::size_t b = 0; b < bound_count; ++b)
        scan.integer();
    }
}

int read_dimension(MshScanner& scan)
{
  const int dim = scan.integer();
  if (dim < 0 || dim > 3)
    scan.fail(fmt::format("entities have 0 to 3 dimensions, not {}", dim));
  return dim;
}

void read_nodes(MshScanner& scan, MshContent& content)
{
  if (!content.node_tags.empty())
    scan.fail("there is a second section of nodes");
  const std::uint64_t blocks = scan.size();
  const std::size_t total = scan.count(32, 4);
  scan.size();
  scan.size();
  if (total > most)
    scan.fail(fmt::format("there are more than {} nodes; cut the mesh into parts", most));
  content.node_tags.reserve(total);
  content.points.reserve(3 * total);
  for (std::uint64_t b = 0; b < blocks; ++b)
  {
    const int dim = read_dimension(scan);
    scan.integer();
    const int parametric = scan.integer();
    const std::size_t count = scan.count(32, 4);
    if (count > total - content.node_tags.size())
      scan.fail(fmt::format("there are more nodes than the {} that the section speaks of", total));
    for (std::size_t k = 0; k < count; ++k)
      content.node_tags.push_back(scan.size());
    for (std::size_t k = 0; k < count; ++k)
    {
      for (int d = 0; d < 3; ++d)
        content.points.push_back(scan.number());
      for (int d = 0; parametric != 0 && d < dim; ++d)
        scan.number();
    }
  }
  if (content.node_tags.size() != total)
    scan.fail(fmt::format("there are {} nodes instead of {}", content.node_tags.size(), total));
}

GmshType read_type(MshScanner& scan)
{
  const int number = scan.integer();
  if (number == gmsh_point)
    return {element::Shape::segment, 0};
  if (const std::optional<GmshType> type = find_gmsh_type(number))
    return *type;
  scan.fail(
      fmt::format("elements of Gmsh's type {} are not supported; those of all shapes of orders 1 to {} with "
                  "all their nodes are (Mesh.SecondOrderIncomplete = 0)",
                  number, element::largest_order));
}

void read_elements(MshScanner& scan, MshContent& content)
{
  const std::uint64_t blocks = scan.size();
  const std::size_t total = scan.count(16, 2);
  scan.size();
  scan.size();
  std::size_t count_so_far = 0;
  for (std::uint64_t b = 0; b < blocks; ++b)
  {
    MshElements elements;
    elements.entity.first = read_dimension(scan);
    elements.entity.second = scan.integer();
    elements.type = read_type(scan);
    const bool point = elements.type.order == 0;
    const auto width =
        point ? std::size_t{1}
              : static_cast<std::size_t>(element::lattice_size(elements.type.shape, elements.type.order));
    const std::size_t count = scan.count(8 * (width + 1), width + 1);
    count_so_far += count;
    if (count_so_far > total)
      scan.fail(fmt::format("there are more elements than the {} that the section speaks of", total));
    for (std::size_t k = 0; k < count; ++k)
    {
      elements.tags.push_back(scan.size());
      for (std::size_t n = 0; n < width; ++n)
        elements.nodes.push_back(scan.size());
    }
    if (!point && count > 0)
      content.elements.push_back(std::move(elements));
  }
  if (count_so_far != total)
    scan.fail(fmt::format("there are {} elements instead of {}", count_so_far, total));
}

TaggedField read_data(MshScanner& scan)
{
  TaggedField data;
  const std::int64_t strings = scan.text_integer();
  for (std::int64_t k = 0; k < strings; ++k)
  {
    const std::string text = scan.quoted();
    if (k == 0)
      data.field.name = text;
  }
  const std::int64_t reals = scan.text_integer();
  for (std::int64_t k = 0; k < reals; ++k)
    scan.text_number();
  const std::int64_t integers = scan.text_integer();
  std::array<std::int64_t, 3> head = {0, 1, 0};
  for (std::int64_t k = 0; k < integers; ++k)
  {
    const std::int64_t value = scan.text_integer();
    if (k < 3)
      head[k] = value;
  }
  scan.line();
  const auto [step, components, count] = head;
  if (components < 1 || components > 9 || count < 0)
    scan.fail(fmt::format("{} entries of {} components cannot be; 1 to 9 components are supported", count,
                          components));
  data.field.components = static_cast<int>(components);
  for (std::int64_t k = 0; k < count; ++k)
  {
    data.tags.push_back(scan.integer());
    for (std::int64_t d = 0; d < components; ++d)
      data.field.values.push_back(scan.number());
  }
  return data;
}

}  // namespace

MshContent read_sections(MshScanner& scan)
{
  MshContent content;
  if (scan.next_section() != "MeshFormat")
    scan.fail("a .msh file begins with $MeshFormat");
  read_format(scan);
  scan.end_section();
  for (std::string section = scan.next_section(); !section.empty(); section = scan.next_section())
  {
    if (section == "PhysicalNames")
      read_names(scan, content.physical_names);
    else if (section == "BlockNames")
      read_names(scan, content.block_names);
    else if (section == "Entities")
      read_entities(scan, content);
    else if (section == "Nodes")
      read_nodes(scan, content);
    else if (section == "Elements")
      read_elements(scan, content);
    else if (section == "NodeData")
      content.node_data.push_back(read_data(scan));
    else if (section == "ElementData")
      content.element_data.push_back(read_data(scan));
    else if (section == "PartitionedEntities")
      scan.fail("the mesh is in partitions; save it in one piece (Mesh.SaveWithoutOrphans, no -part)");
    else
    {
      scan.skip_section();
      continue;
    }
    scan.end_section();
  }
  return content;
}

}  // namespace blockfsi::output
