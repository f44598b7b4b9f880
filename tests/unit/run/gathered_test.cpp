#include "run/gathered.hpp"

#include "run/locate.hpp"

#include "../mesh/structured.hpp"

#include <doctest/doctest.h>

#include <array>
#include <vector>

using namespace blockfsi;

TEST_CASE("cells that gather on a process keep the fields of their mesh")
{
  const SampleMesh sample = structured(3, 3, 2, waves, true);
  std::vector<double> field;
  for (const double x : sample.x)
    field.push_back(x * x);
  const run::Gathered gathered = run::gather(sample.mesh, sample.x, field, 2);
  CHECK(gathered.mesh.cell_count() == 6);
  run::Finder finder(gathered.mesh, gathered.x);
  for (const std::array<double, 2> point : {waves(0.1, 0.2), waves(0.77, 0.31), waves(0.5, 0.9)})
    for (int c = 0; c < 2; ++c)
      CHECK(finder.find(point).value(gathered.mesh, gathered.field, 2, c) ==
            doctest::Approx(run::locate(sample.mesh, sample.x, point)->value(sample.mesh, field, 2, c))
                .epsilon(1e-13));
}
