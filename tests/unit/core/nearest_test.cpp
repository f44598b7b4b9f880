#include "core/nearest.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace blockfsi;

TEST_CASE("the edit distance counts letters inserted, deleted, replaced or swapped")
{
  CHECK(edit_distance("flap", "flap") == 0);
  CHECK(edit_distance("", "flap") == 4);
  CHECK(edit_distance("flap", "flaps") == 1);
  CHECK(edit_distance("flap", "flop") == 1);
  CHECK(edit_distance("flap", "falp") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);
}

TEST_CASE("the edit distance is symmetric")
{
  CHECK(edit_distance("viscosity", "density") == edit_distance("density", "viscosity"));
}

TEST_CASE("the nearest name is proposed only if it is near")
{
  const std::vector<std::string> known = {"density", "viscosity", "velocity"};
  CHECK(nearest("viscositty", known) == "viscosity");
  CHECK(nearest("vleocity", known) == "velocity");
  CHECK(nearest("banana", known).empty());
  CHECK(nearest("x", std::vector<std::string>{"y"}).empty());
  CHECK(did_you_mean("densty", known) == "; did you mean 'density'?");
  CHECK(did_you_mean("banana", known).empty());
}

TEST_CASE("names are listed with commas between them")
{
  CHECK(listed(std::vector<std::string>{"a", "b", "c"}) == "a, b, c");
  CHECK(listed(std::vector<std::string>{}).empty());
}
