#include "core/error.hpp"
#include "output/mesh_file.hpp"
#include "target.hpp"

void read_input(std::string_view content)
{
  try
  {
    blockfsi::output::read_msh(content, "input.msh");
  }
  catch (const blockfsi::Error&)
  {
  }
}
