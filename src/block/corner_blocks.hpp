#pragma once

#include "block/connect.hpp"
#include "block/corner_graph.hpp"
#include "block/corner_samples.hpp"
#include "block/layout.hpp"
#include "geometry/point.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace blockfsi::block
{

/// The sides of a region's blocks that lie on the interface, and what is measured there.
struct MovingSides
{
  std::vector<bool> side;  ///< shape (side_count): edges in two dimensions, faces in three
  std::vector<bool> edge;  ///< edges of these, shape (edge_count)
  double size = 1.0;       ///< diagonal of the box around them [m]
  /// Of what moves [m]: twice its volume by the area of the interface (in two dimensions area by length), or
  /// the shortest edge of the interface where only a hole is seen.
  double thickness = 1.0;
};

/// Place of a node in the interface, or -1.
///   interface: skeleton numbers, ascending.
std::int32_t interface_index(std::span<const std::int64_t> interface, std::int64_t node);

MovingSides moving_sides(const Layout& layout, const Skeleton& skeleton, std::string_view region,
                         std::span<const std::int64_t> interface);

/// Makes coarse blocks from a skeleton. What is given must outlive it.
class CoarseBlocks
{
public:
  CoarseBlocks(const Layout& layout, const Skeleton& skeleton, const MovingSides& moving,
               std::span<const std::int64_t> interface, int degree);

  /// A block of the layout with its samples: quadrilateral, triangle or hexahedron.
  CoarseBlock make(int block);

private:
  /// A node of the skeleton with a weight.
  struct NodeWeight
  {
    std::int64_t node;
    double weight;
  };
  /// A side or an edge as it enters the transfinite map of a block, at a place on it.
  struct Strand
  {
    bool is_face = false;
    int number = 0;  ///< of the edge or the face
    double weight = 0.0;
    double bend_weight = 0.0;       ///< of what a moving entity has beyond its corners
    std::array<double, 2> place{};  ///< its own graded coordinates
  };
  /// Lattice of a face in space: its nodes and the parameters along its four edges.
  struct FaceLattice
  {
    std::vector<std::int32_t> nodes;
    std::vector<std::vector<double>> parameters;
  };

  std::vector<Strand> strands(int block, const CornerSamples& samples, int sample) const;
  void add_triangle_strands(int block, const std::array<double, 3>& r, std::vector<Strand>& result) const;
  std::vector<NodeWeight> nodes_at(const Strand& strand) const;
  std::vector<NodeWeight> corners_at(const Strand& strand) const;
  geometry::Point position(std::int64_t node) const;
  void add_facets();
  double distance(const geometry::Point& x) const;

  const Layout& layout_;
  const Skeleton& skeleton_;
  const MovingSides& moving_;
  std::span<const std::int64_t> interface_;
  std::vector<FaceLattice> faces_;  ///< shape (face_count)
  /// The interface as segments or triangles (then corner by corner).
  std::vector<std::array<geometry::Point, 3>> facets_;
  int degree_;
  SamplesByShape samples_;
};

}  // namespace blockfsi::block
