#pragma once

#include "block/corner_graph.hpp"
#include "block/corner_solver.hpp"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace blockfsi::block
{

/// How corners move that nothing else leads or holds.
enum class CornerRule
{
  automatic,  ///< elastic in two dimensions, radial in three: by measurement (docs/motion.md)
  fixed,      ///< they stay
  radial,     ///< constant: radial_rule
  elastic,    ///< constant: elastic_rule
  nonlinear,  ///< they minimise the energy of the blocks
};

/// Settings of `nonlinear`; the defaults by dimension are those of `nonlinear_defaults`.
struct NonlinearParameters
{
  EnergyParameters energy;
  CornerRule start = CornerRule::radial;  ///< constant rule that it starts from and is tethered to
  double tolerance = 1e-10;               ///< of the corners' places, relative to the extent of the interface
  int max_iterations = 60;
};

NonlinearParameters nonlinear_defaults(int dim);

/// The corners of coarse blocks as they follow the interface. All processes compute the same.
class CornerMotion
{
public:
  CornerMotion(CornerGraph graph, CornerRule rule);
  CornerMotion(CornerGraph graph, const NonlinearParameters& parameters);

  const CornerGraph& graph() const { return graph_; }

  /// Displacements of all corners for one of the interface. A constant rule is linear in it and allocates
  /// nothing. The nonlinear one starts from the last result, from that plus the change of the constant rule,
  /// or from the constant rule, whichever has the least energy; where that does not converge the way is
  /// halved up to three times.
  ///   d [m], shape (interface_count, dim);  U [m], shape (corner_count, dim), written.
  CornerReport follow(std::span<const double> d, std::span<double> U);

  /// What a nonlinear rule remembers: the interface and the unknowns of the last result; empty otherwise.
  std::vector<double> memory() const;
  /// Goes back to it; the same interface then gives the same corners bit for bit. Throws Error if it does not
  /// fit.
  void recall(std::span<const double> memory);

private:
  struct Nonlinear
  {
    std::variant<CornerEnergy<2>, CornerEnergy<3>> energy;
    NonlinearParameters parameters;
    std::vector<double> d;  ///< last interface
    Eigen::VectorXd y;      ///< last unknowns
  };

  Eigen::VectorXd constant(std::span<const double> d, std::span<double> U) const;
  CornerReport search(std::span<const double> d, std::span<double> U, int depth);

  CornerGraph graph_;
  /// Unknowns from displacements of led corners, shape (unknowns, corner_count * dim), row-major.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> matrix_;
  Eigen::VectorXd y_;
  std::optional<Nonlinear> nonlinear_;
};

}  // namespace blockfsi::block
