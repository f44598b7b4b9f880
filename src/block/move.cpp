#include "block/move.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <string>

namespace blockfsi::block
{

namespace
{

/// Weight of each moving node in the displacement of one node.
using Row = std::map<std::int32_t, double>;

void add(Row& row, double weight, const Row& other)
{
  for (const auto& [index, value] : other)
    row[index] += weight * value;
}

/// Resolves rules that may lead from point to point down to nodes of the interface.
class Resolver
{
public:
  Resolver(const Skeleton& skeleton, const std::vector<std::int64_t>& interface,
           const std::vector<Follow>& rules)
      : skeleton_(skeleton), interface_(interface), state_(skeleton.point_count, State::open),
        rows_(skeleton.point_count), rule_(skeleton.point_count, nullptr)
  {
    for (const Follow& rule : rules)
      enter(rule);
  }

  /// Place of a node in the interface, or -1.
  std::int32_t interface_index(std::int64_t node) const
  {
    const auto at = std::lower_bound(interface_.begin(), interface_.end(), node);
    return at != interface_.end() && *at == node ? static_cast<std::int32_t>(at - interface_.begin()) : -1;
  }

  const Row& row(int point)
  {
    if (state_[point] == State::busy)
      throw Error(fmt::format(
          "the rules that corners follow run in a circle: {}; let one of them follow a point of the "
          "interface",
          circle_text(point)));
    if (state_[point] == State::open)
      resolve(point);
    return rows_[point];
  }

private:
  enum class State
  {
    open,
    busy,
    done
  };

  void check_point(int point) const
  {
    if (point < 0 || point >= skeleton_.point_count)
      throw Error(fmt::format("a rule names point {}, but the points are numbered from 0 to {}", point,
                              skeleton_.point_count - 1));
  }

  void enter(const Follow& rule)
  {
    check_point(rule.point);
    const std::string& name = skeleton_.point_names[rule.point];
    if (interface_index(rule.point) >= 0)
      throw Error(
          fmt::format("the point '{}' lies on the interface and moves with it; remove its rule", name));
    if (rule_[rule.point])
      throw Error(fmt::format("the point '{}' has two rules; give it one with several leaders", name));
    for (const Follow::Leader& leader : rule.leaders)
      check_point(leader.point);
    rule_[rule.point] = &rule;
  }

  void resolve(int point)
  {
    state_[point] = State::busy;
    const std::int32_t index = interface_index(point);
    if (index >= 0)
      rows_[point][index] = 1.0;
    else if (rule_[point])
      for (const Follow::Leader& leader : rule_[point]->leaders)
        add(rows_[point], leader.weight, row(leader.point));
    state_[point] = State::done;
  }

  /// "'a' follows 'b' follows 'a'": from a busy point along busy leaders back to it.
  std::string circle_text(int start) const
  {
    std::string text;
    int point = start;
    do
    {
      text += fmt::format("'{}' follows ", skeleton_.point_names[point]);
      const auto& leaders = rule_[point]->leaders;
      point =
          std::find_if(leaders.begin(), leaders.end(),
                       [this](const Follow::Leader& leader) { return state_[leader.point] == State::busy; })
              ->point;
    } while (point != start);
    return text + fmt::format("'{}'", skeleton_.point_names[start]);
  }

  const Skeleton& skeleton_;
  const std::vector<std::int64_t>& interface_;
  std::vector<State> state_;
  std::vector<Row> rows_;
  std::vector<const Follow*> rule_;
};

}  // namespace

SkeletonMotion::SkeletonMotion(const Skeleton& skeleton, const std::vector<std::int64_t>& interface,
                               const std::vector<Follow>& rules)
    : dim_(skeleton.dim), x_(skeleton.x), row_begin_{0}
{
  Resolver resolver(skeleton, interface, rules);
  const auto append = [this](const Row& row)
  {
    for (const auto& [index, weight] : row)
      if (weight != 0.0)
        terms_.push_back({index, weight});
    row_begin_.push_back(static_cast<std::int32_t>(terms_.size()));
  };
  for (int point = 0; point < skeleton.point_count; ++point)
    append(resolver.row(point));
  for (const PlacedEdge& edge : skeleton.edges)
    for (std::int64_t node = edge.first; node < edge.first + edge.count; ++node)
    {
      Row row;
      const std::int32_t index = resolver.interface_index(node);
      if (index >= 0)
        row[index] = 1.0;
      else
      {
        add(row, 1.0 - skeleton.parameter[node], resolver.row(edge.a));
        add(row, skeleton.parameter[node], resolver.row(edge.b));
      }
      append(row);
    }
}

void SkeletonMotion::move(std::span<const double> displacement, std::span<double> skeleton_x) const
{
  assert(skeleton_x.size() == x_.size());
  const std::size_t count = row_begin_.size() - 1;
  for (std::size_t node = 0; node < count; ++node)
    for (int c = 0; c < dim_; ++c)
    {
      double sum = x_[node * dim_ + c];
      for (std::int32_t k = row_begin_[node]; k < row_begin_[node + 1]; ++k)
        sum += terms_[k].weight * displacement[terms_[k].interface_index * dim_ + c];
      skeleton_x[node * dim_ + c] = sum;
    }
}

}  // namespace blockfsi::block
