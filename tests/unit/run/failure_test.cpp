#include "run/failure.hpp"

#include "core/error.hpp"

#include <doctest/doctest.h>

using namespace blockfsi;

TEST_CASE("an error of the only process ends nobody else")
{
  run::end_unless_all_failed(Error("wrong"));
}
