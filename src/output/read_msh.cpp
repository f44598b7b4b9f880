#include "output/draft.hpp"
#include "output/mesh_file.hpp"
#include "output/msh_scanner.hpp"
#include "output/msh_types.hpp"
#include "output/node_order.hpp"

#include "core/error.hpp"
#include "element/nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

namespace blockfsi::output
{

namespace
{

/// A dimension and a tag: entities and physical groups.
using Tagged = std::pair<int, int>;

/// Elements of one type of one entity, nodes as the file numbers them.
struct Elements
{
  Tagged entity;
  GmshType type;
  std::vector<std::uint64_t> tags;
  std::vector<std::uint64_t> nodes;
};

struct Data
{
  ReadField field;
  std::vector<std::int64_t> tags;
};

/// What the sections of a file say.
struct Content
{
  std::map<Tagged, std::string> physical_names;
  std::map<Tagged, std::string> block_names;
  std::map<Tagged, std::vector<int>> physical;  ///< groups of each entity
  std::vector<std::uint64_t> node_tags;
  std::vector<double> points;
  std::vector<Elements> elements;
  std::vector<Data> node_data;
  std::vector<Data> element_data;
};

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

void read_entities(MshScanner& scan, Content& content)
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

void read_nodes(MshScanner& scan, Content& content)
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

void read_elements(MshScanner& scan, Content& content)
{
  const std::uint64_t blocks = scan.size();
  const std::size_t total = scan.count(16, 2);
  scan.size();
  scan.size();
  std::size_t count_so_far = 0;
  for (std::uint64_t b = 0; b < blocks; ++b)
  {
    Elements elements;
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

Data read_data(MshScanner& scan)
{
  Data data;
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

Content read_sections(MshScanner& scan)
{
  Content content;
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

/// Index of each tag: a table where tags are dense, as they mostly are.
class Numbering
{
public:
  Numbering(std::span<const std::uint64_t> tags, std::string_view what)
  {
    const std::uint64_t largest = tags.empty() ? 0 : *std::max_element(tags.begin(), tags.end());
    if (largest < 4 * tags.size() + 1000)
      table_.assign(largest + 1, -1);
    for (std::size_t k = 0; k < tags.size(); ++k)
    {
      const auto index = static_cast<std::int32_t>(k);
      if (table_.empty() ? !index_.try_emplace(tags[k], index).second
                         : std::exchange(table_[tags[k]], index) >= 0)
        throw Error(fmt::format("{} {} is there twice", what, tags[k]));
    }
  }

  /// -1: there is none.
  std::int32_t find(std::uint64_t tag) const
  {
    if (!table_.empty())
      return tag < table_.size() ? table_[tag] : -1;
    const auto found = index_.find(tag);
    return found == index_.end() ? -1 : found->second;
  }

private:
  std::vector<std::int32_t> table_;
  std::unordered_map<std::uint64_t, std::int32_t> index_;
};

/// The nodes of an element as points, in the order of the lattice.
void find_points(const Elements& elements, std::size_t k, std::span<const std::int32_t> order,
                 const Numbering& numbering, std::vector<std::int32_t>& points)
{
  points.resize(order.size());
  for (std::size_t n = 0; n < order.size(); ++n)
  {
    const std::uint64_t tag = elements.nodes[k * order.size() + n];
    const std::int32_t point = numbering.find(tag);
    if (point < 0)
      throw Error(fmt::format("element {} has the node {}, which there is not", elements.tags[k], tag));
    points[order[n]] = point;
  }
}

/// Entities refer to groups with a sign that tells their direction.
std::string group_name(const Content& content, int dim, int tag)
{
  const std::int64_t group = std::abs(std::int64_t{tag});
  const auto found = content.physical_names.find({dim, static_cast<int>(group)});
  return found == content.physical_names.end() ? fmt::format("physical {}", group) : found->second;
}

/// Adds the elements of the dimension of the mesh in the order of their tags; each of their entities is a
/// block.
std::vector<std::uint64_t> add_cells(const Content& content, int dim, const Numbering& numbering,
                                     Draft& draft)
{
  std::vector<std::uint64_t> tags;
  std::map<int, std::int32_t> blocks;
  std::vector<std::int32_t> points;
  // Blocks that are empty keep their number as long as they have a name.
  for (const auto& [entity, name] : content.block_names)
    if (entity.first == dim)
      blocks.try_emplace(entity.second, static_cast<std::int32_t>(blocks.size()));
  for (const Elements& elements : content.elements)
    if (elements.entity.first == dim)
      blocks.try_emplace(elements.entity.second, 0);
  for (std::int32_t next = 0; auto& [tag, block] : blocks)
  {
    block = next++;
    const auto name = content.block_names.find({dim, tag});
    const auto groups = content.physical.find({dim, tag});
    draft.block_names.push_back(name != content.block_names.end()
                                    ? name->second
                                    : fmt::format("{} {}", dim == 3 ? "volume" : "surface", tag));
    draft.block_regions.push_back(groups == content.physical.end() || groups->second.empty()
                                      ? std::string()
                                      : group_name(content, dim, groups->second.front()));
  }
  struct Cell
  {
    std::uint64_t tag;
    const Elements* elements;
    std::size_t position;
  };
  std::vector<Cell> cells;
  std::map<element::Shape, std::vector<std::int32_t>> orders;
  for (const Elements& elements : content.elements)
  {
    if (elements.entity.first != dim)
      continue;
    orders[elements.type.shape] = gmsh_order(elements.type.shape, elements.type.order);
    for (std::size_t k = 0; k < elements.tags.size(); ++k)
      cells.push_back({elements.tags[k], &elements, k});
  }
  std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.tag < b.tag; });
  for (const auto& [tag, elements, k] : cells)
  {
    find_points(*elements, k, orders[elements->type.shape], numbering, points);
    DraftCells& list = draft.cells_of(elements->type.shape);
    list.points.insert(list.points.end(), points.begin(), points.end());
    list.block.push_back(blocks[elements->entity.second]);
    list.number.push_back(static_cast<std::int64_t>(tags.size()));
    tags.push_back(tag);
  }
  return tags;
}

/// Which boundary an element of one dimension less is part of.
struct BoundaryElement
{
  const std::vector<std::string>* names = nullptr;
  std::uint64_t tag = 0;
  bool found = false;
};

/// Elements by all their nodes in ascending order: corners alone would not tell the two halves of a circle.
using BoundaryElements = std::map<std::vector<std::int32_t>, std::vector<BoundaryElement>>;

/// Looks for the sides of cells that the elements of boundaries lie on. The first cell with such a side has
/// it.
void match_sides(Draft& draft, BoundaryElements& wanted)
{
  std::vector<bool> on_boundary(draft.point_count(), false);
  for (const auto& [nodes, elements] : wanted)
    for (const std::int32_t node : nodes)
      on_boundary[node] = true;
  std::vector<std::int32_t> key;
  for (const DraftCells& list : draft.cells)
  {
    const auto n = static_cast<std::size_t>(element::lattice_size(list.shape, draft.order));
    const std::size_t side_count = element::sides(list.shape).size();
    std::vector<std::vector<std::int32_t>> lattices;
    for (std::size_t s = 0; s < side_count; ++s)
      lattices.push_back(element::side_lattice(list.shape, draft.order, static_cast<int>(s)));
    for (std::size_t c = 0; c < list.number.size(); ++c)
      for (std::size_t s = 0; s < side_count; ++s)
      {
        key.clear();
        for (const std::int32_t at : lattices[s])
        {
          key.push_back(list.points[c * n + at]);
          if (!on_boundary[key.back()])
            break;
        }
        if (key.size() < lattices[s].size() || !on_boundary[key.back()])
          continue;
        std::sort(key.begin(), key.end());
        const auto found = wanted.find(key);
        if (found == wanted.end())
          continue;
        for (BoundaryElement& element : found->second)
          if (!std::exchange(element.found, true))
            for (const std::string& name : *element.names)
              draft.boundaries[name].push_back(
                  {static_cast<std::int32_t>(list.number[c]), static_cast<std::int32_t>(s)});
      }
  }
  for (const auto& [nodes, elements] : wanted)
    for (const BoundaryElement& element : elements)
      if (!element.found)
        throw Error(fmt::format("element {} of the boundary '{}' is no side of any cell", element.tag,
                                element.names->front()));
}

void add_boundaries(const Content& content, int dim, const Numbering& numbering, Draft& draft)
{
  std::map<int, std::vector<std::string>> names;  // by entity
  for (const auto& [entity, groups] : content.physical)
    if (entity.first == dim - 1)
      for (const int group : groups)
        names[entity.second].push_back(group_name(content, dim - 1, group));
  for (const auto& [group, name] : content.physical_names)
    if (group.first == dim - 1)
      draft.boundaries[name];
  BoundaryElements wanted;
  std::vector<std::int32_t> points;
  for (const Elements& elements : content.elements)
  {
    const auto found = names.find(elements.entity.second);
    if (elements.entity.first != dim - 1 || found == names.end())
      continue;
    if (elements.type.order != draft.order)
      throw Error(fmt::format("the boundary '{}' has elements of order {}, but cells have order {}",
                              found->second.front(), elements.type.order, draft.order));
    const std::vector<std::int32_t> order = gmsh_order(elements.type.shape, elements.type.order);
    for (std::size_t k = 0; k < elements.tags.size(); ++k)
    {
      find_points(elements, k, order, numbering, points);
      std::sort(points.begin(), points.end());
      wanted[points].push_back({&found->second, elements.tags[k], false});
    }
  }
  match_sides(draft, wanted);
}

/// Values in the order of the numbering; things without a value have 0.
ReadField arrange(const Data& data, const Numbering& numbering, std::size_t count)
{
  const auto components = static_cast<std::size_t>(data.field.components);
  ReadField field{data.field.name, data.field.components, std::vector<double>(count * components, 0.0)};
  for (std::size_t k = 0; k < data.tags.size(); ++k)
  {
    const std::int32_t at = numbering.find(static_cast<std::uint64_t>(data.tags[k]));
    if (at >= 0)
      std::copy_n(data.field.values.begin() + k * components, components,
                  field.values.begin() + at * components);
  }
  return field;
}

/// Files list nodes by entity; their tags tell how they were numbered.
void sort_nodes(Content& content)
{
  std::vector<std::size_t> position(content.node_tags.size());
  std::iota(position.begin(), position.end(), std::size_t{0});
  std::stable_sort(position.begin(), position.end(),
                   [&content](std::size_t a, std::size_t b)
                   { return content.node_tags[a] < content.node_tags[b]; });
  std::vector<std::uint64_t> tags;
  std::vector<double> points;
  tags.reserve(position.size());
  points.reserve(content.points.size());
  for (const std::size_t from : position)
  {
    tags.push_back(content.node_tags[from]);
    points.insert(points.end(), content.points.begin() + 3 * from, content.points.begin() + 3 * from + 3);
  }
  content.node_tags = std::move(tags);
  content.points = std::move(points);
}

void check_dimensions(const Content& content)
{
  for (const Elements& elements : content.elements)
    if (element::dimension(elements.type.shape) != elements.entity.first)
      throw Error(fmt::format("element {} is a {}, but its entity has {} dimensions", elements.tags.front(),
                              element::name(elements.type.shape), elements.entity.first));
}

Draft make_draft(Content& content)
{
  check_dimensions(content);
  int dim = 0;
  for (const Elements& elements : content.elements)
    dim = std::max(dim, elements.entity.first);
  if (dim < 2)
    throw Error("there are no cells of two or three dimensions");
  Draft draft;
  draft.order = 0;
  for (const Elements& elements : content.elements)
  {
    if (elements.entity.first != dim)
      continue;
    if (draft.order == 0)
      draft.order = elements.type.order;
    if (elements.type.order != draft.order)
      throw Error(fmt::format("element {} has order {}, but others have order {}; a mesh has one order",
                              elements.tags.front(), elements.type.order, draft.order));
  }
  sort_nodes(content);
  draft.points = std::move(content.points);
  const Numbering nodes(content.node_tags, "node");
  const std::vector<std::uint64_t> tags = add_cells(content, dim, nodes, draft);
  const Numbering cells(tags, "element");
  add_boundaries(content, dim, nodes, draft);
  for (const Data& data : content.node_data)
    draft.fields.push_back(arrange(data, nodes, draft.point_count()));
  for (const Data& data : content.element_data)
    draft.cell_fields.push_back(arrange(data, cells, tags.size()));
  return draft;
}

}  // namespace

ReadMesh read_msh(std::string_view content, const std::string& name)
{
  MshScanner scan(content, name);
  try
  {
    Content sections = read_sections(scan);
    return assemble(make_draft(sections));
  }
  catch (const Error& error)
  {
    throw error.at({name, 0, 0});
  }
}

}  // namespace blockfsi::output
