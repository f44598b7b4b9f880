#include "fem/line_table.hpp"

#include "element/line.hpp"

namespace blockfsi::fem
{

LineTable make_line_table(int order, int points)
{
  const element::Rule rule = element::gauss(points);
  const element::Table table = element::lagrange(element::lobatto(order), rule.points);
  return {points, order + 1, table.value, table.first, table.second, rule.points, rule.weights};
}

}  // namespace blockfsi::fem
