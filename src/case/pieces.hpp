#pragma once

#include "block/layout.hpp"
#include "case/key.hpp"

#include <span>
#include <string>
#include <vector>

namespace blockfsi::case_file
{

class Pieces;

/// A way to make blocks: a table [blocks.KIND.NAME]. Pieces may be made from others, whatever their order in
/// the file.
struct PieceKind
{
  Description says;
  /// Adds the blocks of NAME to an empty layout.
  void (*read)(const Field& field, Reading& reading, Pieces& pieces, block::Layout& layout);
  std::vector<Section> (*sections)();
};

std::span<const PieceKind> round_kinds();  ///< box, disc, annulus, channel, ball, shell
std::span<const PieceKind> sweep_kinds();  ///< extrude, revolve, copy, mirror, rotate
std::span<const PieceKind> tube_kinds();   ///< tubes
std::vector<PieceKind> all_kinds();

/// The pieces of [blocks], made when they are first asked for.
class Pieces
{
public:
  /// `value` is [blocks]; `empty` has its dimension, order and default divisions. Throws Error for names in
  /// use.
  Pieces(const Value& value, Reading& reading, block::Layout empty);

  /// The piece of a name, for a piece that is made from it; `consumed`: it is no part of the domain itself.
  /// Throws Error at the value for an unknown name and for pieces made from each other in a circle.
  const block::Layout& get(const Value& name, bool consumed);

  /// Appends all pieces that were not consumed, in the order of the file.
  void append_to(block::Layout& layout);

private:
  struct Entry
  {
    Field field;
    const PieceKind* kind;
    block::Layout layout;
    enum class State
    {
      open,
      busy,
      done
    } state = State::open;
    bool consumed = false;
  };
  void make(Entry& entry);

  Reading& reading_;
  block::Layout empty_;
  std::vector<PieceKind> kinds_;
  std::vector<Entry> entries_;
};

}  // namespace blockfsi::case_file
