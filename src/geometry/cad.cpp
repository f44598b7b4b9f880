#include "geometry/cad.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace blockfsi::geometry
{

namespace
{

/// Three coordinates; what is round-off beside the size of the whole is 0.
std::string point_text(const Point& x, double round_off)
{
  std::string result;
  for (const double value : x)
    result += fmt::format(" {:>11.5g}", std::abs(value) <= round_off ? 0.0 : value);
  return result;
}

std::string heading(const char* what, const char* from, const char* to)
{
  return fmt::format("{:<6} {:<11} {:>11} {:>11} {:>11}   {:>11} {:>11} {:>11}", what, "type", from, "y", "z",
                     to, "y", "z");
}

double largest_coordinate(const CadFile& file)
{
  double result = 0.0;
  for (const std::vector<CadItem>* items : {&file.edges(), &file.faces()})
    for (const CadItem& item : *items)
      for (std::size_t c = 0; c < 3; ++c)
        result = std::max({result, std::abs(item.low[c]), std::abs(item.high[c])});
  return result;
}

}  // namespace

bool is_iges(const std::filesystem::path& path)
{
  if (!std::filesystem::is_regular_file(path))
    throw Error(fmt::format("cannot read {}: there is no such file", path.string()));
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool iges = ending == ".iges" || ending == ".igs";
  if (!iges && ending != ".step" && ending != ".stp")
    throw Error(
        fmt::format("cannot read {}: its name must end in .step, .stp, .iges or .igs", path.string()));
  return iges;
}

std::string describe(const CadFile& file)
{
  const double round_off = 1e-9 * largest_coordinate(file);
  std::string result = heading("edge", "start x [m]", "end x [m]") + "   length [m]\n";
  for (const CadItem& item : file.edges())
    result += fmt::format("{:<6} {:<11}{}  {}   {:.6g}\n", item.number, item.type,
                          point_text(item.start, round_off), point_text(item.end, round_off), item.length);
  if (file.faces().empty())
    return result;
  result += heading("face", "from x [m]", "to x [m]") + "\n";
  for (const CadItem& item : file.faces())
    result += fmt::format("{:<6} {:<11}{}  {}\n", item.number, item.type, point_text(item.low, round_off),
                          point_text(item.high, round_off));
  return result;
}

}  // namespace blockfsi::geometry
