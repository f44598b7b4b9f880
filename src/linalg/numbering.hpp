#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace blockfsi::linalg
{

/// Global numbers of distributed nodes, and the exchange of values between owners and ghosts.
/// The nodes that a process owns are numbered in a row, in the order of its local nodes.
class Numbering
{
public:
  Numbering() = default;
  /// `lattice`: a number for each local node that means the same node on every process, ascending;
  /// `owner`: the process that owns each; empty: process 0 all. All processes must call this together.
  Numbering(std::span<const std::int64_t> lattice, std::span<const std::int32_t> owner);

  std::size_t node_count() const { return global_.size(); }
  std::int64_t owned_count() const { return static_cast<std::int64_t>(owned_.size()); }
  std::int64_t total_count() const { return total_; }
  /// Global number of a local node.
  std::int32_t global(std::size_t node) const { return global_[node]; }
  /// Local nodes that this process owns, ascending.
  std::span<const std::int32_t> owned() const { return owned_; }

  /// Gives ghosts the values of their owners; values of shape (node_count, components).
  void update_ghosts(std::span<double> values, int components) const;
  /// Adds the values at ghosts to those of their owners.
  void add_from_ghosts(std::span<double> values, int components) const;

private:
  /// Nodes exchanged with one other process.
  struct Neighbour
  {
    int rank = 0;
    std::vector<std::int32_t> ghosts;  ///< local nodes that the neighbour owns
    std::vector<std::int32_t> shared;  ///< own nodes that the neighbour has as ghosts, in its order
  };
  using Lists = std::vector<std::int32_t> Neighbour::*;

  void find_neighbours(std::span<const std::int64_t> lattice, std::span<const std::int32_t> owner);
  /// Sends the values at one list of each neighbour and receives those at the other.
  std::vector<std::vector<double>> exchange(std::span<const double> values, int components, Lists sent,
                                            Lists received) const;

  std::vector<std::int32_t> global_;
  std::vector<std::int32_t> owned_;
  std::vector<Neighbour> neighbours_;
  std::int64_t total_ = 0;
};

}  // namespace blockfsi::linalg
