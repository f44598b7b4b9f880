#include "coupling/accelerator.hpp"

#include "core/error.hpp"
#include "toy.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

using namespace blockfsi;
using namespace blockfsi::coupling;
using test::AddedMass;
using test::Vector;

namespace
{

/// Evaluations until |d~ - d| <= tolerance, at most 200; d holds the last input.
int iterate(Acceleration& acceleration, const AddedMass& problem, Vector& d, double tolerance = 1e-10)
{
  Vector d_tilde(d.size());
  acceleration.start_step();
  for (int count = 1; count <= 200; ++count)
  {
    problem(d, d_tilde);
    if (test::distance(d, d_tilde) <= tolerance)
    {
      acceleration.observe(d, d_tilde);
      acceleration.accept_step();
      return count;
    }
    acceleration.next(d, d_tilde);
  }
  return 201;
}

/// The history of one accepted step with the given columns.
History taught(Vector V, Vector W, int columns)
{
  History history;
  history.V = std::move(V);
  history.W = std::move(W);
  history.columns_per_step = {columns, 0};
  return history;
}

const std::vector<Accelerator> every_method = {Constant{}, Aitken{}, IqnIls{}, IqnImvj{}};

AddedMass loaded(std::size_t size, double mu_0)
{
  AddedMass problem(size, mu_0);
  problem.set_load(Vector(size, 1.0));
  return problem;
}

/// Evaluations over twenty steps whose load changes slowly.
int evaluations_in_series(const Accelerator& accelerator)
{
  AddedMass problem(60, 10.0);
  Acceleration acceleration({.accelerator = accelerator}, 60);
  Vector d(60, 0.0);
  int sum = 0;
  for (int step = 1; step <= 20; ++step)
  {
    const double t = 0.05 * step;
    problem.set_load({std::sin(3 * t), std::cos(2 * t), std::sin(t), 0.3 * std::sin(7 * t)});
    sum += iterate(acceleration, problem, d, 1e-6);
  }
  return sum;
}

}  // namespace

TEST_CASE("constant relaxation moves d by omega times the residual")
{
  Acceleration acceleration({.accelerator = Constant{.relaxation = 0.25}}, 2);
  Vector d = {1.0, 2.0};
  acceleration.start_step();
  acceleration.next(d, Vector{5.0, -2.0});
  CHECK(d == Vector{2.0, 1.0});
}

TEST_CASE("constant relaxation contracts by |1 - omega (1 + mu)| along an eigenvector")
{
  AddedMass problem(1, 3.0);
  problem.set_load({1.0});
  Acceleration acceleration({.accelerator = Constant{.relaxation = 0.3}}, 1);
  Vector d = {0.0}, d_tilde(1);
  double error = test::distance(d, problem.solution());
  for (int k = 0; k < 5; ++k)
  {
    problem(d, d_tilde);
    acceleration.next(d, d_tilde);
    const double next_error = test::distance(d, problem.solution());
    CHECK(next_error / error == doctest::Approx(0.2));
    error = next_error;
  }
}

TEST_CASE("Aitken is exact after two evaluations of a linear scalar problem")
{
  for (const double mu : {0.5, 3.0, 1000.0})
  {
    AddedMass problem(1, mu);
    problem.set_load({1.0});
    Acceleration acceleration({.accelerator = Aitken{}}, 1);
    Vector d = {0.7};
    CHECK(iterate(acceleration, problem, d, 1e-12 * (1.0 + mu)) == 3);
    CHECK(test::distance(d, problem.solution()) < 1e-14 * (1.0 + mu));
  }
}

TEST_CASE("Aitken starts each step with its last relaxation, but not above the initial one")
{
  AddedMass problem(1, 3.0);  // omega = 1 / (1 + mu) = 0.25 solves it
  problem.set_load({1.0});
  Acceleration acceleration({.accelerator = Aitken{.initial = 0.1}}, 1);
  Vector d = {0.0};
  iterate(acceleration, problem, d);
  CHECK(acceleration.history().omega == doctest::Approx(0.25));
  acceleration.start_step();
  d = {0.0};
  acceleration.next(d, Vector{1.0});
  CHECK(d[0] == doctest::Approx(0.1));
}

TEST_CASE("Aitken does not mix the residuals of two steps")
{
  Acceleration acceleration({.accelerator = Aitken{.initial = 0.5}}, 1);
  Vector d = {0.0};
  acceleration.start_step();
  acceleration.next(d, Vector{1.0});
  acceleration.accept_step();
  acceleration.start_step();
  d = {0.0};
  acceleration.next(d, Vector{0.9});  // with the old residual omega would be -0.5 * 1 / (0.9 - 1) = 5
  CHECK(d[0] == doctest::Approx(0.45));
}

