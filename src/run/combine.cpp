#include "run/combine.hpp"

#include "linalg/communicator.hpp"

#include <cstring>
#include <span>
#include <type_traits>

namespace blockfsi::run
{

namespace
{

template <class T>
T combine_all(const T& mine)
{
  static_assert(std::is_trivially_copyable_v<T>);
  const std::vector<std::byte> bytes = linalg::gather_bytes(std::as_bytes(std::span(&mine, 1)));
  T result;
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(T))
  {
    T other;
    std::memcpy(&other, bytes.data() + at, sizeof(T));
    result = mesh::merge(result, other);
  }
  return result;
}

}  // namespace

mesh::Quality combine(const mesh::Quality& mine)
{
  return combine_all(mine);
}

mesh::Validity combine(const mesh::Validity& mine)
{
  return combine_all(mine);
}

}  // namespace blockfsi::run
