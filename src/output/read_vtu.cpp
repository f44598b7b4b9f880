#include "output/collapsed.hpp"
#include "output/draft.hpp"
#include "output/mesh_file.hpp"
#include "output/vtk_arrays.hpp"
#include "output/vtk_types.hpp"
#include "output/xml.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace blockfsi::output
{

namespace
{

constexpr std::string_view names_of_this_program = "boundary_sides";

/// The array of a name among the children of an element, if there is that element and such a child.
const XmlElement* find_array(const XmlElement* parent, std::string_view name)
{
  if (parent == nullptr)
    return nullptr;
  for (const XmlElement& element : parent->children)
    if (element.attribute("Name") == name)
      return &element;
  return nullptr;
}

/// What is read of a file, with messages that name the place.
struct Source
{
  const std::string& file;
  VtkArrays arrays;

  [[noreturn]] void fail(const XmlElement& at, const std::string& message) const
  {
    throw Error({file, at.line, 0}, message);
  }

  const XmlElement& child(const XmlElement& parent, std::string_view name) const
  {
    if (const XmlElement* found = parent.child(name))
      return *found;
    fail(parent, fmt::format("<{}> has no <{}>", parent.name, name));
  }

  std::int64_t count(const XmlElement& at, std::string_view name) const
  {
    const std::string_view text = at.attribute(name);
    std::int64_t value = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value < 0)
      fail(at,
           fmt::format("{} of <{}> must be a number that is not negative, not '{}'", name, at.name, text));
    return value;
  }

  const XmlElement& named_array(const XmlElement& parent, std::string_view name) const
  {
    if (const XmlElement* found = find_array(&parent, name))
      return *found;
    fail(parent, fmt::format("<{}> has no array '{}'", parent.name, name));
  }
};

void expect_size(const Source& source, const XmlElement& at, std::size_t found, std::int64_t expected)
{
  if (found != static_cast<std::size_t>(expected))
    source.fail(at,
                fmt::format("array '{}' has {} values instead of {}", at.attribute("Name"), found, expected));
}

/// The connectivity of a file.
struct Connectivity
{
  std::vector<std::int64_t> nodes;
  std::vector<std::int64_t> offsets;  ///< behind the last node of each cell
  std::vector<std::int64_t> types;
};

Connectivity read_connectivity(Source& source, const XmlElement& cells, std::int64_t cell_count)
{
  Connectivity result;
  const XmlElement& types = source.named_array(cells, "types");
  const XmlElement& offsets = source.named_array(cells, "offsets");
  const XmlElement& nodes = source.named_array(cells, "connectivity");
  result.types = source.arrays.integers(types);
  expect_size(source, types, result.types.size(), cell_count);
  result.offsets = source.arrays.integers(offsets);
  expect_size(source, offsets, result.offsets.size(), cell_count);
  std::int64_t last = 0;
  for (const std::int64_t offset : result.offsets)
  {
    if (offset < last)
      source.fail(offsets, fmt::format("offsets must ascend, but {} follows {}", offset, last));
    last = offset;
  }
  result.nodes = source.arrays.integers(nodes);
  expect_size(source, nodes, result.nodes.size(), last);
  return result;
}

/// Block of each cell as consecutive numbers, with names.
std::vector<std::int32_t> read_blocks(Source& source, const XmlElement* cell_data,
                                      const XmlElement* field_data, std::int64_t cell_count, Draft& draft)
{
  const XmlElement* array = find_array(cell_data, "block");
  const XmlElement* names = find_array(field_data, "block_names");
  const XmlElement* regions = find_array(field_data, "block_regions");
  if (array == nullptr)
  {
    draft.block_names = {"mesh"};
    draft.block_regions = {""};
    return std::vector<std::int32_t>(cell_count, 0);
  }
  std::vector<std::int64_t> numbers = source.arrays.integers(*array);
  expect_size(source, *array, numbers.size(), cell_count);
  std::vector<std::int32_t> block;
  if (names != nullptr && regions != nullptr)
  {
    draft.block_names = source.arrays.strings(*names);
    draft.block_regions = source.arrays.strings(*regions);
    if (draft.block_names.size() != draft.block_regions.size())
      source.fail(*regions, fmt::format("there are {} names of blocks, but {} of their regions",
                                        draft.block_names.size(), draft.block_regions.size()));
    for (const std::int64_t number : numbers)
    {
      if (number < 0 || static_cast<std::size_t>(number) >= draft.block_names.size())
        source.fail(*array, fmt::format("a cell is of block {}, but there are {} blocks", number,
                                        draft.block_names.size()));
      block.push_back(static_cast<std::int32_t>(number));
    }
    return block;
  }
  const std::set<std::int64_t> found(numbers.begin(), numbers.end());
  const std::vector<std::int64_t> ascending(found.begin(), found.end());
  for (const std::int64_t number : ascending)
  {
    draft.block_names.push_back(fmt::format("block {}", number));
    draft.block_regions.emplace_back();
  }
  for (const std::int64_t number : numbers)
    block.push_back(static_cast<std::int32_t>(std::lower_bound(ascending.begin(), ascending.end(), number) -
                                              ascending.begin()));
  return block;
}

std::vector<ReadField> read_fields(Source& source, const XmlElement* parent, std::int64_t count,
                                   std::string_view left_out)
{
  std::vector<ReadField> fields;
  if (parent == nullptr)
    return fields;
  for (const XmlElement& array : parent->children)
  {
    const std::string_view name = array.attribute("Name");
    if (array.name != "DataArray" || name == left_out)
      continue;
    const std::int64_t components =
        array.attribute("NumberOfComponents").empty() ? 1 : source.count(array, "NumberOfComponents");
    if (components < 1 || components > 9)
      source.fail(array, fmt::format("array '{}' has {} components; 1 to 9 are supported", name, components));
    ReadField field{std::string(name), static_cast<int>(components), source.arrays.numbers(array)};
    expect_size(source, array, field.values.size(), count * components);
    fields.push_back(std::move(field));
  }
  return fields;
}

void read_boundaries(Source& source, const XmlElement* field_data, Draft& draft)
{
  const XmlElement* names_array = find_array(field_data, "boundary_names");
  const XmlElement* array = find_array(field_data, names_of_this_program);
  if (names_array == nullptr || array == nullptr)
    return;
  const std::vector<std::string> names = source.arrays.strings(*names_array);
  for (const std::string& name : names)
    draft.boundaries[name];
  const std::vector<std::int64_t> sides = source.arrays.integers(*array);
  if (sides.size() % 3 != 0)
    source.fail(*array, "sides of boundaries need three numbers each: boundary, cell, side");
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  for (std::size_t s = 0; s < sides.size(); s += 3)
  {
    if (sides[s] < 0 || static_cast<std::size_t>(sides[s]) >= names.size())
      source.fail(*array, fmt::format("there is no boundary {}, but {} names", sides[s], names.size()));
    if (sides[s + 1] < 0 || sides[s + 1] > most || sides[s + 2] < 0 || sides[s + 2] > most)
      source.fail(*array, fmt::format("there is no side {} of cell {}", sides[s + 2], sides[s + 1]));
    draft.boundaries[names[sides[s]]].push_back(
        {static_cast<std::int32_t>(sides[s + 1]), static_cast<std::int32_t>(sides[s + 2])});
  }
}

/// Cells by shape; collapsed hexahedra apart.
std::vector<Collapsed> read_cells(const Connectivity& of, std::span<const std::int32_t> block, Draft& draft)
{
  std::vector<Collapsed> collapsed;
  std::map<std::pair<std::int64_t, std::int64_t>, VtkType> types;
  std::vector<std::int32_t> points;
  int order = 0;
  for (std::size_t c = 0; c < of.types.size(); ++c)
  {
    const std::int64_t first = c == 0 ? 0 : of.offsets[c - 1];
    const std::int64_t count = of.offsets[c] - first;
    auto found = types.find({of.types[c], count});
    if (found == types.end())
      found =
          types
              .emplace(std::pair(of.types[c], count),
                       read_vtk_type(static_cast<int>(std::clamp<std::int64_t>(of.types[c], -1, 255)), count))
              .first;
    const VtkType& type = found->second;
    if (order == 0)
      order = type.degree;
    if (type.degree != order)
      throw Error(fmt::format("cell {} has order {}, but those before have order {}; a mesh has one order", c,
                              type.degree, order));
    points.resize(count);
    for (std::int64_t k = 0; k < count; ++k)
    {
      const std::int64_t point = of.nodes[first + k];
      if (point < 0 || static_cast<std::size_t>(point) >= draft.point_count())
        throw Error(
            fmt::format("cell {} has the node {}, but there are {} points", c, point, draft.point_count()));
      points[type.order[k]] = static_cast<std::int32_t>(point);
    }
    if (type.shape == element::Shape::hexahedron && order > 1 && is_collapsed(points, order))
    {
      draft.cells_of(element::Shape::pyramid);  // shapes keep the order in which they appear
      collapsed.push_back({points, block[c], static_cast<std::int64_t>(c)});
      continue;
    }
    DraftCells& list = draft.cells_of(type.shape);
    list.points.insert(list.points.end(), points.begin(), points.end());
    list.block.push_back(block[c]);
    list.number.push_back(static_cast<std::int64_t>(c));
  }
  draft.order = order;
  return collapsed;
}

/// Before version 2.2 the inner nodes of the edges (2, 6) and (3, 7) of Lagrange hexahedra were swapped.
void check_version(const Source& source, const XmlElement& root, const Connectivity& of)
{
  const std::string_view version = root.attribute("version", "0.1");
  const bool old = version == "0.1" || version == "1.0" || version == "2.0" || version == "2.1";
  const bool hexahedra = std::find(of.types.begin(), of.types.end(), 72) != of.types.end();
  if (old && hexahedra)
    source.fail(root,
                fmt::format("version {} of the format lists nodes of Lagrange hexahedra in another order; "
                            "write the file again with VTK 9 or ParaView 5.9 or newer",
                            version));
}

const XmlElement& check_root(const Source& source, const XmlElement& root)
{
  if (root.name != "VTKFile" || root.attribute("type") != "UnstructuredGrid")
    source.fail(root, fmt::format("this is <{} type=\"{}\">, not a VTK file of an unstructured grid",
                                  root.name, root.attribute("type")));
  const std::string_view version = root.attribute("version", "0.1");
  if (!version.starts_with("0.") && !version.starts_with("1.") && !version.starts_with("2."))
    source.fail(root, fmt::format("version {} of the format is not known; versions up to 2.3 are", version));
  return source.child(root, "UnstructuredGrid");
}

}  // namespace

