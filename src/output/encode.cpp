#include "output/encode.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace blockfsi::output
{

static_assert(std::endian::native == std::endian::little, "files are declared and written as little-endian");

namespace
{

struct Escape
{
  char character;
  std::string_view text;
};

constexpr std::array<Escape, 3> escapes = {{{'&', "&amp;"}, {'<', "&lt;"}, {'"', "&quot;"}}};

constexpr std::size_t block_size = std::size_t{1} << 20;

/// Appends one compressed block and returns its size.
std::size_t compress_block(std::span<const std::byte> block, std::vector<std::byte>& result)
{
  const std::size_t before = result.size();
  uLongf size = compressBound(block.size());
  result.resize(before + size);
  // Mantissas hardly shrink whatever the effort: the fastest level gives most of what there is.
  const int status = compress2(reinterpret_cast<Bytef*>(result.data() + before), &size,
                               reinterpret_cast<const Bytef*>(block.data()), block.size(), Z_BEST_SPEED);
  if (status != Z_OK)
    throw Error("there is not enough memory to compress a field file; use more processes");
  result.resize(before + size);
  return size;
}

constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

constexpr std::int8_t no_digit = -1;
constexpr std::int8_t padding = -2;
constexpr std::int8_t space = -3;

/// Value of each character of base64.
constexpr std::array<std::int8_t, 256> make_digit_values()
{
  std::array<std::int8_t, 256> values{};
  values.fill(no_digit);
  for (std::size_t k = 0; k < digits.size(); ++k)
    values[static_cast<unsigned char>(digits[k])] = static_cast<std::int8_t>(k);
  values['='] = padding;
  for (const char c : {' ', '\n', '\r', '\t'})
    values[static_cast<unsigned char>(c)] = space;
  return values;
}

constexpr std::array<std::int8_t, 256> digit_values = make_digit_values();

}  // namespace

std::string encode_base64(std::span<const std::byte> bytes)
{
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  std::size_t at = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = (group << 8) | (k < count ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k <= count; ++k)
      text[at + k] = digits[(group >> (18 - 6 * k)) & 63];
    at += 4;
  }
  return text;
}

std::string encode_compressed(std::span<const std::byte> bytes)
{
  std::vector<std::uint64_t> header = {(bytes.size() + block_size - 1) / block_size, block_size,
                                       bytes.size() % block_size};
  std::vector<std::byte> compressed;
  for (std::size_t first = 0; first < bytes.size(); first += block_size)
  {
    const std::size_t size = std::min(block_size, bytes.size() - first);
    header.push_back(compress_block(bytes.subspan(first, size), compressed));
  }
  return encode_base64(std::as_bytes(std::span(header))) + encode_base64(compressed);
}

void Allowance::take(std::uint64_t bytes)
{
  if (bytes > left_)
    throw Error("its arrays unpack to more than a hundred times the size of the file, so it is not a mesh");
  left_ -= bytes;
}

bool Base64Reader::decode_group()
{
  std::uint32_t bits = 0;
  int characters = 0;
  int padded = 0;
  while (characters < 4)
  {
    if (at_ == text_.size())
    {
      if (characters == 0)
        return false;
      throw Error("its base64 text is cut off");
    }
    const std::int8_t value = digit_values[static_cast<unsigned char>(text_[at_++])];
    if (value == space)
      continue;
    if (value == no_digit || (value == padding && characters < 2) || (value != padding && padded > 0))
      throw Error(fmt::format("character {} of its base64 text has no place there", at_));
    padded += value == padding ? 1 : 0;
    bits = (bits << 6) | static_cast<std::uint32_t>(value == padding ? 0 : value);
    ++characters;
  }
  left_ = 3 - padded;
  for (int k = 0; k < 3; ++k)
    group_[k] = static_cast<std::byte>((bits >> (16 - 8 * k)) & 255);
  // Bytes are taken from the end of the group's array.
  std::move_backward(group_.begin(), group_.begin() + left_, group_.end());
  return true;
}

std::vector<std::byte> Base64Reader::take(std::uint64_t count)
{
  if (count > text_.size() - at_ + left_)
    throw Error(fmt::format("its base64 text ends before the {} bytes that it should hold", count));
  std::vector<std::byte> bytes(count);
  for (std::byte& byte : bytes)
  {
    if (left_ == 0 && !decode_group())
      throw Error(fmt::format("its base64 text ends before the {} bytes that it should hold", count));
    byte = group_[3 - left_--];
  }
  return bytes;
}

void decompress(std::span<const std::byte> compressed, std::span<std::byte> result)
{
  uLongf size = result.size();
  const int status = uncompress(reinterpret_cast<Bytef*>(result.data()), &size,
                                reinterpret_cast<const Bytef*>(compressed.data()), compressed.size());
  if (status != Z_OK || size != result.size())
    throw Error("its compressed data are damaged");
}

std::string escape_xml(std::string_view text)
{
  std::string result;
  for (const char c : text)
  {
    const auto found = std::find_if(escapes.begin(), escapes.end(),
                                    [c](const Escape& escape) { return escape.character == c; });
    if (found == escapes.end())
      result += c;
    else
      result += found->text;
  }
  return result;
}

std::string unescape_xml(std::string_view text)
{
  std::string result;
  while (!text.empty())
  {
    const auto found = std::find_if(escapes.begin(), escapes.end(),
                                    [text](const Escape& escape) { return text.starts_with(escape.text); });
    result += found == escapes.end() ? text.front() : found->character;
    text.remove_prefix(found == escapes.end() ? 1 : found->text.size());
  }
  return result;
}

}  // namespace blockfsi::output
