#pragma once

#include "block/connect.hpp"
#include "block/layout.hpp"
#include "block/topology.hpp"

namespace blockfsi::block
{

/// The layout with curves for all edges of shaped faces that have none: on the face's surface, or where those
/// of two faces meet. Throws Error, naming the edge and the face, where an end does not lie on them, where
/// the search for the curve fails, and where two surfaces meet of which one is no level set, sphere,
/// cylinder, torus or plane.
Layout with_curves_on_faces(const Layout& layout);

/// Moves the inner nodes of shaped faces from their interpolation onto their surfaces (formulation.md 2).
/// Throws Error for a node that has no place there, naming block, face, node and bracket, and for edges that
/// do not lie on the surface of their face, naming how far they are off.
void shape_faces(const Layout& layout, const Topology& topology, Skeleton& skeleton);

}  // namespace blockfsi::block
