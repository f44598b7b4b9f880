#pragma once

#include "core/dual.hpp"
#include "fem/cell_loop.hpp"
#include "mesh/mesh.hpp"

#include <array>
#include <span>
#include <vector>

namespace blockfsi::fem
{

/// What a physics sees at a quadrature point of a side. S is double or Dual<double, 3 Unknowns>.
template <class S, int Unknowns, int Data>
struct SideInput
{
  std::array<S, Unknowns> value;
  std::array<std::array<S, 2>, Unknowns> gradient;
  std::array<double, Data> data;
  std::array<double, 2> x;       ///< [m]
  std::array<double, 2> normal;  ///< unit, outward
};

/// Integrates weak forms over sides of cells. Sides are few: one at a time.
class SideLoop
{
public:
  /// `points`: Gauss points on a side. The mesh must outlive the loop.
  SideLoop(const mesh::Mesh& mesh, int points);

  /// Adds to the residual of all sides the integral of test function times physics(in)[u]; arguments as
  /// CellLoop.
  template <class P>
  void add_residual(const P& physics, std::span<const mesh::Side> sides, std::span<const double> x,
                    std::span<const double> unknown, std::span<const NodalField> data,
                    std::span<double> residual);

  /// Adds the derivative to the matrices of the cells that the sides belong to.
  template <class P>
  void add_tangent(const P& physics, std::span<const mesh::Side> sides, std::span<const double> x,
                   std::span<const double> unknown, std::span<const NodalField> data,
                   std::span<double> matrices);

private:
  /// Values and derivatives of all functions of a cell at a point of a side.
  struct Basis
  {
    std::vector<double> value;
    std::vector<double> xi;
    std::vector<double> eta;
  };
  /// Position, normal and physical gradients of the functions at one point of a side.
  struct Point
  {
    std::array<double, 2> x{};
    std::array<double, 2> normal{};
    double weight = 0.0;
    std::vector<std::array<double, 2>> gradient;
  };

  const Basis& basis(int side, int q) const { return basis_[side * static_cast<int>(weights_.size()) + q]; }
  void locate(const mesh::Side& side, int q, std::span<const double> x);
  template <class P, class S>
  SideInput<S, P::unknowns, P::data> input(const mesh::Side& side, int q, std::span<const double> unknown,
                                           std::span<const NodalField> data) const;

  const mesh::Mesh* mesh_;
  std::vector<double> weights_;
  std::vector<Basis> basis_;
  Point point_;
};

template <class P, class S>
SideInput<S, P::unknowns, P::data> SideLoop::input(const mesh::Side& side, int q,
                                                   std::span<const double> unknown,
                                                   std::span<const NodalField> data) const
{
  const auto nodes = mesh_->cell(side.cell);
  const Basis& functions = basis(side.side, q);
  SideInput<S, P::unknowns, P::data> in;
  in.x = point_.x;
  in.normal = point_.normal;
  const auto number = [](double value, int i)
  {
    if constexpr (std::is_same_v<S, double>)
    {
      static_cast<void>(i);
      return value;
    }
    else
      return S::input(value, i);
  };
  for (int u = 0; u < P::unknowns; ++u)
  {
    double value = 0.0;
    std::array<double, 2> gradient{};
    for (std::size_t a = 0; a < nodes.size(); ++a)
    {
      const double nodal = unknown[static_cast<std::size_t>(nodes[a]) * P::unknowns + u];
      value += functions.value[a] * nodal;
      for (int k = 0; k < 2; ++k)
        gradient[k] += point_.gradient[a][k] * nodal;
    }
    in.value[u] = number(value, u);
    for (int k = 0; k < 2; ++k)
      in.gradient[u][k] = number(gradient[k], P::unknowns + 2 * u + k);
  }
  int entry = 0;
  for (const NodalField& field : data)
    for (int c = 0; c < field.components; ++c, ++entry)
    {
      in.data[entry] = 0.0;
      for (std::size_t a = 0; a < nodes.size(); ++a)
        in.data[entry] +=
            functions.value[a] * field.values[static_cast<std::size_t>(nodes[a]) * field.components + c];
    }
  return in;
}

template <class P>
void SideLoop::add_residual(const P& physics, std::span<const mesh::Side> sides, std::span<const double> x,
                            std::span<const double> unknown, std::span<const NodalField> data,
                            std::span<double> residual)
{
  for (const mesh::Side& side : sides)
    for (int q = 0; q < static_cast<int>(weights_.size()); ++q)
    {
      locate(side, q, x);
      const std::array<double, P::unknowns> out = physics(input<P, double>(side, q, unknown, data));
      const auto nodes = mesh_->cell(side.cell);
      for (std::size_t a = 0; a < nodes.size(); ++a)
        for (int u = 0; u < P::unknowns; ++u)
          residual[static_cast<std::size_t>(nodes[a]) * P::unknowns + u] +=
              point_.weight * basis(side.side, q).value[a] * out[u];
    }
}

template <class P>
void SideLoop::add_tangent(const P& physics, std::span<const mesh::Side> sides, std::span<const double> x,
                           std::span<const double> unknown, std::span<const NodalField> data,
                           std::span<double> matrices)
{
  using S = Dual<double, 3 * P::unknowns>;
  const std::size_t n = mesh_->nodes_per_cell();
  const std::size_t size = n * P::unknowns;
  for (const mesh::Side& side : sides)
    for (int q = 0; q < static_cast<int>(weights_.size()); ++q)
    {
      locate(side, q, x);
      const std::array<S, P::unknowns> out = physics(input<P, S>(side, q, unknown, data));
      const Basis& functions = basis(side.side, q);
      double* matrix = matrices.data() + side.cell * size * size;
      for (std::size_t a = 0; a < n; ++a)
        for (int u = 0; u < P::unknowns; ++u)
          for (std::size_t b = 0; b < n; ++b)
            for (int v = 0; v < P::unknowns; ++v)
            {
              const auto& d = out[u].derivative;
              const double change = d[v] * functions.value[b] +
                                    d[P::unknowns + 2 * v] * point_.gradient[b][0] +
                                    d[P::unknowns + 2 * v + 1] * point_.gradient[b][1];
              matrix[(a * P::unknowns + u) * size + b * P::unknowns + v] +=
                  point_.weight * functions.value[a] * change;
            }
    }
}

}  // namespace blockfsi::fem
