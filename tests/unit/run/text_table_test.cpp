#include "run/text_table.hpp"

#include <doctest/doctest.h>

using namespace blockfsi;

TEST_CASE("a table of texts is aligned for people and quoted for programs")
{
  const run::TextTable table{{"motion", "angle"}, {{"regenerate", "5"}, {"a,b", "says \"no\""}}};
  CHECK(run::aligned(table) == "motion          angle\n"
                               "regenerate          5\n"
                               "a,b         says \"no\"\n");
  CHECK(run::csv(table) == "motion,angle\nregenerate,5\n\"a,b\",\"says \"\"no\"\"\"\n");
}
