#pragma once

#include "geometry/surface.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace blockfsi::geometry
{

/// An edge or a face of a CAD file as a list shows it.
struct CadItem
{
  int number = 0;    ///< from 1, in the order of the file
  std::string type;  ///< "line", "circle", "B-spline", "plane", "torus", ...
  Point low{};       ///< of the bounding box [m]
  Point high{};
  Point start{};  ///< of an edge [m]
  Point end{};
  double length = 0.0;  ///< of an edge [m]
};

/// A curve of a CAD file as our own NURBS, over the range that the edge has.
struct CadCurve
{
  NurbsCurve curve;
  double error = 0.0;  ///< 0 where the curve converts exactly, else how far it is off at most, by samples [m]
};

/// A surface of a CAD file as our own.
struct CadSurface
{
  NurbsSurface patch;  ///< over the rectangle of parameters that bounds the face
  Surface
      surface;  ///< for projection: the whole plane, sphere, cylinder or torus if it is one, else the patch
  double error =
      0.0;  ///< 0 where the surface converts exactly, else how far it is off at most, by samples [m]
};

/// The shapes of a STEP or an IGES file, in metres whatever the unit of the file. Cheap to copy.
class CadFile
{
public:
  /// Reads a file that ends in .step, .stp, .iges or .igs. Throws Error if there is none, if it is no such
  /// file, if it holds no shape or if this build has no CAD (CMake option BLOCKFSI_CAD).
  explicit CadFile(const std::filesystem::path& path);

  const std::vector<CadItem>& edges() const;
  const std::vector<CadItem>& faces() const;
  /// Edge or face by its number from 1; throws Error if there is none of that number or if it has no length.
  CadCurve edge(int number) const;
  CadSurface face(int number) const;

private:
  struct Shapes;
  std::shared_ptr<const Shapes> shapes_;
};

/// Whether this build reads CAD files (CMake option BLOCKFSI_CAD).
bool reads_cad();

/// Whether a file exists and is IGES by its name, else STEP; throws Error if it is missing or has another
/// ending.
bool is_iges(const std::filesystem::path& path);

/// A line for each edge with its number, type, ends and length, then one for each face with its number, type
/// and the box around it.
std::string describe(const CadFile& file);

}  // namespace blockfsi::geometry
