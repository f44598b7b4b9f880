#include "block/lattice.hpp"

#include "block/message.hpp"
#include "core/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <sstream>
#include <utility>

namespace blockfsi::block
{

namespace
{

using Words = std::vector<std::vector<std::string>>;  ///< drawn word of row j and column i
using IndexPair = std::array<int, 2>;

std::vector<std::string> split(const std::string& line)
{
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    words.push_back(word);
  return words;
}

void check_count(std::size_t given, std::size_t wanted, const char* list, const char* unit)
{
  if (given != 0 && given != wanted)
    throw Error(
        fmt::format("{} has {} entries, but there are {} {}; give one for each", list, given, wanted, unit));
}

std::string listed_numbers(const std::vector<double>& values)
{
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const double value : values)
    texts.push_back(fmt::format("{:.9g}", value));
  return listed(texts);
}

void check_coordinates(const Lattice& lattice)
{
  const auto is_monotone = [](const std::vector<double>& values, auto compare)
  { return std::adjacent_find(values.begin(), values.end(), std::not_fn(compare)) == values.end(); };
  if (lattice.x.size() < 2 || lattice.y.size() < 2)
    throw Error(fmt::format("there are {} x and {} y; a lattice needs at least 2 of each", lattice.x.size(),
                            lattice.y.size()));
  if (!is_monotone(lattice.x, std::less<double>()))
    throw Error(fmt::format("the x are {}; they must ascend", listed_numbers(lattice.x)));
  if (!is_monotone(lattice.y, std::less<double>()) && !is_monotone(lattice.y, std::greater<double>()))
    throw Error(fmt::format("the y are {}; they must descend (top row drawn first) or ascend",
                            listed_numbers(lattice.y)));
}

/// The drawing as words, checked against the coordinates.
Words read_drawing(const Lattice& lattice)
{
  const std::size_t columns = lattice.x.size() - 1;
  const std::size_t rows = lattice.y.size() - 1;
  if (lattice.draw.size() != rows)
    throw Error(fmt::format("{} rows are drawn, but {} y make {} rows; draw one line for each",
                            lattice.draw.size(), lattice.y.size(), rows));
  Words words;
  for (std::size_t j = 0; j < rows; ++j)
  {
    words.push_back(split(lattice.draw[j]));
    if (words[j].size() != columns)
      throw Error(fmt::format(
          "line {} of the drawing, \"{}\", has {} words, but {} x make {} columns; write one word "
          "for each, '.' for a hole",
          j + 1, lattice.draw[j], words[j].size(), lattice.x.size(), columns));
  }
  check_count(lattice.divide_x.size(), columns, "divide.x", "columns");
  check_count(lattice.divide_y.size(), rows, "divide.y", "rows");
  check_count(lattice.grade_x.size(), columns, "grade.x", "columns");
  check_count(lattice.grade_y.size(), rows, "grade.y", "rows");
  return words;
}

/// One lattice on its way into a layout.
class Drawing
{
public:
  Drawing(Layout& layout, const Lattice& lattice)
      : layout_(layout), lattice_(lattice), words_(read_drawing(lattice)),
        columns_(static_cast<int>(lattice.x.size()) - 1), rows_(static_cast<int>(lattice.y.size()) - 1),
        is_downward_(lattice.y[0] > lattice.y[1])
  {
    number_holes();
  }

  void add()
  {
    add_points();
    add_blocks();
    place_points();
    add_hole_edges();
    add_edges();
  }

private:
  bool is_block(int i, int j) const
  {
    return i >= 0 && j >= 0 && i < columns_ && j < rows_ && words_[j][i] != ".";
  }

  bool is_hole(int i, int j) const
  {
    return i >= 0 && j >= 0 && i < columns_ && j < rows_ && words_[j][i] == ".";
  }

  /// Spreads a hole's number over the dots that touch along a side.
  void fill_hole(int i, int j, int number)
  {
    if (!is_hole(i, j) || hole_[j][i] != 0)
      return;
    hole_[j][i] = number;
    fill_hole(i - 1, j, number);
    fill_hole(i + 1, j, number);
    fill_hole(i, j - 1, number);
    fill_hole(i, j + 1, number);
  }

  void number_holes()
  {
    hole_.assign(rows_, std::vector<int>(columns_, 0));
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i < columns_; ++i)
        if (is_hole(i, j) && hole_[j][i] == 0)
          fill_hole(i, j, ++hole_count_);
  }

