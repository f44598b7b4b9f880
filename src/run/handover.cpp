#include "run/handover.hpp"

#include "fem/boundary.hpp"
#include "fem/projection.hpp"
#include "linalg/communicator.hpp"
#include "run/gathered.hpp"
#include "run/shared_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>

namespace blockfsi::run
{

namespace
{

using Values = std::vector<double>;

/// Nodes that are nearer to each other than this share of the extent of all are the same.
constexpr double same_place = 1e-9;

/// Gauss points beyond the order with which the fields of one mesh are integrated over the cells of another.
/// Derivatives jump where edges of the old cells cross the new ones: that many points, not the order of the
/// rule, make the error small.
constexpr int more_points = 6;

double extent(std::span<const double> x)
{
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  return *high - *low;
}

/// For each of the points `to` the one of `from` at the same place, both of shape (count, 2).
std::vector<std::size_t> match(std::span<const double> from, std::span<const double> to,
                               const Location& where)
{
  const double tolerance = same_place * extent(from);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < to.size(); i += 2)
  {
    std::size_t at = 0;
    while (at < from.size() && std::hypot(from[at] - to[i], from[at + 1] - to[i + 1]) > tolerance)
      at += 2;
    if (at >= from.size())
      throw Error(where,
                  fmt::format("[switch] to: the body must have the same blocks, divisions and order in "
                              "both cases; at ({:.6g}, {:.6g}) the second one has a node more",
                              to[i], to[i + 1]));
    result.push_back(at / 2);
  }
  return result;
}

Values pick(const Values& values, const std::vector<std::size_t>& from)
{
  Values result;
  for (const std::size_t node : from)
    result.insert(result.end(), {values[2 * node], values[2 * node + 1]});
  return result;
}

/// The values of a nodal field of the body at the nodes that each process owns, gathered.
Values gather_owned(const SolidSide& solid, std::span<const double> field)
{
  Values mine;
  for (const std::int32_t node : solid.numbering().owned())
    mine.insert(mine.end(),
                {field[2 * static_cast<std::size_t>(node)], field[2 * static_cast<std::size_t>(node) + 1]});
  return gather_values(mine);
}

/// The fields of a flow side by side.
enum Component : std::uint8_t
{
  velocity = 0,
  change = 2,
  pressure = 4,
  pressure_before = 5,
  component_count = 6
};

/// All nodal fields of a state, shape (node_count, component_count).
Values side_by_side(const fluid::State& state)
{
  Values result;
  for (std::size_t node = 0; node < state.p.size(); ++node)
    result.insert(result.end(), {state.u[2 * node], state.u[2 * node + 1], state.change[2 * node],
                                 state.change[2 * node + 1], state.p[node], state.p_before[node]});
  return result;
}

/// The velocity prescribed at boundaries, else 0, shape (node_count, 2).
///   first_x: where formulas are evaluated, x: where the nodes are [m], both of that shape.
Values boundary_velocity(const fluid::Conditions& conditions, std::span<const double> first_x,
                         std::span<const double> x, double time, SharedField& old)
{
  using Kind = fluid::Prescribed::Kind;
  Values interface_x;
  for (const fluid::Prescribed& entry : conditions.prescribed)
    if (entry.kind == Kind::interface)
      interface_x.insert(interface_x.end(), {x[2 * entry.node], x[2 * entry.node + 1]});
  const Values at_interface = old.at(interface_x);
  const double* next = at_interface.data();
  Values u(x.size(), 0.0);
  for (const fluid::Prescribed& entry : conditions.prescribed)
  {
    const std::size_t i = 2 * static_cast<std::size_t>(entry.node);
    double& value = u[i + entry.component];
    if (entry.kind == Kind::expression)
      value = entry.value(first_x[i], first_x[i + 1], 0.0, time);
    else if (entry.kind == Kind::interface)
      value = std::exchange(next, next + component_count)[velocity + entry.component];
  }
  return u;
}

/// A velocity known at points, there alone.
class AtPoints
{
public:
  AtPoints(std::span<const double> points, std::span<const double> values)
  {
    for (std::size_t k = 0; 2 * k < points.size(); ++k)
    {
      const double* at = values.data() + component_count * k;
      velocity_[{points[2 * k], points[2 * k + 1]}] = {at[velocity], at[velocity + 1]};
    }
  }
  std::array<double, 2> operator()(const std::array<double, 2>& x) const { return velocity_.at(x); }

private:
  std::map<std::array<double, 2>, std::array<double, 2>> velocity_;
};

/// Components of values of shape (count, stride), from `first` on.
Values components(std::span<const double> values, std::size_t stride, std::size_t first, std::size_t count)
{
  Values result;
  for (std::size_t i = first; i < values.size(); i += stride)
    result.insert(result.end(), values.begin() + i, values.begin() + i + count);
  return result;
}

/// Relative difference in the L2 norm between a nodal field and values at the points, of shape (points,
/// components).
double difference(fem::Projection& projection, const Values& nodal, const Values& given, int components)
{
  const Values& weight = projection.quadrature().weight;
  const Values found = projection.values_at_points({nodal.data(), components});
  std::array<double, 2> sums{};
  for (std::size_t k = 0; k < given.size(); ++k)
  {
    const double off = found[3 * k] - given[k];
    sums[0] += weight[k / components] * off * off;
    sums[1] += weight[k / components] * given[k] * given[k];
  }
  linalg::sum(sums);
  return sums[1] > 0.0 ? std::sqrt(sums[0] / sums[1]) : 0.0;
}

FlowIntegrals integrate(const FluidSide& fluid, double density)
{
  fem::CellLoop cells(fluid.mesh(), fem::quadrature_points(fluid.mesh().order));
  const Values weight = cells.quadrature(fluid.x()).weight;
  const Values u = cells.values_at_points(fluid.x(), {fluid.state().u.data(), 2});
  std::array<double, 6> sums{};
  for (std::size_t q = 0; q < weight.size(); ++q)
  {
    const double* value = u.data() + 6 * q;
    const double divergence = value[1] + value[5];
    const double square =
        value[1] * value[1] + value[2] * value[2] + value[4] * value[4] + value[5] * value[5];
    const std::array<double, 6> terms = {1.0,        density * value[0],      density * value[3],
                                         divergence, divergence * divergence, square};
    for (std::size_t k = 0; k < terms.size(); ++k)
      sums[k] += weight[q] * terms[k];
  }
  linalg::sum(sums);
  return {sums[0], {sums[1], sums[2]}, sums[3], sums[5] > 0.0 ? std::sqrt(sums[4] / sums[5]) : 0.0};
}

}  // namespace

