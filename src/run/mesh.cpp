#include "run/mesh.hpp"

#include "block/cell_sizes.hpp"
#include "block/connect.hpp"
#include "block/place.hpp"
#include "linalg/communicator.hpp"
#include "mesh/quality.hpp"
#include "mesh/validity.hpp"
#include "output/vtu.hpp"

#include <fmt/format.h>

#include <chrono>
#include <vector>

namespace blockfsi::run
{

Exit make_mesh(const case_file::Case& description, const std::filesystem::path& output, bool sizes)
{
  if (linalg::part().size > 1)
    throw Error("blockfsi mesh works with one process; leave out mpirun");
  const auto start = std::chrono::steady_clock::now();
  const block::Skeleton skeleton = block::make_skeleton(description.layout);
  const block::Connected connected = block::connect(description.layout, skeleton, "", Part{});
  const mesh::Mesh& mesh = connected.mesh;
  const std::vector<double> x = block::initial_nodes(connected, skeleton);
  const std::chrono::duration<double> made = std::chrono::steady_clock::now() - start;

  const mesh::Quality quality = mesh::measure(mesh::QualityTables(mesh), mesh, x);
  std::vector<mesh::Verdict> verdicts(mesh.cell_count());
  const mesh::Validity validity = mesh::certify(mesh::ValidityTables(mesh), mesh, x, verdicts);
  fmt::print("{} blocks, {} cells of order {}, {} nodes, made in {:.3f} s\n",
             description.layout.blocks.size(), mesh.cell_count(), mesh.order, mesh.node_count(),
             made.count());
  fmt::print("scaled Jacobian at least {:.3f}, angles from {:.1f} to {:.1f} degrees; worst in {}\n",
             quality.scaled_jacobian, quality.smallest_angle, quality.largest_angle,
             quality.block >= 0 ? description.layout.blocks[quality.block].name : std::string("no block"));
  fmt::print("proved valid: {} of {} cells\n", validity.valid, mesh.cell_count());
  if (sizes)
    fmt::print("{}", block::table(block::cell_sizes(skeleton)));
  if (!output.empty())
  {
    std::vector<std::int32_t> proved;
    proved.reserve(verdicts.size());
    for (const mesh::Verdict verdict : verdicts)
      proved.push_back(verdict == mesh::Verdict::valid ? 1 : 0);
    const std::vector<output::CellField> cells = {{"block", std::span(mesh.cell_block)},
                                                  {"proved_valid", std::span<const std::int32_t>(proved)}};
    output::write_vtu(output, mesh, x, {}, cells);
    fmt::print("written: {}\n", output.string());
  }
  if (validity.all_valid())
    return Exit::done;
  fmt::print(stderr, "blockfsi: cell {} of {} is not proved valid\n", validity.cell,
             description.layout.blocks[validity.block].name);
  return Exit::failed;
}

}  // namespace blockfsi::run
