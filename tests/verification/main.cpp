#define DOCTEST_CONFIG_IMPLEMENT
#include "linalg/session.hpp"

#include <doctest/doctest.h>

int main(int count, char** arguments)
{
  const blockfsi::linalg::Session session;
  return doctest::Context(count, arguments).run();
}
