#pragma once

#include "block/corner_graph.hpp"

#include <Eigen/Core>

namespace blockfsi::block
{

/// Constant rules: matrices G with y = G U for the unknowns y [m] of the free corners, from the displacements
/// U [m] of all corners in which those of free corners are not read; shape (unknowns, corner_count * dim).

/// Interpolation of the displacements known at corners by cubic radial functions |x - x_i|^3 and linear
/// polynomials: no parameters, linear displacements are reproduced. Where a corner slides, its component
/// across is known (zero) and that along is not; with walls along the axes the components decouple
/// (corners3d.md section 2; Duchon 1977).
Eigen::MatrixXd radial_rule(const CornerGraph& graph);

/// One solve of linear elasticity on the coarse blocks, all weighing alike save for det^(-1/4), with
/// Poisson's ratio -0.4: a material that keeps angles rather than areas (formulation.md 9.5).
Eigen::MatrixXd elastic_rule(const CornerGraph& graph);

}  // namespace blockfsi::block
