#pragma once

#include "block/connect.hpp"
#include "fem/cell_loop.hpp"
#include "fem/side_loop.hpp"
#include "linalg/numbering.hpp"
#include "linalg/system.hpp"
#include "motion/boundary.hpp"
#include "motion/equation.hpp"
#include "motion/parameters.hpp"
#include "motion/report.hpp"

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

namespace blockfsi::motion
{

/// The mesh on which an update works. What is referred to must outlive the update.
struct Domain
{
  const block::Skeleton& skeleton;
  const block::Plan& plan;
  const mesh::Mesh& mesh;
  const linalg::Numbering& numbering;
  std::span<const double> x;                   ///< the first mesh [m], shape (node_count, 2); copied
  const std::vector<std::int64_t>& interface;  ///< skeleton numbers of its nodes, ascending
};

/// Extends the displacement of the interface into the fluid by a linear equation, at the order of the mesh:
/// what regenerating the mesh competes with. The factors are kept as long as the matrix stays: for ever in
/// total forms, for a step in incremental ones; an update then costs one back substitution.
class Extension
{
public:
  /// Throws Error if a boundary that shall slide does not run along an axis.
  Extension(const PseudoSolid& parameters, const Domain& domain);
  Extension(const Harmonic& parameters, const Domain& domain);
  Extension(const Biharmonic& parameters, const Domain& domain);

  /// Coordinates of all local nodes for a displacement of the interface; all processes together.
  ///   displacement [m], shape (interface count, 2);  x [m], shape (node_count, 2), written.
  [[nodiscard]] Report follow(std::span<const double> displacement, std::span<double> x);

  /// Makes the mesh that belongs to a displacement the one from which incremental forms go on.
  void accept(std::span<const double> displacement, std::span<const double> x);

  /// What an incremental form remembers of the past: empty in total forms.
  std::vector<double> memory() const;
  void recall(std::span<const double> memory);

  /// The equation alone: the displacement inside for one given at all nodes where it is prescribed.
  ///   lift [m], shape (node_count, 2), 0 where nothing is prescribed;
  ///   slope: integrals of the normal derivative times the test functions over the boundary, same shape, for
  ///   the biharmonic equation only (else empty);  u [m], same shape, written.
  [[nodiscard]] Report extend(std::span<const double> lift, std::span<const double> slope,
                              std::span<double> u);

private:
  using Equation = std::variant<Elasticity, Diffusion, Plate>;
  /// A system of equations with the components of the displacement that it is solved for in turn.
  struct Part
  {
    linalg::System system;
    std::vector<int> components;
  };

  Extension(const Equation& equation, const Stiffness& stiffness, From from,
            const std::vector<std::string>& slide, const Domain& domain);
  /// Unknowns per node in a system, and how many of them are displacements.
  int width() const;
  int lifted() const;
  void make_parts();
  bool renew();
  bool solve(Part& part, int component, std::span<const double> lift, std::span<const double> slope,
             std::span<double> u);
  std::vector<double> slope_of(std::span<const double> lift);

  Equation equation_;
  From from_;
  Slope slope_ = Slope::zero;
  const mesh::Mesh* mesh_;
  const linalg::Numbering* numbering_;
  std::vector<double> first_x_;
  std::vector<double> base_x_;  ///< from which displacements are counted
  std::vector<double> base_displacement_;
  Boundary boundary_;
  std::vector<double> distance_;  ///< to the interface and to the chosen points, shape (node_count, 2)
  fem::CellLoop cells_;
  fem::SideLoop sides_;
  std::vector<Part> parts_;
  bool stale_ = true;
  int factorisations_ = 0;
};

}  // namespace blockfsi::motion
