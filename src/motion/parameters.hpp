#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

namespace blockfsi::motion
{

/// The mesh is generated anew from its blocks; what their corners do belongs to the blocks.
struct Regeneration
{
};

/// A function of a distance d that falls from `weight` to nothing: weight ((d + length) / length)^-exponent.
/// Near d = 0 the material of the mesh is stiff, so that the cells there move along without deforming.
struct Falloff
{
  double weight = 0.0;    ///< at distance 0; 0 leaves it out [-]
  double length = 1.0;    ///< [m]
  double exponent = 2.0;  ///< [-]
};

/// How stiff the mesh is from place to place: (base + near the interface + near points) J^-jacobian, with J
/// the Jacobian of the map from the unit cell [m^2]. The first three are the forms of Fig. 7 in Fries &
/// Schussnig, distances in the first mesh; the last is due to Tezduyar et al. 1992 and Stein, Tezduyar &
/// Benney 2003: small cells are stiff. Only ratios matter.
struct Stiffness
{
  double base = 1.0;
  Falloff interface;
  Falloff points;
  std::vector<std::array<double, 3>> at;  ///< the points [m]
  double jacobian = 1.0;
};

/// The mesh from which the displacement is counted.
enum class From
{
  first,  ///< total: the mesh depends on the present interface alone, the matrix stays
  last    ///< incremental: from the last accepted mesh, with a new matrix in every step
};

/// The mesh as a linear elastic body.
struct PseudoSolid
{
  Stiffness stiffness;
  double poisson = 0.3;  ///< [-], in plane strain
  From from = From::first;
  std::vector<std::string> slide;  ///< straight boundaries along an axis on which nodes may slide
};

/// div (stiffness grad u) = 0 for each component of the displacement u.
struct Harmonic
{
  Stiffness stiffness;
  From from = From::first;
  std::vector<std::string> slide;
};

/// What the biharmonic displacement's normal derivative is at the interface.
enum class Slope
{
  turned,  ///< of a mesh that turns with the interface and keeps its thickness: rigid motions are reproduced
  zero     ///< the mesh keeps its direction
};

/// Laplacian of Laplacian of u = 0 for each component of the displacement u; its normal derivative is
/// prescribed too: zero on outer boundaries, `slope` at the interface.
struct Biharmonic
{
  Slope slope = Slope::turned;
  std::vector<std::string> slide;
};

/// How the fluid mesh follows the interface.
using Parameters = std::variant<Regeneration, PseudoSolid, Harmonic, Biharmonic>;

/// Boundaries on which nodes slide; none where the mesh is regenerated.
inline std::vector<std::string> sliding(const Parameters& parameters)
{
  return std::visit(
      [](const auto& kind) -> std::vector<std::string>
      {
        if constexpr (requires { kind.slide; })
          return kind.slide;
        else
          return {};
      },
      parameters);
}

}  // namespace blockfsi::motion
