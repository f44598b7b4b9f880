#include "geometry/cad.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace blockfsi::geometry
{

namespace
{

std::string box_text(const CadItem& item)
{
  return fmt::format("{:11.5g} {:11.5g} {:11.5g}   {:11.5g} {:11.5g} {:11.5g}", item.low[0], item.low[1],
                     item.low[2], item.high[0], item.high[1], item.high[2]);
}

std::string heading(const char* what)
{
  return fmt::format("{:<6} {:<11} {:>11} {:>11} {:>11}   {:>11} {:>11} {:>11}", what, "type", "from x", "y",
                     "z", "to x", "y", "z");
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
  std::string result = heading("edge") + "   length [m]\n";
  for (const CadItem& item : file.edges())
    result += fmt::format("{:<6} {:<11} {}   {:.6g}\n", item.number, item.type, box_text(item), item.length);
  result += heading("face") + "\n";
  for (const CadItem& item : file.faces())
    result += fmt::format("{:<6} {:<11} {}\n", item.number, item.type, box_text(item));
  return result;
}

}  // namespace blockfsi::geometry
