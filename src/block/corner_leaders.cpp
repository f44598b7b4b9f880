#include "block/corner_layout.hpp"

#include "block/corner_blocks.hpp"
#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

namespace blockfsi::block
{

namespace
{

/// Weight of each interface node in the displacement of one point.
using Row = std::map<std::int32_t, double>;

/// Resolves rules that may lead from point to point down to nodes of the interface.
class Resolver
{
public:
  Resolver(const Skeleton& skeleton, std::span<const std::int64_t> interface,
           const std::vector<Follow>& follows)
      : skeleton_(skeleton), interface_(interface), state_(skeleton.point_count, State::open),
        rows_(skeleton.point_count), rule_(skeleton.point_count, nullptr)
  {
    for (const Follow& follow : follows)
      enter(follow);
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
    if (interface_index(interface_, rule.point) >= 0)
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
    const std::int32_t index = interface_index(interface_, point);
    if (index >= 0)
      rows_[point][index] = 1.0;
    else if (rule_[point])
      for (const Follow::Leader& leader : rule_[point]->leaders)
        for (const auto& [node, weight] : row(leader.point))
          rows_[point][node] += leader.weight * weight;
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
  std::span<const std::int64_t> interface_;
  std::vector<State> state_;
  std::vector<Row> rows_;
  std::vector<const Follow*> rule_;
};

}  // namespace

std::vector<std::vector<Share>> led_points(const Skeleton& skeleton, std::span<const std::int64_t> interface,
                                           const std::vector<Follow>& follows)
{
  Resolver resolver(skeleton, interface, follows);
  std::vector<std::vector<Share>> led(skeleton.point_count);
  for (int point = 0; point < skeleton.point_count; ++point)
    for (const auto& [node, weight] : resolver.row(point))
      if (weight != 0.0)
        led[point].push_back({node, weight});
  return led;
}

}  // namespace blockfsi::block
