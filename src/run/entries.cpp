#include "run/entries.hpp"

#include "core/error.hpp"
#include "core/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

namespace blockfsi::run
{

namespace
{

/// Names that need no section in the case, with what they stand for in [motion].
constexpr std::array<std::pair<std::string_view, std::string_view>, 9> shorthands = {
    {{"regenerate", "regenerate={}"},
     {"fixed", "regenerate={corners=\"fixed\"}"},
     {"radial", "regenerate={corners=\"radial\"}"},
     {"elastic", "regenerate={corners=\"elastic\"}"},
     {"nonlinear", "regenerate={corners=\"nonlinear\"}"},
     {"pseudo_solid", "pseudo_solid={}"},
     {"incremental", "pseudo_solid={from=\"last\"}"},
     {"harmonic", "harmonic={}"},
     {"biharmonic", "biharmonic={}"}}};

/// The keys of [motion] in the order of motion::Parameters.
constexpr std::array<std::string_view, 4> kinds = {"regenerate", "pseudo_solid", "harmonic", "biharmonic"};

std::string_view kind(const case_file::Motion& motion)
{
  return kinds[motion.update.index()];
}

const case_file::Motion* variant(const case_file::Case& description, std::string_view name)
{
  const auto found = std::find_if(description.variants.begin(), description.variants.end(),
                                  [name](const auto& entry) { return entry.first == name; });
  return found != description.variants.end() ? &found->second : nullptr;
}

/// Names become names of folders.
void check_name(const std::string& name)
{
  const auto is_fine = [](char c)
  {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  if (name.empty() || !std::all_of(name.begin(), name.end(), is_fine))
    throw Error(fmt::format("'{}' cannot be compared: a name consists of letters, digits, _ and -", name));
}

case_file::Case with(const case_file::Case& base, const case_file::Motion& motion)
{
  case_file::Case result = base;
  result.motion = motion;
  return result;
}

Entry make_entry(const case_file::Case& base, const std::filesystem::path& path,
                 const std::vector<std::string>& overrides, const std::string& name)
{
  check_name(name);
  if (const case_file::Motion* motion = variant(base, name))
    return {name, with(base, *motion)};
  if (kind(base.motion) == name)
    return {name, base};
  const auto* const shorthand = std::find_if(shorthands.begin(), shorthands.end(),
                                             [&](const auto& entry) { return entry.first == name; });
  if (shorthand == shorthands.end())
  {
    std::vector<std::string> known;
    for (const auto& entry : base.variants)
      known.push_back(entry.first);
    for (const auto& entry : shorthands)
      known.emplace_back(entry.first);
    throw Error(
        fmt::format("--motion: there is no way of moving the mesh called '{}'; known are {}; write others "
                    "as [compare.NAME] into the case",
                    name, listed(known)));
  }
  std::vector<std::string> more = overrides;
  more.push_back(fmt::format("compare.{}.{}", name, shorthand->second));
  return {name, with(base, *variant(case_file::read(path, more), name))};
}

}  // namespace

std::vector<Entry> read_entries(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                                const std::vector<std::string>& names)
{
  const case_file::Case base = case_file::read(path, overrides);
  std::vector<std::string> wanted = names;
  if (wanted.empty())
  {
    wanted.emplace_back(kind(base.motion));
    for (const auto& entry : base.variants)
      wanted.push_back(entry.first);
  }
  std::vector<Entry> entries;
  std::set<std::string, std::less<>> seen;
  for (const std::string& name : wanted)
  {
    if (!seen.insert(name).second)
      throw Error(fmt::format("--motion names '{}' twice", name));
    entries.push_back(make_entry(base, path, overrides, name));
  }
  return entries;
}

}  // namespace blockfsi::run
