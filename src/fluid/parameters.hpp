#pragma once

#include "core/error.hpp"
#include "core/expression.hpp"

#include <array>
#include <string>
#include <variant>
#include <vector>

namespace blockfsi::fluid
{

/// Prescribed velocity.
struct Velocity
{
  std::array<Expression, 3> value;  ///< [m/s] of x, y, z, t
};

/// No slip on a wall at rest.
struct Wall
{
};

/// No flow through a straight boundary along an axis, no shear.
struct Slip
{
};

/// Prescribed traction h = sigma n [Pa] of x, y, z, t.
struct Traction
{
  std::array<Expression, 3> value;
};

/// Do-nothing outflow: mu du/dn - p n = -pressure n. A developed channel flow leaves undisturbed.
struct Outflow
{
  Expression pressure;  ///< [Pa]
};

using Condition = std::variant<Velocity, Wall, Slip, Traction, Outflow>;

struct BoundaryCondition
{
  std::string boundary;
  Condition condition;
  Location where;
};

/// Newton's method.
struct Newton
{
  double tolerance = 1e-8;  ///< size of the last increment relative to the solution [-]
  int iterations = 25;      ///< at most
};

struct Parameters
{
  std::string region = "fluid";
  double density = 1.0;                        ///< [kg/m^3]
  double viscosity = 1.0;                      ///< dynamic [Pa s]
  std::array<Expression, 3> body_force;        ///< per mass [m/s^2]
  std::array<Expression, 3> initial_velocity;  ///< [m/s]
  double backflow = 0.5;  ///< beta of the backflow stabilisation on Traction and Outflow [-]
  /// What stands for the step in tau_M of the stabilisation [s]; 0: the step itself. A fixed time makes the
  /// equations in space those of every step, so that results converge with the order of the time scheme.
  double stabilisation_time = 0.0;
  std::vector<BoundaryCondition> boundaries;
  Newton newton;
};

}  // namespace blockfsi::fluid
