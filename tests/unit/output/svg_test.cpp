#include "output/svg.hpp"

#include "../mesh/structured.hpp"
#include "element/line.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stack>
#include <string>
#include <vector>

using namespace blockfsi;

namespace
{

std::size_t count(const std::string& text, const std::string& what)
{
  std::size_t number = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + what.size()))
    ++number;
  return number;
}

/// Whether all elements are closed in order and no reserved character stands alone. Enough for what we write:
/// no comments, no CDATA.
bool is_well_formed(const std::string& text)
{
  std::stack<std::string> open;
  for (std::size_t at = 0; at < text.size(); ++at)
  {
    if (text[at] == '&')
    {
      const std::size_t end = text.find(';', at);
      const std::string entity = text.substr(at, end - at + 1);
      if (entity != "&amp;" && entity != "&lt;" && entity != "&gt;" && entity != "&quot;")
        return false;
    }
    if (text[at] != '<')
      continue;
    const std::size_t end = text.find('>', at);
    const std::string tag = text.substr(at + 1, end - at - 1);
    if (end == std::string::npos || std::count(tag.begin(), tag.end(), '"') % 2 != 0)
      return false;
    if (tag[0] == '/')
    {
      if (open.empty() || open.top() != tag.substr(1))
        return false;
      open.pop();
    }
    else if (tag.back() != '/')
      open.push(tag.substr(0, tag.find(' ')));
    at = end;
  }
  return open.empty();
}

output::Figure sample_figure()
{
  output::Figure figure;
  figure.title = "a < b & c";
  figure.x_label = "time [s]";
  figure.y_label = "\"quality\"";
  figure.curves = {{"first", {0.0, 1.0, 2.0}, {0.5, 0.25, 0.75}, false},
                   {"second", {0.0, 1.0}, {0.5, 0.1}, true}};
  return figure;
}

}  // namespace

TEST_CASE("a figure is well-formed, says what it shows and suits a dark page")
{
  const std::string text = output::draw(sample_figure());
  CHECK(is_well_formed(text));
  CHECK(text.find("<title>a &lt; b &amp; c</title>") != std::string::npos);
  CHECK(text.find(">time [s]</text>") != std::string::npos);
  CHECK(text.find(">&quot;quality&quot;</text>") != std::string::npos);
  CHECK(text.find(">first</text>") != std::string::npos);
  CHECK(text.find("prefers-color-scheme:dark") != std::string::npos);
  // A line and a legend for each curve, and a cross for the one that was cut short.
  CHECK(count(text, "class=\"line c0\"") == 2);
  CHECK(count(text, "class=\"line c1\"") == 2);
  CHECK(count(text, "class=\"end c1\"") == 1);
  CHECK(count(text, "class=\"end c0\"") == 0);
}

TEST_CASE("values that are not finite interrupt a curve, a figure without values is still one")
{
  output::Figure figure = sample_figure();
  figure.curves = {{"gap",
                    {0.0, 1.0, 2.0, 3.0, 4.0},
                    {0.5, 0.6, std::numeric_limits<double>::quiet_NaN(), 0.6, 0.5},
                    false}};
  const std::string text = output::draw(figure);
  CHECK(text.find("nan") == std::string::npos);
  const std::size_t line = text.find("class=\"line c0\" clip-path");
  const std::string path = text.substr(line, text.find("/>", line) - line);
  CHECK(count(path, "M") == 2);
  CHECK(count(path, "L") == 2);
  figure.curves = {{"empty", {}, {}, true}};
  CHECK(is_well_formed(output::draw(figure)));
  CHECK(output::draw(figure).find("inf") == std::string::npos);
  figure.is_logarithmic = true;
  figure.curves = {{"negative", {0.0, 1.0}, {-1.0, 0.0}, false},
                   {"positive", {0.0, 1.0}, {1e-3, 2.0}, false}};
  const std::string logarithmic = output::draw(figure);
  CHECK(is_well_formed(logarithmic));
  CHECK(logarithmic.find(">0.001</text>") != std::string::npos);
}

