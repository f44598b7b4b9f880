#pragma once

#include "mesh/split.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace blockfsi::mesh
{

/// What a cell shares with others: its corners, edges and sides (in 3D), as sets of corners, and itself.
struct Entities
{
  std::vector<Mean> corners;                     ///< sets of corners of the cell, smaller ones first
  std::vector<std::vector<std::int32_t>> nodes;  ///< those of the cell that name each entity

  /// The smallest entity that holds a set of corners.
  std::size_t holding(Mean mean) const
  {
    std::size_t e = 0;
    while ((corners[e] & mean) != mean)
      ++e;
    return e;
  }
};

/// How much each corner of a cell counts in a node of its lattice.
using Weights = std::array<int, element::max_corners>;

/// Weights of all nodes of a cell, in whole numbers without a common factor: so the node of a side has the
/// same from both cells, whatever their shapes. Shape (lattice_size).
std::vector<Weights> corner_weights(element::Shape shape, int order);

/// Nodes of a kind of part as functions of the cell that it is part of.
struct PartNodes
{
  CellPart part;
  std::vector<double> matrix;       ///< shape (node_count, nodes of the cell)
  std::vector<std::size_t> entity;  ///< of the cell, on which each node lies
  std::vector<Mean> side;           ///< corners of the cell that each side of the part touches
};

/// What making parts of cells of one shape and order, of a new order, takes.
struct PartTables
{
  PartTables(element::Shape shape, int order, int new_order);

  /// Made when first asked for.
  const PartNodes& of(const CellPart& part);

  element::Shape shape;
  int order;
  int new_order;
  Entities entities;
  std::vector<std::int32_t> corners;  ///< positions of the corners among the nodes of a cell
  std::map<CellPart, PartNodes> parts;
};

}  // namespace blockfsi::mesh
