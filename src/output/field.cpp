#include "output/field.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

namespace blockfsi::output
{

void check_size(const std::string& name, std::size_t found, std::size_t expected)
{
  if (found != expected)
    throw Error(fmt::format("field '{}' has {} values, but the mesh needs {}", name, found, expected));
}

}  // namespace blockfsi::output
