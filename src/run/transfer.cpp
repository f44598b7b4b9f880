#include "run/transfer.hpp"

#include "element/line.hpp"
#include "run/locate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>

namespace blockfsi::run
{

namespace
{

using Values = std::vector<double>;

/// Nodes that are nearer to each other than this share of the extent of all are the same.
constexpr double same_place = 1e-9;

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
    if (at >= from.size() || from.size() != to.size())
      throw Error(where,
                  fmt::format("[switch] to: the body must have the same blocks, divisions and order in "
                              "both cases; at ({:.6g}, {:.6g}) the second one has a node more",
                              to[i], to[i + 1]));
    result.push_back(at / 2);
  }
  return result;
}

Values gather(const Values& values, const std::vector<std::size_t>& from)
{
  Values result;
  for (const std::size_t node : from)
    result.insert(result.end(), {values[2 * node], values[2 * node + 1]});
  return result;
}

/// Finds points of one mesh in another one.
class Finder
{
public:
  Finder(const mesh::Mesh& mesh, std::span<const double> x) : mesh_(mesh), x_(x) {}

  /// The place of a point. Curved boundaries of two meshes are not quite the same: a point beside the mesh is
  /// looked for on the way to one that is inside.
  Located find(const std::array<double, 2>& point, const std::array<double, 2>& inside)
  {
    for (const double share : {0.0, 1e-9, 1e-6, 1e-4, 1e-3, 1e-2, 3e-2, 0.1, 0.2, 0.4, 0.7, 1.0})
    {
      const std::array<double, 2> at = {point[0] + share * (inside[0] - point[0]),
                                        point[1] + share * (inside[1] - point[1])};
      if (std::optional<Located> found = locate(mesh_, x_, at, last_))
      {
        last_ = found->cell;
        return *found;
      }
    }
    return nearest(point);
  }

private:
  /// The nearest node.
  Located nearest(const std::array<double, 2>& point) const
  {
    Located best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t cell = 0; cell < mesh_.cell_count(); ++cell)
    {
      const auto nodes = mesh_.cell(cell);
      for (std::size_t a = 0; a < nodes.size(); ++a)
      {
        const double distance = std::hypot(x_[2 * nodes[a]] - point[0], x_[2 * nodes[a] + 1] - point[1]);
        if (distance >= least)
          continue;
        least = distance;
        best = {cell, Values(nodes.size(), 0.0)};
        best.shape[a] = 1.0;
      }
    }
    return best;
  }

  const mesh::Mesh& mesh_;
  std::span<const double> x_;
  std::size_t last_ = 0;
};

std::array<double, 2> middle(const mesh::Mesh& mesh, std::span<const double> x, std::size_t cell)
{
  std::array<double, 2> sum{};
  const auto nodes = mesh.cell(cell);
  for (const std::int32_t node : nodes)
    for (int c = 0; c < 2; ++c)
      sum[c] += x[2 * node + c] / static_cast<double>(nodes.size());
  return sum;
}

/// A nodal field of one mesh at the nodes of another one, whose places were found.
Values evaluate(const mesh::Mesh& mesh, const std::vector<Located>& places, const Values& field, int stride)
{
  Values result;
  for (const Located& place : places)
    for (int c = 0; c < stride; ++c)
      result.push_back(place.value(mesh, field, stride, c));
  return result;
}

/// A mesh with velocity and pressure.
struct Fields
{
  const mesh::Mesh& mesh;
  std::span<const double> x;
  const Values& u;
  const Values& p;
};

