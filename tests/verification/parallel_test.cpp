// The same on any number of processes: run by one, two and three.

#include "support.hpp"

#include "block/corner_layout.hpp"
#include "fem/boundary.hpp"
#include "fem/cell_loop.hpp"
#include "fluid/solver.hpp"
#include "linalg/communicator.hpp"
#include "motion/update.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

using namespace blockfsi;
using verification::formula;

namespace
{

verification::Domain domain(int order)
{
  return verification::rectangle({0.0, 0.0}, {1.0, 1.0}, 3, order, 0.08, "fluid");
}

/// How many cells meet at each node of the whole mesh, by its number in the lattice.
std::map<std::int64_t, double> cells_at_nodes(const verification::Domain& domain)
{
  const block::Connected whole = block::connect(domain.layout, domain.skeleton, "fluid", {0, 1});
  std::map<std::int64_t, double> count;
  for (const std::int32_t node : whole.mesh.cells)
    count[whole.mesh.lattice[node]] += 1.0;
  return count;
}

}  // namespace

TEST_CASE("all processes together own each node once and number them without gaps")
{
  for (const int order : {1, 3})
  {
    const verification::Domain part = domain(order);
    const linalg::Numbering& numbering = part.numbering;
    const std::int64_t total = part.mesh().total_node_count;
    CHECK(numbering.total_count() == total);
    CHECK(linalg::sum(numbering.owned_count()) == total);
    std::vector<double> seen(static_cast<std::size_t>(total), 0.0);
    for (const std::int32_t node : numbering.owned())
      seen[numbering.global(node)] += 1.0;
    linalg::sum(seen);
    CHECK(std::all_of(seen.begin(), seen.end(), [](double count) { return count == 1.0; }));
    // A node has the same number on every process: sums over all that have it are multiples of it.
    std::vector<double> by_number(static_cast<std::size_t>(total), 0.0);
    std::vector<double> copies(static_cast<std::size_t>(total), 0.0);
    const std::map<std::int64_t, double> whole = cells_at_nodes(part);
    std::size_t k = 0;
    std::map<std::int64_t, std::size_t> row;
    for (const auto& [lattice, count] : whole)
      row[lattice] = k++;
    for (std::size_t node = 0; node < numbering.node_count(); ++node)
    {
      by_number[row[part.mesh().lattice[node]]] += numbering.global(node);
      copies[row[part.mesh().lattice[node]]] += 1.0;
    }
    linalg::sum(by_number);
    linalg::sum(copies);
    for (std::size_t node = 0; node < numbering.node_count(); ++node)
    {
      const std::size_t i = row[part.mesh().lattice[node]];
      CHECK(by_number[i] == copies[i] * numbering.global(node));
    }
  }
}

TEST_CASE("ghosts receive the values of their owners")
{
  const verification::Domain part = domain(3);
  const std::size_t count = part.mesh().node_count();
  std::vector<double> values(2 * count, -1.0);
  for (const std::int32_t node : part.numbering.owned())
    for (int c = 0; c < 2; ++c)
      values[2 * node + c] = 2.0 * static_cast<double>(part.mesh().lattice[node]) + c;
  part.numbering.update_ghosts(values, 2);
  for (std::size_t i = 0; i < values.size(); ++i)
    CHECK(values[i] == 2.0 * static_cast<double>(part.mesh().lattice[i / 2]) + static_cast<double>(i % 2));
}

TEST_CASE("contributions of all processes add up to those of one")
{
  const verification::Domain part = domain(3);
  std::vector<double> values(part.mesh().node_count(), 0.0);
  for (const std::int32_t node : part.mesh().cells)
    values[node] += 1.0;
  part.numbering.add_from_ghosts(values, 1);
  const std::map<std::int64_t, double> whole = cells_at_nodes(part);
  for (const std::int32_t node : part.numbering.owned())
    CHECK(values[node] == whole.at(part.mesh().lattice[node]));
}

TEST_CASE("the nodes on a boundary are marked on processes that have no side there too")
{
  const verification::Domain part = domain(2);
  for (const char* name : {"left", "right", "bottom", "top"})
  {
    const block::Connected whole = block::connect(part.layout, part.skeleton, "fluid", {0, 1});
    std::map<std::int64_t, bool> on;
    for (const mesh::Side& side : whole.mesh.boundaries.find(name)->second)
      for (int k = 0; k <= 2; ++k)
        on[whole.mesh.lattice[whole.mesh.cell(side.cell)[mesh::side_node(2, side.side, k)]]] = true;
    const std::vector<std::uint8_t> marks = fem::nodes_on(part.mesh(), part.numbering, name);
    for (std::size_t node = 0; node < marks.size(); ++node)
      CHECK((marks[node] != 0) == on.contains(part.mesh().lattice[node]));
  }
}