ReadMesh read_vtu(std::string_view content, const std::string& name)
{
  const AppendedText appended = split_appended(content);
  const XmlElement root = parse_xml(appended.xml, name, appended.found);
  Source source{name, VtkArrays(name, root, appended, content.size())};
  const XmlElement& grid = check_root(source, root);
  if (std::count_if(grid.children.begin(), grid.children.end(),
                    [](const XmlElement& element) { return element.name == "Piece"; }) > 1)
    source.fail(grid, "the grid is in several pieces; merge them first");
  const XmlElement& piece = source.child(grid, "Piece");
  const std::int64_t point_count = source.count(piece, "NumberOfPoints");
  const std::int64_t cell_count = source.count(piece, "NumberOfCells");
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  if (point_count > most || cell_count > most)
    source.fail(piece, fmt::format("there are more than {} points or cells; cut the mesh into parts", most));

  Draft draft;
  const XmlElement& points = source.child(source.child(piece, "Points"), "DataArray");
  draft.points = source.arrays.numbers(points);
  expect_size(source, points, draft.points.size(), 3 * point_count);
  const Connectivity connectivity = read_connectivity(source, source.child(piece, "Cells"), cell_count);
  check_version(source, root, connectivity);
  const XmlElement* field_data = grid.child("FieldData");
  const std::vector<std::int32_t> block =
      read_blocks(source, piece.child("CellData"), field_data, cell_count, draft);
  draft.fields = read_fields(source, piece.child("PointData"), point_count, {});
  draft.cell_fields = read_fields(source, piece.child("CellData"), cell_count, "block");
  read_boundaries(source, field_data, draft);
  try
  {
    add_collapsed(draft, read_cells(connectivity, block, draft));
    return assemble(std::move(draft));
  }
  catch (const Error& error)
  {
    throw error.at({name, 0, 0});
  }
}

}  // namespace blockfsi::output
