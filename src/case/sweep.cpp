#include "block/sweep.hpp"

#include "block/transform.hpp"
#include "case/edge.hpp"
#include "case/level_set.hpp"
#include "case/pieces.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace blockfsi::case_file
{

namespace
{

constexpr double degrees = std::numbers::pi / 180.0;

/// A piece made from another one: what its keys say, and the piece.
template <typename T>
struct Derived
{
  T says;
  Pieces& pieces;
  const block::Layout* base = nullptr;
};

template <typename T>
Key<Derived<T>> of_key()
{
  return {{"of", "text", "required", "", "the piece that it is made from"},
          [](const Value& v, Reading&, Derived<T>& d)
          {
            d.base = &d.pieces.get(v, T::consumes);
            d.says.of = text(v);
          }};
}

struct Extrude : block::Extrusion
{
  static constexpr bool consumes = true;
};

const Keys<Derived<Extrude>>& extrude_keys()
{
  using D = Derived<Extrude>;
  static const Keys<D> keys = {
      of_key<Extrude>(),
      {{"by", "[number, number, number]", "required", "m", "the way along which it is drawn"},
       [](const Value& v, Reading& r, D& d) { d.says.by = point_in_space(v, r.constants); }},
      {{"divide", "whole number", "1", "", "cells along the way"},
       [](const Value& v, Reading& r, D& d) { d.says.divisions = integer(v, r.constants, 1, most_cells); }},
      {{"grade", "grading", "uniform", "", "of these cells"},
       [](const Value& v, Reading& r, D& d) { d.says.grading = read_grading(v, r); }}};
  return keys;
}

struct Revolve : block::Revolution
{
  static constexpr bool consumes = true;
};

const Keys<Derived<Revolve>>& revolve_keys()
{
  using D = Derived<Revolve>;
  static const Keys<D> keys = {
      of_key<Revolve>(),
      {{"center", "list of numbers", "the origin", "m", "a point of the axis"},
       [](const Value& v, Reading& r, D& d) { d.says.center = point_in_space(v, r.constants); }},
      {{"axis", "list of numbers", "[0, 1]", "", "direction of the axis, in the plane of the blocks"},
       [](const Value& v, Reading& r, D& d) { d.says.axis = point_in_space(v, r.constants); }},
      {{"angle", "number", "360", "degrees", "right-handed about the axis"},
       [](const Value& v, Reading& r, D& d) { d.says.angle = number(v, r.constants, positive); }},
      {{"sectors", "whole number", "4", "", "blocks around, each less than half a turn"},
       [](const Value& v, Reading& r, D& d) { d.says.sectors = integer(v, r.constants, 1, most_cells); }},
      {{"around", "whole number", "4", "", "cells along each of them"},
       [](const Value& v, Reading& r, D& d) { d.says.around = integer(v, r.constants, 1, most_cells); }}};
  return keys;
}

struct Copy
{
  static constexpr bool consumes = false;
  std::string of;
  geometry::Point by{};
  geometry::Point center{};
  geometry::Point axis{0.0, 0.0, 1.0};
  double angle = 0.0;
  int times = 1;
};

const Keys<Derived<Copy>>& copy_keys()
{
  using D = Derived<Copy>;
  static const Keys<D> keys = {
      of_key<Copy>(),
      {{"by", "list of numbers", "none", "m", "how far each copy lies from the one before"},
       [](const Value& v, Reading& r, D& d) { d.says.by = point_in_space(v, r.constants); }},
      {{"angle", "number", "0", "degrees", "by which each copy is turned against the one before"},
       [](const Value& v, Reading& r, D& d) { d.says.angle = number(v, r.constants); }},
      {{"center", "list of numbers", "the origin", "m", "a point of the axis about which it is turned"},
       [](const Value& v, Reading& r, D& d) { d.says.center = point_in_space(v, r.constants); }},
      {{"axis", "list of numbers", "[0, 0, 1]", "", "direction of that axis"},
       [](const Value& v, Reading& r, D& d) { d.says.axis = point_in_space(v, r.constants); }},
      {{"times", "whole number", "1", "",
        "number of copies; those of more than one are called NAME 1, NAME 2, ..."},
       [](const Value& v, Reading& r, D& d) { d.says.times = integer(v, r.constants, 1, most_cells); }}};
  return keys;
}

struct Mirror
{
  static constexpr bool consumes = false;
  std::string of;
  geometry::Point center{};
  geometry::Point normal{};
};

const Keys<Derived<Mirror>>& mirror_keys()
{
  using D = Derived<Mirror>;
  static const Keys<D> keys = {
      of_key<Mirror>(),
      {{"center", "list of numbers", "the origin", "m",
        "a point of the plane, in 2D the line, of the mirror"},
       [](const Value& v, Reading& r, D& d) { d.says.center = point_in_space(v, r.constants); }},
      {{"normal", "list of numbers", "required", "", "direction across it"},
       [](const Value& v, Reading& r, D& d) { d.says.normal = point_in_space(v, r.constants); }}};
  return keys;
}

template <typename T>
Derived<T> read_derived(const Field& field, const Keys<Derived<T>>& keys, Reading& reading, Pieces& pieces)
{
  Derived<T> derived{{}, pieces};
  if constexpr (T::consumes)
  {
    derived.says.name = field.name;
    derived.says.where = field.where;
  }
  read_keys(field.value, keys, reading, derived);
  return derived;
}

void read_extrude(const Field& field, Reading& reading, Pieces& pieces, block::Layout& layout)
{
  const auto derived = read_derived<Extrude>(field, extrude_keys(), reading, pieces);
  block::append(layout, block::extruded(*derived.base, derived.says));
}

void read_revolve(const Field& field, Reading& reading, Pieces& pieces, block::Layout& layout)
{
  const auto derived = read_derived<Revolve>(field, revolve_keys(), reading, pieces);
  block::append(layout, block::revolved(*derived.base, derived.says));
}

void read_copy(const Field& field, Reading& reading, Pieces& pieces, block::Layout& layout)
{
  const auto derived = read_derived<Copy>(field, copy_keys(), reading, pieces);
  const Copy& copy = derived.says;
  for (int k = 1; k <= copy.times; ++k)
  {
    block::Affine map = placed(field.value, [&]
                               { return block::rotation(copy.center, copy.axis, k * copy.angle * degrees); });
    map.shift = geometry::add(map.shift, geometry::scaled(k, copy.by));
    const std::string name = copy.times == 1 ? field.name : field.name + " " + std::to_string(k);
    block::append(layout, block::transformed(*derived.base, map, copy.of, name));
  }
}

void read_mirror(const Field& field, Reading& reading, Pieces& pieces, block::Layout& layout)
{
  const auto derived = read_derived<Mirror>(field, mirror_keys(), reading, pieces);
  const block::Affine map =
      placed(field.value, [&] { return block::reflection(derived.says.center, derived.says.normal); });
  block::append(layout, block::transformed(*derived.base, map, derived.says.of, field.name));
}

}  // namespace

std::span<const PieceKind> sweep_kinds()
{
  static const std::array<PieceKind, 4> kinds = {
      {{{"extrude", "tables NAME", "", "", "pieces of the plane drawn along a vector"},
        read_extrude,
        []
        {
          return std::vector<Section>{
              section("[blocks.extrude.NAME]",
                      "replaces the piece; boundaries \"NAME first\", \"NAME last\" and those "
                      "of the piece",
                      extrude_keys())};
        }},
       {{"revolve", "tables NAME", "", "", "pieces of the plane turned about an axis"},
        read_revolve,
        []
        {
          return std::vector<Section>{
              section("[blocks.revolve.NAME]",
                      "replaces the piece; boundaries \"NAME first\", \"NAME last\" and those "
                      "of the piece",
                      revolve_keys())};
        }},
       {{"copy", "tables NAME", "", "", "pieces moved and turned, beside the original"},
        read_copy,
        [] {
          return std::vector<Section>{section("[blocks.copy.NAME]", "first turned, then moved", copy_keys())};
        }},
       {{"mirror", "tables NAME", "", "", "pieces mirrored, beside the original"}, read_mirror, [] {
          return std::vector<Section>{section("[blocks.mirror.NAME]", "", mirror_keys())};
        }}}};
  return kinds;
}

}  // namespace blockfsi::case_file
