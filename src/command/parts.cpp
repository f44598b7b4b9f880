#include "command/parts.hpp"

#include <fmt/format.h>

namespace blockfsi::command
{

void Parts::end(std::string_view name)
{
  const auto now = std::chrono::steady_clock::now();
  seconds_.emplace_back(name, std::chrono::duration<double>(now - begin_).count());
  begin_ = now;
}

std::string Parts::table(std::size_t node_count) const
{
  double whole = 0.0;
  for (const auto& [name, seconds] : seconds_)
    whole += seconds;
  std::string text = fmt::format("{:<16}{:>12}{:>10}{:>16}\n", "part", "seconds", "share", "nodes per s");
  const auto row = [&](std::string_view name, double seconds)
  {
    const std::string rate =
        seconds > 0.0 ? fmt::format("{:.3g}", static_cast<double>(node_count) / seconds) : "-";
    text += fmt::format("{:<16}{:>12.3f}{:>9.2f}%{:>16}\n", name, seconds,
                        whole > 0.0 ? 100.0 * seconds / whole : 0.0, rate);
  };
  for (const auto& [name, seconds] : seconds_)
    row(name, seconds);
  row("total", whole);
  return text;
}

}  // namespace blockfsi::command
