#pragma once

#include "mesh/mesh.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace blockfsi::output
{

// Pictures as SVG: text stays text, and colours suit print, light and dark pages alike.

/// One line of a figure.
struct Curve
{
  std::string name;
  std::vector<double> x;
  std::vector<double> y;
  bool is_cut_short = false;  ///< ends with a cross: what it shows went no further
};

/// Curves over one axis.
struct Figure
{
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Curve> curves;
  bool is_logarithmic = false;  ///< the axis of y; values that are not positive are left out
  std::optional<double> y_low;  ///< else from the curves
  std::optional<double> y_high;
};

/// The figure with axes, grid and legend. Curves of very many points keep their extremes and lose the rest.
/// Values that are not finite interrupt a curve.
std::string draw(const Figure& figure);

/// A part of the plane [m].
struct Window
{
  std::array<double, 2> low{};
  std::array<double, 2> high{};
};

/// A mesh as a layer of a picture: the edges of its cells as smooth curves, once each, boundaries heavier.
struct MeshLayer
{
  const mesh::Mesh* mesh = nullptr;
  std::span<const double> x;                ///< [m], shape (node_count, 2)
  bool is_filled = false;                   ///< as bodies are, without inner edges being heavier
  std::span<const std::int32_t> highlight;  ///< cells drawn as faulty
};

/// One of several pictures side by side.
struct Panel
{
  std::string title;
  std::vector<MeshLayer> layers;
};

/// Panels in rows, all showing the same window; what lies outside of it is left out.
std::string draw(std::span<const Panel> panels, const Window& window, int columns, const std::string& title);

}  // namespace blockfsi::output
