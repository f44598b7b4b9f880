#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi::output
{

/// Base64 with padding (RFC 4648).
std::string encode_base64(std::span<const std::byte> bytes);

/// Content of a VTK DataArray with vtkZLibDataCompressor and 64-bit headers: base64 of the header (block
/// count, block size, size of the last block if it is shorter, compressed sizes), then base64 of the
/// compressed blocks.
std::string encode_compressed(std::span<const std::byte> bytes);

/// How many bytes the arrays of one file may take in all, so that a small file that unpacks to more than any
/// machine has is refused.
class Allowance
{
public:
  /// For a file of that many bytes: a hundred times as many, and 64 MiB.
  explicit Allowance(std::size_t file_size) : left_(100 * file_size + (std::size_t{1} << 26)) {}

  /// Throws Error if less is left.
  void take(std::uint64_t bytes);

private:
  std::uint64_t left_;
};

/// Reads bytes one after the other from base64; white space is skipped, and texts with padding of their own
/// may follow each other.
class Base64Reader
{
public:
  explicit Base64Reader(std::string_view text) : text_(text) {}

  /// The next bytes. Throws Error if the text ends before or is no base64.
  std::vector<std::byte> take(std::uint64_t count);

private:
  bool decode_group();

  std::string_view text_;
  std::size_t at_ = 0;
  std::array<std::byte, 3> group_{};
  int left_ = 0;  ///< bytes of the group that were not taken yet
};

/// Unpacks zlib data. Throws Error unless they are whole and fill the result.
void decompress(std::span<const std::byte> compressed, std::span<std::byte> result);

/// Text as the value of an XML attribute, and back.
std::string escape_xml(std::string_view text);
std::string unescape_xml(std::string_view text);

}  // namespace blockfsi::output
