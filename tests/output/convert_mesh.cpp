// Reads a mesh with its fields and writes it in the format of another name: convert_mesh IN OUT. Exit status
// 2 and a message where the file is refused.

#include "core/error.hpp"
#include "output/mesh_file.hpp"

#include <cstdio>
#include <exception>
#include <vector>

int main(int argc, char** argv)
{
  using namespace blockfsi;
  if (argc != 3)
    return 2;
  try
  {
    const output::ReadMesh read = output::read_mesh(argv[1]);
    std::vector<output::Field> fields;
    for (const output::ReadField& field : read.fields)
      if (field.components <= 3)
        fields.push_back({field.name, field.components, field.values});
    std::vector<output::CellField> cell_fields;
    for (const output::ReadField& field : read.cell_fields)
      if (field.components == 1)
        cell_fields.push_back({field.name, std::span<const double>(field.values)});
    output::write_mesh(argv[2], read.mesh, read.x, fields, cell_fields);
  }
  catch (const Error& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
