#pragma once

#include "mesh/quality.hpp"
#include "run/entries.hpp"
#include "run/flap_motion.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace blockfsi::run
{

/// The fluid mesh when the tip of the flap has turned by an angle.
struct SweepPoint
{
  double angle = 0.0;  ///< [degrees]
  mesh::Quality quality;
  bool certified = true;
  double seconds = 0.0;  ///< of the update
};

/// A mesh kept for a picture.
struct Snapshot
{
  double angle = 0.0;     ///< [degrees]
  std::vector<double> x;  ///< [m], shape (node_count, dim)
};

/// How far one way of moving the mesh goes with a flap that is bent without a fluid.
struct Sweep
{
  FlapShape shape = FlapShape::rotation;
  std::vector<SweepPoint> points;  ///< up to the first mesh that is not proved valid, which is the last
  double last_valid = 0.0;         ///< largest angle up to which all meshes are proved valid [degrees]
  bool is_complete = false;        ///< it went as far as was asked
  std::string failure;             ///< of the update itself; empty: none
  std::vector<Snapshot> snapshots;

  /// Least scaled Jacobian at an angle that was visited; nan if the sweep did not come so far.
  double scaled_jacobian(double angle) const;
  /// Median time of an update [s].
  double seconds() const;
};

/// What is left of the first mesh after bending to and fro.
struct Cycles
{
  std::vector<double> drift;  ///< largest distance of a node from its first place after each cycle [m]
  std::vector<double> scaled_jacobian;  ///< least within each cycle
  double broke_at = 0.0;                ///< angle at which a mesh was not valid [degrees]
  bool is_complete = true;
};

/// A way of moving the mesh, made ready for sweeps.
class PrescribedMesh
{
public:
  explicit PrescribedMesh(const case_file::Case& description);
  ~PrescribedMesh();

  /// Bends in steps of case_file::Prescribed::step up to `angle`, keeping meshes at the angles of `show`.
  Sweep sweep(FlapShape shape);
  /// Bends to +amplitude, to -amplitude and back, several times.
  Cycles cycle(FlapShape shape);

  const mesh::Mesh& mesh() const;
  std::int64_t node_count() const;

private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace blockfsi::run
