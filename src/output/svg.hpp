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

/// An edge of blocks in a picture of them.
struct BlockLine
{
  std::string name;
  int divisions = 1;
  int boundary = -1;  ///< entry of BlockPicture::boundaries; -1: between blocks
  int pieces = 1;
  /// Gauss-Lobatto nodes of order 3 of each piece, ends shared [m], shape (3 pieces + 1).
  std::vector<std::array<double, 2>> x;
  std::vector<std::array<double, 2>> cell_ends;  ///< between its ends [m]
};

/// A block by its edges, one after the other round it.
struct BlockOutline
{
  std::string name;
  int region = 0;          ///< entry of BlockPicture::regions
  std::vector<int> lines;  ///< entries of BlockPicture::lines
};

struct NamedPoint
{
  std::string name;
  std::array<double, 2> x{};  ///< [m]
};

/// The blocks of a mesh in the plane.
struct BlockPicture
{
  std::string title;
  std::vector<NamedPoint> points;
  std::vector<BlockLine> lines;
  std::vector<BlockOutline> blocks;
  std::vector<std::string> regions;
  std::vector<std::string> boundaries;
};

/// Edges with their numbers of cells and a stroke where each cell ends, points and blocks with their names,
/// regions and boundaries in colours with a legend. A name that finds no room near its place is left out;
/// every point, edge and block tells its name under the pointer.
std::string draw(const BlockPicture& picture);

}  // namespace blockfsi::output
