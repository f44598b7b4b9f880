#include "output/svg.hpp"
#include "output/svg_style.hpp"

#include "element/lattice.hpp"
#include "element/line.hpp"
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

constexpr double page_width = 900.0;
constexpr double gap = 12.0;
constexpr double panel_title = 22.0;
constexpr double title_height = 34.0;
/// Units of the coordinates in a panel per pixel of the page: whole numbers are then fine enough.
constexpr double units = 10.0;

using Point = std::array<double, 2>;

/// Cubic Bezier pieces of a polynomial edge: exact up to order 3, above that Hermite interpolation of two or
/// three pieces.
class EdgeCurve
{
public:
  explicit EdgeCurve(int order) : pieces_((order + 2) / 3), nodes_(order + 1)
  {
    std::vector<double> ends;
    for (int k = 0; k <= pieces_; ++k)
      ends.push_back(static_cast<double>(k) / pieces_);
    table_ = element::lagrange(element::lobatto(order), ends);
  }

  int pieces() const { return pieces_; }

  /// The 3 pieces + 1 control points of an edge with these nodes.
  std::vector<Point> control(std::span<const Point> nodes) const
  {
    std::vector<Point> result(3 * pieces_ + 1);
    for (int k = 0; k <= pieces_; ++k)
    {
      Point at{};
      Point slope{};
      for (int i = 0; i < nodes_; ++i)
        for (int c = 0; c < 2; ++c)
        {
          at[c] += table_.value[k * nodes_ + i] * nodes[i][c];
          slope[c] += table_.first[k * nodes_ + i] * nodes[i][c] / (3.0 * pieces_);
        }
      result[3 * k] = at;
      if (k > 0)
        result[3 * k - 1] = {at[0] - slope[0], at[1] - slope[1]};
      if (k < pieces_)
        result[3 * k + 1] = {at[0] + slope[0], at[1] + slope[1]};
    }
    return result;
  }

private:
  int pieces_;
  int nodes_;
  element::Table table_;
};

/// From the plane to the units of a panel, y downwards.
struct Frame
{
  Window window;
  double scale = 1.0;

  Point operator()(double x, double y) const
  {
    return {(x - window.low[0]) * scale, (window.high[1] - y) * scale};
  }
  double width() const { return (window.high[0] - window.low[0]) * scale; }
  double height() const { return (window.high[1] - window.low[1]) * scale; }

  /// Whether the box around some points meets the panel.
  bool shows(std::span<const Point> points) const
  {
    Point low = points[0];
    Point high = points[0];
    for (const Point& point : points)
      for (int c = 0; c < 2; ++c)
      {
        low[c] = std::min(low[c], point[c]);
        high[c] = std::max(high[c], point[c]);
      }
    return high[0] >= 0.0 && low[0] <= width() && high[1] >= 0.0 && low[1] <= height();
  }
};

/// Writes paths in whole numbers, relative to where the pen is, which keeps files small.
class Pen
{
public:
  void move(const Point& to)
  {
    const std::array<long, 2> next = whole(to);
    text += fmt::format("M{} {}", next[0], next[1]);
    at_ = next;
  }
  void line(const Point& to)
  {
    const std::array<long, 2> next = whole(to);
    text += "l" + step(next);
    at_ = next;
  }
  void curve(const Point& a, const Point& b, const Point& to)
  {
    const std::array<long, 2> next = whole(to);
    text += "c" + step(whole(a)) + separated(step(whole(b))) + separated(step(next));
    at_ = next;
  }

  std::string text;

private:
  static std::array<long, 2> whole(const Point& point)
  {
    return {std::lround(point[0]), std::lround(point[1])};
  }
  static std::string separated(const std::string& number) { return (number[0] == '-' ? "" : " ") + number; }
  std::string step(const std::array<long, 2>& to) const
  {
    return fmt::format("{}", to[0] - at_[0]) + separated(fmt::format("{}", to[1] - at_[1]));
  }

  std::array<long, 2> at_{};
};

/// Whether the control points of a piece lie within a unit of its chord: then a line looks the same.
bool is_straight(std::span<const Point> p)
{
  const Point chord = {p[3][0] - p[0][0], p[3][1] - p[0][1]};
  const double length = std::hypot(chord[0], chord[1]);
  for (int k = 1; k <= 2; ++k)
  {
    const double off = chord[0] * (p[k][1] - p[0][1]) - chord[1] * (p[k][0] - p[0][0]);
    if (std::abs(off) > 0.7 * length)
      return false;
  }
  return true;
}

void trace(Pen& pen, std::span<const Point> control)
{
  for (std::size_t k = 0; k + 3 < control.size(); k += 3)
  {
    const std::span<const Point> piece = control.subspan(k, 4);
    if (is_straight(piece))
      pen.line(piece[3]);
    else
      pen.curve(piece[1], piece[2], piece[3]);
  }
}

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
      trace(pen, control);
      corner = edges[e][0] == corner ? edges[e][1] : edges[e][0];
      done[e] = true;
      break;
    }
  pen.text += "z";
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
      trace(pen, control);
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
      trace(outline, control);
    }
  if (!outline.text.empty())
    out += "<path class=\"edge\" d=\"" + outline.text + "\"/>\n";
  return out + "<path class=\"" + (layer.is_filled ? "body" : "mesh") + "\" d=\"" + pen.text + "\"/>\n";
}

}  // namespace

std::string draw(std::span<const Panel> panels, const Window& window, int columns, const std::string& title)
{
  const double panel_width = (page_width - (columns + 1) * gap) / columns;
  const double ratio = (window.high[1] - window.low[1]) / (window.high[0] - window.low[0]);
  const double panel_height = panel_width * ratio;
  const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  const double height = title_height + rows * (panel_title + panel_height + gap);
  const Frame frame{window, units * panel_width / (window.high[0] - window.low[0])};
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
