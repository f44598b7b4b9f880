#include "solid/material.hpp"

namespace blockfsi::solid
{

Lame lame(double young, double poisson, Plane plane)
{
  const double lambda = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  const double mu = young / (2.0 * (1.0 + poisson));
  return {plane == Plane::strain ? lambda : 2.0 * lambda * mu / (lambda + 2.0 * mu), mu};
}

}  // namespace blockfsi::solid
