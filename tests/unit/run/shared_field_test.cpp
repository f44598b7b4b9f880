#include "run/shared_field.hpp"

#include "../mesh/structured.hpp"

#include <doctest/doctest.h>

#include <array>
#include <vector>

using namespace blockfsi;

TEST_CASE("a shared field has the values of the functions of its mesh, and of the nearest node far away")
{
  const SampleMesh sample = structured(3, 3, 2, waves, true);
  std::vector<double> field;
  for (const double x : sample.x)
    field.push_back(x * x);
  run::SharedField shared(sample.mesh, sample.x, field, 2);
  std::vector<double> points;
  for (const std::array<double, 2> point : {waves(0.1, 0.2), waves(0.77, 0.31), waves(0.5, 0.9)})
    points.insert(points.end(), point.begin(), point.end());
  const std::vector<double> values = shared.at(points);
  REQUIRE(values.size() == points.size());
  for (std::size_t k = 0; k < points.size(); k += 2)
    for (int c = 0; c < 2; ++c)
      CHECK(values[k + c] == doctest::Approx(run::locate(sample.mesh, sample.x, {points[k], points[k + 1]})
                                                 ->value(sample.mesh, field, 2, c))
                                 .epsilon(1e-13));
  const std::array<double, 2> corner = waves(1.0, 1.0);
  const std::vector<double> far = shared.at(std::array{corner[0] + 3.0, corner[1] + 2.0});
  for (int c = 0; c < 2; ++c)
    CHECK(far[c] == doctest::Approx(corner[c] * corner[c]).epsilon(1e-14));
}
