#include "block/connect.hpp"

#include "layouts.hpp"

#include <doctest/doctest.h>

#include <random>
#include <set>

using namespace blockfsi;
using namespace blockfsi::block;
using namespace blockfsi::block::testing;

namespace
{

/// Two blocks, left and right of a curved edge, each listing its points from another corner on; the edge is
/// described from below or from above.
Layout two_blocks(int first_corner, bool from_below, int order)
{
  Layout layout;
  layout.order = order;
  layout.default_divisions = 3;
  const std::array<std::array<double, 2>, 6> at{{{0, 0}, {1, 0}, {2.2, 0}, {0, 1}, {1.1, 1}, {2, 1.3}}};
  for (int p = 0; p < 6; ++p)
    layout.points.push_back({"p" + std::to_string(p), {at[p][0], at[p][1], 0.0}, {}});
  layout.blocks.push_back({"left", "fluid", {0, 1, 4, 3}, {}});
  const std::array<int, 4> right{1, 2, 5, 4};
  Block turned{"right", "solid", {}, {}};
  for (int c = 0; c < 4; ++c)
    turned.points.push_back(right[(c + first_corner) % 4]);
  layout.blocks.push_back(turned);
  Edge& edge = add_edge(layout, from_below ? 1 : 4, from_below ? 4 : 1);
  edge.curve = geometry::Through{{{1.2, from_below ? 0.4 : 0.6, 0.0}}};
  edge.grading = Geometric{1.5};
  close(layout);
  return layout;
}

/// Coordinates by lattice number.
std::map<std::int64_t, std::array<double, 2>> by_number(const Connected& connected, const Skeleton& skeleton)
{
  const std::vector<double> x = place(connected, skeleton);
  std::map<std::int64_t, std::array<double, 2>> result;
  for (std::size_t n = 0; n < connected.mesh.node_count(); ++n)
    result[lattice_number(connected.mesh, n)] = {x[2 * n], x[2 * n + 1]};
  return result;
}

/// Row of a cell in lattice numbers.
std::vector<std::int64_t> row(const mesh::Mesh& mesh, std::size_t c)
{
  std::vector<std::int64_t> numbers;
  for (const std::int32_t node : mesh.cell(c))
    numbers.push_back(lattice_number(mesh, node));
  return numbers;
}

/// All parts of one mesh put together again, as numbers of the whole.
struct Union
{
  std::map<std::int64_t, std::vector<std::int64_t>> cells;
  std::map<std::int64_t, int> blocks;
  std::map<std::string, std::set<std::pair<std::int64_t, int>>> boundaries;
  std::map<std::int64_t, std::set<int>> owners;
  std::map<std::int64_t, int> lowest_rank;
  std::map<std::int64_t, std::array<double, 2>> x;

  bool operator==(const Union&) const = default;
};

void add_part(Union& whole, const Connected& part, const Skeleton& skeleton, int rank)
{
  const mesh::Mesh& mesh = part.mesh;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
  {
    const std::int64_t number = mesh.number_of_cell(c);
    CHECK(whole.cells.count(number) == 0);
    whole.cells[number] = row(mesh, c);
    whole.blocks[number] = mesh.cell_block[c];
    for (const std::int64_t node : row(mesh, c))
      whole.lowest_rank.try_emplace(node, rank);
  }
  for (std::size_t n = 0; n < mesh.node_count(); ++n)
    whole.owners[lattice_number(mesh, n)].insert(mesh.owner.empty() ? 0 : mesh.owner[n]);
  for (const auto& [name, sides] : mesh.boundaries)
    for (const auto& side : sides)
      whole.boundaries[name].insert({mesh.number_of_cell(side.cell), side.side});
  for (const auto& [number, x] : by_number(part, skeleton))
  {
    const auto [known, is_new] = whole.x.try_emplace(number, x);
    CHECK((is_new || known->second == x));
  }
}

Union unite(const Layout& layout, const Skeleton& skeleton, std::string_view region, int size)
{
  Union whole;
  for (int rank = 0; rank < size; ++rank)
    add_part(whole, connect(layout, skeleton, region, {rank, size}), skeleton, rank);
  return whole;
}

}  // namespace

