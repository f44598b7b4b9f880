#include "output/svg.hpp"
#include "output/svg_pen.hpp"
#include "output/svg_style.hpp"

#include "element/lattice.hpp"
#include "element/shape.hpp"
#include "output/encode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace blockfsi::output
{

namespace
{

using svg::EdgeCurve;
using svg::Frame;
using svg::Pen;
using svg::Point;

constexpr double page_width = 900.0;
constexpr double gap = 12.0;
constexpr double panel_title = 22.0;
constexpr double title_height = 34.0;
constexpr double ring_radius = 14.0;

/// Control points of an edge of a cell in the units of the panel.
std::vector<Point> edge_points(const MeshLayer& layer, const Frame& frame, const EdgeCurve& curve,
                               std::size_t cell, std::span<const std::int32_t> lattice)
{
  std::vector<Point> nodes;
  for (const std::int32_t k : lattice)
  {
    const std::size_t node = layer.mesh->cell(cell)[k];
    nodes.push_back(frame(layer.x[2 * node], layer.x[2 * node + 1]));
  }
  return curve.control(nodes);
}

/// The outline of a cell as one closed path.
void trace_outline(Pen& pen, const MeshLayer& layer, const Frame& frame, const EdgeCurve& curve,
                   std::size_t cell)
{
  const element::Shape shape = layer.mesh->shape(cell);
  const auto edges = element::edges(shape);
  std::int8_t corner = edges[0][0];
  std::vector<bool> done(edges.size(), false);
  for (std::size_t turn = 0; turn < edges.size(); ++turn)
    for (std::size_t e = 0; e < edges.size(); ++e)
    {
      if (done[e] || (edges[e][0] != corner && edges[e][1] != corner))
        continue;
      std::vector<Point> control = edge_points(
          layer, frame, curve, cell, element::edge_lattice(shape, layer.mesh->order, static_cast<int>(e)));
      if (edges[e][0] != corner)
        std::reverse(control.begin(), control.end());
      if (turn == 0)
        pen.move(control.front());
      pen.trace(control);
      corner = edges[e][0] == corner ? edges[e][1] : edges[e][0];
      done[e] = true;
      break;
    }
  pen.close();
}

/// Rings about faulty cells, which may be too thin to be seen.
std::string draw_rings(const MeshLayer& layer, const Frame& frame)
{
  std::string out;
  for (const std::int32_t cell : layer.highlight)
  {
    const std::span<const std::int32_t> nodes = layer.mesh->cell(cell);
    double x = 0.0, y = 0.0;
    for (const std::int32_t node : nodes)
    {
      x += layer.x[2 * node] / static_cast<double>(nodes.size());
      y += layer.x[2 * node + 1] / static_cast<double>(nodes.size());
    }
    const Point centre = frame(x, y);
    out += fmt::format("<circle class=\"ring\" cx=\"{:.0f}\" cy=\"{:.0f}\" r=\"{:.0f}\"/>\n", centre[0],
                       centre[1], svg::units * ring_radius);
  }
  return out;
}

std::string draw_layer(const MeshLayer& layer, const Frame& frame)
{
  const mesh::Mesh& mesh = *layer.mesh;
  const EdgeCurve curve(mesh.order);
  std::string out;
  Pen faulty;
  for (const std::int32_t cell : layer.highlight)
    trace_outline(faulty, layer, frame, curve, cell);
  if (!faulty.text.empty())
    out += "<path class=\"bad\" d=\"" + faulty.text + "\"/>\n";
  Pen pen;
  std::set<std::pair<std::int32_t, std::int32_t>> drawn;
  for (std::size_t cell = 0; cell < mesh.cell_count(); ++cell)
  {
    const element::Shape shape = mesh.shape(cell);
    if (layer.is_filled)
    {
      trace_outline(pen, layer, frame, curve, cell);
      continue;
    }
    for (int e = 0; e < static_cast<int>(element::edges(shape).size()); ++e)
    {
      const std::vector<std::int32_t> lattice = element::edge_lattice(shape, mesh.order, e);
      const std::int32_t first = mesh.cell(cell)[lattice.front()];
      const std::int32_t last = mesh.cell(cell)[lattice.back()];
      if (!drawn.insert(std::minmax(first, last)).second)
        continue;
      const std::vector<Point> control = edge_points(layer, frame, curve, cell, lattice);
      if (!frame.shows(control))
        continue;
      pen.move(control.front());
      pen.trace(control);
    }
  }
  Pen outline;
  for (const auto& [name, sides] : mesh.boundaries)
    for (const mesh::Side& side : sides)
    {
      const std::vector<std::int32_t> lattice =
          element::edge_lattice(mesh.shape(side.cell), mesh.order, side.side);
      const std::vector<Point> control = edge_points(layer, frame, curve, side.cell, lattice);
      if (layer.is_filled || !frame.shows(control))
        continue;
      outline.move(control.front());
      outline.trace(control);
    }
  if (!outline.text.empty())
    out += "<path class=\"edge\" d=\"" + outline.text + "\"/>\n";
  return out + "<path class=\"" + (layer.is_filled ? "body" : "mesh") + "\" d=\"" + pen.text + "\"/>\n" +
         draw_rings(layer, frame);
}

}  // namespace

std::string draw(std::span<const Panel> panels, const Window& window, int columns, const std::string& title)
{
  const double panel_width = (page_width - (columns + 1) * gap) / columns;
  const double ratio = (window.high[1] - window.low[1]) / (window.high[0] - window.low[0]);
  const double panel_height = panel_width * ratio;
  const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  const double height = title_height + rows * (panel_title + panel_height + gap);
  const Frame frame{window, svg::units * panel_width / (window.high[0] - window.low[0])};
  std::string out =
      fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1:.0f}\" width=\"{0}\" "
                  "height=\"{1:.0f}\" role=\"img\">\n<title>{2}</title>\n",
                  page_width, height, escape_xml(title));
  out += svg::style;
  out += fmt::format("\n<rect class=\"page\" width=\"{}\" height=\"{:.0f}\"/>\n", page_width, height);
  out += fmt::format("<text class=\"title\" x=\"{}\" y=\"22\">{}</text>\n", gap, escape_xml(title));
  for (std::size_t k = 0; k < panels.size(); ++k)
  {
    const double x = gap + static_cast<double>(k % columns) * (panel_width + gap);
    const double y = title_height + static_cast<double>(k / columns) * (panel_title + panel_height + gap);
    out += fmt::format("<text class=\"small\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x, y + 15.0,
                       escape_xml(panels[k].title));
    out += fmt::format(
        "<svg x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" viewBox=\"0 0 {:.0f} {:.0f}\">\n",
        x, y + panel_title, panel_width, panel_height, frame.width(), frame.height());
    for (const MeshLayer& layer : panels[k].layers)
      out += draw_layer(layer, frame);
    out += "</svg>\n";
    out +=
        fmt::format("<rect class=\"axis\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
                    x, y + panel_title, panel_width, panel_height);
  }
  return out + "</svg>\n";
}

}  // namespace blockfsi::output
