// Alone in this file, so that the compiler does not inline half of a replaced pair of operators.
#include "allocations.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <cstdlib>
#include <memory>
#include <new>

namespace
{

std::atomic<long> count{0};

}  // namespace

void* operator new(std::size_t size)
{
  ++count;
  if (void* memory = std::malloc(size > 0 ? size : 1))
    return memory;
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept
{
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

namespace blockfsi::testing
{

long allocation_count()
{
  return count;
}

TEST_CASE("the tests' counter of allocations counts")
{
  const long before = allocation_count();
  void* memory = ::operator new(8);
  ::operator delete(memory);
  CHECK(allocation_count() == before + 1);
}

}  // namespace blockfsi::testing
