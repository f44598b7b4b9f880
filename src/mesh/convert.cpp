#include "mesh/convert.hpp"

#include "core/error.hpp"
#include "mesh/part.hpp"
#include "mesh/tensor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace blockfsi::mesh
{

namespace
{

using element::Shape;

/// Numbers that name something shared between cells.
using Key = std::array<std::int64_t, 5>;

/// Puts the first four entries, those of corners, in order; -1, where there are fewer, comes first.
void sort_corners(Key& key)
{
  for (std::size_t end = 1; end < 4; ++end)
    for (std::size_t m = end; m > 0 && key[m] < key[m - 1]; --m)
      std::swap(key[m], key[m - 1]);
}

/// A value for each key, -1 at first: a hash table with open addressing, several times faster than the
/// standard one, which keeps every entry in its own piece of memory.
class Numbering
{
public:
  std::int64_t& operator[](const Key& key)
  {
    if (2 * keys_.size() >= slots_.size())
      grow();
    std::size_t slot = first_slot(key);
    for (; slots_[slot] >= 0; slot = (slot + 1) & (slots_.size() - 1))
      if (keys_[slots_[slot]] == key)
        return values_[slots_[slot]];
    slots_[slot] = static_cast<std::int64_t>(keys_.size());
    keys_.push_back(key);
    return values_.emplace_back(-1);
  }

private:
  std::size_t first_slot(const Key& key) const
  {
    std::uint64_t hash = 0;
    for (const std::int64_t entry : key)
    {
      // An odd constant of splitmix64 (Steele, Lea and Flood 2014).
      hash = (hash ^ static_cast<std::uint64_t>(entry)) * 0xbf58476d1ce4e5b9ULL;
      hash ^= hash >> 31U;
    }
    return hash & (slots_.size() - 1);
  }

  void grow()
  {
    slots_.assign(std::max<std::size_t>(64, 2 * slots_.size()), -1);
    for (std::size_t k = 0; k < keys_.size(); ++k)
    {
      std::size_t slot = first_slot(keys_[k]);
      while (slots_[slot] >= 0)
        slot = (slot + 1) & (slots_.size() - 1);
      slots_[slot] = static_cast<std::int64_t>(k);
    }
  }

  std::vector<std::int64_t> slots_;  ///< a power of two of them; -1: free
  std::vector<Key> keys_;
  std::vector<std::int64_t> values_;
};

/// Angle at corner b of the path a b c in the plane or in space.
double angle(std::span<const double> x, int dim, std::int32_t a, std::int32_t b, std::int32_t c)
{
  double product = 0.0;
  double first = 0.0;
  double second = 0.0;
  for (int d = 0; d < dim; ++d)
  {
    const double p = x[dim * a + d] - x[dim * b + d];
    const double q = x[dim * c + d] - x[dim * b + d];
    product += p * q;
    first += p * p;
    second += q * q;
  }
  return std::acos(std::clamp(product / std::sqrt(first * second), -1.0, 1.0));
}

/// Whether the cut of a quadrilateral from corner 0 to 2 leaves the larger least angle.
bool cut_from_first(std::span<const double> x, int dim, const std::array<std::int32_t, 8>& at)
{
  const auto least = [&](int s)
  {
    const auto corner = [&](int c) { return at[(c + s) % 4]; };
    double result = 4.0;
    for (const auto& [a, b, c] : {std::array{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 3}, {2, 3, 0}, {3, 0, 2}})
      result = std::min(result, angle(x, dim, corner(a), corner(b), corner(c)));
    return result;
  };
  const double first = least(0);
  const double second = least(1);
  // Between equals (up to rounding) the corner of the lowest number decides, as in space.
  if (std::abs(first - second) > 1e-10)
    return first > second;
  return std::min_element(at.begin(), at.begin() + 4) - at.begin() == 0 ||
         std::min_element(at.begin(), at.begin() + 4) - at.begin() == 2;
}

/// Makes the new mesh cell by cell.
class Converter
{
public:
  Converter(const Mesh& mesh, std::span<const double> x, const Conversion& conversion)
      : mesh_(mesh), x_(x), conversion_(conversion),
        order_(conversion.order > 0 ? conversion.order : mesh.order)
  {
    for (int s = 0; s < element::shape_count; ++s)
      weights_.push_back(corner_weights(static_cast<Shape>(s), order_));
    for (const auto& [name, sides] : mesh.boundaries)
    {
      result_.mesh.boundaries[name];
      for (const Side& side : sides)
        named_[{side.cell, side.side}].push_back(name);
    }
  }

  Converted run()
  {
    Mesh& made = result_.mesh;
    made.dim = mesh_.dim;
    made.order = order_;
    made.block_names = mesh_.block_names;
    made.block_regions = mesh_.block_regions;
    for (const CellRun& run : mesh_.runs)
      convert_run(run);
    made.local_node_count = result_.x.size() / mesh_.dim;
    made.total_node_count = static_cast<std::int64_t>(made.local_node_count);
    made.total_cell_count = static_cast<std::int64_t>(made.cell_count());
    project();
    return std::move(result_);
  }

private:
  void convert_run(const CellRun& run)
  {
    PartTables tables(run.shape, mesh_.order, order_);
    std::vector<CellPart> parts = fixed_parts(run.shape);
    for (std::int32_t c = run.first; c < run.first + run.count; ++c)
    {
      name_entities(tables, c);
      if (conversion_.to == Target::tetrahedra)
        parts = tetrahedra(run.shape, corners_);
      if (conversion_.to == Target::triangles && run.shape == Shape::quadrilateral)
        parts = two_triangles(cut_from_first(x_, mesh_.dim, corners_));
      for (const CellPart& part : parts)
        add_part(tables, tables.of(part), c);
    }
  }

  /// Parts of cells of a shape that are the same for all of them.
  std::vector<CellPart> fixed_parts(Shape shape) const
  {
    const Target to = conversion_.to;
    if (to == Target::triangles_with_centres && shape == Shape::quadrilateral)
      return four_triangles();
    if (to == Target::quadrilaterals && !mesh_.is_all(Shape::quadrilateral))
      return quadrilaterals(shape);
    if (to == Target::hexahedra && !mesh_.is_all(Shape::hexahedron))
      return hexahedra(shape);
    return whole(shape);
  }

  /// Nodes of the corners of a cell, and a number for each of its entities.
  void name_entities(const PartTables& tables, std::int32_t c)
  {
    const std::span<const std::int32_t> nodes = mesh_.cell(c);
    corners_.fill(-1);
    for (std::size_t k = 0; k < tables.corners.size(); ++k)
      corners_[k] = nodes[tables.corners[k]];
    entity_numbers_.clear();
    for (std::size_t e = 0; e + 1 < tables.entities.corners.size(); ++e)
    {
      Key key;
      key.fill(-1);
      std::size_t count = 0;
      for (std::size_t k = 0; k < tables.corners.size(); ++k)
        if ((tables.entities.corners[e] >> k & 1U) != 0)
          key[count++] = corners_[k];
      sort_corners(key);
      std::int64_t lowest = -1;
      for (const std::int32_t position : tables.entities.nodes[e])
      {
        const bool is_corner = std::find(key.begin(), key.begin() + 4, nodes[position]) != key.begin() + 4;
        if (!is_corner && (lowest < 0 || nodes[position] < lowest))
          lowest = nodes[position];
      }
      key[4] = lowest;
      std::int64_t& number = entities_[key];
      if (number < 0)
        number = entity_count_++;
      entity_numbers_.push_back(number);
    }
    // The cell itself is shared with none.
    entity_numbers_.push_back(entity_count_++);
  }

  void add_part(const PartTables& tables, const PartNodes& nodes, std::int32_t parent)
  {
    Mesh& made = result_.mesh;
    const auto cell = static_cast<std::int32_t>(made.cell_count());
    const Shape shape = nodes.part.shape;
    if (made.runs.empty() || made.runs.back().shape != shape)
      made.runs.push_back({shape, cell, 0, static_cast<std::int64_t>(made.cells.size())});
    ++made.runs.back().count;
    made.cell_block.push_back(mesh_.cell_block[parent]);
    result_.parent.push_back(parent);
    // A corner is the entity of which it is the middle.
    std::array<std::int64_t, element::max_corners> corner{};
    for (int c = 0; c < element::corner_count(shape); ++c)
      corner[c] = entity_numbers_[tables.entities.holding(nodes.part.corners[c])];
    for (std::size_t n = 0; n < nodes.entity.size(); ++n)
      made.cells.push_back(node(nodes, n, corner, parent));
    add_sides(tables.shape, nodes, parent, cell);
  }

  /// A node is named by the entity of the old mesh on which it lies, and by what the corners of the part
  /// count in it.
  std::int32_t node(const PartNodes& nodes, std::size_t n,
                    const std::array<std::int64_t, element::max_corners>& corner, std::int32_t parent)
  {
    const Weights& weights = weights_[static_cast<std::size_t>(nodes.part.shape)][n];
    Key key;
    key.fill(-1);
    std::size_t count = 0;
    for (int c = 0; c < element::corner_count(nodes.part.shape); ++c)
    {
      // More than four corners: inside a part, and its own.
      if (weights[c] > 0 && ++count > 4)
        return place(nodes, n, parent);
      if (weights[c] > 0)
        key[count - 1] = corner[c] << 32U | weights[c];
    }
    sort_corners(key);
    // At a corner the entity is the corner.
    key[4] = count == 1 ? -1 : entity_numbers_[nodes.entity[n]];
    std::int64_t& number = nodes_[key];
    if (number < 0)
      number = place(nodes, n, parent);
    return static_cast<std::int32_t>(number);
  }

  /// A new node: its number.
  std::int32_t place(const PartNodes& nodes, std::size_t n, std::int32_t parent)
  {
    const std::span<const std::int32_t> old = mesh_.cell(parent);
    const std::span<const double> row = std::span(nodes.matrix).subspan(n * old.size(), old.size());
    // A node of the old cell keeps its coordinates bit for bit.
    const auto whole_weight =
        std::find_if(row.begin(), row.end(), [](double w) { return std::abs(w - 1.0) < 1e-13; });
    is_old_.push_back(whole_weight != row.end());
    for (int d = 0; d < mesh_.dim; ++d)
    {
      // Relative to one node, so that a place far from the origin costs no digits.
      const double origin = x_[static_cast<std::size_t>(mesh_.dim) * old[0] + d];
      double sum = 0.0;
      for (std::size_t k = 0; k < old.size(); ++k)
        sum += row[k] * (x_[static_cast<std::size_t>(mesh_.dim) * old[k] + d] - origin);
      result_.x.push_back(whole_weight != row.end()
                              ? x_[static_cast<std::size_t>(mesh_.dim) * old[whole_weight - row.begin()] + d]
                              : origin + sum);
    }
    return static_cast<std::int32_t>(is_old_.size() - 1);
  }

  void add_sides(Shape shape, const PartNodes& nodes, std::int32_t parent, std::int32_t cell)
  {
    for (std::int32_t old = 0; old < static_cast<std::int32_t>(element::sides(shape).size()); ++old)
    {
      const auto names = named_.find({parent, old});
      if (names == named_.end())
        continue;
      const Mean corners = side_corners(shape, old);
      for (std::size_t side = 0; side < nodes.side.size(); ++side)
        if ((corners & nodes.side[side]) == nodes.side[side])
          for (const std::string_view name : names->second)
            result_.mesh.boundaries.find(name)->second.push_back({cell, static_cast<std::int32_t>(side)});
    }
  }

  void project()
  {
    if (!conversion_.project)
      return;
    std::vector<bool> done = is_old_;
    const Mesh& made = result_.mesh;
    for (const auto& [name, sides] : made.boundaries)
      for (const Side& side : sides)
        for (const std::int32_t position : element::side_lattice(made.shape(side.cell), order_, side.side))
        {
          const std::int32_t at = made.cell(side.cell)[position];
          if (done[at])
            continue;
          done[at] = true;
          conversion_.project(
              name, std::span(result_.x).subspan(static_cast<std::size_t>(mesh_.dim) * at, mesh_.dim));
        }
  }

  const Mesh& mesh_;
  std::span<const double> x_;
  const Conversion& conversion_;
  int order_;
  std::vector<std::vector<Weights>> weights_;  ///< by shape
  std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::string_view>> named_;
  Numbering entities_;
  std::int64_t entity_count_ = 0;
  Numbering nodes_;
  std::array<std::int32_t, 8> corners_{};     ///< nodes of the corners of the present cell
  std::vector<std::int64_t> entity_numbers_;  ///< of the present cell
  std::vector<bool> is_old_;                  ///< whether a node was one before
  Converted result_;
};

void check(const Mesh& mesh, std::span<const double> x, const Conversion& conversion)
{
  check_order(mesh.order);
  if (conversion.order != 0)
    check_order(conversion.order);
  if (x.size() != mesh.dim * mesh.node_count())
    throw Error(fmt::format("{} coordinates were given for {} nodes in {} dimensions", x.size(),
                            mesh.node_count(), mesh.dim));
  if (mesh.total_cell_count != static_cast<std::int64_t>(mesh.cell_count()))
    throw Error(fmt::format("only a whole mesh can be converted, and this is {} of {} cells",
                            mesh.cell_count(), mesh.total_cell_count));
  const Target to = conversion.to;
  const bool to_flat =
      to == Target::triangles || to == Target::triangles_with_centres || to == Target::quadrilaterals;
  for (const CellRun& run : mesh.runs)
  {
    const bool is_flat = element::dimension(run.shape) == 2;
    if (to != Target::same && to_flat != is_flat)
      throw Error(fmt::format("cells of the shape {} cannot be made into {}", element::name(run.shape),
                              to_flat ? "triangles or quadrilaterals" : "tetrahedra or hexahedra"));
    if (to == Target::hexahedra && run.shape == Shape::pyramid)
      throw Error("no pyramid can be cut into hexahedra; make tetrahedra of the mesh first, then hexahedra");
  }
}

}  // namespace

Converted convert(const Mesh& mesh, std::span<const double> x, const Conversion& conversion)
{
  check(mesh, x, conversion);
  return Converter(mesh, x, conversion).run();
}

}  // namespace blockfsi::mesh
