// Entry of libFuzzer, which brings its own main function.

#include "target.hpp"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  read_input({reinterpret_cast<const char*>(data), size});
  return 0;
}
