#include "core/error.hpp"
#include "geometry/sampled.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>

namespace blockfsi::geometry
{

namespace
{

/// More points than this in one direction are taken for a mistake rather than allocated.
constexpr double largest_count = 1e5;
constexpr double largest_total = 1e9;

std::string whole_file(const std::filesystem::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (text.empty())
    throw Error("cannot be read or is empty; give the path of a .vti file or of a text with samples");
  return text;
}

/// Takes numbers off the front of a text.
class Numbers
{
public:
  explicit Numbers(std::string_view text) : text_(text) {}

  double next(std::string_view what)
  {
    skip();
    double value = 0.0;
    const auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), value);
    if (error != std::errc())
      throw Error(
          text_.empty()
              ? fmt::format("ends where {} should stand", what)
              : fmt::format("found '{}' where {} should stand",
                            text_.substr(0, std::min<std::size_t>(text_.find_first_of(" \t\r\n"), 20)),
                            what));
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return value;
  }
  bool finished()
  {
    skip();
    return text_.empty();
  }

private:
  void skip() { text_.remove_prefix(std::min(text_.find_first_not_of(" \t\r\n"), text_.size())); }
  std::string_view text_;
};

/// A count of points from a file, which must be a whole number of sensible size.
int count_of(double value)
{
  if (!(value >= 1.0 && value <= largest_count && value == std::floor(value)))
    throw Error(fmt::format("has {:.9g} points in one direction; allowed are whole numbers from 1 to {:.0e}",
                            value, largest_count));
  return static_cast<int>(value);
}

std::size_t total(const Samples& samples)
{
  const double points = static_cast<double>(samples.count[0]) * samples.count[1] * samples.count[2];
  if (points > largest_total)
    throw Error(fmt::format("has {:.3g} points; allowed are {:.0e}", points, largest_total));
  return static_cast<std::size_t>(points);
}

void read_values(Numbers& numbers, Samples& samples)
{
  const std::size_t points = total(samples);
  for (std::size_t i = 0; i < points; ++i)
    samples.values.push_back(numbers.next("a sample"));
  if (!numbers.finished())
    throw Error(fmt::format("goes on after the last of {} samples", points));
}

Samples from_text(std::string_view text)
{
  Numbers numbers(text);
  Samples samples;
  for (int& count : samples.count)
    count = count_of(numbers.next("a number of points"));
  for (double& origin : samples.origin)
    origin = numbers.next("the origin");
  for (double& spacing : samples.spacing)
    spacing = numbers.next("the spacing");
  read_values(numbers, samples);
  return samples;
}

/// The value of an attribute of the first tag of a kind.
std::optional<std::string_view> attribute(std::string_view xml, std::string_view tag, std::string_view name)
{
  const std::size_t begin = xml.find(fmt::format("<{}", tag));
  if (begin == std::string_view::npos)
    return {};
  const std::string_view head = xml.substr(begin, xml.find('>', begin) - begin);
  const std::string key = fmt::format(" {}=\"", name);
  const std::size_t at = head.find(key);
  if (at == std::string_view::npos)
    return {};
  const std::string_view rest = head.substr(at + key.size());
  return rest.substr(0, rest.find('"'));
}

std::string_view required(std::string_view xml, std::string_view tag, std::string_view name)
{
  const auto value = attribute(xml, tag, name);
  if (!value)
    throw Error(fmt::format("has no <{} {}=\"...\">", tag, name));
  return *value;
}

Samples from_image(std::string_view xml)
{
  Samples samples;
  Numbers extent(required(xml, "ImageData", "WholeExtent"));
  Numbers origin(required(xml, "ImageData", "Origin"));
  Numbers spacing(required(xml, "ImageData", "Spacing"));
  for (std::size_t c = 0; c < 3; ++c)
  {
    const double low = extent.next("an extent");
    samples.count[c] = count_of(extent.next("an extent") - low + 1.0);
    samples.spacing[c] = spacing.next("the spacing");
    samples.origin[c] = origin.next("the origin") + low * samples.spacing[c];
  }
  const std::size_t points = xml.find("<PointData");
  if (points == std::string_view::npos)
    throw Error("has no point data");
  xml.remove_prefix(points);
  if (const auto format = attribute(xml, "DataArray", "format"); !format || *format != "ascii")
    throw Error(
        fmt::format("holds its samples as '{}'; write it with format=\"ascii\"", format.value_or("nothing")));
  const std::size_t begin = xml.find('>', xml.find("<DataArray")) + 1;
  Numbers numbers(xml.substr(begin, xml.find('<', begin) - begin));
  read_values(numbers, samples);
  return samples;
}

}  // namespace

Samples read_samples(const std::filesystem::path& path)
{
  try
  {
    const std::string text = whole_file(path);
    return path.extension() == ".vti" ? from_image(text) : from_text(text);
  }
  catch (const Error& error)
  {
    throw Error(fmt::format("the file of samples '{}' {}", path.string(), error.message()));
  }
}

}  // namespace blockfsi::geometry
