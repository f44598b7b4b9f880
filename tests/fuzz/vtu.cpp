#include "core/error.hpp"
#include "output/mesh_file.hpp"
#include "target.hpp"

void read_input(std::string_view content)
{
  try
  {
    blockfsi::output::read_vtu(content, "input.vtu");
  }
  catch (const blockfsi::Error&)
  {
  }
}