/// Relative differences of velocity and pressure, by Gauss points of the new mesh between its nodes.
std::array<double, 2> differences(const Fields& from, const Fields& to)
{
  const int n = to.mesh.order + 1;
  const element::Rule rule = element::gauss(n + 1);
  const element::Table line = element::lagrange(element::lobatto(to.mesh.order), rule.points);
  Finder finder(from.mesh, from.x);
  std::array<double, 2> square{};
  std::array<double, 2> size{};
  for (std::size_t cell = 0; cell < to.mesh.cell_count(); ++cell)
    for (int k = 0; k <= n; ++k)
      for (int l = 0; l <= n; ++l)
      {
        Located at{cell, Values(to.mesh.cell(cell).size())};
        std::array<std::array<double, 2>, 2> J{};
        for (int j = 0; j < n; ++j)
          for (int i = 0; i < n; ++i)
          {
            const std::int32_t node = to.mesh.cell(cell)[j * n + i];
            at.shape[j * n + i] = line.value[k * n + i] * line.value[l * n + j];
            for (int c = 0; c < 2; ++c)
            {
              J[c][0] += line.first[k * n + i] * line.value[l * n + j] * to.x[2 * node + c];
              J[c][1] += line.value[k * n + i] * line.first[l * n + j] * to.x[2 * node + c];
            }
          }
        const double weight =
            rule.weights[k] * rule.weights[l] * std::abs(J[0][0] * J[1][1] - J[0][1] * J[1][0]);
        const std::array<double, 2> point = {at.value(to.mesh, to.x, 2, 0), at.value(to.mesh, to.x, 2, 1)};
        const Located old = finder.find(point, middle(to.mesh, to.x, cell));
        const auto add = [&](int which, double before, double after)
        {
          square[which] += weight * (after - before) * (after - before);
          size[which] += weight * before * before;
        };
        for (int c = 0; c < 2; ++c)
          add(0, old.value(from.mesh, from.u, 2, c), at.value(to.mesh, to.u, 2, c));
        add(1, old.value(from.mesh, from.p, 1, 0), at.value(to.mesh, to.p, 1, 0));
      }
  const auto relative = [&](int which)
  { return size[which] > 0.0 ? std::sqrt(square[which] / size[which]) : 0.0; };
  return {relative(0), relative(1)};
}

}  // namespace

Transfer::Transfer(const Simulation& from, const Simulation& to)
{
  const Location& where = from.description().second->where;
  for (const Simulation* simulation : {&from, &to})
    if (!simulation->fluid() || !simulation->solid())
      throw Error(where, "[switch] to: both cases need a fluid and a solid");
  body_ = match(from.solid()->X(), to.solid()->X(), where);
  interface_ = match(from.interface_points(), to.interface_points(), where);
}

TransferReport Transfer::carry(const Simulation& from, Simulation& to) const
{
  const output::Arrays old = from.save();
  const auto values = [&](const std::string& name) { return output::get<Values>(old, name); };
  output::Arrays next = to.save();
  next["time"] = Values{from.time(), from.time(), to.description().time.step};
  next["step"] = std::vector<std::int64_t>{from.step(), from.step(), from.step()};
  for (const char* name : {"interface.0", "interface.1", "interface.2"})
    next[name] = gather(values(name), interface_);
  next["interface.step"] = values("interface.step");
  next["solid.d"] = gather(values("solid.d"), body_);
  next["solid.v"] = gather(values("solid.v"), body_);
  to.restore(next);

  const mesh::Mesh& old_mesh = from.fluid()->mesh();
  const mesh::Mesh& mesh = to.fluid()->mesh();
  TransferReport report;
  report.quality = to.fluid()->quality();
  report.valid = to.fluid()->certify().all_valid();
  if (!report.valid)
    return report;
  const std::span<const double> x = to.fluid()->x();
  Finder finder(old_mesh, from.fluid()->x());
  std::vector<Located> places(mesh.node_count());
  for (std::size_t cell = 0; cell < mesh.cell_count(); ++cell)
    for (const std::int32_t node : mesh.cell(cell))
      if (places[node].shape.empty())
        places[node] = finder.find({x[2 * node], x[2 * node + 1]}, middle(mesh, x, cell));
  for (const auto& [name, stride] :
       {std::pair{"fluid.u", 2}, {"fluid.change", 2}, {"fluid.p", 1}, {"fluid.p_before", 1}})
    next[name] = evaluate(old_mesh, places, values(name), stride);
  next["fluid.times"] = values("fluid.times");
  to.restore(next);
  const fluid::State& before = from.fluid()->state();
  const fluid::State& after = to.fluid()->state();
  const auto [velocity, pressure] =
      differences({old_mesh, from.fluid()->x(), before.u, before.p}, {mesh, x, after.u, after.p});
  report.velocity_error = velocity;
  report.pressure_error = pressure;
  return report;
}

}  // namespace blockfsi::run
