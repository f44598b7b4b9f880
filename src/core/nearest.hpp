#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi
{

/// Number of letters to insert, delete, replace or swap with their neighbour to turn one word into another
/// (optimal string alignment; Damerau 1964).
inline std::size_t edit_distance(std::string_view a, std::string_view b)
{
  std::vector<std::size_t> before;
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    before = last;
    last = row;
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t replace = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replace});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

/// The known name that a misspelt one most probably means, or an empty text if none is near: at most a third
/// of the letters may differ, two for short names. `known` is any range of texts.
template <typename Names>
std::string nearest(std::string_view name, const Names& known)
{
  std::string best;
  std::size_t limit = name.size() < 3 ? 2 : std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const auto& candidate : known)
  {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < limit && distance < std::max(name.size(), std::string_view(candidate).size()))
    {
      limit = distance;
      best = candidate;
    }
  }
  return best;
}

/// "; did you mean 'x'?" for the nearest known name, or an empty text.
template <typename Names>
std::string did_you_mean(std::string_view name, const Names& known)
{
  const std::string best = nearest(name, known);
  return best.empty() ? "" : "; did you mean '" + best + "'?";
}

/// The names with ", " between them.
template <typename Names>
std::string listed(const Names& names)
{
  std::string text;
  for (const auto& name : names)
  {
    if (!text.empty())
      text += ", ";
    text += name;
  }
  return text;
}

/// "; did you mean 'x'?" for the nearest known name, else "; known are ..." with all of them.
template <typename Names>
std::string suggestion(std::string_view name, const Names& known)
{
  const std::string hint = did_you_mean(name, known);
  return hint.empty() ? "; known are " + listed(known) : hint;
}

}  // namespace blockfsi
