#include "output/vtu.hpp"

#include "../mesh/structured.hpp"
#include "core/error.hpp"
#include "output/encode.hpp"
#include "output/file.hpp"
#include "output/series.hpp"
#include "temporary.hpp"

#include <doctest/doctest.h>

using namespace blockfsi;

namespace
{

std::string base64(std::string_view text)
{
  return output::encode_base64(std::as_bytes(std::span(text)));
}

std::array<double, 2> same(double u, double v)
{
  return {u, v};
}

}  // namespace

TEST_CASE("base64 is that of RFC 4648, section 10")
{
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foob") == "Zm9vYg==");
  CHECK(base64("fooba") == "Zm9vYmE=");
  CHECK(base64("foobar") == "Zm9vYmFy");
}

TEST_CASE("text survives as an XML attribute")
{
  const std::string text = "a < \"b\" & &amp; c>";
  CHECK(output::escape_xml(text).find_first_of("<\"") == std::string::npos);
  CHECK(output::unescape_xml(output::escape_xml(text)) == text);
}

TEST_CASE("a field that does not fit the mesh is refused")
{
  const TemporaryFolder folder;
  const SampleMesh sample = structured(2, 2, 1, same);
  const std::vector<double> values(10);
  CHECK_THROWS_WITH_AS(output::write_vtu(folder.path() / "a.vtu", sample.mesh, sample.x,
                                         std::array{output::Field{"p", 1, values}}, {}),
                       "field 'p' has 10 values, but the mesh needs 15", Error);
  CHECK_THROWS_AS(output::write_vtu(folder.path() / "a.vtu", sample.mesh, values, {}, {}), Error);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "a.vtu"));
}

TEST_CASE("a process without cells writes a piece without cells")
{
  const TemporaryFolder folder;
  mesh::Mesh none;
  none.order = 3;
  output::write_vtu(folder.path() / "a.vtu", none, {}, std::array{output::Field{"p", 1, {}}}, {});
  CHECK(output::read_file(folder.path() / "a.vtu").find("NumberOfCells=\"0\"") != std::string::npos);
}

TEST_CASE("a series can be opened after each addition and lists all snapshots with their regions")
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "fields.pvd";
  output::Series series(path);
  CHECK_FALSE(std::filesystem::exists(path));
  const std::vector<output::Snapshot> first = {{0.0, "water", "fields/water-0.vtu"},
                                               {0.0, "a \"soft\" flap", "fields/flap-0.vtu"}};
  series.add(first);
  CHECK(output::read_series(path) == first);
  const std::vector<output::Snapshot> second = {{0.1, "water", "fields/water-1.vtu"}};
  series.add(second);
  CHECK(output::read_series(path).size() == 3);
  CHECK(output::read_series(path)[2] == second[0]);
}

TEST_CASE("a resumed series forgets what lies behind the time of the restart and goes on")
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "fields.pvd";
  const auto add = [](output::Series& series, int k) {
    series.add(std::array{output::Snapshot{0.1 * k, "water", "water-" + std::to_string(k) + ".vtu"}});
  };
  {
    output::Series series(path);
    for (int k = 0; k <= 7; ++k)
      add(series, k);
  }
  output::Series series = output::Series::resume(path, 0.1 * 3);
  CHECK(series.snapshots().size() == 4);
  add(series, 4);
  const std::vector<output::Snapshot> snapshots = output::read_series(path);
  REQUIRE(snapshots.size() == 5);
  CHECK(snapshots.back().file == "water-4.vtu");
  CHECK(output::Series::resume(folder.path() / "none.pvd", 1.0).snapshots().empty());
}

TEST_CASE("a file that is no series is refused")
{
  const TemporaryFolder folder;
  const auto path = folder.path() / "fields.pvd";
  output::replace_file(path, "<VTKFile>");
  CHECK_THROWS_WITH_AS(output::Series::resume(path, 1.0), doctest::Contains("is not a series of field files"),
                       Error);
}