TEST_CASE("a long curve keeps its extremes and becomes short")
{
  output::Figure figure = sample_figure();
  output::Curve curve{"long", {}, {}, false};
  for (int i = 0; i < 200000; ++i)
  {
    curve.x.push_back(i);
    curve.y.push_back(i == 123456 ? -3.0 : std::sin(0.01 * i));
  }
  figure.curves = {curve};
  figure.y_low = -3.0;
  figure.y_high = 1.0;
  const std::string text = output::draw(figure);
  CHECK(text.size() < 30000);
  // The lowest point of the plot, 40 + 300.
  CHECK(text.find(" 340.0") != std::string::npos);
}

TEST_CASE("each edge of a mesh is drawn once, curved ones as curves")
{
  const SampleMesh straight = structured(2, 3, 2, [](double x, double y) { return std::array{x, y}; });
  const SampleMesh bent = structured(3, 3, 2,
                                     [](double x, double y) {
                                       return std::array{x, y + 0.1 * std::sin(6.0 * x)};
                                     });
  const std::vector<output::Panel> panels = {{"straight", {{&straight.mesh, straight.x, false, {}}}},
                                             {"bent", {{&bent.mesh, bent.x, false, {}}}}};
  const std::string text = output::draw(panels, {{-0.1, -0.1}, {1.1, 1.1}}, 2, "meshes");
  CHECK(is_well_formed(text));
  std::size_t at = text.find("class=\"mesh\"");
  const std::string first = text.substr(at, text.find("/>", at) - at);
  // 3 x 3 lines along and 4 x 2 across.
  CHECK(count(first, "M") == 17);
  CHECK(count(first, "c") == 1);  // of "class"
  at = text.find("class=\"mesh\"", at + 1);
  const std::string second = text.substr(at, text.find("/>", at) - at);
  CHECK(count(second, "M") == 17);
  CHECK(count(second, "c") == 1 + 9);
}

TEST_CASE("what lies outside of the window is left out, faulty cells are marked")
{
  const SampleMesh sample = structured(1, 4, 4, [](double x, double y) { return std::array{x, y}; });
  const std::vector<std::int32_t> faulty = {5};
  const std::vector<output::Panel> panels = {{"part", {{&sample.mesh, sample.x, false, faulty}}}};
  const std::string text = output::draw(panels, {{0.3, 0.3}, {0.45, 0.45}}, 1, "part");
  CHECK(count(text, "M") < 17);
  CHECK(count(text, "class=\"bad\"") == 1);
  CHECK(count(text, "class=\"ring\"") == 1);
}

TEST_CASE("an edge of order 3 is drawn exactly")
{
  // y = t^3 along x = t has the Bezier points 0, 0, 0, 1.
  const SampleMesh sample = structured(3, 1, 1,
                                       [](double x, double y) {
                                         return std::array{x, y + x * x * x};
                                       });
  const std::vector<output::Panel> panels = {{"cubic", {{&sample.mesh, sample.x, false, {}}}}};
  const std::string text = output::draw(panels, {{0.0, 0.0}, {2.0, 2.0}}, 1, "cubic");
  // One panel is 876 wide: 4380 units per metre, the first edge from the lower left corner.
  CHECK(text.find("M0 8760c1460 0 2920 0 4380-4380") != std::string::npos);
}

