#include "output/vtk_arrays.hpp"

#include "core/error.hpp"
#include "core/space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <variant>

namespace blockfsi::output
{

namespace
{

/// Bytes that follow each other, raw or as base64.
class ByteReader
{
public:
  ByteReader(std::string_view text, bool base64) : raw_(text), base64_(text), encoded_(base64) {}

  std::vector<std::byte> take(std::uint64_t count)
  {
    if (encoded_)
      return base64_.take(count);
    if (count > raw_.size())
      throw Error(fmt::format("the file ends before the {} bytes that it should hold", count));
    std::vector<std::byte> bytes(count);
    std::memcpy(bytes.data(), raw_.data(), count);
    raw_.remove_prefix(count);
    return bytes;
  }

  std::uint64_t take_number(bool wide)
  {
    const std::vector<std::byte> bytes = take(wide ? 8 : 4);
    std::uint64_t number = 0;
    std::memcpy(&number, bytes.data(), bytes.size());
    return number;
  }

private:
  std::string_view raw_;
  Base64Reader base64_;
  bool encoded_;
};

std::vector<std::byte> unpack(ByteReader& reader, bool wide, Allowance& allowance)
{
  const std::uint64_t blocks = reader.take_number(wide);
  if (blocks == 0)
    return {};
  const std::uint64_t size = reader.take_number(wide);
  const std::uint64_t partial = reader.take_number(wide);
  constexpr std::uint64_t most = std::uint64_t{1} << 40;
  if (blocks > most || size > most || partial > size)
    throw Error(fmt::format("its header speaks of {} blocks of {} bytes", blocks, size));
  if (size > 0 && blocks > most / size)
    throw Error(fmt::format("its header speaks of {} blocks of {} bytes", blocks, size));
  const std::uint64_t total = blocks * size - (partial > 0 ? size - partial : 0);
  allowance.take(total);
  allowance.take(8 * blocks);
  std::vector<std::uint64_t> lengths(blocks);
  for (std::uint64_t& length : lengths)
    length = reader.take_number(wide);
  std::vector<std::byte> result(total);
  std::span<std::byte> rest(result);
  for (const std::uint64_t length : lengths)
  {
    const std::size_t part = std::min<std::size_t>(size, rest.size());
    decompress(reader.take(length), rest.first(part));
    rest = rest.subspan(part);
  }
  return result;
}

/// Calls a visitor with a value of the type that an array has.
template <class Visitor>
auto with_type(std::string_view type, Visitor visit)
{
  if (type == "Float64")
    return visit(double{});
  if (type == "Float32")
    return visit(float{});
  if (type == "Int64")
    return visit(std::int64_t{});
  if (type == "UInt64")
    return visit(std::uint64_t{});
  if (type == "Int32")
    return visit(std::int32_t{});
  if (type == "UInt32")
    return visit(std::uint32_t{});
  if (type == "Int16")
    return visit(std::int16_t{});
  if (type == "UInt16")
    return visit(std::uint16_t{});
  if (type == "Int8")
    return visit(std::int8_t{});
  if (type == "UInt8" || type == "String")
    return visit(std::uint8_t{});
  throw Error(fmt::format("its type '{}' is not known", type));
}

/// A number as the type that is wanted; throws where it does not fit.
template <typename To, typename From>
To convert(From value)
{
  if constexpr (std::is_floating_point_v<From> && std::is_integral_v<To>)
  {
    if (!(std::abs(value) < From(1LL << 53)) || value != std::floor(value))
      throw Error(fmt::format("it must hold integers, not {}", value));
  }
  if constexpr (std::is_same_v<From, std::uint64_t> && std::is_integral_v<To>)
  {
    if (value > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
      throw Error(fmt::format("its value {} is too large", value));
  }
  return static_cast<To>(value);
}

template <typename To>
std::vector<To> parse_text(std::string_view text, Allowance& allowance)
{
  std::vector<To> values;
  const char* at = text.data();
  const char* const last = text.data() + text.size();
  while (true)
  {
    at = std::find_if_not(at, last, is_space);
    if (at == last)
      return values;
    double value = 0.0;
    std::int64_t integer = 0;
    const char* const end = std::find_if(at, last, is_space);
    const bool whole = std::from_chars(at, end, integer).ptr == end;
    const auto [stop, error] = std::from_chars(at, end, value);
    if (!whole && (error != std::errc{} || stop != end))
      throw Error(
          fmt::format("'{}' is not a number", std::string_view(at, std::min<std::size_t>(end - at, 40))));
    allowance.take(sizeof(To));
    values.push_back(whole ? convert<To>(integer) : convert<To>(value));
    at = end;
  }
}

template <typename To>
std::vector<To> parse_bytes(std::span<const std::byte> bytes, std::string_view type, Allowance& allowance)
{
  return with_type(type,
                   [bytes, &allowance]<typename From>(From)
                   {
                     if (bytes.size() % sizeof(From) != 0)
                       throw Error(
                           fmt::format("its {} bytes are not a multiple of {}", bytes.size(), sizeof(From)));
                     std::vector<To> values(bytes.size() / sizeof(From));
                     allowance.take(values.size() * sizeof(To));
                     for (std::size_t k = 0; k < values.size(); ++k)
                     {
                       From value{};
                       std::memcpy(&value, bytes.data() + k * sizeof(From), sizeof(From));
                       values[k] = convert<To>(value);
                     }
                     return values;
                   });
}

}  // namespace

AppendedText split_appended(std::string_view content)
{
  constexpr std::string_view opening = "<AppendedData";
  const std::size_t begin = content.find(opening);
  if (begin == std::string_view::npos)
    return {content, {}, false, false};
  AppendedText result{content.substr(0, begin), content.substr(begin), true, false};
  const std::size_t head = result.data.find('>');
  const std::size_t underscore = head == std::string_view::npos ? head : result.data.find('_', head);
  result.base64 = result.data.substr(0, head).find("\"base64\"") != std::string_view::npos;
  result.data =
      underscore == std::string_view::npos ? std::string_view{} : result.data.substr(underscore + 1);
  const std::size_t end = result.data.rfind("</AppendedData>");
  result.data = result.data.substr(0, end);
  return result;
}

VtkArrays::VtkArrays(const std::string& file, const XmlElement& root, AppendedText appended,
                     std::size_t file_size)
    : file_(file), appended_(appended), allowance_(file_size)
{
  const std::string_view compressor = root.attribute("compressor");
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
    throw Error({file, root.line, 0},
                fmt::format("arrays are compressed by '{}'; only vtkZLibDataCompressor and "
                            "arrays that are not compressed are supported",
                            compressor));
  if (root.attribute("byte_order", "LittleEndian") != "LittleEndian")
    throw Error({file, root.line, 0}, fmt::format("its byte order is '{}'; only LittleEndian is supported",
                                                  root.attribute("byte_order")));
  compressed_ = !compressor.empty();
  wide_header_ = root.attribute("header_type", "UInt32") == "UInt64";
}

std::vector<std::byte> VtkArrays::bytes(const XmlElement& array)
{
  const std::string_view format = array.attribute("format");
  std::string_view text = array.text;
  bool base64 = true;
  if (format == "appended")
  {
    const std::string_view offset_text = array.attribute("offset");
    std::uint64_t offset = 0;
    const auto [end, error] =
        std::from_chars(offset_text.data(), offset_text.data() + offset_text.size(), offset);
    if (error != std::errc{} || offset > appended_.data.size() || !appended_.found)
      throw Error(fmt::format("its offset '{}' lies outside of the appended data", offset_text));
    text = appended_.data.substr(offset);
    base64 = appended_.base64;
  }
  else if (format != "binary")
    throw Error(fmt::format("its format '{}' is not known; ascii, binary and appended are", format));
  ByteReader reader(text, base64);
  if (compressed_)
    return unpack(reader, wide_header_, allowance_);
  const std::uint64_t count = reader.take_number(wide_header_);
  allowance_.take(count);
  return reader.take(count);
}

template <typename T>
std::vector<T> VtkArrays::values(const XmlElement& array)
{
  try
  {
    if (array.attribute("format", "ascii") == "ascii")
      return parse_text<T>(array.text, allowance_);
    return parse_bytes<T>(bytes(array), array.attribute("type"), allowance_);
  }
  catch (const Error& error)
  {
    throw error.within(fmt::format("array '{}'", array.attribute("Name"))).at({file_, array.line, 0});
  }
}

std::vector<double> VtkArrays::numbers(const XmlElement& array)
{
  return values<double>(array);
}

std::vector<std::int64_t> VtkArrays::integers(const XmlElement& array)
{
  return values<std::int64_t>(array);
}

std::vector<std::string> VtkArrays::strings(const XmlElement& array)
{
  std::vector<std::string> result(1);
  for (const std::int64_t code : values<std::int64_t>(array))
    if (code == 0)
      result.emplace_back();
    else
      result.back() += static_cast<char>(code);
  result.pop_back();
  return result;
}

}  // namespace blockfsi::output
