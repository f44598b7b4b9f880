#include "geometry/patch.hpp"

#include "core/error.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace blockfsi;
using namespace blockfsi::geometry;

namespace
{

/// x = (u^n, v^n, u^a v^b), a + b = n, with its derivatives.
SurfaceJet monomials(int n, double u, double v)
{
  const int b = n / 2;
  const int a = n - b;
  const auto power = [](double s, int k) { return k < 0 ? 0.0 : std::pow(s, k); };
  SurfaceJet s;
  s.x = {power(u, n), power(v, n), power(u, a) * power(v, b)};
  s.u = {n * power(u, n - 1), 0.0, a * power(u, a - 1) * power(v, b)};
  s.v = {0.0, n * power(v, n - 1), b * power(u, a) * power(v, b - 1)};
  s.uu = {n * (n - 1) * power(u, n - 2), 0.0, a * (a - 1) * power(u, a - 2) * power(v, b)};
  s.uv = {0.0, 0.0, a * b * power(u, a - 1) * power(v, b - 1)};
  s.vv = {0.0, n * (n - 1) * power(v, n - 2), b * (b - 1) * power(u, a) * power(v, b - 2)};
  return s;
}

double difference(const SurfaceJet& a, const SurfaceJet& b)
{
  return distance(a.x, b.x) + distance(a.u, b.u) + distance(a.v, b.v) + distance(a.uu, b.uu) +
         distance(a.uv, b.uv) + distance(a.vv, b.vv);
}

template <typename Patch>
std::string message_of(const Patch& patch)
{
  try
  {
    check("the patch", patch);
  }
  catch (const Error& error)
  {
    return error.message();
  }
  return "";
}

}  // namespace

TEST_CASE("patches reproduce polynomials of their order with both derivatives")
{
  for (int n = 1; n <= 8; ++n)
  {
    std::vector<Point> square;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        square.push_back(monomials(n, static_cast<double>(i) / n, static_cast<double>(j) / n).x);
    const QuadrilateralPatch quadrilateral = equispaced_patch(n, n, square);
    TrianglePatch triangle{n, {}};
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i + j <= n; ++i)
        triangle.points.push_back(monomials(n, static_cast<double>(i) / n, static_cast<double>(j) / n).x);
    CHECK(message_of(quadrilateral) == "");
    CHECK(message_of(triangle) == "");
    for (const double u : {0.0, 0.13, 0.5, 0.77})
      for (const double v : {0.0, 0.06, 0.23})
      {
        // Second derivatives amplify roundings of the points by about n^4.
        CHECK(difference(jet(quadrilateral, u, v), monomials(n, u, v)) < 1e-14 * std::pow(n, 4) + 1e-14);
        CHECK(difference(jet(triangle, u, v), monomials(n, u, v)) < 1e-14 * std::pow(n, 4) + 1e-14);
      }
  }
}

TEST_CASE("a patch with uneven parameters passes through its points there")
{
  QuadrilateralPatch patch;
  patch.parameters = {std::vector<double>{0.0, 0.3, 1.0}, std::vector<double>{0.0, 1.0}};
  patch.points = {{0, 0, 1}, {0, 1, 0}, {1, 0, 2}, {1, 1, 0}, {2, 0, 0}, {2, 1, 5}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      CHECK(jet(patch, patch.parameters[0][i], patch.parameters[1][j]).x == patch.points[2 * i + j]);
}

TEST_CASE("wrong patches are refused with the reason")
{
  QuadrilateralPatch patch = equispaced_patch(2, 1, std::vector<Point>(5));
  CHECK(message_of(patch) == "the patch: found 5 points; its order needs 6");
  patch.parameters[0][1] = 1.0;
  CHECK(message_of(patch) == "the patch: parameter 3 along u is 1, after 1; they must ascend");
  patch.parameters[0] = {0.0, 0.5};
  CHECK(message_of(patch) == "the patch: the parameters along u go from 0 to 0.5; they must go from 0 to 1");
  patch.parameters[1] = {0.0};
  patch.parameters[0] = {0.0, 1.0};
  CHECK(message_of(patch) == "the patch: found 1 parameters along v; there must be from 2 to 26");
  CHECK(message_of(TrianglePatch{0, {}}) == "the patch: the order is 0; it must be from 1 to 25");
  CHECK(message_of(TrianglePatch{2, std::vector<Point>(5)}) ==
        "the patch: found 5 points; its order needs 6");
}
