#include "run/fluid_side.hpp"

#include "block/place.hpp"
#include "linalg/communicator.hpp"
#include "motion/velocity.hpp"
#include "run/combine.hpp"
#include "run/mesh_update.hpp"

#include <stdexcept>
#include <utility>

namespace blockfsi::run
{

FluidSide::FluidSide(const case_file::Case& description, const block::Skeleton& skeleton,
                     const std::vector<std::int64_t>& interface, coupling::Transfer transfer,
                     Timings& timings)
    : timings_(&timings),
      connected_(block::connect(description.layout, skeleton, description.fluid->region, linalg::part())),
      numbering_(connected_.mesh.lattice, connected_.mesh.owner), interface_(interface, connected_.mesh),
      transfer_(std::move(transfer)), x_(block::initial_nodes(connected_, skeleton)),
      motion_(
          make_update(description, {skeleton, connected_.plan, connected_.mesh, numbering_, x_, interface})),
      displacement_(2 * interface.size(), 0.0), x_new_(x_), x_geometry_(x_), w_(x_.size(), 0.0),
      solver_(*description.fluid, connected_.mesh, numbering_, x_, timings), state_(solver_.initial()),
      z_(3 * connected_.mesh.node_count(), 0.0), reaction_(z_.size(), 0.0),
      quality_tables_(description.layout.order), validity_tables_(description.layout.order),
      first_jacobian_(mesh::sample_jacobian(quality_tables_, connected_.mesh, x_))
{
  measure();
}

void FluidSide::begin(const fem::TimeStep& step)
{
  step_ = step;
  solver_.guess(step, state_, z_);
}

motion::Report FluidSide::move(std::span<const double> displacement)
{
  motion::Report report;
  {
    const Stopwatch watch(*timings_, Task::place);
    has_moved_ = true;
    moved_validity_.reset();
    transfer_.to_fluid(displacement, displacement_);
    report = motion::follow(motion_, displacement_, x_new_);
    motion::mesh_velocity(step_, x_, x_new_, x_geometry_, w_);
  }
  reaction_known_ = false;
  measure();
  return report;
}

linalg::NewtonReport FluidSide::solve()
{
  return solver_.solve(step_, state_, mesh_motion(), z_);
}

void FluidSide::load(std::span<double> values)
{
  reaction_ = solver_.reaction(step_, state_, mesh_motion(), z_);
  reaction_known_ = true;
  std::vector<double> on_fluid(2 * interface_.count());
  interface_.gather(reaction_, 3, on_fluid);
  transfer_.to_solid(on_fluid, values);
  for (double& value : values)
    value = -value;
}

void FluidSide::accept()
{
  if (!reaction_known_)
    reaction_ = solver_.reaction(step_, state_, mesh_motion(), z_);
  reaction_time_ = step_.t + step_.theta * step_.step;
  state_ = solver_.finish(step_, state_, z_);
  x_ = x_new_;
  // A fluid alone keeps its mesh, and all processes must agree on what is known.
  if (has_moved_)
    validity_ = moved_validity_;
  has_moved_ = false;
  motion::accept(motion_, displacement_, x_);
}

void FluidSide::measure()
{
  const Stopwatch watch(*timings_, Task::quality);
  quality_ = combine(mesh::measure(quality_tables_, connected_.mesh, x_new_, first_jacobian_));
}

const mesh::Validity& FluidSide::certify() const
{
  const Stopwatch watch(*timings_, Task::quality);
  if (!validity_)
    validity_ = combine(mesh::certify(validity_tables_, connected_.mesh, x_));
  return *validity_;
}

mesh::Validity FluidSide::certify_moved()
{
  const Stopwatch watch(*timings_, Task::quality);
  moved_validity_ = combine(mesh::certify(validity_tables_, connected_.mesh, x_new_));
  if (!moved_validity_->all_valid() || step_.geometry == 1.0)
    return *moved_validity_;
  return combine(mesh::certify(validity_tables_, connected_.mesh, x_geometry_));
}

void FluidSide::restore(fluid::State state, std::span<const double> displacement,
                        std::span<const double> mesh_memory)
{
  state_ = std::move(state);
  motion::recall(motion_, mesh_memory);
  transfer_.to_fluid(displacement, displacement_);
  if (const motion::Report report = motion::follow(motion_, displacement_, x_); !report.ok)
    throw std::runtime_error(report.failure);
  x_new_ = x_;
  validity_.reset();
  moved_validity_.reset();
  has_moved_ = false;
  measure();
}

}  // namespace blockfsi::run
