#include "geometry/patch.hpp"

#include "core/error.hpp"
#include "geometry/lagrange.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <utility>

namespace blockfsi::geometry
{

namespace
{

void check_points(std::string_view what, const std::vector<Point>& points, std::size_t needed)
{
  if (points.size() != needed)
    throw Error(fmt::format("{}: found {} points; its order needs {}", what, points.size(), needed));
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i]))
      throw Error(fmt::format("{}: point {} is {}; it must be finite", what, i + 1, text(points[i])));
}

void check_parameters(std::string_view what, const char* name, const std::vector<double>& t)
{
  if (t.size() < 2 || t.size() > max_degree + 1)
    throw Error(fmt::format("{}: found {} parameters along {}; there must be from 2 to {}", what, t.size(),
                            name, max_degree + 1));
  if (t.front() != 0.0 || t.back() != 1.0)
    throw Error(fmt::format("{}: the parameters along {} go from {:.9g} to {:.9g}; they must go from 0 to 1",
                            what, name, t.front(), t.back()));
  for (std::size_t i = 1; i < t.size(); ++i)
    if (!(t[i] > t[i - 1]))
      throw Error(fmt::format("{}: parameter {} along {} is {:.9g}, after {:.9g}; they must ascend", what,
                              i + 1, name, t[i], t[i - 1]));
}

/// Silvester's R_i(s) = prod_(m < i) (n s - m) / (m + 1), i = 0 ... n, with two derivatives.
void silvester(int n, double s, BasisValues& R)
{
  R.value[0] = 1.0;
  R.first[0] = R.second[0] = 0.0;
  for (int i = 0; i < n; ++i)
  {
    const double slope = n / (i + 1.0);
    const double factor = (n * s - i) / (i + 1.0);
    R.value[i + 1] = R.value[i] * factor;
    R.first[i + 1] = R.first[i] * factor + R.value[i] * slope;
    R.second[i + 1] = R.second[i] * factor + 2.0 * R.first[i] * slope;
  }
}

}  // namespace

QuadrilateralPatch equispaced_patch(int order_u, int order_v, std::vector<Point> points)
{
  QuadrilateralPatch patch;
  for (const auto& [direction, order] : {std::pair{0, order_u}, std::pair{1, order_v}})
    for (int i = 0; i <= order; ++i)
      patch.parameters[direction].push_back(static_cast<double>(i) / order);
  patch.points = std::move(points);
  return patch;
}

void check(std::string_view what, const QuadrilateralPatch& patch)
{
  check_parameters(what, "u", patch.parameters[0]);
  check_parameters(what, "v", patch.parameters[1]);
  check_points(what, patch.points, patch.parameters[0].size() * patch.parameters[1].size());
}

void check(std::string_view what, const TrianglePatch& patch)
{
  if (patch.order < 1 || patch.order > max_degree)
    throw Error(fmt::format("{}: the order is {}; it must be from 1 to {}", what, patch.order, max_degree));
  check_points(what, patch.points, static_cast<std::size_t>(patch.order + 1) * (patch.order + 2) / 2);
}

SurfaceJet jet(const QuadrilateralPatch& patch, double u, double v)
{
  BasisValues M;
  BasisValues N;
  lagrange(patch.parameters[0], u, M);
  lagrange(patch.parameters[1], v, N);
  const std::size_t columns = patch.parameters[1].size();
  SurfaceJet result;
  for (std::size_t i = 0; i < patch.parameters[0].size(); ++i)
  {
    CurveJet row;  // along v
    for (std::size_t j = 0; j < columns; ++j)
    {
      const Point& p = patch.points[i * columns + j];
      row.x = add_scaled(row.x, N.value[j], p);
      row.first = add_scaled(row.first, N.first[j], p);
      row.second = add_scaled(row.second, N.second[j], p);
    }
    result.x = add_scaled(result.x, M.value[i], row.x);
    result.u = add_scaled(result.u, M.first[i], row.x);
    result.v = add_scaled(result.v, M.value[i], row.first);
    result.uu = add_scaled(result.uu, M.second[i], row.x);
    result.uv = add_scaled(result.uv, M.first[i], row.first);
    result.vv = add_scaled(result.vv, M.value[i], row.second);
  }
  return result;
}

SurfaceJet jet(const TrianglePatch& patch, double u, double v)
{
  const int n = patch.order;
  BasisValues A;
  BasisValues B;
  BasisValues C;
  silvester(n, u, A);
  silvester(n, v, B);
  silvester(n, 1.0 - u - v, C);
  SurfaceJet result;
  std::size_t next = 0;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i + j <= n; ++i)
    {
      // The third coordinate 1 - u - v falls with u and with v.
      const int k = n - i - j;
      const double a = A.value[i], b = B.value[j], c = C.value[k];
      const double a1 = A.first[i], b1 = B.first[j], c1 = -C.first[k];
      const double a2 = A.second[i], b2 = B.second[j], c2 = C.second[k];
      const Point& p = patch.points[next++];
      result.x = add_scaled(result.x, a * b * c, p);
      result.u = add_scaled(result.u, b * (a1 * c + a * c1), p);
      result.v = add_scaled(result.v, a * (b1 * c + b * c1), p);
      result.uu = add_scaled(result.uu, b * (a2 * c + 2.0 * a1 * c1 + a * c2), p);
      result.vv = add_scaled(result.vv, a * (b2 * c + 2.0 * b1 * c1 + b * c2), p);
      result.uv = add_scaled(result.uv, a1 * (b1 * c + b * c1) + a * (b1 * c1 + b * c2), p);
    }
  return result;
}

}  // namespace blockfsi::geometry
