#pragma once

#include <cstddef>
#include <vector>

namespace blockfsi::block
{

/// Where the nodes of cells of an order above 2 lie between those on the edges of their triangle. The
/// parallel form takes the edges at u, v and u + v, where edges have nodes for nodes on edges of cells, but
/// not for all warped ones within cells. Nodes that lie alike in their boxes of two cells take them alike.
class TriangleNodes
{
public:
  explicit TriangleNodes(int order);

  std::ptrdiff_t order() const { return order_; }

  enum class Coordinate
  {
    u,
    v,
    sum  ///< u + v
  };

  /// Values along a row of nodes, given those at the nodes of an edge, each shape (n + 1, dim): entry i is at
  /// the coordinate (u or sum) of node i of the row, v = 0 where its box begins. Entries from n - row + 1 on
  /// are left.
  ///   row: remainder of the row's number by the order
  template <int dim>
  void along_row(Coordinate coordinate, std::ptrdiff_t row, const double* edge, std::ptrdiff_t n,
                 double* to) const;
  /// Values of an edge at v of the nodes of a box in a row of nodes, shape (order, dim).
  ///   edge: values at the nodes of an edge from the row of boxes on, shape (>= order + 1, dim)
  template <int dim>
  void across(std::ptrdiff_t row, const double* edge, double* to) const;

private:
  /// Where a point lies on an edge: node of the begin of its cell, counted from the box's, and what it takes
  /// from the cell's nodes, shape (order + 1).
  struct Point
  {
    std::ptrdiff_t first;
    const double* weights;
  };
  Point at(Coordinate coordinate, std::ptrdiff_t i, std::ptrdiff_t j) const
  {
    const std::ptrdiff_t place = (static_cast<std::ptrdiff_t>(coordinate) * order_ + j) * order_ + i;
    return {first_[place], weights_.data() + place * (order_ + 1)};
  }
  void append(double t, const std::vector<double>& line);

  std::ptrdiff_t order_;
  // Shapes (coordinate, j, i) over the remainders.
  std::vector<std::ptrdiff_t> first_;
  std::vector<double> weights_;
};

}  // namespace blockfsi::block
