// The CAD reader of a build without Open CASCADE.
#ifndef BLOCKFSI_CAD

#include "core/error.hpp"
#include "geometry/cad.hpp"

#include <fmt/format.h>

namespace blockfsi::geometry
{

struct CadFile::Shapes
{
  std::vector<CadItem> none;
};

bool reads_cad()
{
  return false;
}

CadFile::CadFile(const std::filesystem::path& path)
{
  static_cast<void>(is_iges(path));
  throw Error(fmt::format("cannot read {}: this program was built without CAD; install Open CASCADE (Debian: "
                          "libocct-data-exchange-dev) and build with -DBLOCKFSI_CAD=ON, as ./dev does",
                          path.string()));
}

const std::vector<CadItem>& CadFile::edges() const
{
  return shapes_->none;
}

const std::vector<CadItem>& CadFile::faces() const
{
  return shapes_->none;
}

CadCurve CadFile::edge(int) const
{
  return {};
}

CadSurface CadFile::face(int) const
{
  return {};
}

}  // namespace blockfsi::geometry

#endif
