#include "fluid/flow.hpp"

namespace blockfsi::fluid
{

double inverse_constant(int order)
{
  constexpr std::array<double, 8> table = {12.0, 24.0, 113.194, 309.610, 674.451, 1285.32, 2233.75, 3624.90};
  return table[order - 1];
}

}  // namespace blockfsi::fluid
