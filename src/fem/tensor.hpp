#pragma once

#include "core/lanes.hpp"
#include "fem/line_table.hpp"

#include <span>

namespace blockfsi::fem
{

/// Largest number of quadrature points and of nodes along a side of a cell: order 8 and two extra points.
inline constexpr int max_line = 11;

/// Values and derivatives of one field on the unit cell at all quadrature points, for a batch of cells;
/// each array has shape (points, points), xi fastest. Null pointers ask for nothing.
struct ReferenceValues
{
  Lanes* value = nullptr;
  Lanes* xi = nullptr;
  Lanes* eta = nullptr;
  Lanes* xi_xi = nullptr;
  Lanes* xi_eta = nullptr;
  Lanes* eta_eta = nullptr;
};

/// Evaluates a field from its nodal values, shape (nodes, nodes), xi fastest, by sum factorisation.
void interpolate(const LineTable& table, const Lanes* nodal, const ReferenceValues& out);

/// The transpose: adds to nodal residuals what the factors of a test function (value) and of its derivatives
/// (xi, eta) on the unit cell give, integrated over the points (weights are already in the factors).
void integrate(const LineTable& table, const Lanes* value, const Lanes* xi, const Lanes* eta, Lanes* nodal);

}  // namespace blockfsi::fem
