// Templates of fem/cell_loop.hpp.

#include <algorithm>

namespace blockfsi::fem
{

namespace detail
{

/// Number of derivatives that a tangent needs: values, gradients, second derivatives.
template <class P>
inline constexpr int input_count = 3 * P::unknowns + 3 * P::curved;

/// Index of an input among the derivatives.
template <class P>
constexpr int value_input(int unknown)
{
  return unknown;
}
template <class P>
constexpr int gradient_input(int unknown, int direction)
{
  return P::unknowns + 2 * unknown + direction;
}
template <class P>
constexpr int second_input(int unknown, int k)
{
  return 3 * P::unknowns + 3 * unknown + k;
}

}  // namespace detail

/// Fills values_: for each point the values, gradients, second derivatives of the unknowns, then the data.
template <class P>
void CellLoop::evaluate(std::size_t batch, std::span<const double> x, std::span<const double> unknown,
                        std::span<const NodalField> data, std::span<const double> given)
{
  constexpr int inputs = detail::input_count<P>;
  constexpr int width = inputs + P::data;
  const int n = mesh_->nodes_per_cell();
  const int m = table_.points * table_.points;
  nodal_.resize(static_cast<std::size_t>(n) * std::max(2, std::max(P::unknowns, P::data)));
  values_.resize(static_cast<std::size_t>(m) * width);

  gather(batch, {x.data(), 2}, nodal_.data());
  geometry_.compute(table_, nodal_.data(), P::curved > 0);

  constexpr int max_points = max_line * max_line;
  Lanes reference[6][max_points];
  gather(batch, {unknown.data(), P::unknowns}, nodal_.data());
  for (int u = 0; u < P::unknowns; ++u)
  {
    const bool curved = u < P::curved;
    ReferenceValues out{reference[0], reference[1], reference[2], nullptr, nullptr, nullptr};
    if (curved)
      out = {reference[0], reference[1], reference[2], reference[3], reference[4], reference[5]};
    interpolate(table_, nodal_.data() + u * n, out);
    for (int q = 0; q < m; ++q)
    {
      Lanes* value = values_.data() + static_cast<std::size_t>(q) * width;
      const CellGeometry::Point& point = geometry_.points[q];
      const std::array<Lanes, 2> grad = gradient(point, reference[1][q], reference[2][q]);
      value[detail::value_input<P>(u)] = reference[0][q];
      for (int k = 0; k < 2; ++k)
        value[detail::gradient_input<P>(u, k)] = grad[k];
      if (curved)
      {
        const std::array<Lanes, 3> h = second(point, grad, reference[3][q], reference[4][q], reference[5][q]);
        for (int k = 0; k < 3; ++k)
          value[detail::second_input<P>(u, k)] = h[k];
      }
    }
  }

  int entry = inputs;
  for (const NodalField& field : data)
  {
    gather(batch, field, nodal_.data());
    for (int c = 0; c < field.components; ++c, ++entry)
    {
      interpolate(table_, nodal_.data() + c * n, {reference[0]});
      for (int q = 0; q < m; ++q)
        values_[static_cast<std::size_t>(q) * width + entry] = reference[0][q];
    }
  }
  const std::size_t rest = given.empty() ? 0 : width - entry;
  for (int lane = 0; lane < lane_count && rest > 0; ++lane)
    for (int q = 0; q < m; ++q)
      for (std::size_t c = 0; c < rest; ++c)
        values_[static_cast<std::size_t>(q) * width + entry + c][lane] =
            given[(cell(batch, lane) * m + q) * rest + c];
}

namespace detail
{

/// The inputs of a point, either as plain numbers or each with its own derivative.
template <class P, class S>
PointInput<S, P::unknowns, P::curved, P::data> point_input(const Lanes* values,
                                                           const CellGeometry::Point& point)
{
  const auto number = [values](int i)
  {
    if constexpr (std::is_same_v<S, Lanes>)
      return values[i];
    else
      return S::input(values[i], i);
  };
  PointInput<S, P::unknowns, P::curved, P::data> in;
  for (int u = 0; u < P::unknowns; ++u)
  {
    in.value[u] = number(value_input<P>(u));
    for (int k = 0; k < 2; ++k)
      in.gradient[u][k] = number(gradient_input<P>(u, k));
  }
  for (int u = 0; u < P::curved; ++u)
    for (int k = 0; k < 3; ++k)
      in.second[u][k] = number(second_input<P>(u, k));
  for (int d = 0; d < P::data; ++d)
    in.data[d] = values[input_count<P> + d];
  in.metric = point.metric;
  return in;
}

}  // namespace detail

template <Physics P>
void CellLoop::add_residual(const P& physics, std::span<const double> x, std::span<const double> unknown,
                            std::span<const NodalField> data, std::span<double> residual,
                            std::span<const double> given)
{
  constexpr int width = detail::input_count<P> + P::data;
  constexpr int max_points = max_line * max_line;
  const int n = mesh_->nodes_per_cell();
  const int m = table_.points * table_.points;
  Lanes factor[P::unknowns][3][max_points];
  residual_.resize(n);
  for (std::size_t batch = 0; batch < batch_count(); ++batch)
  {
    evaluate<P>(batch, x, unknown, data, given);
    for (int q = 0; q < m; ++q)
    {
      const CellGeometry::Point& point = geometry_.points[q];
      const auto in =
          detail::point_input<P, Lanes>(values_.data() + static_cast<std::size_t>(q) * width, point);
      PointOutput<Lanes, P::unknowns> out;
      physics(in, out);
      for (int u = 0; u < P::unknowns; ++u)
      {
        const auto& a = point.inverse;
        factor[u][0][q] = out.value[u] * point.weight;
        for (int k = 0; k < 2; ++k)
          factor[u][1 + k][q] = (a[k][0] * out.gradient[u][0] + a[k][1] * out.gradient[u][1]) * point.weight;
      }
    }
    for (int u = 0; u < P::unknowns; ++u)
    {
      std::fill(residual_.begin(), residual_.end(), Lanes{});
      integrate(table_, factor[u][0], factor[u][1], factor[u][2], residual_.data());
      for (int lane = 0; lane < used(batch); ++lane)
      {
        const std::int32_t* nodes = mesh_->cells.data() + cell(batch, lane) * n;
        for (int i = 0; i < n; ++i)
          residual[static_cast<std::size_t>(nodes[i]) * P::unknowns + u] += residual_[i][lane];
      }
    }
  }
}

template <Physics P>
void CellLoop::tangent(const P& physics, std::span<const double> x, std::span<const double> unknown,
                       std::span<const NodalField> data, std::span<double> matrices)
{
  constexpr int inputs = detail::input_count<P>;
  constexpr int width = inputs + P::data;
  constexpr int outputs = 3 * P::unknowns;
  using S = Dual<Lanes, inputs>;
  const int m = table_.points * table_.points;
  factors_.resize(static_cast<std::size_t>(m) * outputs * inputs);
  for (std::size_t batch = 0; batch < batch_count(); ++batch)
  {
    evaluate<P>(batch, x, unknown, data);
    for (int q = 0; q < m; ++q)
    {
      const CellGeometry::Point& point = geometry_.points[q];
      const auto in = detail::point_input<P, S>(values_.data() + static_cast<std::size_t>(q) * width, point);
      PointOutput<S, P::unknowns> out;
      physics(in, out);
      Lanes* factor = factors_.data() + static_cast<std::size_t>(q) * outputs * inputs;
      for (int u = 0; u < P::unknowns; ++u)
        for (int k = 0; k < 3; ++k)
        {
          const S& value = k == 0 ? out.value[u] : out.gradient[u][k - 1];
          for (int i = 0; i < inputs; ++i)
            factor[(3 * u + k) * inputs + i] = value.derivative[i] * point.weight;
        }
    }
    write_tangent<P>(batch, matrices);
  }
}

/// Fills values_ with the functions of a batch of cells in physical coordinates, shape (nodes, points, 6):
/// N, N_x, N_y, N_xx, N_xy, N_yy, the last three only if asked for.
inline void CellLoop::tabulate(bool second_derivatives)
{
  const int n = mesh_->nodes_per_cell();
  const int nodes = table_.nodes;
  const int points = table_.points;
  const int m = points * points;
  values_.resize(static_cast<std::size_t>(n) * m * 6);
  for (int b = 0; b < n; ++b)
    for (int q = 0; q < m; ++q)
    {
      const int q1 = (q % points) * nodes + b % nodes;
      const int q2 = (q / points) * nodes + b / nodes;
      const CellGeometry::Point& point = geometry_.points[q];
      Lanes* s = values_.data() + (static_cast<std::size_t>(b) * m + q) * 6;
      const auto grad = gradient(point, lanes(table_.first[q1] * table_.value[q2]),
                                 lanes(table_.value[q1] * table_.first[q2]));
      s[0] = lanes(table_.value[q1] * table_.value[q2]);
      s[1] = grad[0];
      s[2] = grad[1];
      if (!second_derivatives)
        continue;
      const auto h =
          second(point, grad, lanes(table_.second[q1] * table_.value[q2]),
                 lanes(table_.first[q1] * table_.first[q2]), lanes(table_.value[q1] * table_.second[q2]));
      std::copy(h.begin(), h.end(), s + 3);
    }
}

/// Contracts the factors of all points with one trial function, shape (points, outputs, unknowns).
template <class P>
void CellLoop::contract(int trial)
{
  constexpr int inputs = detail::input_count<P>;
  constexpr int outputs = 3 * P::unknowns;
  const int m = table_.points * table_.points;
  contracted_.resize(static_cast<std::size_t>(m) * outputs * P::unknowns);
  Lanes* out = contracted_.data();
  const Lanes* factor = factors_.data();
  const Lanes* s = values_.data() + static_cast<std::size_t>(trial) * m * 6;
  for (int q = 0; q < m; ++q, s += 6)
    for (int o = 0; o < outputs; ++o, factor += inputs)
      for (int v = 0; v < P::unknowns; ++v)
      {
        Lanes sum = factor[detail::value_input<P>(v)] * s[0];
        for (int k = 0; k < 2; ++k)
          sum += factor[detail::gradient_input<P>(v, k)] * s[1 + k];
        if (v < P::curved)
          for (int k = 0; k < 3; ++k)
            sum += factor[detail::second_input<P>(v, k)] * s[3 + k];
        *out++ = sum;
      }
}

/// Contracts the factors of a batch with test and trial functions:
/// K(a u, b v) = sum_q sum_k sum_l T_k(a) factor(u k, v l) S_l(b),
/// with T = (N, N_x, N_y) and S = (N, N_x, N_y, N_xx, N_xy, N_yy).
template <class P>
void CellLoop::write_tangent(std::size_t batch, std::span<double> matrices)
{
  const int n = mesh_->nodes_per_cell();
  const int m = table_.points * table_.points;
  const int size = n * P::unknowns;
  tabulate(P::curved > 0);
  for (int b = 0; b < n; ++b)
  {
    contract<P>(b);
    for (int a = 0; a < n; ++a)
    {
      Lanes block[P::unknowns * P::unknowns] = {};
      const Lanes* in = contracted_.data();
      const Lanes* t = values_.data() + static_cast<std::size_t>(a) * m * 6;
      for (int q = 0; q < m; ++q, t += 6)
        for (int u = 0; u < P::unknowns; ++u)
          for (int k = 0; k < 3; ++k)
            for (int v = 0; v < P::unknowns; ++v)
              block[u * P::unknowns + v] += t[k] * *in++;
      for (int lane = 0; lane < used(batch); ++lane)
      {
        double* matrix = matrices.data() + (batch * lane_count + lane) * size * size;
        for (int u = 0; u < P::unknowns; ++u)
          for (int v = 0; v < P::unknowns; ++v)
            matrix[(a * P::unknowns + u) * size + b * P::unknowns + v] = block[u * P::unknowns + v][lane];
      }
    }
  }
}

}  // namespace blockfsi::fem
