#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi::output
{

/// An element of an XML file.
struct XmlElement
{
  std::string name;
  std::map<std::string, std::string, std::less<>> attributes;
  std::string text;  ///< without the elements inside
  std::vector<XmlElement> children;
  int line = 0;

  /// The first child of that name, or null.
  const XmlElement* child(std::string_view wanted) const;
  /// Value of an attribute, or `otherwise`.
  std::string_view attribute(std::string_view wanted, std::string_view otherwise = {}) const;
};

/// The root of an XML document. With `cut_off` it may end inside the root, after the elements
/// that are there (what follows is no XML). Throws Error with line and column; documents that declare
/// entities are refused.
XmlElement parse_xml(std::string_view content, const std::string& file, bool cut_off = false);

}  // namespace blockfsi::output
