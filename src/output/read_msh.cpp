#include "output/draft.hpp"
#include "output/mesh_file.hpp"
#include "output/msh_content.hpp"
#include "output/node_order.hpp"

#include "core/error.hpp"
#include "element/nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace blockfsi::output
{

namespace
{

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
void find_points(const MshElements& elements, std::size_t k, std::span<const std::int32_t> order,
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
std::string group_name(const MshContent& content, int dim, int tag)
{
  const std::int64_t group = std::abs(std::int64_t{tag});
  const auto found = content.physical_names.find({dim, static_cast<int>(group)});
  return found == content.physical_names.end() ? fmt::format("physical {}", group) : found->second;
}

/// Adds the elements of the dimension of the mesh in the order of their tags; each of their entities is a
/// block.
std::vector<std::uint64_t> add_cells(const MshContent& content, int dim, const Numbering& numbering,
                                     Draft& draft)
{
  std::vector<std::uint64_t> tags;
  std::map<int, std::int32_t> blocks;
  std::vector<std::int32_t> points;
  // Blocks that are empty keep their number as long as they have a name.
  for (const auto& [entity, name] : content.block_names)
    if (entity.first == dim)
      blocks.try_emplace(entity.second, static_cast<std::int32_t>(blocks.size()));
  for (const MshElements& elements : content.elements)
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
    const MshElements* elements;
    std::size_t position;
  };
  std::vector<Cell> cells;
  std::map<element::Shape, std::vector<std::int32_t>> orders;
  for (const MshElements& elements : content.elements)
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

/// MshElements by all their nodes in ascending order: corners alone would not tell the two halves of a
/// circle.
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

void add_boundaries(const MshContent& content, int dim, const Numbering& numbering, Draft& draft)
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
  for (const MshElements& elements : content.elements)
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
ReadField arrange(const TaggedField& data, const Numbering& numbering, std::size_t count)
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
void sort_nodes(MshContent& content)
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

void check_dimensions(const MshContent& content)
{
  for (const MshElements& elements : content.elements)
    if (element::dimension(elements.type.shape) != elements.entity.first)
      throw Error(fmt::format("element {} is a {}, but its entity has {} dimensions", elements.tags.front(),
                              element::name(elements.type.shape), elements.entity.first));
}

Draft make_draft(MshContent& content)
{
  check_dimensions(content);
  int dim = 0;
  for (const MshElements& elements : content.elements)
    dim = std::max(dim, elements.entity.first);
  if (dim < 2)
    throw Error("there are no cells of two or three dimensions");
  Draft draft;
  draft.order = 0;
  for (const MshElements& elements : content.elements)
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
  for (const TaggedField& data : content.node_data)
    draft.fields.push_back(arrange(data, nodes, draft.point_count()));
  for (const TaggedField& data : content.element_data)
    draft.cell_fields.push_back(arrange(data, cells, tags.size()));
  return draft;
}

}  // namespace

ReadMesh read_msh(std::string_view content, const std::string& name)
{
  MshScanner scan(content, name);
  try
  {
    MshContent sections = read_sections(scan);
    return assemble(make_draft(sections));
  }
  catch (const Error& error)
  {
    throw error.at({name, 0, 0});
  }
}

}  // namespace blockfsi::output
