#include "output/vtu.hpp"

#include "core/error.hpp"
#include "output/encode.hpp"
#include "output/file.hpp"
#include "output/lattice_values.hpp"
#include "output/node_order.hpp"
#include "output/vtk_types.hpp"

#include <fmt/format.h>

#include <iterator>
#include <optional>
#include <string_view>
#include <type_traits>

namespace blockfsi::output
{

namespace
{

using element::Shape;

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
void add_array(std::string& text, std::string_view name, int components, std::span<const T> values,
               std::string_view more = {})
{
  fmt::format_to(std::back_inserter(text),
                 "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"{} format=\"binary\">\n",
                 type_name<T>(), escape_xml(name), components, more);
  text += encode_compressed(std::as_bytes(values));
  text += "\n</DataArray>\n";
}

/// The points of a file: the nodes of the mesh, then those that pyramids need in addition.
class FilePoints
{
public:
  explicit FilePoints(const mesh::Mesh& mesh)
      : mesh_(mesh), change_(mesh, element::NodeKind::warped, element::NodeKind::equispaced)
  {
    for (const mesh::CellRun& run : mesh.runs)
      if (run.shape == Shape::pyramid && mesh.order > 1)
        add_pyramids(run);
  }

  std::size_t count() const
  {
    return mesh_.node_count() + (pyramids_.count > 0 ? pyramids_.count * collapsed_->extra.size() : 0);
  }

  /// A nodal field there, shape (count, width).
  std::vector<double> values(std::span<const double> nodal, int components, int width) const
  {
    std::vector<double> result = change_(nodal, components, width);
    result.resize(count() * width);
    std::size_t point = mesh_.node_count();
    for (std::int32_t c = pyramids_.first; c < pyramids_.first + pyramids_.count; ++c)
    {
      const std::span<const std::int32_t> nodes = mesh_.cell(c);
      for (int q = 0; q < table_.point_count; ++q, ++point)
        for (std::size_t k = 0; k < nodes.size(); ++k)
          for (int d = 0; d < components; ++d)
            result[point * width + d] +=
                table_.value[q * nodes.size() + k] * nodal[std::size_t(nodes[k]) * components + d];
    }
    return result;
  }

  /// What stands at each point of the lattice that VTK uses for a cell.
  void points(std::int32_t cell, std::vector<std::int32_t>& result) const
  {
    const std::span<const std::int32_t> nodes = mesh_.cell(cell);
    result.assign(nodes.begin(), nodes.end());
    if (cell < pyramids_.first || cell >= pyramids_.first + pyramids_.count)
      return;
    const auto extra =
        static_cast<std::int32_t>(mesh_.node_count() + (cell - pyramids_.first) * collapsed_->extra.size());
    result.clear();
    for (const std::int32_t at : collapsed_->hexahedron)
      result.push_back(at >= 0 ? nodes[at] : extra - 1 - at);
  }

private:
  void add_pyramids(const mesh::CellRun& run)
  {
    pyramids_ = run;
    collapsed_.emplace(mesh_.order);
    std::vector<element::Point> points;
    for (const auto& [x, y, z] : collapsed_->extra)
      points.push_back({x * (1.0 - z), y * (1.0 - z), z});
    table_ = element::tabulate(Shape::pyramid, mesh_.order, points, 0);
  }

  const mesh::Mesh& mesh_;
  LatticeChange change_;
  mesh::CellRun pyramids_{.count = 0};
  std::optional<CollapsedPyramid> collapsed_;
  element::CellTable table_;
};

void add_cells(std::string& text, const mesh::Mesh& mesh, const FilePoints& points)
{
  std::vector<std::int32_t> connectivity;
  connectivity.reserve(mesh.cells.size());
  std::vector<std::int64_t> offsets;
  std::vector<std::uint8_t> types;
  std::vector<std::int32_t> lattice;
  for (const mesh::CellRun& run : mesh.runs)
  {
    const VtkType type = vtk_type(run.shape, mesh.order);
    for (std::int32_t c = run.first; c < run.first + run.count; ++c)
    {
      points.points(c, lattice);
      for (const std::int32_t at : type.order)
        connectivity.push_back(lattice[at]);
      offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
      types.push_back(type.number);
    }
  }
  text += "<Cells>\n";
  add_array<std::int32_t>(text, "connectivity", 1, connectivity);
  add_array<std::int64_t>(text, "offsets", 1, offsets);
  add_array<std::uint8_t>(text, "types", 1, types);
  text += "</Cells>\n";
}

/// Strings are written as their bytes, each followed by a zero.
void add_names(std::string& text, std::string_view name, std::span<const std::string> values)
{
  fmt::format_to(std::back_inserter(text),
                 "<Array type=\"String\" Name=\"{}\" NumberOfTuples=\"{}\" format=\"ascii\">\n", name,
                 values.size());
  for (const std::string& value : values)
  {
    for (const char c : value)
      fmt::format_to(std::back_inserter(text), "{} ", static_cast<unsigned>(static_cast<unsigned char>(c)));
    text += "0\n";
  }
  text += "</Array>\n";
}

void add_field_data(std::string& text, const mesh::Mesh& mesh)
{
  std::vector<std::string> names;
  std::vector<std::int32_t> sides;
  for (const auto& [name, of] : mesh.boundaries)
  {
    for (const mesh::Side& side : of)
      sides.insert(sides.end(), {static_cast<std::int32_t>(names.size()), side.cell, side.side});
    names.push_back(name);
  }
  text += "<FieldData>\n";
  add_names(text, "block_names", mesh.block_names);
  add_names(text, "block_regions", mesh.block_regions);
  add_names(text, "boundary_names", names);
  add_array<std::int32_t>(text, "boundary_sides", 3, sides,
                          fmt::format(" NumberOfTuples=\"{}\"", sides.size() / 3));
  text += "</FieldData>\n";
}

std::string file_head(std::string_view type)
{
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"2.2\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n",
      type);
}

void add_cell_data(std::string& text, const mesh::Mesh& mesh, std::span<const CellField> cell_fields)
{
  for (const CellField& field : cell_fields)
    std::visit(
        [&text, &field, &mesh]<typename T>(std::span<const T> values)
        {
          check_size(field.name, values.size(), mesh.cell_count());
          add_array<T>(text, field.name, 1, values);
        },
        field.values);
}

}  // namespace

void write_vtu(const std::filesystem::path& path, const mesh::Mesh& mesh, std::span<const double> x,
               std::span<const Field> fields, std::span<const CellField> cell_fields, Names names)
{
  check_size("coordinates", x.size(), mesh.dim * mesh.node_count());
  for (const Field& field : fields)
    check_size(field.name, field.values.size(), mesh.node_count() * field.components);
  const FilePoints points(mesh);
  std::string text = file_head("UnstructuredGrid");
  text += "<UnstructuredGrid>\n";
  if (names == Names::kept)
    add_field_data(text, mesh);
  fmt::format_to(std::back_inserter(text), "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n",
                 points.count(), mesh.cell_count());
  add_array<double>(text, "Points", 3, points.values(x, mesh.dim, 3));
  text += "</Points>\n";
  add_cells(text, mesh, points);
  text += "<PointData>\n";
  for (const Field& field : fields)
  {
    const int width = written_components(field);
    add_array<double>(text, field.name, width, points.values(field.values, field.components, width));
  }
  text += "</PointData>\n<CellData>\n";
  add_cell_data(text, mesh, cell_fields);
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
