#pragma once

#include "output/encode.hpp"
#include "output/xml.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi::output
{

/// A VTK file in two: XML, and the data appended to it, which need not be XML.
struct AppendedText
{
  std::string_view xml;
  std::string_view data;  ///< behind the underscore
  bool found = false;
  bool base64 = false;
};

AppendedText split_appended(std::string_view content);

/// Reads the arrays of a VTK file: as text, inline base64 or appended (base64 or raw), plain or compressed by
/// zlib. All of them together may take what the Allowance of the file gives.
class VtkArrays
{
public:
  /// What is given must outlive this. Throws Error for big-endian files and other compressors.
  VtkArrays(const std::string& file, const XmlElement& root, AppendedText appended, std::size_t file_size);

  /// Values of an array, with the place in the message if they cannot be read.
  std::vector<double> numbers(const XmlElement& array);
  /// The same for integers; fractions are refused.
  std::vector<std::int64_t> integers(const XmlElement& array);
  std::vector<std::string> strings(const XmlElement& array);

private:
  std::vector<std::byte> bytes(const XmlElement& array);
  template <typename T>
  std::vector<T> values(const XmlElement& array);

  const std::string& file_;
  AppendedText appended_;
  bool compressed_ = false;
  bool wide_header_ = false;  ///< 64 bits
  Allowance allowance_;
};

}  // namespace blockfsi::output