  void add_points()
  {
    for (int j = 0; j <= rows_; ++j)
      for (int i = 0; i <= columns_; ++i)
        if (is_block(i, j) || is_block(i - 1, j) || is_block(i, j - 1) || is_block(i - 1, j - 1))
        {
          point_[{i, j}] = static_cast<int>(layout_.points.size());
          layout_.points.push_back({fmt::format("{} x{} y{}", lattice_.name, i, j),
                                    {lattice_.x[i], lattice_.y[j], 0.0},
                                    lattice_.where});
        }
    if (point_.empty())
      throw Error("the drawing has no block, only holes; write the name of a region where a block is");
  }

  /// Point (i, j), which must be a corner of a block.
  int point(const IndexPair& index) const
  {
    const auto found = point_.find(index);
    if (found == point_.end())
      throw Error(fmt::format(
          "there is no point x{} y{}: x runs from 0 to {}, y from 0 to {}, and the point must be a "
          "corner of a block",
          index[0], index[1], columns_, rows_));
    return found->second;
  }

  void add_blocks()
  {
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i < columns_; ++i)
      {
        if (!is_block(i, j))
          continue;
        const int low = is_downward_ ? j + 1 : j;
        const int high = is_downward_ ? j : j + 1;
        layout_.blocks.push_back(
            {fmt::format("block ({}, {}) of {}", i, j, lattice_.name),
             words_[j][i],
             {point({i, low}), point({i + 1, low}), point({i + 1, high}), point({i, high})},
             lattice_.where});
      }
  }

  /// Calls visit(from, to, i, j) for the four sides of cell (i, j) of the drawing, each towards increasing
  /// index, with the neighbour (i, j) beyond it.
  template <typename Visit>
  void for_each_side(int i, int j, Visit visit) const
  {
    visit(IndexPair{i, j}, IndexPair{i + 1, j}, i, j - 1);
    visit(IndexPair{i + 1, j}, IndexPair{i + 1, j + 1}, i + 1, j);
    visit(IndexPair{i, j + 1}, IndexPair{i + 1, j + 1}, i, j + 1);
    visit(IndexPair{i, j}, IndexPair{i, j + 1}, i - 1, j);
  }

  void project(const Lattice::CircleSides& circle, const IndexPair& index)
  {
    auto& x = layout_.points[point(index)].x;
    const double away = std::hypot(x[0] - circle.center[0], x[1] - circle.center[1]);
    if (!(away > 0.0))
      throw Error(fmt::format(
          "the point x{} y{} sits at the centre of the circle, so it cannot be moved onto it; move "
          "the point or the centre",
          index[0], index[1]));
    for (std::size_t c = 0; c < 2; ++c)
      x[c] = circle.center[c] + (x[c] - circle.center[c]) * (circle.radius / away);
  }

  const Lattice::CircleSides* circle_of(int hole) const
  {
    const auto found =
        std::find_if(lattice_.circles.begin(), lattice_.circles.end(),
                     [hole](const Lattice::CircleSides& circle) { return circle.hole == hole; });
    return found == lattice_.circles.end() ? nullptr : &*found;
  }

  void check_circles() const
  {
    for (const Lattice::CircleSides& circle : lattice_.circles)
    {
      if (circle.hole < 1 || circle.hole > hole_count_)
        throw Error(fmt::format("a circle is given for hole {}, but the drawing has {} hole(s)", circle.hole,
                                hole_count_));
      if (!(circle.radius > 0.0))
        throw Error(fmt::format("the circle of hole {} has a radius of {:.9g} m; it must be positive",
                                circle.hole, circle.radius));
      if (circle_of(circle.hole) != &circle)
        throw Error(fmt::format("hole {} has two circles; give it one", circle.hole));
    }
  }

  /// Moves points onto circles, each once, and then to the places that the user gives.
  void place_points()
  {
    check_circles();
    std::map<int, const Lattice::CircleSides*> circle_at;
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i < columns_; ++i)
        if (const auto* circle = circle_of(hole_[j][i]))
          for_each_side(i, j,
                        [&](const IndexPair& from, const IndexPair& to, int beside_i, int beside_j)
                        {
                          if (!is_block(beside_i, beside_j))
                            return;
                          for (const IndexPair& index : {from, to})
                            if (circle_at.try_emplace(point(index), circle).second)
                              project(*circle, index);
                        });
    for (const Lattice::Place& place : lattice_.places)
      layout_.points[point({place.i, place.j})].x = {place.x[0], place.x[1], 0.0};
  }

  void add_hole_edges()
  {
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i < columns_; ++i)
        if (hole_[j][i] != 0)
          for_each_side(i, j,
                        [&](const IndexPair& from, const IndexPair& to, int beside_i, int beside_j)
                        {
                          if (!is_block(beside_i, beside_j))
                            return;
                          layout_.hole_edges.push_back({lattice_.name, hole_[j][i], point(from), point(to)});
                          if (const auto* circle = circle_of(hole_[j][i]))
                            curve_[{from, to}] = geometry::Arc{{circle->center[0], circle->center[1], 0.0}};
                        });
  }

  /// Divisions of the column or row that an edge crosses.
  std::optional<int> divisions(const IndexPair& from, bool along_x) const
  {
    const std::vector<int>& all = along_x ? lattice_.divide_x : lattice_.divide_y;
    if (all.empty() || all[from[along_x ? 0 : 1]] == 0)
      return std::nullopt;
    return all[from[along_x ? 0 : 1]];
  }

  /// Grading of an edge towards increasing index.
  std::optional<Grading> grading(const IndexPair& from, bool along_x) const
  {
    const auto& all = along_x ? lattice_.grade_x : lattice_.grade_y;
    if (all.empty() || !all[from[along_x ? 0 : 1]])
      return std::nullopt;
    const Grading& grading = *all[from[along_x ? 0 : 1]];
    return !along_x && is_downward_ ? reversed(grading) : grading;
  }

  bool is_edge(const IndexPair& from, bool along_x) const
  {
    const auto [i, j] = from;
    return is_block(i, j) || (along_x ? is_block(i, j - 1) : is_block(i - 1, j));
  }

  const Lattice::EdgeCurve* given_curve(const IndexPair& from, const IndexPair& to) const
  {
    const auto joins = [&](const Lattice::EdgeCurve& curve)
    { return (curve.from == from && curve.to == to) || (curve.from == to && curve.to == from); };
    const auto found = std::find_if(lattice_.curves.begin(), lattice_.curves.end(), joins);
    if (found == lattice_.curves.end())
      return nullptr;
    if (std::find_if(found + 1, lattice_.curves.end(), joins) != lattice_.curves.end())
      throw Error(fmt::format("two curves are given between x{} y{} and x{} y{}; give one", from[0], from[1],
                              to[0], to[1]));
    return &*found;
  }

  void add_edge(const IndexPair& from, const IndexPair& to)
  {
    const bool along_x = to[0] > from[0];
    Edge edge;
    edge.a = point(from);
    edge.b = point(to);
    edge.divisions = divisions(from, along_x);
    edge.grading = grading(from, along_x);
    edge.where = lattice_.where;
    if (const auto arc = curve_.find({from, to}); arc != curve_.end())
      edge.curve = arc->second;
    if (const Lattice::EdgeCurve* given = given_curve(from, to))
    {
      edge.curve = given->curve;
      if (given->from == to)
      {
        std::swap(edge.a, edge.b);
        edge.grading = edge.grading ? std::optional(reversed(*edge.grading)) : std::nullopt;
      }
    }
    if (edge.divisions || edge.grading || !std::holds_alternative<geometry::Segment>(edge.curve))
      layout_.edges.push_back(std::move(edge));
  }

  void check_curves() const
  {
    for (const Lattice::EdgeCurve& curve : lattice_.curves)
    {
      point(curve.from);
      point(curve.to);
      const IndexPair& low = std::min(curve.from, curve.to);
      const bool along_x = curve.from[1] == curve.to[1];
      const int steps = std::abs(curve.from[0] - curve.to[0]) + std::abs(curve.from[1] - curve.to[1]);
      if (steps != 1 || !is_edge(low, along_x))
        throw Error(fmt::format("a curve is given between x{} y{} and x{} y{}, which is no side of a block",
                                curve.from[0], curve.from[1], curve.to[0], curve.to[1]));
    }
  }

  void add_edges()
  {
    check_curves();
    for (int j = 0; j <= rows_; ++j)
      for (int i = 0; i <= columns_; ++i)
        for (const bool along_x : {true, false})
          if (is_edge({i, j}, along_x))
            add_edge({i, j}, along_x ? IndexPair{i + 1, j} : IndexPair{i, j + 1});
  }

  Layout& layout_;
  const Lattice& lattice_;
  Words words_;
  int columns_;
  int rows_;
  bool is_downward_;
  int hole_count_ = 0;
  std::vector<std::vector<int>> hole_;  ///< hole of each word, 0: none
  std::map<IndexPair, int> point_;
  std::map<std::pair<IndexPair, IndexPair>, geometry::Curve> curve_;  ///< arcs of the holes
};

}  // namespace

void add(Layout& layout, const Lattice& lattice)
{
  try
  {
    check_coordinates(lattice);
    Drawing(layout, lattice).add();
  }
  catch (const Error& error)
  {
    throw mistake(lattice.where, error.within(fmt::format("the lattice '{}'", lattice.name)).message());
  }
}

}  // namespace blockfsi::block
