#include "run/combine.hpp"

#include "linalg/communicator.hpp"

#include <span>

namespace blockfsi::run
{

namespace
{

template <class T>
T combine_all(const T& mine)
{
  T result;
  for (const T& other : linalg::gather(std::span(&mine, 1)))
    result = mesh::merge(result, other);
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
