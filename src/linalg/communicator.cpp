#include "linalg/communicator.hpp"

#include <mpi.h>

namespace blockfsi::linalg
{

namespace
{

bool alone()
{
  return part().size == 1;
}

double reduce(double value, MPI_Op operation)
{
  if (!alone())
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, operation, MPI_COMM_WORLD);
  return value;
}

}  // namespace

Part part()
{
  int started = 0;
  int finished = 0;
  MPI_Initialized(&started);
  MPI_Finalized(&finished);
  Part result;
  if (started != 0 && finished == 0)
  {
    MPI_Comm_rank(MPI_COMM_WORLD, &result.rank);
    MPI_Comm_size(MPI_COMM_WORLD, &result.size);
  }
  return result;
}

void sum(std::span<double> values)
{
  if (!alone())
    MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM,
                  MPI_COMM_WORLD);
}

std::int64_t sum(std::int64_t value)
{
  if (!alone())
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
  return value;
}

double maximum(double value)
{
  return reduce(value, MPI_MAX);
}

double minimum(double value)
{
  return reduce(value, MPI_MIN);
}

bool any(bool condition)
{
  return maximum(condition ? 1.0 : 0.0) > 0.5;
}

std::vector<std::byte> gather_bytes(std::span<const std::byte> mine)
{
  if (alone())
    return {mine.begin(), mine.end()};
  std::vector<std::byte> all(mine.size() * part().size);
  const int count = static_cast<int>(mine.size());
  MPI_Allgather(mine.data(), count, MPI_BYTE, all.data(), count, MPI_BYTE, MPI_COMM_WORLD);
  return all;
}

std::int64_t from_first(std::int64_t value)
{
  if (!alone())
    MPI_Bcast(&value, 1, MPI_INT64_T, 0, MPI_COMM_WORLD);
  return value;
}

void barrier()
{
  if (!alone())
    MPI_Barrier(MPI_COMM_WORLD);
}

}  // namespace blockfsi::linalg
