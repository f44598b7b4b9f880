#include "command/mesh.hpp"

#include "block/cell_sizes.hpp"
#include "block/connect.hpp"
#include "block/place.hpp"
#include "command/parts.hpp"
#include "command/picture.hpp"
#include "geometry/cad.hpp"
#include "mesh/quality.hpp"
#include "mesh/validity.hpp"
#include "output/mesh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace blockfsi::command
{

const std::vector<std::pair<std::string, mesh::Target>>& conversions()
{
  static const std::vector<std::pair<std::string, mesh::Target>> names = {
      {"triangles", mesh::Target::triangles},
      {"triangles4", mesh::Target::triangles_with_centres},
      {"quadrilaterals", mesh::Target::quadrilaterals},
      {"tetrahedra", mesh::Target::tetrahedra},
      {"hexahedra", mesh::Target::hexahedra}};
  return names;
}

namespace
{

using element::Shape;
using mesh::Target;

/// Shape of the cells that a conversion makes.
Shape made_shape(Target target)
{
  switch (target)
  {
  case Target::quadrilaterals:
    return Shape::quadrilateral;
  case Target::tetrahedra:
    return Shape::tetrahedron;
  case Target::hexahedra:
    return Shape::hexahedron;
  default:
    return Shape::triangle;
  }
}

const std::string& name_of(Target target)
{
  return std::find_if(conversions().begin(), conversions().end(),
                      [=](const auto& entry) { return entry.second == target; })
      ->first;
}

std::string plural(Shape shape)
{
  switch (shape)
  {
  case Shape::tetrahedron:
    return "tetrahedra";
  case Shape::hexahedron:
    return "hexahedra";
  default:
    return std::string(element::name(shape)) + "s";
  }
}

/// Shapes of cells in a mesh of the blocks; a pyramid holds tetrahedra, too.
std::vector<Shape> shapes_of(const block::Layout& layout)
{
  std::vector<Shape> shapes;
  for (const block::Block& block : layout.blocks)
  {
    shapes.push_back(block.shape);
    if (block.shape == Shape::pyramid)
      shapes.push_back(Shape::tetrahedron);
  }
  std::sort(shapes.begin(), shapes.end());
  shapes.erase(std::unique(shapes.begin(), shapes.end()), shapes.end());
  return shapes;
}

/// Throws Error unless the conversions can be done one after the other; better before a large mesh is made.
void check_steps(const block::Layout& layout, const std::vector<Target>& steps)
{
  std::vector<Shape> shapes = shapes_of(layout);
  for (const Target step : steps)
  {
    const Shape made = made_shape(step);
    if (element::dimension(made) != layout.dim)
      throw Error(fmt::format("--convert {}: the mesh is {}, where it can be converted to {}", name_of(step),
                              layout.dim == 2 ? "plane" : "in space",
                              layout.dim == 2 ? "triangles, triangles4 or quadrilaterals"
                                              : "tetrahedra or hexahedra"));
    if (made == Shape::hexahedron && std::find(shapes.begin(), shapes.end(), Shape::pyramid) != shapes.end())
      throw Error("--convert hexahedra: no pyramid can be cut into hexahedra, but its tetrahedra can: "
                  "--convert tetrahedra,hexahedra");
    shapes = {made};
  }
}

/// Order of the cells that are cut.
int order_before(const block::Layout& layout, const std::vector<Target>& steps, int order)
{
  const std::vector<Shape> shapes = shapes_of(layout);
  const bool places_nodes = std::any_of(
      steps.begin(), steps.end(),
      [&](Target step)
      {
        const Shape made = made_shape(step);
        const bool halves_edges = made == Shape::quadrilateral || made == Shape::hexahedron;
        // Tetrahedra bring diagonals of sides; triangles only what lies inside of cells.
        return made != Shape::triangle && (halves_edges || order > 1) && shapes != std::vector<Shape>{made};
      });
  return places_nodes ? std::min(2 * order, element::largest_order) : order;
}

/// A mesh with its nodes.
struct Made
{
  mesh::Mesh mesh;
  std::vector<double> x;  ///< [m], shape (node_count, dim)
};

Made convert(Made made, const std::vector<Target>& steps, int order)
{
  for (std::size_t k = 0; k < steps.size(); ++k)
  {
    const bool is_last = k + 1 == steps.size();
    mesh::Converted converted = mesh::convert(made.mesh, made.x, {steps[k], is_last ? order : 0, {}});
    made = {std::move(converted.mesh), std::move(converted.x)};
  }
  return made;
}

std::string shape_counts(const mesh::Mesh& mesh)
{
  std::string text;
  for (const mesh::CellRun& run : mesh.runs)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", run.count, plural(run.shape));
  return text;
}

void write(const std::filesystem::path& path, const Made& made, const std::vector<mesh::Verdict>& verdicts)
{
  std::vector<std::int32_t> proved;
  proved.reserve(verdicts.size());
  for (const mesh::Verdict verdict : verdicts)
    proved.push_back(verdict == mesh::Verdict::valid ? 1 : 0);
  const std::vector<output::CellField> fields = {{"proved_valid", std::span<const std::int32_t>(proved)}};
  output::write_mesh(path, made.mesh, made.x, {}, fields);
  fmt::print("written: {}\n", path.string());
}

}  // namespace

Exit make_mesh(const std::filesystem::path& path, const std::vector<std::string>& overrides,
               const MeshOptions& options)
{
  Parts parts;
  const case_file::Case description = case_file::read(path, overrides);
  if (!options.output.empty())
    output::check_mesh_path(options.output);
  if (!options.picture.empty())
    check_picture_path(options.picture, description.layout.dim);
  check_steps(description.layout, options.steps);
  block::Layout layout = description.layout;
  const int order = options.order > 0 ? options.order : layout.order;
  layout.order = order_before(layout, options.steps, order);
  parts.end("read, check");

  std::optional<block::Skeleton> of_other_order;
  if (layout.order != description.layout.order)
  {
    of_other_order = block::make_skeleton(layout);
    parts.end("edges, faces");
  }
  const block::Skeleton& skeleton = of_other_order ? *of_other_order : *description.skeleton;
  if (!options.picture.empty())
  {
    draw_blocks(options.picture, layout, skeleton,
                description.title.empty() ? description.path.filename().string() : description.title);
    parts.end("picture");
  }
  block::Connected connected = block::connect(layout, skeleton, "", Part{});
  parts.end("connect");
  std::vector<double> x = block::initial_nodes(connected, skeleton);
  parts.end("place");
  Made made = {std::move(connected.mesh), std::move(x)};
  if (!options.steps.empty())
  {
    made = convert(std::move(made), options.steps, order);
    parts.end("convert");
  }
  const mesh::Mesh& mesh = made.mesh;
  const mesh::Quality quality = mesh::measure(mesh::QualityTables(mesh), mesh, made.x);
  parts.end("quality");
  std::vector<mesh::Verdict> verdicts(mesh.cell_count());
  const mesh::Validity validity = mesh::certify(mesh::ValidityTables(mesh), mesh, made.x, verdicts);
  parts.end("certify");

  fmt::print("{} blocks, {} cells of order {} ({}), {} nodes\n", layout.blocks.size(), mesh.cell_count(),
             mesh.order, shape_counts(mesh), mesh.node_count());
  fmt::print("scaled Jacobian at least {:.3f}, angles from {:.1f} to {:.1f} degrees; worst in {}\n",
             quality.scaled_jacobian, quality.smallest_angle, quality.largest_angle,
             quality.block >= 0 ? layout.blocks[quality.block].name : std::string("no block"));
  fmt::print("proved valid: {} of {} cells\n", validity.valid, mesh.cell_count());
  if (options.sizes)
    fmt::print("{}", block::table(block::cell_sizes(skeleton)));
  if (!options.picture.empty())
    fmt::print("written: {}\n", options.picture.string());
  if (!options.output.empty())
  {
    write(options.output, made, verdicts);
    parts.end("write");
  }
  fmt::print("{}", parts.table(mesh.node_count()));
  if (validity.all_valid())
    return Exit::done;
  fmt::print(stderr, "blockfsi: cell {} of {} is not proved valid\n", validity.cell,
             layout.blocks[validity.block].name);
  return Exit::failed;
}

Exit list_cad(const std::filesystem::path& path)
{
  fmt::print("{}", geometry::describe(geometry::CadFile(path)));
  return Exit::done;
}

}  // namespace blockfsi::command
