#include "motion/extension.hpp"

#include "linalg/communicator.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace blockfsi::motion
{

namespace
{

/// Normal derivative of the displacement of a mesh that turns with the interface and keeps its thickness:
/// n' - n, where n' is the normal after the motion. What the gradient says across the interface is not used.
struct TurnedNormal
{
  static constexpr int unknowns = 2;
  static constexpr int data = 0;

  template <class S>
  std::array<S, 2> operator()(const fem::SideInput<S, 2, 0>& in) const
  {
    const std::array<double, 2>& n = in.normal;
    // The tangent (-n_y, n_x) and what becomes of it.
    std::array<S, 2> t = {S(-n[1]), S(n[0])};
    for (int c = 0; c < 2; ++c)
      t[c] = t[c] - in.gradient[c][0] * n[1] + in.gradient[c][1] * n[0];
    const S length = sqrt(t[0] * t[0] + t[1] * t[1]);
    return {t[1] / length - n[0], -t[0] / length - n[1]};
  }
};

std::vector<double> interleave(std::span<const double> a, std::span<const double> b)
{
  std::vector<double> result(2 * a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    result[2 * i] = a[i];
    result[2 * i + 1] = b[i];
  }
  return result;
}

}  // namespace

Extension::Extension(const Equation& equation, const Stiffness& stiffness, From from,
                     const std::vector<std::string>& slide, const Domain& domain)
    : equation_(equation), from_(from), mesh_(&domain.mesh), numbering_(&domain.numbering),
      first_x_(domain.x.begin(), domain.x.end()), base_x_(first_x_),
      base_displacement_(2 * domain.interface.size(), 0.0),
      boundary_(find_boundary(domain.mesh, domain.numbering, domain.x, domain.interface, slide)),
      distance_(interleave(distance_to_interface(domain.skeleton, domain.interface, domain.x),
                           distance_to_points(stiffness.at, domain.x))),
      cells_(domain.mesh, fem::quadrature_points(domain.mesh.order)),
      sides_(domain.mesh, fem::quadrature_points(domain.mesh.order))
{
}

Extension::Extension(const PseudoSolid& parameters, const Domain& domain)
    : Extension(Elasticity::from(parameters), parameters.stiffness, parameters.from, parameters.slide, domain)
{
}

Extension::Extension(const Harmonic& parameters, const Domain& domain)
    : Extension(Diffusion{{parameters.stiffness}}, parameters.stiffness, parameters.from, parameters.slide,
                domain)
{
}

Extension::Extension(const Biharmonic& parameters, const Domain& domain)
    : Extension(Plate{}, {}, From::first, parameters.slide, domain)
{
  slope_ = parameters.slope;
}

int Extension::width() const
{
  return std::visit([](const auto& equation) { return std::decay_t<decltype(equation)>::unknowns; },
                    equation_);
}

int Extension::lifted() const
{
  return std::holds_alternative<Elasticity>(equation_) ? 2 : 1;
}

/// One system for both components together or, where they do not mix, for each; components with the same
/// prescribed nodes share one.
void Extension::make_parts()
{
  const std::vector<std::uint8_t>& fixed = boundary_.fixed;
  const std::size_t count = mesh_->node_count();
  const auto add = [&](std::vector<std::uint8_t> marks, std::vector<int> components)
  {
    parts_.push_back(
        {linalg::System(*numbering_, width(), mesh_->cells, mesh_->nodes_per_cell(), marks, "motion_"),
         std::move(components)});
  };
  if (lifted() == 2)
  {
    add(fixed, {0});
    return;
  }
  bool alike = true;
  for (std::size_t node = 0; node < count; ++node)
    alike = alike && fixed[2 * node] == fixed[2 * node + 1];
  alike = !linalg::any(!alike);
  for (int component = 0; component < (alike ? 1 : 2); ++component)
  {
    std::vector<std::uint8_t> marks(width() * count, 0);
    for (std::size_t node = 0; node < count; ++node)
      marks[width() * node] = fixed[2 * node + component];
    add(std::move(marks), alike ? std::vector<int>{0, 1} : std::vector<int>{component});
  }
}

/// Makes the factors for the mesh from which displacements are counted.
bool Extension::renew()
{
  if (parts_.empty())
    make_parts();
  const std::vector<double> zero(width() * mesh_->node_count(), 0.0);
  for (Part& part : parts_)
  {
    std::visit(
        [&](const auto& equation)
        {
          std::vector<fem::NodalField> data;
          if constexpr (std::decay_t<decltype(equation)>::data > 0)
            data.push_back({distance_.data(), 2});
          cells_.tangent(equation, base_x_, zero, data, part.system.cell_matrices());
        },
        equation_);
    part.system.assemble();
    if (part.system.factorise() != linalg::Status::ok)
      return false;
  }
  stale_ = false;
  ++factorisations_;
  return true;
}

bool Extension::solve(Part& part, int component, std::span<const double> lift, std::span<const double> slope,
                      std::span<double> u)
{
  const int unknowns = width();
  const int count = mesh_->nodes_per_cell();
  const int size = unknowns * count;
  const std::span<const double> matrices = part.system.cell_matrices();
  std::vector<double> residual(unknowns * mesh_->node_count(), 0.0);
  for (std::size_t i = 0; i < slope.size() / 2; ++i)
    residual[2 * i + 1] = -slope[2 * i + component];
  for (std::size_t c = 0; c < mesh_->cell_count(); ++c)
  {
    const std::span<const std::int32_t> nodes = mesh_->cell(c);
    const double* matrix = matrices.data() + c * size * size;
    for (int b = 0; b < count; ++b)
      for (int k = 0; k < lifted(); ++k)
      {
        const double value = lift[2 * static_cast<std::size_t>(nodes[b]) + component + k];
        // Only cells at the interface have any.
        for (int row = 0; value != 0.0 && row < size; ++row)
          residual[static_cast<std::size_t>(nodes[row / unknowns]) * unknowns + row % unknowns] +=
              matrix[row * size + b * unknowns + k] * value;
      }
  }
  std::vector<double> increment(residual.size());
  if (part.system.solve(residual, increment) != linalg::Status::ok)
    return false;
  for (std::size_t node = 0; node < mesh_->node_count(); ++node)
    for (int k = 0; k < lifted(); ++k)
      u[2 * node + component + k] = lift[2 * node + component + k] - increment[unknowns * node + k];
  return true;
}

Report Extension::extend(std::span<const double> lift, std::span<const double> slope, std::span<double> u)
{
  const int before = factorisations_;
  Report report;
  const bool ready = !stale_ || renew();
  report.factorisations = factorisations_ - before;
  bool solved = ready;
  for (Part& part : parts_)
    for (const int component : part.components)
      solved = solved && solve(part, component, lift, slope, u);
  if (!ready)
    report.failure = "the matrix of the mesh equations is singular";
  else if (!solved)
    report.failure = "the mesh equations could not be solved";
  report.ok = solved;
  return report;
}

std::vector<double> Extension::slope_of(std::span<const double> lift)
{
  if (!std::holds_alternative<Plate>(equation_))
    return {};
  std::vector<double> result(lift.size(), 0.0);
  const auto found = mesh_->boundaries.find("interface");
  if (slope_ == Slope::turned && found != mesh_->boundaries.end())
    sides_.add_residual(TurnedNormal{}, found->second, base_x_, lift, {}, result);
  return result;
}

Report Extension::follow(std::span<const double> displacement, std::span<double> x)
{
  std::copy(base_x_.begin(), base_x_.end(), x.begin());
  if (std::equal(displacement.begin(), displacement.end(), base_displacement_.begin()))
    return {};
  std::vector<double> lift(x.size(), 0.0);
  for (const Boundary::Moving& at : boundary_.moving)
    for (int c = 0; c < 2; ++c)
    {
      const std::size_t i = 2 * static_cast<std::size_t>(at.node) + c;
      lift[i] = first_x_[i] + displacement[2 * at.index + c] - base_x_[i];
    }
  std::vector<double> u(x.size(), 0.0);
  Report report = extend(lift, slope_of(lift), u);
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] += u[i];
  for (const Boundary::Moving& at : boundary_.moving)
    for (int c = 0; c < 2; ++c)
    {
      const std::size_t i = 2 * static_cast<std::size_t>(at.node) + c;
      x[i] = first_x_[i] + displacement[2 * at.index + c];
    }
  return report;
}

void Extension::accept(std::span<const double> displacement, std::span<const double> x)
{
  if (from_ == From::first ||
      std::equal(displacement.begin(), displacement.end(), base_displacement_.begin()))
    return;
  base_x_.assign(x.begin(), x.end());
  base_displacement_.assign(displacement.begin(), displacement.end());
  stale_ = true;
}

std::vector<double> Extension::memory() const
{
  if (from_ == From::first)
    return {};
  std::vector<double> result = base_displacement_;
  result.insert(result.end(), base_x_.begin(), base_x_.end());
  return result;
}

void Extension::recall(std::span<const double> memory)
{
  if (from_ == From::first)
    return;
  const std::size_t count = base_displacement_.size();
  std::copy_n(memory.begin(), count, base_displacement_.begin());
  std::copy(memory.begin() + static_cast<std::ptrdiff_t>(count), memory.end(), base_x_.begin());
  stale_ = true;
}

}  // namespace blockfsi::motion