TEST_CASE("Aitken keeps its relaxation where two residuals are equal")
{
  Acceleration acceleration({.accelerator = Aitken{.initial = 0.5}}, 1);
  Vector d = {0.0};
  acceleration.start_step();
  acceleration.next(d, Vector{d[0] + 1.0});
  acceleration.next(d, Vector{d[0] + 1.0});
  CHECK(d[0] == doctest::Approx(1.0));
}

TEST_CASE("Aitken never stops at a relaxation of zero")
{
  Acceleration acceleration({.accelerator = Aitken{.initial = 0.5}}, 2);
  Vector d = {0.0, 0.0};
  acceleration.start_step();
  acceleration.next(d, Vector{1.0, 0.0});
  // r_1 . (r_2 - r_1) = 0: the formula gives omega = 0.
  acceleration.next(d, Vector{d[0] + 1.0, d[1] + 1.0});
  CHECK(d == Vector{1.0, 0.5});
}

TEST_CASE("quasi-Newton solves a linear problem of n unknowns with n + 1 evaluations")
{
  for (const std::size_t n : {1u, 2u, 5u, 12u})
    for (const double mu_0 : {0.5, 3.0, 30.0})
    {
      const AddedMass problem = loaded(n, mu_0);
      Acceleration acceleration({.accelerator = IqnIls{.reuse = 0, .filter = 1e-12}}, n);
      Vector d(n, 0.0);
      // One evaluation more sees that it is solved.
      CHECK(iterate(acceleration, problem, d, 1e-8) <= static_cast<int>(n) + 2);
      CHECK(test::distance(d, problem.solution()) < 1e-7);
    }
}

TEST_CASE("quasi-Newton needs as many evaluations as the load has directions, whatever the size")
{
  AddedMass problem(60, 10.0);
  problem.set_load({1.0, -2.0, 0.5});
  Acceleration acceleration({.accelerator = IqnIls{.reuse = 0, .filter = 1e-10}}, 60);
  Vector d(60, 0.0);
  CHECK(iterate(acceleration, problem, d, 1e-9) <= 5);
}

TEST_CASE("quasi-Newton converges where plain relaxation diverges")
{
  const AddedMass problem = loaded(40, 10.0);
  Vector d(40, 0.0);
  Acceleration relaxed({.accelerator = Constant{.relaxation = 0.5}}, 40);
  CHECK(iterate(relaxed, problem, d) == 201);
  for (const Accelerator& method : {Accelerator(IqnIls{}), Accelerator(IqnImvj{})})
  {
    d.assign(40, 0.0);
    Acceleration quasi_newton({.accelerator = method}, 40);
    CHECK(iterate(quasi_newton, problem, d) < 40);
  }
}

TEST_CASE("a second step of the same linear problem needs one correction only")
{
  AddedMass problem(30, 10.0);
  problem.set_load({1.0, 2.0, 3.0});
  Acceleration acceleration({.accelerator = IqnIls{.reuse = 3, .filter = 1e-10}}, 30);
  Vector d(30, 0.0);
  CHECK(iterate(acceleration, problem, d, 1e-8) > 3);
  problem.set_load({-1.0, 1.0, 0.5});
  CHECK(iterate(acceleration, problem, d, 1e-8) == 2);
}

TEST_CASE("reused columns save evaluations over a series of steps")
{
  CHECK(evaluations_in_series(IqnIls{.reuse = 8}) < 0.7 * evaluations_in_series(IqnIls{.reuse = 0}));
}

TEST_CASE("columns older than the reused steps are forgotten, empty steps do not count")
{
  AddedMass problem(20, 3.0);
  Acceleration acceleration({.accelerator = IqnIls{.reuse = 2}}, 20);
  Vector d(20, 0.0);
  for (int step = 1; step <= 5; ++step)
  {
    problem.set_load({std::sin(step), std::cos(step), 1.0 / step});
    d.assign(20, 0.0);
    iterate(acceleration, problem, d, 1e-8);
  }
  const History before = acceleration.history();
  CHECK(before.columns_per_step.size() == 3);
  CHECK(before.columns_per_step.back() == 0);
  acceleration.start_step();
  acceleration.accept_step();
  CHECK(acceleration.history() == before);
}

