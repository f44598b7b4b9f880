#include "motion/velocity.hpp"

namespace blockfsi::motion
{

void mesh_velocity(const fem::TimeStep& step, std::span<const double> x0, std::span<const double> x1,
                   std::span<double> x, std::span<double> w)
{
  for (std::size_t i = 0; i < x0.size(); ++i)
  {
    const double change = x1[i] - x0[i];
    x[i] = x0[i] + step.geometry * change;
    w[i] = step.step > 0.0 ? change / step.step : 0.0;
  }
}

}  // namespace blockfsi::motion
