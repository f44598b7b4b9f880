#include "output/series.hpp"

#include "core/error.hpp"
#include "output/encode.hpp"
#include "output/file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

namespace blockfsi::output
{

namespace
{

constexpr std::string_view head =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
    "<Collection>\n";
constexpr std::string_view foot = "</Collection>\n</VTKFile>\n";

/// Number of each region in order of first appearance.
int part_number(std::vector<std::string_view>& regions, std::string_view region)
{
  const auto found = std::find(regions.begin(), regions.end(), region);
  const auto number = found - regions.begin();
  if (found == regions.end())
    regions.push_back(region);
  return static_cast<int>(number);
}

std::optional<std::string_view> attribute(std::string_view line, std::string_view name)
{
  const std::string opening = fmt::format(" {}=\"", name);
  const std::size_t begin = line.find(opening);
  if (begin == std::string_view::npos)
    return std::nullopt;
  line.remove_prefix(begin + opening.size());
  const std::size_t end = line.find('"');
  if (end == std::string_view::npos)
    return std::nullopt;
  return line.substr(0, end);
}

std::optional<Snapshot> parse(std::string_view line)
{
  const auto time = attribute(line, "timestep");
  const auto region = attribute(line, "name");
  const auto file = attribute(line, "file");
  if (!time || !region || !file)
    return std::nullopt;
  Snapshot snapshot{0.0, unescape_xml(*region), unescape_xml(*file)};
  const auto [end, error] = std::from_chars(time->data(), time->data() + time->size(), snapshot.time);
  if (error != std::errc{} || end != time->data() + time->size())
    return std::nullopt;
  return snapshot;
}

}  // namespace

Series::Series(std::filesystem::path path) : path_(std::move(path)) {}

Series Series::resume(std::filesystem::path path, double last)
{
  Series series(std::move(path));
  if (!std::filesystem::exists(series.path_))
    return series;
  series.snapshots_ = read_series(series.path_);
  std::erase_if(series.snapshots_, [last](const Snapshot& snapshot) { return snapshot.time > last; });
  return series;
}

void Series::add(std::span<const Snapshot> snapshots)
{
  snapshots_.insert(snapshots_.end(), snapshots.begin(), snapshots.end());
  std::vector<std::string_view> regions;
  std::string text(head);
  for (const Snapshot& snapshot : snapshots_)
    text += fmt::format("<DataSet timestep=\"{}\" group=\"\" part=\"{}\" name=\"{}\" file=\"{}\"/>\n",
                        snapshot.time, part_number(regions, snapshot.region), escape_xml(snapshot.region),
                        escape_xml(snapshot.file));
  text += foot;
  replace_file(path_, text);
}

std::vector<Snapshot> read_series(const std::filesystem::path& path)
{
  const std::string content = read_file(path);
  const Error error(fmt::format(
      "'{}' is not a series of field files of this program; move it away and start again", path.string()));
  std::string_view text = content;
  if (!text.starts_with(head) || !text.ends_with(foot))
    throw error;
  text = text.substr(head.size(), text.size() - head.size() - foot.size());
  std::vector<Snapshot> snapshots;
  while (!text.empty())
  {
    const std::size_t end = text.find('\n');
    const auto snapshot = parse(text.substr(0, end));
    if (!snapshot || end == std::string_view::npos)
      throw error;
    snapshots.push_back(*snapshot);
    text.remove_prefix(end + 1);
  }
  return snapshots;
}

}  // namespace blockfsi::output