TEST_CASE("a step that was not accepted leaves no column")
{
  const AddedMass problem = loaded(8, 3.0);
  Acceleration acceleration({.accelerator = IqnIls{}}, 8);
  Vector d(8, 0.0), d_tilde(8);
  iterate(acceleration, problem, d);
  const History before = acceleration.history();
  acceleration.start_step();
  d.assign(8, 1.0);
  for (int k = 0; k < 3; ++k)
  {
    problem(d, d_tilde);
    acceleration.next(d, d_tilde);
  }
  CHECK(acceleration.history().V.size() > before.V.size());
  acceleration.start_step();
  CHECK(acceleration.history() == before);
}

TEST_CASE("dependent columns are filtered out")
{
  // The same step three times gives columns that are copies of each other up to a factor.
  AddedMass problem(10, 3.0);
  Acceleration acceleration({.accelerator = IqnIls{.reuse = 5}}, 10);
  Vector d(10, 0.0);
  for (int step = 1; step <= 3; ++step)
  {
    problem.set_load({1.0});
    d.assign(10, 0.1 * step);
    iterate(acceleration, problem, d, 1e-12);
    CHECK(test::distance(d, problem.solution()) < 1e-11);
  }
}

TEST_CASE("a column of V that repeats a newer one does not count")
{
  // Two columns equal in V but not in W: without the filter the older, wrong one would enter.
  Acceleration acceleration({.accelerator = IqnIls{.reuse = 2}}, 2);
  acceleration.restore(taught({1.0, 1e-4, 1.0, 0.0}, {500.0, 500.0, -3.0, 0.0}, 2));
  Vector d = {0.0, 0.0};
  acceleration.start_step();
  acceleration.next(d, Vector{1.0, 0.0});
  CHECK(d[0] == doctest::Approx(4.0));  // d~ + W c with c = -1
  CHECK(d[1] == doctest::Approx(0.0));
}

TEST_CASE("no more columns than unknowns are used")
{
  const AddedMass problem = loaded(2, 3.0);
  Acceleration acceleration({.accelerator = IqnIls{.reuse = 9, .filter = 0.0}}, 2);
  for (int step = 1; step <= 6; ++step)
  {
    Vector d = {0.3 * step, -0.2 * step * step};
    iterate(acceleration, problem, d, 1e-9);
    CHECK(test::distance(d, problem.solution()) < 1e-8);
  }
}

TEST_CASE("a zero residual leaves d where it is and spoils nothing, for every method")
{
  for (const Accelerator& method : every_method)
  {
    Acceleration acceleration({.accelerator = method}, 3);
    Vector d(3, 0.0);
    for (int step = 0; step < 3; ++step)
    {
      acceleration.start_step();
      acceleration.next(d, Vector(3, 0.0));
      acceleration.next(d, Vector(3, 0.0));
      CHECK(d == Vector(3, 0.0));
      acceleration.accept_step();
    }
    const AddedMass problem = loaded(3, 0.3);
    CHECK(iterate(acceleration, problem, d) < 60);
    CHECK(test::distance(d, problem.solution()) < 1e-9);
  }
}

TEST_CASE("quasi-Newton does not undo the step of the solvers for ever")
{
  // V = W makes d~ + W c = d exactly: the plain formula would repeat the same input.
  for (const Accelerator& method :
       {Accelerator(IqnIls{.initial = 0.5}), Accelerator(IqnImvj{.initial = 0.5})})
  {
    Acceleration acceleration({.accelerator = method}, 1);
    acceleration.restore(taught({1.0}, {1.0}, 1));
    Vector d = {2.0};
    acceleration.start_step();
    acceleration.next(d, Vector{3.0});
    CHECK(d[0] == doctest::Approx(2.5));
  }
}

TEST_CASE("an answer that is no number does not enter the columns")
{
  Acceleration acceleration({.accelerator = IqnIls{}}, 1);
  Vector d = {0.0};
  acceleration.start_step();
  acceleration.next(d, Vector{1.0});
  acceleration.next(d, Vector{std::numeric_limits<double>::quiet_NaN()});
  CHECK(acceleration.history().V.empty());
}

TEST_CASE("a Jacobian carried from step to step is the least change that fits the columns of the step")
{
  // Two steps with one column each. J_1 = W_1 V_1^+; J_2 = J_1 + (W_2 - J_1 V_2) V_2^+, by hand for
  // v_1 = (1, 0), w_1 = (2, 1), v_2 = (1, 1), w_2 = (0, 4): J_1 = [2 0; 1 0], J_2 = J_1 + (-2, 3) (1/2, 1/2)
  // = [1 -1; 2.5 1.5].
  Acceleration acceleration({.accelerator = IqnImvj{}}, 2);
  History history = taught({1.0, 0.0, 1.0, 1.0}, {2.0, 1.0, 0.0, 4.0}, 1);
  history.columns_per_step = {1, 1, 0};
  acceleration.restore(history);
  Vector d = {10.0, 20.0};
  const Vector r = {3.0, -2.0};
  acceleration.start_step();
  acceleration.next(d, Vector{13.0, 18.0});
  CHECK(d[0] == doctest::Approx(13.0 - (1.0 * r[0] - 1.0 * r[1])));
  CHECK(d[1] == doctest::Approx(18.0 - (2.5 * r[0] + 1.5 * r[1])));
}

