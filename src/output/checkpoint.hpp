#pragma once

#include "core/part.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace blockfsi::output
{

/// Everything that a run needs to go on, by name.
using Array =
    std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::int32_t>, std::string>;
using Arrays = std::map<std::string, Array, std::less<>>;

/// The array of that name and type T (one of Array's). Throws Error if there is none of that name and type.
template <typename T>
const T& get(const Arrays& arrays, std::string_view name);

/// Writes the arrays to a file with format version, part and CRC-32, at once and waiting for the disk: a
/// process killed at any time leaves the old file or the new. Bits are kept, NaN included. Throws Error if
/// the file cannot be written.
void write_checkpoint(const std::filesystem::path& path, const Arrays& arrays);

/// Reads and verifies such a file. Throws Error if it is cut off, changed, of another format version or no
/// checkpoint at all.
Arrays read_checkpoint(const std::filesystem::path& path);

// Sets: one file per process, `folder`/step-000123/rank-0.bin and so on. A set counts only when the files of
// all its processes are there, intact and of one run: there is no other mark of completeness that could be
// wrong.

/// Writes one process's file of the set of a step. `run` tells runs apart that write to one folder (for
/// example the time of their start, the same number on all processes): files of different runs never make one
/// set.
void write_rank(const std::filesystem::path& folder, std::int64_t step, Part part, const Arrays& arrays,
                std::uint64_t run = 0);

/// The step of the newest complete set, if any; reads and verifies every file of the sets it looks at, so one
/// process should ask and tell the others. Sets that are incomplete or damaged are passed over. Throws Error
/// if all complete sets were written by another number of processes than `size`.
std::optional<std::int64_t> latest_complete(const std::filesystem::path& folder, int size);

/// Reads and verifies one process's file of a set. Throws Error as read_checkpoint does, and if the file was
/// written for another part.
Arrays read_rank(const std::filesystem::path& folder, std::int64_t step, Part part);

/// Removes all sets older than the `keep` newest that have all their files (their content is not verified).
/// One process should call it, after all have written.
void remove_old(const std::filesystem::path& folder, int keep = 2);

/// Removes all sets: what a run that starts from the beginning does first. One process should call it.
void remove_all(const std::filesystem::path& folder);

}  // namespace blockfsi::output
