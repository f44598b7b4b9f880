#include "case/pieces.hpp"

#include "block/transform.hpp"
#include "case/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace blockfsi::case_file
{

std::vector<PieceKind> all_kinds()
{
  std::vector<PieceKind> kinds = {{{"lattice", "tables NAME", "", "", "drawn lattices of blocks"},
                                   [](const Field& field, Reading& reading, Pieces&, block::Layout& layout)
                                   { read_lattice(field, reading, layout); },
                                   lattice_sections}};
  for (const auto more : {round_kinds(), sweep_kinds(), tube_kinds()})
    kinds.insert(kinds.end(), more.begin(), more.end());
  return kinds;
}

Pieces::Pieces(const Value& value, Reading& reading, block::Layout empty)
    : reading_(reading), empty_(std::move(empty)), kinds_(all_kinds())
{
  for (const Field& group : table(value))
  {
    const auto kind = std::find_if(kinds_.begin(), kinds_.end(),
                                   [&](const PieceKind& k) { return k.says.name == group.name; });
    if (kind == kinds_.end())
      continue;
    for (const Field& field : table(group.value))
    {
      for (const Entry& other : entries_)
        if (other.field.name == field.name)
          throw Error(field.where, fmt::format("{}: the name '{}' is taken by {}; choose another",
                                               field.value.path, field.name, other.field.value.path));
      entries_.push_back({field, &*kind, empty_});
    }
  }
}

void Pieces::make(Entry& entry)
{
  if (entry.state == Entry::State::done)
    return;
  if (entry.state == Entry::State::busy)
    throw Error(entry.field.where,
                fmt::format("{}: is made from itself, by way of other pieces; break the circle",
                            entry.field.value.path));
  entry.state = Entry::State::busy;
  entry.kind->read(entry.field, reading_, *this, entry.layout);
  entry.state = Entry::State::done;
}

const block::Layout& Pieces::get(const Value& name, bool consumed)
{
  const std::string& wanted = text(name);
  const auto entry =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.field.name == wanted; });
  if (entry == entries_.end())
  {
    std::vector<std::string> known;
    for (const Entry& e : entries_)
      known.push_back(e.field.name);
    fail(name, fmt::format("found \"{}\", allowed is the name of a piece: {}{}", wanted, listed(known),
                           did_you_mean(wanted, known)));
  }
  make(*entry);
  entry->consumed = entry->consumed || consumed;
  return entry->layout;
}

void Pieces::append_to(block::Layout& layout)
{
  for (Entry& entry : entries_)
    make(entry);
  for (const Entry& entry : entries_)
    if (!entry.consumed)
      block::append(layout, entry.layout);
}

}  // namespace blockfsi::case_file
