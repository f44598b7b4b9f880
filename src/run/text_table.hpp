#pragma once

#include <string>
#include <vector>

namespace blockfsi::run
{

/// A table of texts for people and for programs.
struct TextTable
{
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  ///< as long as the header
};

/// Columns under each other, the first to the left, the others to the right.
std::string aligned(const TextTable& table);
/// Comma-separated; fields with commas, quotes or line breaks are quoted (RFC 4180).
std::string csv(const TextTable& table);

}  // namespace blockfsi::run
