#pragma once

#include <string>

namespace blockfsi::motion
{

/// What came of a mesh update. Whether cells are folded is not asked here: mesh/quality.hpp tells.
struct Report
{
  bool ok = true;
  std::string failure;     ///< why the mesh was not updated
  int factorisations = 0;  ///< of the equations of the mesh
};

}  // namespace blockfsi::motion