namespace
{

/// A block of which one side, a quarter of a circle of radius 10, lies on the boundary "rim".
output::BlockPicture sector()
{
  output::BlockPicture picture;
  picture.title = "a & b";
  picture.points = {{"centre", {0.0, 0.0}}, {"east", {10.0, 0.0}}, {"north", {0.0, 10.0}}};
  const auto straight = [](std::array<double, 2> a, std::array<double, 2> b)
  {
    std::vector<std::array<double, 2>> x;
    for (const double t : element::lobatto(3))
      x.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
    return x;
  };
  std::vector<std::array<double, 2>> arc;
  for (int piece = 0; piece < 2; ++piece)
    for (const double t : element::lobatto(3))
      if (piece == 0 || t > 0.0)
      {
        const double angle = 0.25 * std::acos(-1.0) * (piece + t);
        arc.push_back({10.0 * std::cos(angle), 10.0 * std::sin(angle)});
      }
  arc.front() = {10.0, 0.0};
  arc.back() = {0.0, 10.0};
  picture.lines = {{"centre - east", 2, -1, 1, straight({0, 0}, {10, 0}), {{5.0, 0.0}}},
                   {"east - north", 7, 0, 2, arc, {}},
                   {"centre - north", 1, -1, 1, straight({0, 0}, {0, 10}), {}}};
  picture.blocks = {{"slice", 0, {0, 1, 2}}};
  picture.regions = {"fluid"};
  picture.boundaries = {"rim"};
  return picture;
}

}  // namespace

TEST_CASE("a picture of blocks names points, blocks, regions and boundaries and counts cells")
{
  const std::string text = output::draw(sector());
  CHECK(is_well_formed(text));
  CHECK(text.find("<title>a &amp; b</title>") != std::string::npos);
  CHECK(text.find("prefers-color-scheme:dark") != std::string::npos);
  for (const char* name : {"centre", "east", "north", "slice", "fluid", "rim", "2", "7", "1"})
    CHECK_MESSAGE(text.find(std::string(">") + name + "</text>") != std::string::npos, name);
  CHECK(count(text, "class=\"point\"") == 3);
  CHECK(count(text, "class=\"between\"") == 2);
  CHECK(text.find("<title>east - north: 7 cells, rim</title>") != std::string::npos);
  CHECK(text.find("<title>centre - north: 1 cell</title>") != std::string::npos);
  CHECK(text.find("<title>slice (fluid)</title>") != std::string::npos);
  // One stroke where two cells meet.
  const std::size_t ends = text.find("class=\"ends\" d=\"");
  REQUIRE(ends != std::string::npos);
  CHECK(count(text.substr(ends, text.find('>', ends) - ends), "M") == 1);
}

TEST_CASE("edges of blocks are drawn as the curves that they are")
{
  const std::string text = output::draw(sector());
  const std::size_t arc = text.find("class=\"boundary c0\" d=\"");
  REQUIRE(arc != std::string::npos);
  const std::size_t pieces = text.find(" d=\"", arc) + 4;
  CHECK(count(text.substr(pieces, text.find('"', pieces) - pieces), "c") == 2);
  const std::size_t straight = text.find("class=\"between\" d=\"");
  REQUIRE(straight != std::string::npos);
  const std::size_t data = text.find(" d=\"", straight) + 4;
  const std::string line = text.substr(data, text.find('"', data) - data);
  CHECK(count(line, "l") == 1);
  CHECK(count(line, "c") == 0);
}

TEST_CASE("names of points that lie close together do not cover each other")
{
  output::BlockPicture picture = sector();
  for (int k = 0; k < 4; ++k)
    picture.points.push_back({"near " + std::to_string(k), {9.7, 0.2 * k}});
  const std::string text = output::draw(picture);
  std::vector<std::array<double, 2>> places;
  for (std::size_t at = text.find("<text class=\"name\""); at != std::string::npos;
       at = text.find("<text class=\"name\"", at + 1))
    places.push_back({std::stod(text.substr(text.find("x=\"", at) + 3)),
                      std::stod(text.substr(text.find("y=\"", at) + 3))});
  CHECK(places.size() == 7);
  for (std::size_t a = 0; a < places.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      // Names of four letters or more in letters 12 pixels high.
      CHECK((std::abs(places[a][1] - places[b][1]) > 10.0 || std::abs(places[a][0] - places[b][0]) > 25.0));
}
