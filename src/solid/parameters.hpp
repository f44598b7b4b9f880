#pragma once

#include "core/error.hpp"
#include "core/expression.hpp"

#include <array>
#include <string>
#include <variant>
#include <vector>

namespace blockfsi::solid
{

/// All displacements are zero.
struct Fixed
{
};

/// Prescribed displacement [m] of x, y, z, t in the directions that are not free; no traction in these.
struct Displacement
{
  std::array<Expression, 3> value;
  std::array<bool, 3> is_free = {};
};

/// Dead traction P N [Pa] per area of the undeformed body, of x, y, z, t; the default where nothing is said
/// is an error, a free boundary has traction 0.
struct Traction
{
  std::array<Expression, 3> value;
};

using Condition = std::variant<Fixed, Displacement, Traction>;

struct BoundaryCondition
{
  std::string boundary;
  Condition condition;
  Location where;
};

enum class Plane
{
  strain,
  stress
};

struct Newton
{
  double tolerance = 1e-10;  ///< size of the last increment relative to the displacement [-]
  int iterations = 25;
};

struct Parameters
{
  std::string region = "solid";
  int order = 0;            ///< of its cells; 0: that of the blocks
  double divide = 1.0;      ///< number of its cells along an edge relative to that of the blocks [-]
  double density = 1000.0;  ///< of the undeformed body [kg/m^3]
  double young = 1e6;       ///< of the St. Venant-Kirchhoff material [Pa]
  double poisson = 0.3;     ///< [-]
  Plane plane = Plane::strain;
  std::array<Expression, 3> body_force;        ///< per mass [m/s^2]
  std::array<Expression, 3> initial_velocity;  ///< [m/s]
  int load_steps = 1;                          ///< of a static solution
  std::vector<BoundaryCondition> boundaries;
  Newton newton;
};

}  // namespace blockfsi::solid
