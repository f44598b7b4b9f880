#include "block/corner_samples.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

using namespace blockfsi;
using namespace blockfsi::block;

TEST_CASE("samples of coarse blocks differentiate polynomials of their degree exactly")
{
  for (const element::Shape shape :
       {element::Shape::triangle, element::Shape::quadrilateral, element::Shape::hexahedron})
    for (const int degree : {2, 4})
    {
      const CornerSamples samples = corner_samples(shape, degree);
      const bool flat = samples.dim == 2;
      const auto f = [&](const std::array<double, 3>& r)
      { return std::pow(r[0], degree) + r[0] * r[1] + (flat ? 0.0 : 3.0 * r[1] * r[2]); };
      const auto gradient = [&](const std::array<double, 3>& r)
      {
        return std::array<double, 3>{degree * std::pow(r[0], degree - 1) + r[1],
                                     r[0] + (flat ? 0.0 : 3.0 * r[2]), 3.0 * r[1]};
      };
      for (int s = 0; s < samples.count; ++s)
        for (int axis = 0; axis < samples.dim; ++axis)
        {
          double sum = 0.0;
          for (int t = 0; t < samples.count; ++t)
            sum += samples.derivative[(axis * samples.count + s) * samples.count + t] * f(samples.point[t]);
          CHECK(sum == doctest::Approx(gradient(samples.point[s])[axis]).epsilon(1e-11));
        }
    }
}

TEST_CASE("weights of samples are positive with sum 1, functions of corners are 1 there and sum to 1")
{
  for (const element::Shape shape :
       {element::Shape::triangle, element::Shape::quadrilateral, element::Shape::hexahedron})
  {
    const CornerSamples samples = corner_samples(shape, 4);
    CHECK(std::accumulate(samples.weight.begin(), samples.weight.end(), 0.0) ==
          doctest::Approx(1.0).epsilon(1e-13));
    int corners = 0;
    for (int s = 0; s < samples.count; ++s)
    {
      CHECK(samples.weight[s] > 0.0);
      double sum = 0.0;
      for (int c = 0; c < samples.corner_count; ++c)
      {
        const double value = samples.basis[s * samples.corner_count + c];
        sum += value;
        corners += value == 1.0;
      }
      CHECK(sum == doctest::Approx(1.0).epsilon(1e-14));
    }
    CHECK(corners == samples.corner_count);
  }
}