TEST_CASE("steps of a flow give the same forces and errors as on one process")
{
  const verification::Domain part = domain(3);
  const mesh::Mesh& mesh = part.mesh();
  fluid::Parameters parameters;
  parameters.viscosity = 0.02;
  parameters.newton.tolerance = 1e-12;
  parameters.initial_velocity = {formula("4*y*(1 - y)"), 0.0, 0.0};
  parameters.boundaries = {{"left", fluid::Velocity{{formula("4*y*(1 - y)*(1 + t)"), 0.0, 0.0}}, {}},
                           {"bottom", fluid::Wall{}, {}},
                           {"top", fluid::Wall{}, {}},
                           {"right", fluid::Outflow{0.0}, {}}};
  Timings timings;
  fluid::Solver solver(parameters, mesh, part.numbering, part.x, timings);
  fluid::State state = solver.initial();
  std::vector<double> z(3 * mesh.node_count());
  std::vector<double> force = {0.0, 0.0, 0.0};
  const std::vector<double> w =
      verification::rate(part.x, verification::moved_inside(part.x, 0.02, 0.1), 0.1);
  for (int n = 0; n < 3; ++n)
  {
    const fem::TimeStep time{0.1 * n, 0.1, 0.75, 0.5};
    solver.guess(time, state, z);
    REQUIRE(solver.solve(time, state, {part.x, w}, z).status == linalg::NewtonStatus::converged);
    const std::vector<double> reaction = solver.reaction(time, state, {part.x, w}, z);
    const std::vector<std::uint8_t> wall = fem::nodes_on(mesh, part.numbering, "bottom");
    force = {0.0, 0.0, 0.0};
    for (const std::int32_t node : part.numbering.owned())
      for (int c = 0; c < 2 && wall[node] != 0; ++c)
        force[c] -= reaction[3 * node + c];
    linalg::sum(force);
    state = solver.finish(time, state, z);
  }
  const double norm =
      verification::error(mesh, part.x, z, 3, [](double, double) { return verification::Vector{}; });
  // From a run on one process.
  CHECK(force[0] == doctest::Approx(0.3256762347288497).epsilon(1e-9));
  CHECK(force[1] == doctest::Approx(-0.6336632174628937).epsilon(1e-9));
  CHECK(norm == doctest::Approx(0.9312956337521008).epsilon(1e-9));
  std::vector<double> ghosts = z;
  part.numbering.update_ghosts(ghosts, 3);
  CHECK(ghosts == z);
}

TEST_CASE("the mesh follows the interface as on one process, in every way")
{
  using namespace blockfsi;
  block::Layout layout;
  layout.order = 3;
  block::Lattice lattice;
  lattice.name = "box";
  lattice.x = {0.0, 1.0, 1.5, 3.0};
  lattice.y = {2.0, 1.0, 0.0};
  lattice.draw = {"fluid fluid fluid", "fluid flap fluid"};
  lattice.divide_x = {3, 2, 3};
  lattice.divide_y = {3, 3};
  block::add(layout, lattice);
  layout.boundaries.push_back({"floor", block::ByCondition{Condition("y = 0", {})}, {}});
  layout.boundaries.push_back({"rest", block::ByCondition{Condition("y = 2 or x = 0 or x = 3", {})}, {}});
  const block::Skeleton skeleton = block::make_skeleton(layout);
  const std::vector<std::int64_t> interface = block::interface_nodes(layout, skeleton, "fluid", "flap");
  std::vector<double> displacement;
  for (const std::int64_t node : interface)
    displacement.insert(displacement.end(),
                        {0.2 * skeleton.x[2 * node + 1], 0.05 * skeleton.x[2 * node + 1]});

  /// Sum of squares of the displacements, weighted by their places, after two steps.
  const auto measure =
      [&](const motion::Parameters& parameters, Part part, const linalg::Numbering* numbering)
  {
    const block::Connected connected = block::connect(layout, skeleton, "fluid", part);
    const std::vector<double> x0 = block::initial_nodes(connected, skeleton);
    motion::Update update =
        motion::make_update(parameters, {skeleton, connected.plan, connected.mesh, *numbering, x0, interface},
                            block::corner_motion(layout, skeleton, "fluid", interface, {}));
    std::vector<double> x(x0.size());
    for (const double factor : {0.5, 1.0})
    {
      std::vector<double> d = displacement;
      for (double& value : d)
        value *= factor;
      REQUIRE(motion::follow(update, d, x).ok);
      motion::accept(update, d, x);
    }
    double sum = 0.0;
    for (const std::int32_t node : numbering->owned())
      for (int c = 0; c < 2; ++c)
      {
        const std::size_t i = 2 * static_cast<std::size_t>(node) + c;
        sum += (x[i] - x0[i]) * (x[i] - x0[i]) * (1.0 + x0[i]);
      }
    std::vector<double> ghosts = x;
    numbering->update_ghosts(ghosts, 2);
    CHECK(ghosts == x);
    linalg::sum(std::span(&sum, 1));
    return sum;
  };
  const block::Connected mine = block::connect(layout, skeleton, "fluid", linalg::part());
  const linalg::Numbering numbering(mine.mesh.lattice, mine.mesh.owner);
  motion::PseudoSolid incremental;
  incremental.from = motion::From::last;
  incremental.stiffness.interface = {1.0, 0.2, 2.0};
  motion::Harmonic sliding;
  sliding.slide = {"floor"};
  // From a run on one process.
  const std::vector<std::pair<motion::Parameters, double>> expected = {
      {motion::Regeneration{}, 5.84923333333332},
      {motion::PseudoSolid{}, 3.87530529650338},
      {incremental, 4.45761639914554},
      {sliding, 4.16070641738306},
      {motion::Biharmonic{}, 5.76402956615961}};
  for (const auto& [parameters, value] : expected)
  {
    CAPTURE(parameters.index());
    CHECK(measure(parameters, linalg::part(), &numbering) == doctest::Approx(value).epsilon(1e-10));
  }
}
