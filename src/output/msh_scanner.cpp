#include "output/msh_scanner.hpp"

#include "core/error.hpp"
#include "core/space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

namespace blockfsi::output
{

namespace
{

std::string_view trim(std::string_view text)
{
  while (!text.empty() && is_space(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && is_space(text.back()))
    text.remove_suffix(1);
  return text;
}

}  // namespace

void MshScanner::fail(const std::string& message) const
{
  const std::string place = section_.empty() ? std::string() : fmt::format("section ${}: ", section_);
  if (binary_)
    throw Error({file_, 0, 0}, fmt::format("{}byte {}: {}", place, at_, message));
  const auto lines = std::count(content_.begin(), content_.begin() + std::min(at_, content_.size()), '\n');
  throw Error({file_, static_cast<int>(lines) + 1, 0}, place + message);
}

void MshScanner::skip_space()
{
  while (at_ < content_.size() && is_space(content_[at_]))
    ++at_;
}

std::string_view MshScanner::line()
{
  const std::size_t end = std::min(content_.find('\n', at_), content_.size());
  const std::string_view text = trim(content_.substr(at_, end - at_));
  at_ = std::min(end + 1, content_.size());
  return text;
}

std::string MshScanner::next_section()
{
  section_.clear();
  skip_space();
  if (at_ == content_.size())
    return {};
  const std::size_t begin = at_;
  const std::string_view text = line();
  if (text.size() < 2 || text.front() != '$' || text.size() > 64 || text.starts_with("$End"))
  {
    at_ = begin;
    fail(fmt::format("a section such as $Nodes must begin here, not '{}'", text.substr(0, 40)));
  }
  section_ = text.substr(1);
  return section_;
}

void MshScanner::skip_section()
{
  const std::string end = "$End" + section_;
  const std::size_t found = content_.find(end, at_);
  if (found == std::string_view::npos)
    fail(fmt::format("the file ends before {}", end));
  at_ = found;
  line();
}

void MshScanner::end_section()
{
  skip_space();
  const std::size_t begin = at_;
  if (line() != "$End" + section_)
  {
    at_ = begin;
    fail(fmt::format("$End{} must follow here", section_));
  }
}

std::string_view MshScanner::token()
{
  skip_space();
  const std::size_t begin = at_;
  while (at_ < content_.size() && !is_space(content_[at_]))
    ++at_;
  if (begin == at_)
    fail("the file ends where a number must follow");
  return content_.substr(begin, at_ - begin);
}

template <typename T>
T MshScanner::read()
{
  if (binary_)
  {
    if (content_.size() - at_ < sizeof(T))
      fail("the file ends where a number must follow");
    T value{};
    std::memcpy(&value, content_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  const std::string_view text = token();
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    fail(fmt::format("'{}' is no {}", text.substr(0, 40),
                     std::is_floating_point_v<T> ? "number" : "integer of the range that is needed here"));
  return value;
}

int MshScanner::integer()
{
  return read<std::int32_t>();
}

std::uint64_t MshScanner::size()
{
  return read<std::uint64_t>();
}

double MshScanner::number()
{
  return read<double>();
}

std::int64_t MshScanner::text_integer()
{
  const bool binary = std::exchange(binary_, false);
  const auto value = read<std::int64_t>();
  binary_ = binary;
  return value;
}

double MshScanner::text_number()
{
  const bool binary = std::exchange(binary_, false);
  const auto value = read<double>();
  binary_ = binary;
  return value;
}

std::string MshScanner::quoted()
{
  skip_space();
  const std::size_t end = content_.find('"', at_ + 1);
  if (at_ == content_.size() || content_[at_] != '"' || end == std::string_view::npos)
    fail("a name in quotes must follow here");
  const std::string text(content_.substr(at_ + 1, end - at_ - 1));
  at_ = end + 1;
  return text;
}

std::size_t MshScanner::count(std::size_t bytes_each, std::size_t numbers_each)
{
  const std::uint64_t value = size();
  const std::size_t least = binary_ ? bytes_each : 2 * numbers_each;
  if (least > 0 && value > (content_.size() - at_ + 1) / least)
    fail(fmt::format("{} entries must follow, but the rest of the file has only {} bytes", value,
                     content_.size() - at_));
  return value;
}

}  // namespace blockfsi::output