TEST_CASE("two blocks agree bit for bit on their common curved edge in all eight relative orientations")
{
  for (const int order : {1, 2, 5})
    for (int first_corner = 0; first_corner < 4; ++first_corner)
      for (const bool from_below : {true, false})
      {
        const Layout layout = two_blocks(first_corner, from_below, order);
        const Skeleton skeleton = make_skeleton(layout);
        const auto left = by_number(connect(layout, skeleton, "fluid", {}), skeleton);
        const auto right = by_number(connect(layout, skeleton, "solid", {}), skeleton);
        const std::vector<std::int64_t> shared = interface_nodes(layout, skeleton, "solid", "fluid");
        CHECK(shared.size() == 3u * order + 1);
        for (const std::int64_t node : shared)
          CHECK(left.at(node) == right.at(node));
        CHECK(left.size() + right.size() - shared.size() ==
              by_number(connect(layout, skeleton, "", {}), skeleton).size());
      }
}

TEST_CASE("the orientation of a block changes neither area nor validity of its cells")
{
  double area = 0.0;
  for (int first_corner = 0; first_corner < 4; ++first_corner)
  {
    const Layout layout = two_blocks(first_corner, true, 3);
    const Skeleton skeleton = make_skeleton(layout);
    const Connected all = connect(layout, skeleton, "", {});
    const Measure found = measure(all.mesh, place(all, skeleton));
    if (first_corner == 0)
      area = found.area;
    CHECK(found.area == doctest::Approx(area).epsilon(1e-14));
    CHECK(found.smallest > 0.0);
  }
}

TEST_CASE("every node has its own place: no two numbers share a position, each cell's nodes are distinct")
{
  for (int order = 1; order <= 4; ++order)
  {
    const Layout layout = flap_layout(order);
    const Skeleton skeleton = make_skeleton(layout);
    const Connected all = connect(layout, skeleton, "", {});
    std::set<std::array<long, 2>> places;
    for (const auto& [number, x] : by_number(all, skeleton))
      places.insert({std::lround(x[0] * 1e9), std::lround(x[1] * 1e9)});
    CHECK(places.size() == all.mesh.node_count());
    CHECK(all.mesh.total_node_count == static_cast<std::int64_t>(all.mesh.node_count()));
    // Euler: one hole, so vertices - edges + faces = 0; a lattice of order p has V + (p-1) E + (p-1)^2 F
    // nodes.
    const auto cells = static_cast<std::int64_t>(all.mesh.cell_count());
    std::set<std::int64_t> vertices;
    for (std::size_t c = 0; c < all.mesh.cell_count(); ++c)
      for (const int corner : {0, order, order * (order + 1), (order + 1) * (order + 1) - 1})
        vertices.insert(lattice_number(all.mesh, all.mesh.cell(c)[corner]));
    const auto edges = static_cast<std::int64_t>(vertices.size()) + cells;
    CHECK(all.mesh.total_node_count == static_cast<std::int64_t>(vertices.size()) + (order - 1) * edges +
                                           (order - 1) * (order - 1) * cells);
  }
}

TEST_CASE("the parts of a distributed mesh make up the serial mesh, and all agree on the owners")
{
  for (const int order : {1, 3})
  {
    const Layout layout = flap_layout(order);
    const Skeleton skeleton = make_skeleton(layout);
    for (const std::string_view region : {"", "fluid", "flap"})
    {
      const Union serial = unite(layout, skeleton, region, 1);
      const mesh::Mesh whole = connect(layout, skeleton, region, {}).mesh;
      CHECK(serial.cells.size() == static_cast<std::size_t>(whole.total_cell_count));
      CHECK(serial.x.size() == static_cast<std::size_t>(whole.total_node_count));
      for (const int size : {2, 3, 5, 7})
      {
        const Union parts = unite(layout, skeleton, region, size);
        CHECK(parts.cells == serial.cells);
        CHECK(parts.blocks == serial.blocks);
        CHECK(parts.boundaries == serial.boundaries);
        CHECK(parts.x == serial.x);
        for (const auto& [node, owners] : parts.owners)
        {
          CHECK(owners.size() == 1);
          CHECK(*owners.begin() == parts.lowest_rank.at(node));
        }
      }
    }
  }
}