TEST_CASE("with the columns of one step only, both quasi-Newton methods do the same")
{
  const AddedMass problem = loaded(20, 10.0);
  Acceleration ils({.accelerator = IqnIls{.reuse = 0}}, 20);
  Acceleration imvj({.accelerator = IqnImvj{.reuse = 0}}, 20);
  Vector d(20, 0.0), e(20, 0.0), answer(20);
  for (int k = 0; k < 8; ++k)
  {
    problem(d, answer);
    ils.next(d, answer);
    problem(e, answer);
    imvj.next(e, answer);
    CHECK(test::distance(d, e) < 1e-12);
  }
}

TEST_CASE("a carried Jacobian is exact for a linear problem once its columns span the residuals")
{
  AddedMass problem(30, 10.0);
  problem.set_load({1.0, 2.0, 3.0});
  Acceleration acceleration({.accelerator = IqnImvj{.filter = 1e-10}}, 30);
  Vector d(30, 0.0);
  CHECK(iterate(acceleration, problem, d, 1e-8) > 3);
  CHECK(test::distance(d, problem.solution()) < 1e-7);
  problem.set_load({-1.0, 1.0, 0.5});
  CHECK(iterate(acceleration, problem, d, 1e-8) == 2);
  CHECK(test::distance(d, problem.solution()) < 1e-7);
}

TEST_CASE(
    "a carried Jacobian knows in a step what the steps before have learnt, without a filter between them")
{
  CHECK(evaluations_in_series(IqnImvj{.reuse = 20}) < 0.7 * evaluations_in_series(IqnImvj{.reuse = 0}));
}

TEST_CASE("a restored accelerator continues bit for bit, between steps and in the middle of one")
{
  for (const Accelerator& method : every_method)
    for (const int interruption : {0, 3})
    {
      AddedMass problem = loaded(15, 0.8);
      Acceleration first({.accelerator = method}, 15);
      Vector d(15, 0.0), d_tilde(15);
      iterate(first, problem, d, 1e-6);
      problem.set_load(Vector(15, -1.0));
      first.start_step();
      const auto advance = [&](Acceleration& acceleration, Vector& input)
      {
        problem(input, d_tilde);
        acceleration.next(input, d_tilde);
      };
      for (int k = 0; k < interruption; ++k)
        advance(first, d);
      Acceleration second({.accelerator = method}, 15);
      second.restore(first.history());
      Vector e = d;
      for (int k = 0; k < 4; ++k)
      {
        advance(first, d);
        advance(second, e);
        CHECK(d == e);
      }
      CHECK(first.history() == second.history());
    }
}

TEST_CASE("a history of another interface is refused")
{
  Acceleration acceleration({}, 4);
  CHECK_THROWS_WITH_AS(acceleration.restore(taught({1, 2, 3}, {1, 2, 3}, 1)),
                       "the saved history of the coupling does not belong to an interface of 4 unknowns; "
                       "restart with the case file that wrote it, or start anew",
                       Error);
}

TEST_CASE("parameters out of range are refused")
{
  CHECK_THROWS_WITH_AS(Acceleration({.accelerator = Constant{.relaxation = 0.0}}, 1),
                       "the relaxation of the coupling is 0; choose one above 0 and at most 1", Error);
  CHECK_THROWS_WITH_AS(Acceleration({.accelerator = Aitken{.initial = 2.0}}, 1),
                       "the initial relaxation of the coupling is 2; choose one above 0 and at most 1",
                       Error);
  CHECK_THROWS_WITH_AS(Acceleration({.accelerator = IqnIls{.reuse = -1}}, 1),
                       "the coupling reuses -1 steps; choose 0 or more", Error);
  CHECK_THROWS_WITH_AS(Acceleration({.accelerator = IqnImvj{.reuse = -2}}, 1),
                       "the coupling reuses -2 steps; choose 0 or more", Error);
  CHECK_THROWS_WITH_AS(Acceleration({.accelerator = IqnIls{.filter = 1.0}}, 1),
                       "the filter of the coupling is 1; choose at least 0 and below 1", Error);
}
