#include "run/solid_side.hpp"

#include "block/place.hpp"
#include "linalg/communicator.hpp"

namespace blockfsi::run
{

SolidSide::SolidSide(const block::Layout& layout, const block::Skeleton& skeleton,
                     const solid::Parameters& parameters, const std::vector<std::int64_t>& interface,
                     Timings& timings)
    : connected_(block::connect(layout, skeleton, parameters.region, linalg::part())),
      numbering_(connected_.mesh.lattice, connected_.mesh.owner), interface_(interface, connected_.mesh),
      X_(block::initial_nodes(connected_, skeleton)),
      solver_(parameters, connected_.mesh, numbering_, X_, timings), state_(solver_.initial()), d_(state_.d),
      load_(state_.d.size(), 0.0)
{
}

void SolidSide::begin(const fem::TimeStep& step)
{
  step_ = step;
  // First guess: the body moves on with its velocity.
  for (std::size_t i = 0; i < d_.size(); ++i)
    d_[i] = state_.d[i] + step.step * state_.v[i];
}

linalg::NewtonReport SolidSide::solve(std::span<const double> load)
{
  interface_.scatter(load, load_);
  return step_.step > 0.0 ? solver_.advance(step_, state_, load_, d_) : solver_.solve_static(load_, d_);
}

void SolidSide::displacement(std::span<double> values) const
{
  interface_.gather(d_, 2, values);
}

void SolidSide::accept()
{
  if (step_.step > 0.0)
    state_ = solver_.finish(step_, state_, d_);
  else
    state_.d = d_;
}

}  // namespace blockfsi::run
