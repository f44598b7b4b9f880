#pragma once

namespace blockfsi
{

/// Whether a character only separates others in texts and files; no locale changes that.
constexpr bool is_space(char c)
{
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

}  // namespace blockfsi
