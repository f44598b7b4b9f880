#include "geometry/box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace blockfsi::geometry
{

namespace
{

constexpr std::int32_t most_in_leaf = 4;

class Tree
{
public:
  explicit Tree(std::span<const Box> boxes) : boxes_(boxes), order_(boxes.size())
  {
    std::iota(order_.begin(), order_.end(), 0);
    if (!boxes.empty())
      build(0, static_cast<std::int32_t>(boxes.size()));
  }

  std::vector<std::pair<std::int32_t, std::int32_t>> pairs()
  {
    if (!nodes_.empty())
      within(0);
    std::sort(found_.begin(), found_.end());
    return std::move(found_);
  }

private:
  /// Boxes begin .. end - 1 of the order; their halves if they are many.
  struct Node
  {
    Box box;
    std::int32_t begin = 0;
    std::int32_t end = 0;
    std::int32_t first = -1;
    std::int32_t second = -1;
  };

  double centre(std::int32_t box, std::size_t c) const { return boxes_[box].low[c] + boxes_[box].high[c]; }

  /// The direction in which the centres reach farthest.
  std::size_t longest(std::int32_t begin, std::int32_t end) const
  {
    std::size_t result = 0;
    double extent = -1.0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      const auto [least, most] =
          std::minmax_element(order_.begin() + begin, order_.begin() + end,
                              [&](std::int32_t a, std::int32_t b) { return centre(a, c) < centre(b, c); });
      if (centre(*most, c) - centre(*least, c) > extent)
      {
        extent = centre(*most, c) - centre(*least, c);
        result = c;
      }
    }
    return result;
  }

  std::int32_t build(std::int32_t begin, std::int32_t end)
  {
    const auto at = static_cast<std::int32_t>(nodes_.size());
    nodes_.push_back({boxes_[order_[begin]], begin, end});
    for (std::int32_t i = begin + 1; i < end; ++i)
      nodes_[at].box = joined(nodes_[at].box, boxes_[order_[i]]);
    if (end - begin <= most_in_leaf)
      return at;
    const std::size_t c = longest(begin, end);
    const std::int32_t middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::int32_t a, std::int32_t b) { return centre(a, c) < centre(b, c); });
    const std::int32_t first = build(begin, middle);
    const std::int32_t second = build(middle, end);
    nodes_[at].first = first;
    nodes_[at].second = second;
    return at;
  }

  void compare(std::int32_t a, std::int32_t b)
  {
    if (boxes_[a].meets(boxes_[b]))
      found_.emplace_back(std::min(a, b), std::max(a, b));
  }

  /// Pairs of the boxes of a node.
  void within(std::int32_t n)
  {
    const Node& node = nodes_[n];
    if (node.first >= 0)
    {
      within(node.first);
      within(node.second);
      between(node.first, node.second);
      return;
    }
    for (std::int32_t i = node.begin; i < node.end; ++i)
      for (std::int32_t j = i + 1; j < node.end; ++j)
        compare(order_[i], order_[j]);
  }

  /// Pairs of a box of one node and a box of the other.
  void between(std::int32_t m, std::int32_t n)
  {
    const Node& a = nodes_[m];
    const Node& b = nodes_[n];
    if (!a.box.meets(b.box))
      return;
    if (a.first < 0 && b.first < 0)
    {
      for (std::int32_t i = a.begin; i < a.end; ++i)
        for (std::int32_t j = b.begin; j < b.end; ++j)
          compare(order_[i], order_[j]);
    }
    else if (b.first < 0 || (a.first >= 0 && a.end - a.begin >= b.end - b.begin))
    {
      between(a.first, n);
      between(a.second, n);
    }
    else
    {
      between(m, b.first);
      between(m, b.second);
    }
  }

  std::span<const Box> boxes_;
  std::vector<std::int32_t> order_;
  std::vector<Node> nodes_;
  std::vector<std::pair<std::int32_t, std::int32_t>> found_;
};

}  // namespace

Box joined(const Box& a, const Box& b)
{
  Box result;
  for (std::size_t c = 0; c < 3; ++c)
  {
    result.low[c] = std::min(a.low[c], b.low[c]);
    result.high[c] = std::max(a.high[c], b.high[c]);
  }
  return result;
}

Box box_around(std::span<const Point> points, double margin)
{
  Box box{points[0], points[0]};
  for (const Point& x : points)
    for (std::size_t c = 0; c < 3; ++c)
    {
      box.low[c] = std::min(box.low[c], x[c]);
      box.high[c] = std::max(box.high[c], x[c]);
    }
  for (std::size_t c = 0; c < 3; ++c)
  {
    box.low[c] -= margin;
    box.high[c] += margin;
  }
  return box;
}

std::vector<std::pair<std::int32_t, std::int32_t>> meeting_pairs(std::span<const Box> boxes)
{
  return Tree(boxes).pairs();
}

}  // namespace blockfsi::geometry
