#include "coupling/transfer.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace blockfsi::coupling
{

Transfer::Transfer(std::size_t count) : fluid_count_(count), solid_count_(count) {}

Transfer::Transfer(std::vector<std::int32_t> row_begin, std::vector<std::int32_t> column,
                   std::vector<double> weight, std::size_t solid_count)
    : fluid_count_(row_begin.size() - 1), solid_count_(solid_count), row_begin_(std::move(row_begin)),
      column_(std::move(column)), weight_(std::move(weight))
{
  assert(column_.size() == weight_.size());
}

void Transfer::to_fluid(std::span<const double> solid, std::span<double> fluid) const
{
  assert(solid.size() == 2 * solid_count_ && fluid.size() == 2 * fluid_count_);
  if (row_begin_.empty())
  {
    std::copy(solid.begin(), solid.end(), fluid.begin());
    return;
  }
  for (std::size_t i = 0; i < fluid_count_; ++i)
    for (std::size_t c = 0; c < 2; ++c)
    {
      double sum = 0.0;
      for (std::int32_t k = row_begin_[i]; k < row_begin_[i + 1]; ++k)
        sum += weight_[k] * solid[2 * static_cast<std::size_t>(column_[k]) + c];
      fluid[2 * i + c] = sum;
    }
}

void Transfer::to_solid(std::span<const double> fluid, std::span<double> solid) const
{
  assert(solid.size() == 2 * solid_count_ && fluid.size() == 2 * fluid_count_);
  if (row_begin_.empty())
  {
    std::copy(fluid.begin(), fluid.end(), solid.begin());
    return;
  }
  std::fill(solid.begin(), solid.end(), 0.0);
  for (std::size_t i = 0; i < fluid_count_; ++i)
    for (std::int32_t k = row_begin_[i]; k < row_begin_[i + 1]; ++k)
      for (std::size_t c = 0; c < 2; ++c)
        solid[2 * static_cast<std::size_t>(column_[k]) + c] += weight_[k] * fluid[2 * i + c];
}

}  // namespace blockfsi::coupling
