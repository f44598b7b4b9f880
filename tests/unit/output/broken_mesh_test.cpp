#include "core/error.hpp"
#include "output/file.hpp"
#include "output/mesh_file.hpp"
#include "output/msh.hpp"
#include "output/vtu.hpp"
#include "sample_cells.hpp"
#include "temporary.hpp"

#include <doctest/doctest.h>

#include <string>
#include <string_view>

using namespace blockfsi;

namespace
{

std::string vtu(std::string_view points, std::string_view connectivity, std::string_view types,
                std::string_view head = "type=\"UnstructuredGrid\" version=\"2.2\"")
{
  return "<VTKFile " + std::string(head) +
         "><UnstructuredGrid>\n<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\">\n"
         "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">" +
         std::string(points) +
         "</DataArray></Points>\n<Cells>\n<DataArray type=\"Int32\" Name=\"connectivity\">" +
         std::string(connectivity) +
         "</DataArray>\n<DataArray type=\"Int32\" Name=\"offsets\">4</DataArray>\n"
         "<DataArray type=\"UInt8\" Name=\"types\">" +
         std::string(types) + "</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>";
}

constexpr std::string_view square = "0 0 0 1 0 0 1 1 0 0 1 0";

std::string msh(std::string_view nodes, std::string_view elements, std::string_view version = "4.1 0 8")
{
  return "$MeshFormat\n" + std::string(version) + "\n$EndMeshFormat\n$Nodes\n" + std::string(nodes) +
         "\n$EndNodes\n$Elements\n" + std::string(elements) + "\n$EndElements\n";
}

constexpr std::string_view square_nodes = "1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0";
constexpr std::string_view square_element = "1 1 1 1\n2 1 3 1\n1 1 2 3 4";

std::string complaint(const std::string& content, bool is_msh)
{
  try
  {
    if (is_msh)
      output::read_msh(content, "a.msh");
    else
      output::read_vtu(content, "a.vtu");
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "accepted";
}

}  // namespace

#define CHECK_VTU(content, text) CHECK(complaint(content, false).find(text) != std::string::npos)
#define CHECK_MSH(content, text) CHECK(complaint(content, true).find(text) != std::string::npos)

TEST_CASE("a small VTU file as text is read")
{
  const output::ReadMesh read = output::read_vtu(vtu(square, "0 1 2 3", "9"), "a.vtu");
  CHECK(read.mesh.cells == std::vector<std::int32_t>{0, 1, 3, 2});
  CHECK(read.x == std::vector<double>{0, 0, 1, 0, 1, 1, 0, 1});
}

TEST_CASE("a broken VTU file is refused with the place")
{
  CHECK_VTU("", "a.vtu:1:");
  CHECK_VTU("garbage", "a.vtu:1:1: this is no XML file");
  CHECK_VTU("<!DOCTYPE a [<!ENTITY b \"c\">]><VTKFile/>", "document type declaration is not allowed");
  CHECK_VTU("<VTKFile type=\"PolyData\"/>", "not a VTK file of an unstructured grid");
  CHECK_VTU(vtu(square, "0 1 2 3", "9", "type=\"UnstructuredGrid\" version=\"7.0\""), "version 7.0");
  CHECK_VTU(vtu(square, "0 1 2 3", "9", "type=\"UnstructuredGrid\" byte_order=\"BigEndian\""), "BigEndian");
  CHECK_VTU(vtu(square, "0 1 2 3", "9", "type=\"UnstructuredGrid\" compressor=\"vtkLZ4DataCompressor\""),
            "vtkLZ4DataCompressor");
  CHECK_VTU(vtu("0 0 0 1 0 0", "0 1 2 3", "9"), "6 values instead of 12");
  CHECK_VTU(vtu("0 0 0 1 0 0 1 x 0 0 1 0", "0 1 2 3", "9"), "'x' is not a number");
  CHECK_VTU(vtu("0 0 0 1 0 0 1 nan 0 0 1 0", "0 1 2 3", "9"), "point 2 has the coordinate nan");
  CHECK_VTU(vtu("0 0 0 1 0 0 1 1 0.1 0 1 0", "0 1 2 3", "9"), "plane z = 0");
  CHECK_VTU(vtu(square, "0 1 2 4", "9"), "cell 0 has the node 4, but there are 4 points");
  CHECK_VTU(vtu(square, "0 1 2 -1", "9"), "cell 0 has the node -1");
  CHECK_VTU(vtu(square, "0 1 2 2", "9"), "cell 0 has the node 2 twice");
  CHECK_VTU(vtu(square, "0 1 2", "9"), "3 values instead of 4");
  CHECK_VTU(vtu(square, "0 1 2 3", "5"), "cannot have 4 nodes");
  CHECK_VTU(vtu(square, "0 1 2 3", "42"), "VTK type 42");
}

TEST_CASE("a VTU file that is cut off anywhere is refused")
{
  const TemporaryFolder folder;
  const CellSample sample = mixed_sample(3, 2);
  output::write_mesh(folder.path() / "a.vtu", sample.mesh, sample.x);
  const std::string whole = output::read_file(folder.path() / "a.vtu");
  for (std::size_t length = 0; length + 10 < whole.size(); length += 37)
    CHECK_VTU(whole.substr(0, length), "a.vtu");
}

TEST_CASE("a VTU file that unpacks to more than it can hold is refused before memory is taken")
{
  const std::string file =
      "<VTKFile type=\"UnstructuredGrid\" version=\"2.2\" header_type=\"UInt64\" "
      "compressor=\"vtkZLibDataCompressor\"><UnstructuredGrid><Piece NumberOfPoints=\"1000000000\" "
      "NumberOfCells=\"1\"><Points><DataArray type=\"Float64\" format=\"binary\">";
  // One block of 2^37 bytes.
  CHECK_VTU(file +
                "AQAAAAAAAAAAAAAAIAAAAAAAAAAAAAAA</DataArray></Points></Piece></UnstructuredGrid></VTKFile>",
            "a hundred times the size of the file");
}

TEST_CASE("a small Gmsh file as text is read")
{
  const output::ReadMesh read = output::read_msh(msh(square_nodes, square_element), "a.msh");
  CHECK(read.mesh.cells == std::vector<std::int32_t>{0, 1, 3, 2});
  CHECK(read.mesh.block_names == std::vector<std::string>{"surface 1"});
}

TEST_CASE("a broken Gmsh file is refused with the place")
{
  CHECK_MSH("", "a.msh:1: a .msh file begins with $MeshFormat");
  CHECK_MSH("garbage", "a section such as $Nodes must begin here");
  CHECK_MSH(msh(square_nodes, square_element, "2.2 0 8"), "a.msh:2: section $MeshFormat: version 2.2");
  CHECK_MSH(msh(square_nodes, square_element, "4.1 0 4"), "the bytes of a number");
  CHECK_MSH(msh(square_nodes, "1 1 1 1\n2 1 3 1\n1 1 2 3 3"), "node 2 twice");
  CHECK_MSH(msh(square_nodes, "1 1 1 1\n2 1 3 1\n1 1 2 3 5"), "element 1 has the node 5, which there is not");
  CHECK_MSH(msh(square_nodes, "1 1 1 1\n2 1 16 1\n1 1 2 3 4"), "Gmsh's type 16");
  CHECK_MSH(msh(square_nodes, "1 1 1 1\n3 1 3 1\n1 1 2 3 4"), "its entity has 3 dimensions");
  CHECK_MSH(msh(square_nodes, "1 2 1 2\n2 1 3 1\n1 1 2 3 4"), "1 elements instead of 2");
  CHECK_MSH(msh(square_nodes, "1 1000000000000 1 1\n2 1 3 1\n1 1 2 3 4"),
            "1000000000000 entries must follow");
  CHECK_MSH(msh("1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 nan 0\n0 1 0", square_element),
            "coordinate nan");
  CHECK_MSH(msh("1 4 1 4\n2 1 0 4\n1\n2\n3\n3\n0 0 0\n1 0 0\n1 1 0\n0 1 0", square_element),
            "node 3 is there twice");
  CHECK_MSH(msh("1 99999999999999999999 1 4", square_element), "is no integer of the range");
}

TEST_CASE("a Gmsh file that is cut off anywhere is refused")
{
  const TemporaryFolder folder;
  CellSample sample = mixed_sample(3, 2);
  sample.mesh.block_names = {"first", "second"};
  sample.mesh.boundaries.clear();
  for (const auto encoding : {output::MshEncoding::binary, output::MshEncoding::text})
  {
    output::write_msh(folder.path() / "a.msh", sample.mesh, sample.x, {}, {}, encoding);
    const std::string whole = output::read_file(folder.path() / "a.msh");
    for (std::size_t length = 0; length + 13 < whole.size(); length += 37)
      CHECK_MSH(whole.substr(0, length), "a.msh");
  }
}

TEST_CASE("files of other endings and names that a format cannot hold are refused")
{
  const TemporaryFolder folder;
  CellSample sample = mixed_sample(2, 1);
  CHECK_THROWS_WITH_AS(output::write_mesh(folder.path() / "a.stl", sample.mesh, sample.x),
                       doctest::Contains("must end in .vtu"), Error);
  CHECK_THROWS_WITH_AS(output::read_mesh(folder.path() / "a.stl"), doctest::Contains("must end in .vtu"),
                       Error);
  CHECK_THROWS_WITH_AS(output::write_mesh(folder.path() / "a.msh", sample.mesh, sample.x),
                       doctest::Contains("has a quote or line break"), Error);
}
