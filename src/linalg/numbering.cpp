#include "linalg/numbering.hpp"

#include "linalg/communicator.hpp"

#include <mpi.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace blockfsi::linalg
{

Numbering::Numbering(std::span<const std::int64_t> lattice, std::span<const std::int32_t> owner)
    : global_(lattice.size())
{
  const Part me = part();
  for (std::size_t node = 0; node < lattice.size(); ++node)
    if ((owner.empty() ? 0 : owner[node]) == me.rank)
      owned_.push_back(static_cast<std::int32_t>(node));
  std::int64_t first = 0;
  const std::int64_t count = owned_count();
  total_ = sum(count);
  if (total_ > INT32_MAX / 4)
    throw std::runtime_error("the mesh has more nodes than 32-bit equation numbers allow");
  if (me.size > 1)
  {
    MPI_Exscan(&count, &first, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
    if (me.rank == 0)
      first = 0;
  }
  for (std::size_t i = 0; i < owned_.size(); ++i)
    global_[owned_[i]] = static_cast<std::int32_t>(first + static_cast<std::int64_t>(i));
  if (me.size == 1)
    return;
  find_neighbours(lattice, owner);
  std::vector<double> numbers(global_.begin(), global_.end());
  update_ghosts(numbers, 1);
  std::transform(numbers.begin(), numbers.end(), global_.begin(),
                 [](double number) { return static_cast<std::int32_t>(number); });
}

void Numbering::find_neighbours(std::span<const std::int64_t> lattice, std::span<const std::int32_t> owner)
{
  const Part me = part();
  std::map<int, Neighbour> neighbours;
  for (std::size_t node = 0; node < lattice.size(); ++node)
    if (owner[node] != me.rank)
      neighbours[owner[node]].ghosts.push_back(static_cast<std::int32_t>(node));

  // Each process tells the owners of its ghosts which nodes it needs.
  std::vector<int> need(me.size, 0);
  std::vector<int> asked(me.size, 0);
  for (const auto& [rank, neighbour] : neighbours)
    need[rank] = static_cast<int>(neighbour.ghosts.size());
  MPI_Alltoall(need.data(), 1, MPI_INT, asked.data(), 1, MPI_INT, MPI_COMM_WORLD);

  std::map<int, std::vector<std::int64_t>> sent;
  std::map<int, std::vector<std::int64_t>> received;
  std::vector<MPI_Request> requests;
  for (int rank = 0; rank < me.size; ++rank)
  {
    if (asked[rank] > 0)
    {
      received[rank].resize(asked[rank]);
      MPI_Irecv(received[rank].data(), asked[rank], MPI_INT64_T, rank, 1, MPI_COMM_WORLD,
                &requests.emplace_back());
    }
    if (need[rank] > 0)
    {
      for (const std::int32_t node : neighbours[rank].ghosts)
        sent[rank].push_back(lattice[node]);
      MPI_Isend(sent[rank].data(), need[rank], MPI_INT64_T, rank, 1, MPI_COMM_WORLD,
                &requests.emplace_back());
    }
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);

  for (const auto& [rank, numbers] : received)
    for (const std::int64_t number : numbers)
    {
      const auto found = std::lower_bound(lattice.begin(), lattice.end(), number);
      neighbours[rank].shared.push_back(static_cast<std::int32_t>(found - lattice.begin()));
    }
  for (auto& [rank, neighbour] : neighbours)
  {
    neighbour.rank = rank;
    neighbours_.push_back(std::move(neighbour));
  }
}

std::vector<std::vector<double>> Numbering::exchange(std::span<const double> values, int components,
                                                     Lists sent, Lists received) const
{
  std::vector<std::vector<double>> out(neighbours_.size());
  std::vector<std::vector<double>> in(neighbours_.size());
  std::vector<MPI_Request> requests(2 * neighbours_.size());
  for (std::size_t k = 0; k < neighbours_.size(); ++k)
  {
    const Neighbour& neighbour = neighbours_[k];
    for (const std::int32_t node : neighbour.*sent)
      for (int c = 0; c < components; ++c)
        out[k].push_back(values[node * components + c]);
    in[k].resize((neighbour.*received).size() * components);
    MPI_Irecv(in[k].data(), static_cast<int>(in[k].size()), MPI_DOUBLE, neighbour.rank, 2, MPI_COMM_WORLD,
              &requests[2 * k]);
    MPI_Isend(out[k].data(), static_cast<int>(out[k].size()), MPI_DOUBLE, neighbour.rank, 2, MPI_COMM_WORLD,
              &requests[2 * k + 1]);
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  return in;
}

void Numbering::update_ghosts(std::span<double> values, int components) const
{
  const auto in = exchange(values, components, &Neighbour::shared, &Neighbour::ghosts);
  for (std::size_t k = 0; k < neighbours_.size(); ++k)
    for (std::size_t i = 0; i < neighbours_[k].ghosts.size(); ++i)
      for (int c = 0; c < components; ++c)
        values[neighbours_[k].ghosts[i] * components + c] = in[k][i * components + c];
}

void Numbering::add_from_ghosts(std::span<double> values, int components) const
{
  const auto in = exchange(values, components, &Neighbour::ghosts, &Neighbour::shared);
  for (std::size_t k = 0; k < neighbours_.size(); ++k)
    for (std::size_t i = 0; i < neighbours_[k].shared.size(); ++i)
      for (int c = 0; c < components; ++c)
        values[neighbours_[k].shared[i] * components + c] += in[k][i * components + c];
}

}  // namespace blockfsi::linalg
