#pragma once

#include "block/layout.hpp"
#include "geometry/point.hpp"

#include <array>
#include <string_view>

namespace blockfsi::block
{

/// x -> matrix x + shift: an affine map of the plane or of space.
struct Affine
{
  std::array<geometry::Point, 3> matrix{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< rows
  geometry::Point shift{};                                                   ///< [m]

  geometry::Point operator()(const geometry::Point& x) const;
  /// The map without its shift, of a vector.
  geometry::Point turn(const geometry::Point& vector) const;
};

Affine translation(const geometry::Point& by);
/// Right-handed about the line through `center` along `axis` [rad]. Throws Error for an axis of length 0.
Affine rotation(const geometry::Point& center, const geometry::Point& axis, double angle);
/// At the plane (in 2D the line) through `center` across `normal`. Throws Error for a normal of length 0.
Affine reflection(const geometry::Point& center, const geometry::Point& normal);

/// The inverse map. Throws Error if there is none.
Affine inverse(const Affine& map);

/// Corners of a block in an order that a reflection makes right-handed again.
void turn_over(Block& block);
/// The curve from a to b, and what shapes a face, moved by a map.
geometry::Curve moved(const geometry::Curve& curve, const geometry::Point& a, const geometry::Point& b,
                      const Affine& map);
FaceGeometry moved(const FaceGeometry& geometry, const Affine& map);

/// A layout moved by a map. Points and blocks called "FROM ..." become "TO ...", and so do boundaries. A map
/// that reflects turns the corners of the blocks, so that none is inside out.
Layout transformed(const Layout& layout, const Affine& map, std::string_view from, std::string_view to);

/// Adds points, blocks and all that is said of them to a layout; what coincides is joined later, by `merge`.
void append(Layout& layout, const Layout& piece);

}  // namespace blockfsi::block
