#include "fem/projection.hpp"

#include "fem/side_loop.hpp"

#include <algorithm>

namespace blockfsi::fem
{

namespace
{

/// v (f_h - f), for one component.
struct Nearest
{
  static constexpr int unknowns = 1;
  static constexpr int curved = 0;
  static constexpr int data = 1;

  template <class S>
  void operator()(const PointInput<S, 1, 0, 1>& in, PointOutput<S, 1>& out) const
  {
    out.value[0] = in.value[0] - in.data[0];
    out.gradient[0] = {S(lanes(0.0)), S(lanes(0.0))};
  }
};

/// The velocity nearest to u of those with its divergence. Unknowns u_x, u_y, s; data u_x, u_y.
struct NearestWithDivergence
{
  static constexpr int unknowns = 3;
  static constexpr int curved = 0;
  static constexpr int data = 2;

  template <class S>
  void operator()(const PointInput<S, 3, 0, 2>& in, PointOutput<S, 3>& out) const
  {
    const auto& grad = in.gradient;
    for (int i = 0; i < 2; ++i)
    {
      out.value[i] = in.value[i] - in.data[i];  // v (u_h - u)
      out.gradient[i] = {S(lanes(0.0)), S(lanes(0.0))};
      out.gradient[i][i] = -in.value[2];                             // - div v s
      out.gradient[2][i] = (out.value[i] + grad[2][i]) * lanes(0.5)  // 1/2 grad q (u_h - u + grad s)
                           + in.data[i];                             // + grad q u
    }
    out.value[2] = grad[0][0] + grad[1][1];  // q div u_h
  }
};

/// - q u n at the boundary.
struct Outflow
{
  static constexpr int unknowns = 3;
  static constexpr int data = 0;

  const Projection::Velocity* velocity = nullptr;

  template <class S>
  std::array<S, 3> operator()(const SideInput<S, 3, 0>& in) const
  {
    const std::array<double, 2> u = (*velocity)(in.x);
    return {S(0.0), S(0.0), S(-u[0] * in.normal[0] - u[1] * in.normal[1])};
  }
};

/// A linear problem with its factors.
template <Physics P>
class Linear
{
public:
  Linear(CellLoop& cells, const linalg::Numbering& numbering, std::span<const double> x,
         std::span<const std::uint8_t> fixed)
      : cells_(&cells), x_(x), system_(numbering, P::unknowns, cells.mesh().cells,
                                       cells.mesh().nodes_per_cell(), fixed, "projection_")
  {
    const std::vector<double> z(cells.mesh().node_count() * P::unknowns, 0.0);
    cells.tangent(P{}, x, z, {}, system_.cell_matrices());
    system_.assemble();
    status_ = system_.factorise();
  }

  /// Solves from the values that z has; fixed ones stay. `constant` belongs to the residual.
  linalg::Status solve(std::span<const double> given, std::span<const double> constant, std::span<double> z)
  {
    std::vector<double> residual(z.size());
    std::vector<double> increment(z.size());
    // The second solution takes away the round-off of the first.
    for (int k = 0; k < 2 && status_ == linalg::Status::ok; ++k)
    {
      residual.assign(constant.begin(), constant.end());
      cells_->add_residual(P{}, x_, z, {}, residual, given);
      status_ = system_.solve(residual, increment);
      for (std::size_t i = 0; i < z.size(); ++i)
        z[i] -= increment[i];
    }
    return status_;
  }

private:
  CellLoop* cells_;
  std::span<const double> x_;
  linalg::System system_;
  linalg::Status status_ = linalg::Status::ok;
};

}  // namespace

Projection::Projection(const mesh::Mesh& mesh, const linalg::Numbering& numbering, std::span<const double> x,
                       int points)
    : numbering_(&numbering), x_(x.begin(), x.end()), cells_(mesh, points), quadrature_(cells_.quadrature(x))
{
}

linalg::Status Projection::scalars(std::span<const double> given, int components, std::span<double> nodal)
{
  const std::vector<std::uint8_t> fixed(cells_.mesh().node_count(), 0);
  const std::vector<double> none(fixed.size(), 0.0);
  Linear<Nearest> problem(cells_, *numbering_, x_, fixed);
  std::vector<double> one(given.size() / components);
  for (int c = 0; c < components; ++c)
  {
    for (std::size_t k = 0; k < one.size(); ++k)
      one[k] = given[k * components + c];
    std::vector<double> z(fixed.size(), 0.0);
    if (const linalg::Status status = problem.solve(one, none, z); status != linalg::Status::ok)
      return status;
    for (std::size_t node = 0; node < z.size(); ++node)
      nodal[node * components + c] = z[node];
  }
  return linalg::Status::ok;
}

void Projection::add_outflow(const Velocity& at_boundary, std::span<double> residual)
{
  const std::vector<double> z(residual.size(), 0.0);
  SideLoop sides(cells_.mesh(), cells_.table().points);
  for (const auto& [name, of_boundary] : cells_.mesh().boundaries)
    sides.add_residual(Outflow{&at_boundary}, of_boundary, x_, z, {}, residual);
}

std::vector<double> Projection::boundary_points()
{
  std::vector<double> result;
  const Velocity note = [&result](const std::array<double, 2>& x)
  {
    result.insert(result.end(), x.begin(), x.end());
    return std::array{0.0, 0.0};
  };
  std::vector<double> unused(3 * cells_.mesh().node_count());
  add_outflow(note, unused);
  return result;
}

linalg::Status Projection::velocity(std::span<const double> given, const Velocity& at_boundary,
                                    std::span<const std::uint8_t> fixed, std::span<double> u)
{
  std::vector<double> z(fixed.size(), 0.0);
  for (std::size_t i = 0; i < u.size(); ++i)
    if (fixed[3 * (i / 2) + i % 2] != 0)
      z[3 * (i / 2) + i % 2] = u[i];
  std::vector<double> outflow(z.size(), 0.0);
  add_outflow(at_boundary, outflow);
  const linalg::Status status =
      Linear<NearestWithDivergence>(cells_, *numbering_, x_, fixed).solve(given, outflow, z);
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] = z[3 * (i / 2) + i % 2];
  return status;
}

}  // namespace blockfsi::fem
