#include "output/svg.hpp"

#include "../mesh/structured.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stack>
#include <string>

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
