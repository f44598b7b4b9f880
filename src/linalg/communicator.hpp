#pragma once

#include "core/part.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace blockfsi::linalg
{

/// The share of this process: rank 0 of 1 where MPI was not started.
Part part();

/// Sum over all processes, entry by entry, in place.
void sum(std::span<double> values);
std::int64_t sum(std::int64_t value);
double maximum(double value);
double minimum(double value);
/// Minimum over all processes, entry by entry, in place.
void minimum(std::span<double> values);
/// Whether the condition holds on any process.
bool any(bool condition);
/// The bytes of every process, in the order of ranks; all give the same number.
std::vector<std::byte> gather_bytes(std::span<const std::byte> mine);
/// The same for values of a type that is copied byte by byte.
template <class T>
std::vector<T> gather(std::span<const T> mine)
{
  static_assert(std::is_trivially_copyable_v<T>);
  const std::vector<std::byte> bytes = gather_bytes(std::as_bytes(mine));
  std::vector<T> all(bytes.size() / sizeof(T));
  std::memcpy(all.data(), bytes.data(), bytes.size());
  return all;
}
/// The value of process 0.
std::int64_t from_first(std::int64_t value);
/// The values of one process, of any number, on each.
void from_process(int rank, std::vector<double>& values);
/// Waits until all processes are here.
void barrier();
/// Waits at most so long [s] until all processes have called this; false if some did not come. For the end of
/// a process that cannot go on: whether the others wait for it somewhere else.
bool all_arrive(double seconds);
/// Ends all processes at once with an exit code.
[[noreturn]] void abort(int code);

}  // namespace blockfsi::linalg
