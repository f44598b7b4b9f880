#include "output/svg.hpp"
#include "output/svg_labels.hpp"
#include "output/svg_pen.hpp"
#include "output/svg_style.hpp"

#include "output/encode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace blockfsi::output
{

namespace
{

using svg::Box;
using svg::Frame;
using svg::Numbers;
using svg::Pen;
using svg::Point;
using svg::units;

constexpr int line_order = 3;
constexpr double margin = 48.0;
constexpr double title_height = 34.0;
constexpr double legend_step = 20.0;
constexpr double name_size = 12.0;
constexpr double count_size = 11.0;

/// Sizes of the drawing [pixels]: as large as a usual page, or larger where edges would be too short.
constexpr double usual_width = 840.0;
constexpr double usual_height = 900.0;
constexpr double largest_size = 1600.0;
constexpr double wanted_edge = 36.0;

/// Strokes at the ends of cells [pixels].
constexpr double stroke_length = 5.0;
constexpr double stroke_distance = 2.0;

constexpr std::string_view style =
    "<style>.between{fill:none;stroke:#444;stroke-width:1.1}.boundary{fill:none;stroke-width:2.6}"
    ".ends{fill:none;stroke:#666;stroke-width:.8}.lead{stroke:#888;stroke-width:.7}"
    ".point{fill:#222;stroke:#fff;stroke-width:1}.region{stroke:none}"
    ".r0{fill:#0072b2}.r1{fill:#d55e00}.r2{fill:#009e73}.r3{fill:#b5498d}"
    ".name,.count,.block{paint-order:stroke;stroke:#fff;stroke-width:3px;stroke-linejoin:round}"
    ".name{font-size:12px}.count{font-size:11px;fill:#555;text-anchor:middle}"
    ".block{font-size:11px;font-style:italic;fill:#0a5c8a;text-anchor:middle}"
    "@media(prefers-color-scheme:dark){.between{stroke:#aaa}.ends,.lead{stroke:#888}"
    ".point{fill:#eee;stroke:#14171a}.name,.count,.block{stroke:#14171a}"
    ".count{fill:#b0b6bc}.block{fill:#8fd3f4}}</style>\n";

/// Colours for the eye, opacities for print in grey.
std::string region_look(int region)
{
  constexpr int colours = 4;
  return fmt::format("class=\"region r{}\" fill-opacity=\"{:.2f}\"", region % colours,
                     std::min(0.1 + 0.15 * region, 0.55));
}

Window window_of(const BlockPicture& picture)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Window window{{infinity, infinity}, {-infinity, -infinity}};
  for (const BlockLine& line : picture.lines)
    for (const Point& x : line.x)
      for (int c = 0; c < 2; ++c)
      {
        window.low[c] = std::min(window.low[c], x[c]);
        window.high[c] = std::max(window.high[c], x[c]);
      }
  return window;
}

/// Pixels per metre.
double scale_of(const BlockPicture& picture, const Window& window)
{
  double shortest = std::numeric_limits<double>::infinity();
  for (const BlockLine& line : picture.lines)
    shortest = std::min(
        shortest, std::hypot(line.x.back()[0] - line.x.front()[0], line.x.back()[1] - line.x.front()[1]));
  const double width = window.high[0] - window.low[0];
  const double height = window.high[1] - window.low[1];
  const double usual = std::min(usual_width / width, usual_height / height);
  const double largest = largest_size / std::max(width, height);
  return std::clamp(wanted_edge / shortest, usual, std::max(usual, largest));
}

/// The picture while it is made.
class Drawing
{
public:
  explicit Drawing(const BlockPicture& picture)
      : picture_(picture), window_(window_of(picture)),
        scale_(scale_of(picture, window_)), frame_{window_, units * scale_}, room_(width(), drawing_height())
  {
    const svg::EdgeCurve curve(line_order);
    for (const BlockLine& line : picture.lines)
    {
      std::vector<Point> control;
      for (int piece = 0; piece < line.pieces; ++piece)
      {
        std::vector<Point> nodes;
        for (int i = 0; i <= line_order; ++i)
          nodes.push_back(on_page(line.x[piece * line_order + i]));
        const std::vector<Point> of_piece = curve.control(nodes);
        control.insert(control.end(), of_piece.begin() + (piece > 0 ? 1 : 0), of_piece.end());
      }
      controls_.push_back(std::move(control));
    }
  }

  std::string text()
  {
    std::string drawn = regions() + cell_ends();
    // One after the other: each takes the room that those before have left.
    drawn += lines();
    drawn += points();
    drawn += counts();
    drawn += block_names();
    const std::string below = legend();
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" role=\"img\">\n<title>{2}</title>\n",
        width(), legend_bottom_, escape_xml(picture_.title));
    out += svg::style;
    out += "\n";
    out += style;
    out +=
        fmt::format("<rect class=\"page\" width=\"{:.0f}\" height=\"{:.0f}\"/>\n", width(), legend_bottom_);
    out += fmt::format("<text class=\"title\" x=\"12\" y=\"22\">{}</text>\n", escape_xml(picture_.title));
    return out + drawn + below + "</svg>\n";
  }

private:
  double width() const
  {
    return std::max(frame_.width() / units + 2.0 * margin, 24.0 + svg::text_width(picture_.title, 15.0));
  }
  double drawing_height() const { return title_height + frame_.height() / units + 2.0 * margin; }

  /// A place on the page in units.
  Point on_page(const Point& x) const
  {
    const Point at = frame_(x[0], x[1]);
    return {at[0] + units * margin, at[1] + units * (title_height + margin)};
  }
  Point in_pixels(const Point& x) const
  {
    const Point at = on_page(x);
    return {at[0] / units, at[1] / units};
  }

  static std::string path(std::string_view attributes, const std::string& data, const std::string& name)
  {
    return fmt::format("<path {} d=\"{}\"><title>{}</title></path>\n", attributes, data, escape_xml(name));
  }

  std::string regions()
  {
    std::string out;
    for (const BlockOutline& block : picture_.blocks)
    {
      Pen pen(Numbers::in_pixels);
      Point end{};
      for (std::size_t k = 0; k < block.lines.size(); ++k)
      {
        std::vector<Point> control = controls_[block.lines[k]];
        const std::vector<Point>& next = controls_[block.lines[(k + 1) % block.lines.size()]];
        const bool turned =
            k == 0 ? control.back() != next.front() && control.back() != next.back() : control.front() != end;
        if (turned)
          std::reverse(control.begin(), control.end());
        if (k == 0)
          pen.move(control.front());
        pen.trace(control);
        end = control.back();
      }
      pen.close();
      out +=
          path(region_look(block.region), pen.text, block.name + " (" + picture_.regions[block.region] + ")");
    }
    return out;
  }

  /// Strokes across the edges, left out where they would run together.
  std::string cell_ends() const
  {
    Pen pen(Numbers::in_pixels);
    for (const BlockLine& line : picture_.lines)
    {
      std::vector<Point> at = {on_page(line.x.front())};
      for (const Point& x : line.cell_ends)
        at.push_back(on_page(x));
      at.push_back(on_page(line.x.back()));
      Point last = at.front();
      for (std::size_t k = 1; k + 1 < at.size(); ++k)
      {
        const Point along = {at[k + 1][0] - at[k - 1][0], at[k + 1][1] - at[k - 1][1]};
        const double length = std::hypot(along[0], along[1]);
        if (length == 0.0 || std::hypot(at[k][0] - last[0], at[k][1] - last[1]) < units * stroke_distance)
          continue;
        const double half = 0.5 * units * stroke_length / length;
        pen.move({at[k][0] - half * along[1], at[k][1] + half * along[0]});
        pen.line({at[k][0] + half * along[1], at[k][1] - half * along[0]});
        last = at[k];
      }
    }
    return pen.text.empty() ? "" : "<path class=\"ends\" d=\"" + pen.text + "\"/>\n";
  }

  /// The point at a share of the pieces of a line, in pixels.
  Point along(std::size_t line, double share) const
  {
    const std::vector<Point>& control = controls_[line];
    const double position = share * picture_.lines[line].pieces;
    const int piece = std::min(static_cast<int>(position), picture_.lines[line].pieces - 1);
    const double t = position - piece;
    const std::array<double, 4> b = {(1 - t) * (1 - t) * (1 - t), 3 * t * (1 - t) * (1 - t),
                                     3 * t * t * (1 - t), t * t * t};
    Point result{};
    for (int k = 0; k < 4; ++k)
      for (int c = 0; c < 2; ++c)
        result[c] += b[k] * control[3 * piece + k][c] / units;
    return result;
  }

  std::string lines()
  {
    std::string between;
    std::string boundaries;
    for (std::size_t k = 0; k < picture_.lines.size(); ++k)
    {
      const BlockLine& line = picture_.lines[k];
      Pen pen(Numbers::in_pixels);
      pen.move(controls_[k].front());
      pen.trace(controls_[k]);
      const std::string name =
          fmt::format("{}: {} {}", line.name, line.divisions, line.divisions == 1 ? "cell" : "cells");
      if (line.boundary < 0)
        between += path("class=\"between\"", pen.text, name);
      else
        boundaries += path(fmt::format("class=\"boundary c{}\"", line.boundary % svg::colour_count), pen.text,
                           name + ", " + picture_.boundaries[line.boundary]);
      const Point first = along(k, 0.0);
      const Point last = along(k, 1.0);
      const int samples = 4 + static_cast<int>(std::hypot(last[0] - first[0], last[1] - first[1]));
      for (int s = 0; s <= samples; ++s)
      {
        const Point at = along(k, static_cast<double>(s) / samples);
        room_.add_line_point(at[0], at[1]);
      }
    }
    return between + boundaries;
  }

  std::string points()
  {
    for (const NamedPoint& point : picture_.points)
    {
      const Point at = in_pixels(point.x);
      room_.block({at[0] - 3.0, at[1] - 3.0, 6.0, 6.0});
    }
    std::string dots;
    std::string names;
    for (const NamedPoint& point : picture_.points)
    {
      const Point at = in_pixels(point.x);
      const std::string name = escape_xml(point.name);
      dots += fmt::format(
          "<circle class=\"point\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"><title>{}</title></circle>\n", at[0],
          at[1], name);
      const std::optional<Box> box =
          room_.place_near(at[0], at[1], svg::text_width(point.name, name_size), name_size);
      if (!box)
        continue;
      // A line to names that stand apart.
      const Point nearest = {std::clamp(at[0], box->x, box->x + box->width),
                             std::clamp(at[1], box->y, box->y + box->height)};
      if (std::hypot(nearest[0] - at[0], nearest[1] - at[1]) > 14.0)
        names +=
            fmt::format("<line class=\"lead\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n",
                        at[0], at[1], nearest[0], nearest[1]);
      names += fmt::format("<text class=\"name\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", box->x,
                           box->y + 0.85 * box->height, name);
    }
    return dots + names;
  }

  /// On the edges, near their middles.
  std::string counts()
  {
    std::string out;
    for (std::size_t k = 0; k < picture_.lines.size(); ++k)
    {
      const std::string count = fmt::format("{}", picture_.lines[k].divisions);
      const double wide = svg::text_width(count, count_size);
      for (const double share : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8})
      {
        const Point at = along(k, share);
        const Box box{at[0] - 0.5 * wide, at[1] - 0.5 * count_size, wide, count_size};
        if (!room_.cost(box))
          continue;
        room_.block(box);
        out += fmt::format("<text class=\"count\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", at[0],
                           at[1] + 0.35 * count_size, count);
        break;
      }
    }
    return out;
  }

  /// Where they fit into their blocks.
  std::string block_names()
  {
    std::string out;
    for (const BlockOutline& block : picture_.blocks)
    {
      Point middle{};
      for (const int line : block.lines)
        for (int c = 0; c < 2; ++c)
          middle[c] += along(line, 0.5)[c] / static_cast<double>(block.lines.size());
      const double wide = svg::text_width(block.name, count_size);
      const Box box{middle[0] - 0.5 * wide, middle[1] - 0.5 * count_size, wide, count_size};
      if (room_.cost(box) != 0)
        continue;
      room_.block(box);
      out += fmt::format("<text class=\"block\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", middle[0],
                         middle[1] + 0.35 * count_size, escape_xml(block.name));
    }
    return out;
  }

  /// One entry of the legend with a sample 28 pixels wide.
  std::string entry(const std::string& name, const auto& sample)
  {
    const double wide = 28.0 + 8.0 + svg::text_width(name, name_size) + 20.0;
    if (legend_x_ > 12.0 && legend_x_ + wide > width())
    {
      legend_x_ = 12.0;
      legend_y_ += legend_step;
    }
    const std::string out = sample(legend_x_, legend_y_) +
                            fmt::format("<text class=\"small\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                                        legend_x_ + 36.0, legend_y_ + 4.0, escape_xml(name));
    legend_x_ += wide;
    return out;
  }

  std::string legend()
  {
    legend_y_ = drawing_height();
    std::string out;
    for (std::size_t k = 0; k < picture_.regions.size(); ++k)
      out += entry(picture_.regions[k],
                   [k](double x, double y)
                   {
                     return fmt::format("<rect {} x=\"{:.1f}\" y=\"{:.1f}\" width=\"28\" height=\"12\"/>",
                                        region_look(static_cast<int>(k)), x, y - 6.0);
                   });
    for (std::size_t k = 0; k < picture_.boundaries.size(); ++k)
      out += entry(picture_.boundaries[k],
                   [k](double x, double y)
                   {
                     return fmt::format("<path class=\"boundary c{}\" d=\"M{:.1f} {:.1f}h28\"/>",
                                        k % svg::colour_count, x, y);
                   });
    legend_bottom_ = legend_y_ + legend_step;
    return out;
  }

  const BlockPicture& picture_;
  Window window_;
  double scale_;
  Frame frame_;
  svg::Room room_;
  std::vector<std::vector<Point>> controls_;  ///< of the lines, on the page in units
  double legend_x_ = 12.0;
  double legend_y_ = 0.0;
  double legend_bottom_ = 0.0;
};

}  // namespace

std::string draw(const BlockPicture& picture)
{
  return Drawing(picture).text();
}

}  // namespace blockfsi::output
