#include "linalg/communicator.hpp"

#include <mpi.h>

#include <chrono>
#include <cstdlib>
#include <thread>

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

void minimum(std::span<double> values)
{
  if (!alone())
    MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_MIN,
                  MPI_COMM_WORLD);
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

void from_process(int rank, std::vector<double>& values)
{
  if (alone())
    return;
  auto count = static_cast<std::int64_t>(values.size());
  MPI_Bcast(&count, 1, MPI_INT64_T, rank, MPI_COMM_WORLD);
  values.resize(static_cast<std::size_t>(count));
  MPI_Bcast(values.data(), static_cast<int>(count), MPI_DOUBLE, rank, MPI_COMM_WORLD);
}

void barrier()
{
  if (!alone())
    MPI_Barrier(MPI_COMM_WORLD);
}

bool all_arrive(double seconds)
{
  // Messages of a tag of their own: processes that wait in a collective operation do not see them.
  constexpr int tag = 3;
  if (alone())
    return true;
  const int size = part().size;
  const char mine = 0;
  std::vector<char> theirs(size);
  std::vector<MPI_Request> requests;
  for (int rank = 0; rank < size; ++rank)
  {
    MPI_Irecv(&theirs[rank], 1, MPI_CHAR, rank, tag, MPI_COMM_WORLD, &requests.emplace_back());
    MPI_Isend(&mine, 1, MPI_CHAR, rank, tag, MPI_COMM_WORLD, &requests.emplace_back());
  }
  const auto start = std::chrono::steady_clock::now();
  while (true)
  {
    int all = 0;
    MPI_Testall(static_cast<int>(requests.size()), requests.data(), &all, MPI_STATUSES_IGNORE);
    const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - start;
    if (all != 0 || waited.count() > seconds)
      return all != 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void abort(int code)
{
  MPI_Abort(MPI_COMM_WORLD, code);
  std::abort();
}

}  // namespace blockfsi::linalg
