#include "output/vtu.hpp"

#include "core/error.hpp"
#include "element/line.hpp"
#include "mesh/tensor.hpp"
#include "output/encode.hpp"
#include "output/file.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string_view>
#include <type_traits>

namespace blockfsi::output
{

namespace
{

constexpr int vtk_quad = 9;
constexpr int vtk_lagrange_quadrilateral = 70;

/// Our position in the cell of each of VTK's nodes: corners, sides (each along increasing xi or eta), inner
/// nodes.
std::vector<int> vtk_order(int order)
{
  const int n = order + 1;
  std::vector<int> positions = {0, order, order * n + order, order * n};
  for (int side = 0; side < 4; ++side)
    for (int k = 1; k < order; ++k)
      positions.push_back(mesh::side_node(order, side, k));
  for (int j = 1; j < order; ++j)
    for (int i = 1; i < order; ++i)
      positions.push_back(i + j * n);
  return positions;
}

/// Values at equispaced nodes of a field given at Gauss-Lobatto-Legendre nodes, as shape (node_count, width)
/// with zeros behind the components. A node gets the same value, up to rounding, from each of its cells: on a
/// side only the nodes of the side count, and both families of points are symmetric.
std::vector<double> at_equispaced(const mesh::Mesh& mesh, std::span<const double> values, int components,
                                  int width)
{
  std::vector<double> points(mesh.order + 1);
  for (int i = 0; i <= mesh.order; ++i)
    points[i] = static_cast<double>(i) / mesh.order;
  const mesh::LineMap map = mesh::lagrange_maps(element::lobatto(mesh.order), points).value;
  std::vector<double> result(mesh.node_count() * width);
  std::vector<double> from(mesh.nodes_per_cell());
  std::vector<double> to(mesh.nodes_per_cell());
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
  {
    const std::span<const std::int32_t> nodes = mesh.cell(c);
    for (int d = 0; d < components; ++d)
    {
      for (std::size_t k = 0; k < nodes.size(); ++k)
        from[k] = values[nodes[k] * components + d];
      mesh::apply(map, map, from, to);
      for (std::size_t k = 0; k < nodes.size(); ++k)
        result[nodes[k] * width + d] = to[k];
    }
  }
  return result;
}

int written_components(const Field& field)
{
  return field.components == 2 ? 3 : field.components;
}

template <typename T>
constexpr std::string_view type_name()
{
  if constexpr (std::is_same_v<T, double>)
    return "Float64";
  else if constexpr (std::is_same_v<T, std::int64_t>)
    return "Int64";
  else if constexpr (std::is_same_v<T, std::int32_t>)
    return "Int32";
  else
    return "UInt8";
}

template <typename T>
void add_array(std::string& text, std::string_view name, int components, std::span<const T> values)
{
  fmt::format_to(std::back_inserter(text),
                 "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">\n",
                 type_name<T>(), escape_xml(name), components);
  text += encode_compressed(std::as_bytes(values));
  text += "\n</DataArray>\n";
}

void add_cells(std::string& text, const mesh::Mesh& mesh)
{
  const std::vector<int> positions = vtk_order(mesh.order);
  std::vector<std::int32_t> connectivity;
  connectivity.reserve(mesh.cells.size());
  std::vector<std::int64_t> offsets;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
  {
    for (const int position : positions)
      connectivity.push_back(mesh.cell(c)[position]);
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  const std::vector<std::uint8_t> types(mesh.cell_count(),
                                        mesh.order == 1 ? vtk_quad : vtk_lagrange_quadrilateral);
  text += "<Cells>\n";
  add_array<std::int32_t>(text, "connectivity", 1, connectivity);
  add_array<std::int64_t>(text, "offsets", 1, offsets);
  add_array<std::uint8_t>(text, "types", 1, types);
  text += "</Cells>\n";
}

void check_size(std::string_view name, std::size_t found, std::size_t expected)
{
  if (found != expected)
    throw Error(fmt::format("field '{}' has {} values, but the mesh needs {}", name, found, expected));
}

std::string file_head(std::string_view type)
{
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"2.2\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n",
      type);
}

}  // namespace

void write_vtu(const std::filesystem::path& path, const mesh::Mesh& mesh, std::span<const double> x,
               std::span<const Field> fields, std::span<const CellField> cell_fields)
{
  if (mesh.dim != 2 || !mesh.is_all(element::Shape::quadrilateral))
    throw Error("only meshes of quadrilaterals in the plane can be written to a .vtu file");
  check_size("coordinates", x.size(), 2 * mesh.node_count());
  std::string text = file_head("UnstructuredGrid");
  fmt::format_to(std::back_inserter(text),
                 "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n",
                 mesh.node_count(), mesh.cell_count());
  add_array<double>(text, "Points", 3, at_equispaced(mesh, x, 2, 3));
  text += "</Points>\n";
  add_cells(text, mesh);
  text += "<PointData>\n";
  for (const Field& field : fields)
  {
    check_size(field.name, field.values.size(), mesh.node_count() * field.components);
    const int width = written_components(field);
    add_array<double>(text, field.name, width, at_equispaced(mesh, field.values, field.components, width));
  }
  text += "</PointData>\n<CellData>\n";
  for (const CellField& field : cell_fields)
    std::visit(
        [&text, &field, &mesh]<typename T>(std::span<const T> values)
        {
          check_size(field.name, values.size(), mesh.cell_count());
          add_array<T>(text, field.name, 1, values);
        },
        field.values);
  text += "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  replace_file(path, text);
}

void write_pvtu(const std::filesystem::path& path, std::span<const std::string> pieces,
                std::span<const Field> fields, std::span<const CellField> cell_fields)
{
  const auto array = [](std::string_view type, std::string_view name, int components)
  {
    return fmt::format("<PDataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"/>\n", type,
                       escape_xml(name), components);
  };
  std::string text = file_head("PUnstructuredGrid");
  text += "<PUnstructuredGrid GhostLevel=\"0\">\n<PPoints>\n" + array("Float64", "Points", 3) +
          "</PPoints>\n<PPointData>\n";
  for (const Field& field : fields)
    text += array("Float64", field.name, written_components(field));
  text += "</PPointData>\n<PCellData>\n";
  for (const CellField& field : cell_fields)
    text += std::visit([&field, &array]<typename T>(std::span<const T>)
                       { return array(type_name<T>(), field.name, 1); },
                       field.values);
  text += "</PCellData>\n";
  for (const std::string& piece : pieces)
    text += fmt::format("<Piece Source=\"{}\"/>\n", escape_xml(piece));
  text += "</PUnstructuredGrid>\n</VTKFile>\n";
  replace_file(path, text);
}

}  // namespace blockfsi::output
