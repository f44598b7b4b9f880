#include "output/encode.hpp"

#include "core/error.hpp"

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

}  // namespace

std::string encode_base64(std::span<const std::byte> bytes)
{
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
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
