#pragma once

#include <array>
#include <chrono>
#include <string_view>

namespace blockfsi
{

/// The parts of a run that the timing summary tells apart.
enum class Task
{
  place,
  quality,
  assembly,
  factorisation,
  solve,
  transfer,
  output
};

inline constexpr std::array<std::string_view, 7> task_names = {
    "place", "mesh quality", "assembly", "factorisation", "solve", "transfer", "output"};

/// Wall time [s] and number of calls by task.
struct Timings
{
  std::array<double, task_names.size()> seconds{};
  std::array<long, task_names.size()> calls{};
};

/// Adds the time from its making to its end to one task.
class Stopwatch
{
public:
  Stopwatch(Timings& timings, Task task)
      : timings_(timings), task_(static_cast<std::size_t>(task)), start_(std::chrono::steady_clock::now())
  {
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;
  ~Stopwatch()
  {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    timings_.seconds[task_] += elapsed.count();
    ++timings_.calls[task_];
  }

private:
  Timings& timings_;
  std::size_t task_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace blockfsi