TEST_CASE("shares are contiguous runs of cells, equally long to one, nodes ascend, and all know all names")
{
  const Layout layout = flap_layout(2);
  const Skeleton skeleton = make_skeleton(layout);
  std::int64_t next = 0;
  for (int rank = 0; rank < 7; ++rank)
  {
    const mesh::Mesh part = connect(layout, skeleton, "fluid", {rank, 7}).mesh;
    CHECK(part.cell_count() >= static_cast<std::size_t>(part.total_cell_count / 7));
    CHECK(part.cell_count() <= static_cast<std::size_t>(part.total_cell_count / 7 + 1));
    for (const std::int64_t cell : part.cell_number)
      CHECK(cell == next++);
    CHECK(std::is_sorted(part.lattice.begin(), part.lattice.end()));
    std::vector<std::string> names;
    for (const auto& [name, sides] : part.boundaries)
      names.push_back(name);
    CHECK(names == std::vector<std::string>{"inlet", "interface", "outlet", "sides", "square"});
  }
}

TEST_CASE("a process may get no cells at all")
{
  const Layout layout = unit_square(2, 1);
  const Skeleton skeleton = make_skeleton(layout);
  const Union serial = unite(layout, skeleton, "", 1);
  const Union parts = unite(layout, skeleton, "", 3);
  CHECK(parts.cells == serial.cells);
  CHECK(connect(layout, skeleton, "", {0, 3}).mesh.node_count() == 0);
}

TEST_CASE("boundary sides lie on their boundaries")
{
  const Layout layout = flap_layout(3);
  const Skeleton skeleton = make_skeleton(layout);
  const Connected fluid = connect(layout, skeleton, "fluid", {});
  const std::vector<double> x = place(fluid, skeleton);
  const std::map<std::string, std::pair<std::size_t, Condition>> wanted{
      {"inlet", {4 + 2 + 1 + 2 + 4, Condition("x = 0", {})}},
      {"outlet", {4 + 2 + 1 + 2 + 4, Condition("x = 0.195", {})}},
      {"sides", {2 * (4 + 2 + 5 + 6), Condition("y = 0 or y = 0.12", {})}},
      {"square",
       {2 * 2 + (2 + 1 + 2) + (2 + 2),
        Condition("x >= 0.045 and x <= 0.055 and y >= 0.055 and y <= 0.065", {})}},
      {"interface", {5 + 5 + 1, Condition("y = 0.0603 or y = 0.0597 or x = 0.095", {})}}};
  for (const auto& [name, expected] : wanted)
  {
    const auto& sides = fluid.mesh.boundaries.at(name);
    CHECK(sides.size() == expected.first);
    for (const auto& side : sides)
      for (int k = 0; k <= 3; ++k)
      {
        const int node = fluid.mesh.cell(side.cell)[mesh::side_node(3, side.side, k)];
        CHECK(expected.second.holds(x[2 * node], x[2 * node + 1], 0.0, 1e-12));
      }
  }
}

TEST_CASE("meshes of two regions share just the interface nodes")
{
  const Layout layout = flap_layout(2);
  const Skeleton skeleton = make_skeleton(layout);
  const std::vector<std::int64_t> fluid = connect(layout, skeleton, "fluid", {}).mesh.lattice;
  const std::vector<std::int64_t> flap = connect(layout, skeleton, "flap", {}).mesh.lattice;
  std::vector<std::int64_t> shared;
  std::set_intersection(fluid.begin(), fluid.end(), flap.begin(), flap.end(), std::back_inserter(shared));
  CHECK(shared == interface_nodes(layout, skeleton, "fluid", "flap"));
  CHECK(shared.size() == 2u * (5 + 1 + 5) + 1);
  CHECK(interface_nodes(layout, skeleton, "fluid", "fluid").empty());
}

TEST_CASE("an unknown region is refused with the nearest known one")
{
  const Layout layout = flap_layout(1);
  const Skeleton skeleton = make_skeleton(layout);
  CHECK(message_of([&] { connect(layout, skeleton, "flop", {}); }) ==
        "no block belongs to the region 'flop'; the regions are flap, fluid; did you mean 'flap'?");
}
