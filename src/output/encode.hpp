#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace blockfsi::output
{

/// Base64 with padding (RFC 4648).
std::string encode_base64(std::span<const std::byte> bytes);

/// Content of a VTK DataArray with vtkZLibDataCompressor and 64-bit headers: base64 of the header (block
/// count, block size, size of the last block if it is shorter, compressed sizes), then base64 of the
/// compressed blocks.
std::string encode_compressed(std::span<const std::byte> bytes);

/// Text as the value of an XML attribute, and back.
std::string escape_xml(std::string_view text);
std::string unescape_xml(std::string_view text);

}  // namespace blockfsi::output
