#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace blockfsi::output
{

/// How much a written file must survive.
enum class Durability
{
  process,  ///< the end of this process at any moment
  machine,  ///< also loss of power: waits until file and folder entry are on the disk
};

/// Replaces the whole file at once: readers find the old content or the new, never a part, even if the
/// process is killed meanwhile. Makes missing folders. Goes through `path` + ".tmp", so only one process may
/// write a path. Throws Error, naming the file and the reason, if the system refuses.
void replace_file(const std::filesystem::path& path, std::string_view content,
                  Durability durability = Durability::process);

/// Content of a file. Throws Error, naming the file and the reason, if it cannot be read.
std::string read_file(const std::filesystem::path& path);

}  // namespace blockfsi::output
