#pragma once

#include "mesh/mesh.hpp"
#include "output/mesh_file.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace blockfsi::output
{

/// Cells of one shape as a file has them.
struct DraftCells
{
  element::Shape shape = element::Shape::quadrilateral;
  std::vector<std::int32_t> points;  ///< of each cell, in the order of the shape's lattice
  std::vector<std::int32_t> block;   ///< of each cell
  std::vector<std::int64_t> number;  ///< of each cell in the file: for messages, cell fields and boundaries
};

/// A mesh on its way from a file: points at equispaced lattices, some of them perhaps not used.
struct Draft
{
  int order = 1;
  std::vector<double> points;  ///< shape (point_count, 3)
  std::vector<DraftCells> cells;
  std::vector<std::string> block_names;
  std::vector<std::string> block_regions;
  std::vector<ReadField> fields;                                           ///< at the points
  std::vector<ReadField> cell_fields;                                      ///< in the order of the file
  std::map<std::string, std::vector<mesh::Side>, std::less<>> boundaries;  ///< cells by their number

  std::size_t point_count() const { return points.size() / 3; }
  /// The cells of a shape, made if there are none yet.
  DraftCells& cells_of(element::Shape shape);
};

/// Checks the draft and makes the mesh of it: nodes are the points that cells use, in their order; cells of
/// one shape follow each other. Throws Error, without the name of the file, that says which cell is wrong.
ReadMesh assemble(Draft draft);

}  // namespace blockfsi::output
