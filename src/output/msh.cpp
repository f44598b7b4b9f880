#include "output/msh.hpp"

#include "core/error.hpp"
#include "output/file.hpp"
#include "output/lattice_values.hpp"
#include "output/msh_types.hpp"
#include "output/node_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace blockfsi::output
{

namespace
{

using Corner = std::array<double, 3>;

/// Adds numbers, as bytes or as text.
class Writer
{
public:
  explicit Writer(MshEncoding encoding) : binary_(encoding == MshEncoding::binary) {}

  bool binary() const { return binary_; }
  void add_text(std::string_view text) { text_ += text; }

  template <typename T>
  void add(T value)
  {
    if (binary_)
      text_.append(reinterpret_cast<const char*>(&value), sizeof(T));
    else
      fmt::format_to(std::back_inserter(text_), "{} ", value);
  }
  void add_size(std::size_t value) { add(std::uint64_t{value}); }

  template <typename T>
  void add_all(std::span<const T> values)
  {
    if (binary_)
      text_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    else
      for (const T value : values)
        add(value);
  }
  void end_line()
  {
    if (!binary_)
      text_ += '\n';
  }

  std::string_view text() const { return text_; }

private:
  bool binary_;
  std::string text_;
};

/// An entity: a block, or the sides of a boundary that a block has.
struct Entity
{
  int dim = 2;
  int tag = 1;
  int physical = 0;                 ///< 0: none
  std::vector<int> bounds;          ///< entities that bound it
  std::vector<std::int32_t> nodes;  ///< those that no entity before has
  std::vector<mesh::Side> sides;    ///< of a boundary
  std::vector<std::int32_t> cells;  ///< of a block
  Corner low{};
  Corner high{};
};

struct PhysicalName
{
  int dim = 2;
  int tag = 1;
  std::string name;
};

struct Entities
{
  std::vector<Entity> boundaries;
  std::vector<Entity> blocks;
  std::vector<PhysicalName> names;
};

Entities make_entities(const mesh::Mesh& mesh)
{
  Entities result;
  std::map<std::string_view, int> regions;
  for (std::size_t b = 0; b < mesh.block_names.size(); ++b)
  {
    const std::string& region = mesh.block_regions[b];
    Entity& entity = result.blocks.emplace_back();
    entity.dim = mesh.dim;
    entity.tag = static_cast<int>(b) + 1;
    if (region.empty())
      continue;
    const auto [found, is_new] = regions.try_emplace(region, static_cast<int>(regions.size()) + 1);
    entity.physical = found->second;
    if (is_new)
      result.names.push_back({mesh.dim, found->second, region});
  }
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
    result.blocks[mesh.cell_block[c]].cells.push_back(static_cast<std::int32_t>(c));

  int physical = 0;
  for (const auto& [name, sides] : mesh.boundaries)
  {
    result.names.push_back({mesh.dim - 1, ++physical, name});
    std::map<std::int32_t, std::size_t> of_block;
    for (const mesh::Side& side : sides)
    {
      const std::int32_t block = mesh.cell_block[side.cell];
      const auto [found, is_new] = of_block.try_emplace(block, result.boundaries.size());
      if (is_new)
      {
        Entity& entity = result.boundaries.emplace_back();
        entity.dim = mesh.dim - 1;
        entity.tag = static_cast<int>(result.boundaries.size());
        entity.physical = physical;
        result.blocks[block].bounds.push_back(entity.tag);
      }
      result.boundaries[found->second].sides.push_back(side);
    }
  }
  return result;
}

/// Nodes of a side in the order of its own lattice, turned so that its normal points outwards (in two
/// dimensions: the cell is on the left).
class SideNodes
{
public:
  explicit SideNodes(const mesh::Mesh& mesh) : mesh_(mesh) {}

  void find(const mesh::Side& side, std::vector<std::int32_t>& nodes)
  {
    const element::Shape shape = mesh_.shape(side.cell);
    std::vector<std::int32_t>& lattice = lattices_[{shape, side.side}];
    if (lattice.empty())
      lattice = outward_lattice(shape, side.side);
    const std::span<const std::int32_t> cell = mesh_.cell(side.cell);
    nodes.clear();
    for (const std::int32_t at : lattice)
      nodes.push_back(cell[at]);
  }

private:
  std::vector<std::int32_t> outward_lattice(element::Shape shape, int side) const
  {
    const element::SideShape& of = element::sides(shape)[side];
    const std::vector<std::int32_t> along = element::side_lattice(shape, mesh_.order, side);
    if (of.outward)
      return along;
    std::vector<std::int32_t> turned;
    for (const auto& [s, t, unused] : element::lattice_points(of.shape, mesh_.order))
    {
      const element::LatticePoint from = of.shape == element::Shape::segment
                                             ? element::LatticePoint{mesh_.order - s, 0, 0}
                                             : element::LatticePoint{t, s, 0};
      turned.push_back(along[element::lattice_index(of.shape, mesh_.order, from)]);
    }
    return turned;
  }

  const mesh::Mesh& mesh_;
  std::map<std::pair<element::Shape, int>, std::vector<std::int32_t>> lattices_;
};

/// Nodes belong to the first entity that has them, boundaries first.
void distribute_nodes(const mesh::Mesh& mesh, std::span<const double> x, Entities& entities)
{
  std::vector<bool> taken(mesh.node_count(), false);
  const auto take = [&](Entity& entity, std::int32_t node)
  {
    for (int d = 0; d < 3; ++d)
    {
      entity.low[d] = std::min(entity.low[d], x[3 * std::size_t(node) + d]);
      entity.high[d] = std::max(entity.high[d], x[3 * std::size_t(node) + d]);
    }
    if (!taken[node])
      entity.nodes.push_back(node);
    taken[node] = true;
  };
  const auto start = [](Entity& entity)
  {
    entity.low.fill(std::numeric_limits<double>::max());
    entity.high.fill(std::numeric_limits<double>::lowest());
  };
  SideNodes side_nodes(mesh);
  std::vector<std::int32_t> nodes;
  for (Entity& entity : entities.boundaries)
  {
    start(entity);
    for (const mesh::Side& side : entity.sides)
    {
      side_nodes.find(side, nodes);
      for (const std::int32_t node : nodes)
        take(entity, node);
    }
  }
  for (Entity& entity : entities.blocks)
  {
    if (!entity.cells.empty())
      start(entity);
    for (const std::int32_t cell : entity.cells)
      for (const std::int32_t node : mesh.cell(cell))
        take(entity, node);
  }
}

void check_names(const mesh::Mesh& mesh)
{
  const auto check = [](const std::string& name, std::string_view what)
  {
    if (name.find_first_of("\"\n\r") != std::string::npos)
      throw Error(
          fmt::format("the name '{}' of a {} has a quote or line break, which .msh files cannot hold; "
                      "rename it or write a .vtu file",
                      name, what));
  };
  for (const std::string& name : mesh.block_names)
    check(name, "block");
  for (const std::string& name : mesh.block_regions)
    check(name, "region");
  for (const auto& [name, sides] : mesh.boundaries)
    check(name, "boundary");
}

void add_names(Writer& writer, const mesh::Mesh& mesh, const Entities& entities)
{
  std::string text = fmt::format("$PhysicalNames\n{}\n", entities.names.size());
  for (const PhysicalName& name : entities.names)
    fmt::format_to(std::back_inserter(text), "{} {} \"{}\"\n", name.dim, name.tag, name.name);
  fmt::format_to(std::back_inserter(text), "$EndPhysicalNames\n$BlockNames\n{}\n", mesh.block_names.size());
  for (std::size_t b = 0; b < mesh.block_names.size(); ++b)
    fmt::format_to(std::back_inserter(text), "{} {} \"{}\"\n", mesh.dim, b + 1, mesh.block_names[b]);
  writer.add_text(text + "$EndBlockNames\n");
}

void add_entities(Writer& writer, const mesh::Mesh& mesh, const Entities& entities)
{
  writer.add_text("$Entities\n");
  for (int dim = 0; dim <= 3; ++dim)
    writer.add_size(dim == mesh.dim       ? entities.blocks.size()
                    : dim == mesh.dim - 1 ? entities.boundaries.size()
                                          : 0);
  writer.end_line();
  const auto add = [&writer](const Entity& entity)
  {
    writer.add(entity.tag);
    writer.add_all<double>(entity.low);
    writer.add_all<double>(entity.high);
    writer.add_size(entity.physical > 0 ? 1 : 0);
    if (entity.physical > 0)
      writer.add(entity.physical);
    writer.add_size(entity.bounds.size());
    writer.add_all<int>(entity.bounds);
    writer.end_line();
  };
  for (const Entity& entity : entities.boundaries)
    add(entity);
  for (const Entity& entity : entities.blocks)
    add(entity);
  writer.add_text(writer.binary() ? "\n$EndEntities\n" : "$EndEntities\n");
}

void add_nodes(Writer& writer, const mesh::Mesh& mesh, std::span<const double> x, const Entities& entities)
{
  writer.add_text("$Nodes\n");
  std::size_t blocks = 0;
  std::size_t count = 0;
  for (const auto* list : {&entities.boundaries, &entities.blocks})
    for (const Entity& entity : *list)
    {
      blocks += entity.nodes.empty() ? 0 : 1;
      count += entity.nodes.size();
    }
  for (const std::size_t number : {blocks, count, std::size_t{1}, mesh.node_count()})
    writer.add_size(number);
  writer.end_line();
  for (const auto* list : {&entities.boundaries, &entities.blocks})
    for (const Entity& entity : *list)
    {
      if (entity.nodes.empty())
        continue;
      writer.add(entity.dim);
      writer.add(entity.tag);
      writer.add(0);
      writer.add_size(entity.nodes.size());
      writer.end_line();
      for (const std::int32_t node : entity.nodes)
      {
        writer.add_size(std::size_t(node) + 1);
        writer.end_line();
      }
      for (const std::int32_t node : entity.nodes)
      {
        writer.add_all<double>(x.subspan(3 * std::size_t(node), 3));
        writer.end_line();
      }
    }
  writer.add_text(writer.binary() ? "\n$EndNodes\n" : "$EndNodes\n");
}

/// Elements of one type of one entity.
struct ElementBlock
{
  const Entity* entity = nullptr;
  element::Shape shape = element::Shape::segment;
  std::vector<std::uint64_t> rows;  ///< tag and nodes of each element
  std::size_t count = 0;
};

class ElementBlocks
{
public:
  explicit ElementBlocks(const mesh::Mesh& mesh) : mesh_(mesh) {}

  /// `nodes` follow the lattice of the shape.
  void add(const Entity& entity, element::Shape shape, std::span<const std::int32_t> nodes, std::uint64_t tag)
  {
    if (blocks.empty() || blocks.back().entity != &entity || blocks.back().shape != shape)
    {
      blocks.push_back({&entity, shape, {}, 0});
      order_ = gmsh_order(shape, mesh_.order);
    }
    ElementBlock& block = blocks.back();
    ++block.count;
    block.rows.push_back(tag);
    for (const std::int32_t at : order_)
      block.rows.push_back(static_cast<std::uint64_t>(nodes[at]) + 1);
  }

  std::vector<ElementBlock> blocks;

private:
  const mesh::Mesh& mesh_;
  std::vector<std::int32_t> order_;
};

void add_elements(Writer& writer, const mesh::Mesh& mesh, const Entities& entities)
{
  ElementBlocks all(mesh);
  std::uint64_t tag = mesh.cell_count();  // cells have their own numbers, sides those behind
  SideNodes side_nodes(mesh);
  std::vector<std::int32_t> nodes;
  for (const Entity& entity : entities.boundaries)
  {
    std::vector<mesh::Side> sides = entity.sides;
    const auto shape = [&mesh](const mesh::Side& side)
    { return element::sides(mesh.shape(side.cell))[side.side].shape; };
    std::stable_sort(sides.begin(), sides.end(),
                     [&](const mesh::Side& a, const mesh::Side& b) { return shape(a) < shape(b); });
    for (const mesh::Side& side : sides)
    {
      side_nodes.find(side, nodes);
      all.add(entity, shape(side), nodes, ++tag);
    }
  }
  for (const Entity& entity : entities.blocks)
    for (const std::int32_t cell : entity.cells)
      all.add(entity, mesh.shape(cell), mesh.cell(cell), std::uint64_t(cell) + 1);
  writer.add_text("$Elements\n");
  for (const std::uint64_t number : {std::uint64_t{all.blocks.size()}, tag, std::uint64_t{1}, tag})
    writer.add(number);
  writer.end_line();
  for (const ElementBlock& block : all.blocks)
  {
    writer.add(block.entity->dim);
    writer.add(block.entity->tag);
    writer.add(gmsh_type(block.shape, mesh.order));
    writer.add_size(block.count);
    writer.end_line();
    const std::size_t width = block.rows.size() / block.count;
    for (std::size_t row = 0; row < block.count; ++row)
    {
      writer.add_all<std::uint64_t>(std::span(block.rows).subspan(row * width, width));
      writer.end_line();
    }
  }
  writer.add_text(writer.binary() ? "\n$EndElements\n" : "$EndElements\n");
}

/// $NodeData or $ElementData: values, shape (count, components), of the nodes or elements 1..count.
void add_data(Writer& writer, std::string_view section, std::string_view name, int components,
              std::span<const double> values)
{
  if (name.find_first_of("\"\n\r") != std::string_view::npos)
    throw Error(fmt::format(
        "the field '{}' has a quote or line break in its name, which .msh files cannot hold", name));
  const std::size_t count = values.size() / components;
  writer.add_text(fmt::format("${}\n1\n\"{}\"\n1\n0\n3\n0\n{}\n{}\n", section, name, components, count));
  for (std::size_t k = 0; k < count; ++k)
  {
    writer.add(static_cast<std::int32_t>(k + 1));
    writer.add_all<double>(values.subspan(k * components, components));
    writer.end_line();
  }
  writer.add_text(fmt::format("{}$End{}\n", writer.binary() ? "\n" : "", section));
}

}  // namespace

void write_msh(const std::filesystem::path& path, const mesh::Mesh& mesh, std::span<const double> x,
               std::span<const Field> fields, std::span<const CellField> cell_fields, MshEncoding encoding)
{
  check_size("coordinates", x.size(), mesh.dim * mesh.node_count());
  check_names(mesh);
  const LatticeChange change(mesh, element::NodeKind::warped, element::NodeKind::equispaced);
  const std::vector<double> points = change(x, mesh.dim, 3);
  Entities entities = make_entities(mesh);
  distribute_nodes(mesh, points, entities);
  Writer writer(encoding);
  writer.add_text(fmt::format("$MeshFormat\n4.1 {} 8\n", writer.binary() ? 1 : 0));
  if (writer.binary())
  {
    writer.add(1);
    writer.add_text("\n");
  }
  writer.add_text("$EndMeshFormat\n");
  add_names(writer, mesh, entities);
  add_entities(writer, mesh, entities);
  add_nodes(writer, mesh, points, entities);
  add_elements(writer, mesh, entities);
  for (const Field& field : fields)
  {
    check_size(field.name, field.values.size(), mesh.node_count() * field.components);
    const int width = written_components(field);
    add_data(writer, "NodeData", field.name, width, change(field.values, field.components, width));
  }
  for (const CellField& field : cell_fields)
    std::visit(
        [&]<typename T>(std::span<const T> values)
        {
          check_size(field.name, values.size(), mesh.cell_count());
          add_data(writer, "ElementData", field.name, 1, std::vector<double>(values.begin(), values.end()));
        },
        field.values);
  replace_file(path, writer.text());
}

}  // namespace blockfsi::output
