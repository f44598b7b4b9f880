#pragma once

#include "mesh/mesh.hpp"
#include "run/locate.hpp"

#include <span>
#include <vector>

namespace blockfsi::run
{

/// A nodal field on a mesh of which each process has a share, at any place. No process holds more of it than
/// its own share.
class SharedField
{
public:
  /// The mesh must outlive the field.
  ///   x [m], shape (node_count, 2);  field, shape (node_count, components).
  SharedField(const mesh::Mesh& mesh, std::span<const double> x, std::vector<double> field, int components);

  /// Values at points, which each process has of its own, shape (points, components). A point beside the mesh
  /// of all processes has the values as Finder::find finds it there. All processes must call it together: the
  /// points of one after the other go to all.
  ///   points [m], shape (points, 2).
  std::vector<double> at(std::span<const double> points);

private:
  std::vector<double> at_points_of_all(std::span<const double> points);

  const mesh::Mesh* mesh_;
  Finder finder_;
  std::vector<double> field_;
  int components_;
};

}  // namespace blockfsi::run
