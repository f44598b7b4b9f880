#include "block/between.hpp"

#include "block/numbering.hpp"
#include "element/line.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace blockfsi::block
{

namespace
{

/// The values of a line's nodes that make up the value at one of its places.
struct Term
{
  std::int32_t number;  ///< skeleton number of the node
  double weight;
};

/// The nodes of an edge and the graded parameters of its cells' corners.
struct Line
{
  std::vector<std::int32_t> numbers;  ///< shape (divisions * order + 1)
  std::vector<double> corners;        ///< shape (divisions + 1)
};

Line line(const Skeleton& skeleton, const PlacedEdge& edge)
{
  Line result{edge_numbers(edge), {0.0}};
  for (int cell = 1; cell < edge.divisions; ++cell)
    result.corners.push_back(
        skeleton.parameter[result.numbers[static_cast<std::size_t>(cell) * skeleton.order]]);
  result.corners.push_back(1.0);
  return result;
}

/// The polynomial of the line's cell that holds the parameter t. On faces, terms of two directions multiply.
std::vector<Term> evaluate(const Line& line, const std::vector<double>& nodes, double t)
{
  const auto above = std::upper_bound(line.corners.begin() + 1, line.corners.end() - 1, t);
  const auto cell = static_cast<std::size_t>(above - line.corners.begin()) - 1;
  const double low = line.corners[cell], high = line.corners[cell + 1];
  const std::array<double, 1> point = {(t - low) / (high - low)};
  const element::Table table = element::lagrange(nodes, point);
  std::vector<Term> terms;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (table.value[i] != 0.0)
      terms.push_back({line.numbers[cell * (nodes.size() - 1) + i], table.value[i]});
  return terms;
}

}  // namespace

SparseRows evaluate_between(const Layout& layout, const Skeleton& from, const Skeleton& to,
                            std::string_view region_a, std::string_view region_b)
{
  assert(from.dim == 2 && to.dim == 2 && from.edges.size() == to.edges.size());
  const std::vector<std::int64_t> columns = interface_nodes(layout, from, region_a, region_b);
  const std::vector<std::int64_t> rows = interface_nodes(layout, to, region_a, region_b);
  const std::vector<double> nodes = element::lobatto(from.order);
  const auto place = [](const std::vector<std::int64_t>& all, std::int64_t number)
  { return static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), number) - all.begin()); };

  std::vector<std::vector<Term>> terms(rows.size());
  for (const int side : interface_sides(layout, to, region_a, region_b))
  {
    const PlacedEdge& edge = to.edges[side];
    const Line source = line(from, from.edges[side]);
    // Points have the same numbers in both.
    for (const int point : {edge.a, edge.b})
      terms[place(rows, point)] = {{point, 1.0}};
    for (std::int64_t number = edge.first; number < edge.first + edge.count; ++number)
      terms[place(rows, number)] = evaluate(source, nodes, to.parameter[number]);
  }
  SparseRows result;
  for (const std::vector<Term>& row : terms)
  {
    for (const Term& term : row)
    {
      result.column.push_back(static_cast<std::int32_t>(place(columns, term.number)));
      result.weight.push_back(term.weight);
    }
    result.row_begin.push_back(static_cast<std::int32_t>(result.column.size()));
  }
  return result;
}

}  // namespace blockfsi::block