Handover::Handover(const Simulation& from, const Simulation& to, const Location& where)
{
  for (const Simulation* simulation : {&from, &to})
    if (!simulation->fluid() || !simulation->solid())
      throw Error(where, "[switch] to: both cases need a fluid and a solid");
  const SolidSide& body = *to.solid();
  const FluidSide& fluid = *to.fluid();
  if (from.solid()->numbering().total_count() != body.numbering().total_count())
    throw Error(where,
                fmt::format("[switch] to: the body must have the same blocks, divisions and order in both "
                            "cases; it has {} nodes in the first one and {} in the second",
                            from.solid()->numbering().total_count(), body.numbering().total_count()));
  body_ = match(gather_owned(*from.solid(), from.solid()->X()), body.X(), where);
  if (from.interface_points().size() != to.interface_points().size())
    throw Error(where,
                fmt::format("[switch] to: the fluid must surround the body alike in both cases; it meets {} "
                            "nodes of it in the first one and {} in the second",
                            from.interface_points().size() / 2, to.interface_points().size() / 2));
  interface_ = match(from.interface_points(), to.interface_points(), where);
  conditions_ = fluid::find_conditions(*to.description().fluid, fluid.mesh(), fluid.numbering(), fluid.x());
  first_x_.assign(fluid.x().begin(), fluid.x().end());
}

HandoverReport Handover::carry(const Simulation& from, Simulation& to) const
{
  output::Arrays next = body_of(from, to);
  to.restore(next);
  HandoverReport report;
  report.quality = to.fluid()->quality();
  if (!to.fluid()->certify().all_valid())
  {
    report.failure = "its mesh is not valid there either";
    return report;
  }
  if (!project(*from.fluid(), *to.fluid(), next, report))
  {
    report.failure = "the equations of the projection could not be solved";
    return report;
  }
  to.restore(next);
  report.before = integrate(*from.fluid(), from.description().fluid->density);
  report.after = integrate(*to.fluid(), to.description().fluid->density);
  return report;
}

/// The state of `to` with time, body and interface of `from`.
output::Arrays Handover::body_of(const Simulation& from, const Simulation& to) const
{
  const output::Arrays old = from.save();
  const auto values = [&](const std::string& name) { return output::get<Values>(old, name); };
  output::Arrays next = to.save();
  next["time"] = Values{from.time(), from.time(), to.description().time.step};
  next["step"] = std::vector<std::int64_t>{from.step(), from.step()};
  const Values step = values("interface.step");
  next["interface.step"] = step;
  for (int i = 0; i < static_cast<int>(step[1]); ++i)
  {
    const std::string name = fmt::format("interface.{}", i);
    next[name] = pick(values(name), interface_);
  }
  for (const char* name : {"solid.d", "solid.v"})
    next[name] = pick(gather_owned(*from.solid(), values(name)), body_);
  next["fluid.times"] = values("fluid.times");
  return next;
}

/// Puts the flow into the state; false if that cannot be solved.
bool Handover::project(const FluidSide& from, const FluidSide& to, output::Arrays& state,
                       HandoverReport& report) const
{
  const mesh::Mesh& mesh = to.mesh();
  fem::Projection projection(mesh, to.numbering(), to.x(), std::min(mesh.order + more_points, fem::max_line));
  SharedField old(from.mesh(), from.x(), side_by_side(from.state()), component_count);
  const Values fields = old.at(projection.quadrature().x);
  const Values boundary = projection.boundary_points();
  const AtPoints u_at(boundary, old.at(boundary));
  std::vector<std::uint8_t> fixed = fluid::fixed_unknowns(conditions_, mesh);
  fem::agree(to.numbering(), fixed, 3);
  Values u = boundary_velocity(conditions_, first_x_, to.x(), from.state().time, old);
  const Values given_u = components(fields, component_count, velocity, 2);
  if (projection.velocity(given_u, u_at, fixed, u) != linalg::Status::ok)
    return false;
  constexpr int others = component_count - change;
  Values rest(others * mesh.node_count());
  if (projection.scalars(components(fields, component_count, change, others), others, rest) !=
      linalg::Status::ok)
    return false;
  Values p = components(rest, others, pressure - change, 1);
  report.velocity_error = difference(projection, u, given_u, 2);
  report.pressure_error = difference(projection, p, components(fields, component_count, pressure, 1), 1);
  state["fluid.u"] = std::move(u);
  state["fluid.change"] = components(rest, others, 0, 2);
  state["fluid.p"] = std::move(p);
  state["fluid.p_before"] = components(rest, others, pressure_before - change, 1);
  return true;
}

}  // namespace blockfsi::run
