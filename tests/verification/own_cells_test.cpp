// Turek & Hron's FSI1 on a coarse mesh, with a solid that has cells of its own.

#include "whole_case.hpp"

#include <cmath>

using namespace blockfsi;

namespace
{

struct Result
{
  double deflection = 0.0;  ///< of the flag's tip [m]
  double lift = 0.0;        ///< of the flag alone [N/m]
  int iterations = 0;
};

Result flag(std::vector<std::string> settings)
{
  settings.emplace_back("blocks.order=3");
  run::Simulation simulation(verification::whole_case("turek-hron-fsi1", settings));
  const run::StepReport report = simulation.advance();
  REQUIRE_MESSAGE(report.ok, report.failure);
  const run::SolidSide& solid = *simulation.solid();
  Result result;
  result.iterations = report.coupling_iterations;
  result.deflection = verification::at(solid.mesh(), solid.X(), solid.state().d, {0.6, 0.2})[1];
  for (std::size_t i = 1; i < solid.load().size(); i += 2)
    result.lift += solid.load()[i];
  return result;
}

}  // namespace

TEST_CASE(
    "a flag with cells of its own bends as one that shares the fluid's nodes does, in as many iterations")
{
  const Result shared = flag({});
  for (const auto& settings : std::vector<std::vector<std::string>>{
           {"solid.order=5"}, {"solid.divide=2"}, {"solid.order=2", "solid.divide=2"}})
  {
    const Result own = flag(settings);
    MESSAGE(settings.front() << ": deflection " << own.deflection / shared.deflection - 1.0 << ", lift "
                             << own.lift / shared.lift - 1.0 << " off; iterations " << own.iterations
                             << " and " << shared.iterations);
    CHECK(own.deflection == doctest::Approx(shared.deflection).epsilon(1e-3));
    CHECK(own.lift == doctest::Approx(shared.lift).epsilon(1e-3));
    CHECK(own.iterations <= shared.iterations + 2);
  }
}
