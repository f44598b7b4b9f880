#pragma once

#include <optional>
#include <variant>

namespace blockfsi::coupling
{

/// d <- d + omega r with a fixed omega.
struct Constant
{
  double relaxation = 0.5;  ///< omega [-], in (0, 1]
};

/// Aitken's dynamic relaxation (Kuettler & Wall 2008).
struct Aitken
{
  double initial = 0.5;  ///< first omega of a step at most [-]
};

/// Interface quasi-Newton with an approximation of the inverse by least squares
/// (Degroote, Bathe & Vierendeels 2009), filter QR2 (Haelterman et al. 2016).
struct IqnIls
{
  int reuse = 8;         ///< steps whose columns are kept
  double filter = 1e-2;  ///< columns with |r_jj| < filter |v_j| are dropped [-]
  double initial = 0.5;  ///< relaxation while no column is known [-]
};

/// Interface quasi-Newton whose Jacobian is carried from step to step and changed as little as possible
/// (multi-vector method: Bogaers, Kok, Reddy & Franz 2014), filter QR2 within each step.
struct IqnImvj
{
  int reuse = 20;        ///< steps whose columns are kept; those before them are forgotten
  double filter = 1e-2;  ///< columns with |r_jj| < filter |v_j| are dropped [-]
  double initial = 0.5;  ///< relaxation while no column is known [-]
};

using Accelerator = std::variant<Constant, Aitken, IqnIls, IqnImvj>;

struct Parameters
{
  Accelerator accelerator = IqnIls{};
  double tolerance = 1e-5;  ///< |d~ - d| relative to the displacement of the step [-]
  int iterations = 50;      ///< at most
  /// Order of the extrapolation of the interface, 0..highest_order; none: the one that is best at present.
  std::optional<int> predictor = std::nullopt;
};

}  // namespace blockfsi::coupling
