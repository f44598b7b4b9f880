#include "block/connect.hpp"
#include "block/place.hpp"
#include "case/case.hpp"
#include "element/lattice.hpp"
#include "geometry/level_set.hpp"
#include "mesh/quality.hpp"
#include "mesh/validity.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <variant>
#include <vector>

using namespace blockfsi;

TEST_CASE("the aorta of a short case file is a certified mesh of order 3 whose wall lies on the level set")
{
  const std::string tubes = "blocks.tubes.aorta.";
  const case_file::Case read =
      case_file::read(std::filesystem::path(BLOCKFSI_CASES_FOLDER) / "aorta" / "case.toml",
                      {tubes + "around=1", tubes + "radial=3", tubes + "axial=0.006"});
  const block::Skeleton skeleton = block::make_skeleton(read.layout);
  const block::Connected connected = block::connect(read.layout, skeleton, "", {});
  const mesh::Mesh& mesh = connected.mesh;
  const std::vector<double> x = block::initial_nodes(connected, skeleton);
  CHECK(mesh.order == 3);
  CHECK(mesh.is_all(element::Shape::hexahedron));
  CHECK(mesh::certify(mesh::ValidityTables(mesh), mesh, x).all_valid());
  CHECK(mesh::measure(mesh::QualityTables(mesh), mesh, x).scaled_jacobian > 0.35);

  const geometry::LevelSet& wall = std::get<block::OnLevelSet>(read.layout.faces.front().geometry).level_set;
  double residual = 0.0;
  for (const mesh::Side& side : mesh.boundaries.at("aorta wall"))
  {
    const auto cell = mesh.cell(side.cell);
    const auto at = [&](int n) -> geometry::Point
    {
      const double* p = x.data() + 3 * static_cast<std::size_t>(cell[n]);
      return {p[0], p[1], p[2]};
    };
    for (const std::int32_t n : element::side_lattice(mesh.shape(side.cell), mesh.order, side.side))
    {
      const geometry::Level level = wall(at(n));
      residual =
          std::max({residual, std::abs(level.value), std::abs(level.value) / geometry::norm(level.gradient)});
    }
  }
  CHECK(residual < 1e-13);  // [m], in a vessel of 20 mm

  std::set<std::string> names;
  for (const auto& [name, sides] : mesh.boundaries)
    names.insert(name);
  CHECK(names ==
        std::set<std::string>{"aorta wall", "brachiocephalic", "carotid", "diaphragm", "root", "subclavian"});
}
