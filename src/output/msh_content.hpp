#pragma once

#include "output/mesh_file.hpp"
#include "output/msh_scanner.hpp"
#include "output/msh_types.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace blockfsi::output
{

/// A dimension and a tag: entities and physical groups.
using Tagged = std::pair<int, int>;

/// Elements of one type of one entity, nodes as the file numbers them.
struct MshElements
{
  Tagged entity;
  GmshType type;
  std::vector<std::uint64_t> tags;
  std::vector<std::uint64_t> nodes;
};

/// A field and the tags of the nodes or elements that its values belong to.
struct TaggedField
{
  ReadField field;
  std::vector<std::int64_t> tags;
};

/// What the sections of a .msh file say.
struct MshContent
{
  std::map<Tagged, std::string> physical_names;
  std::map<Tagged, std::string> block_names;
  std::map<Tagged, std::vector<int>> physical;  ///< groups of each entity
  std::vector<std::uint64_t> node_tags;
  std::vector<double> points;
  std::vector<MshElements> elements;
  std::vector<TaggedField> node_data;
  std::vector<TaggedField> element_data;
};

/// Reads all sections of a file of format 4.1. Throws Error naming section and line, or byte, where it is
/// none or holds what is not read: partitions, types without a shape here, more than fits 32 bits.
MshContent read_sections(MshScanner& scan);

}  // namespace blockfsi::output
