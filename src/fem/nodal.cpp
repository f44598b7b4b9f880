#include "fem/nodal.hpp"

namespace blockfsi::fem
{

void evaluate_at_nodes(const std::array<Expression, 3>& formulas, std::span<const double> x, double time,
                       std::span<double> values)
{
  for (std::size_t c = 0; c < 2; ++c)
  {
    const Expression& formula = formulas[c];
    const bool constant = formula.is_constant();
    const double once = constant ? formula(0.0) : 0.0;
    for (std::size_t i = 0; i < x.size(); i += 2)
      values[i + c] = constant ? once : formula(x[i], x[i + 1], 0.0, time);
  }
}

}  // namespace blockfsi::fem
