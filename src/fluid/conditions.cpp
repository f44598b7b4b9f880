#include "fluid/conditions.hpp"

#include "fem/boundary.hpp"

#include <array>

namespace blockfsi::fluid
{

namespace
{

/// Rank of a condition where boundaries meet; traction and outflow prescribe nothing.
int priority(const Condition& condition)
{
  if (std::holds_alternative<Slip>(condition))
    return 1;
  if (std::holds_alternative<Velocity>(condition))
    return 2;
  return std::holds_alternative<Wall>(condition) ? 4 : 0;
}

constexpr int interface_priority = 3;

bool is_open(const Condition& condition)
{
  return std::holds_alternative<Traction>(condition) || std::holds_alternative<Outflow>(condition);
}

/// Marks the velocity component normal to each side of a slip boundary, shape (node_count, 2).
std::vector<std::uint8_t> normal_components(const BoundaryCondition& condition, const mesh::Mesh& mesh,
                                            const linalg::Numbering& numbering, std::span<const double> x)
{
  try
  {
    return fem::normal_components(mesh, numbering, condition.boundary, x);
  }
  catch (const Error& error)
  {
    throw error.at(condition.where);
  }
}

/// Both components at all nodes of a boundary, shape (node_count, 2).
std::vector<std::uint8_t> both_components(std::string_view boundary, const mesh::Mesh& mesh,
                                          const linalg::Numbering& numbering)
{
  const std::vector<std::uint8_t> nodes = fem::nodes_on(mesh, numbering, boundary);
  std::vector<std::uint8_t> marks(2 * nodes.size());
  for (std::size_t i = 0; i < marks.size(); ++i)
    marks[i] = nodes[i / 2];
  return marks;
}

}  // namespace

Conditions find_conditions(const Parameters& parameters, const mesh::Mesh& mesh,
                           const linalg::Numbering& numbering, std::span<const double> x)
{
  std::vector<int> winner(2 * mesh.node_count(), 0);
  std::vector<Prescribed> entries(2 * mesh.node_count());
  const auto prescribe = [&](const std::vector<std::uint8_t>& marks, int rank, Prescribed::Kind kind,
                             const std::array<Expression, 3>& value)
  {
    for (std::size_t i = 0; i < marks.size(); ++i)
      if (marks[i] != 0 && rank > winner[i])
      {
        winner[i] = rank;
        entries[i] = {static_cast<std::int32_t>(i / 2), static_cast<int>(i % 2), kind, value[i % 2]};
      }
  };

  Conditions result;
  for (const BoundaryCondition& condition : parameters.boundaries)
  {
    const int rank = priority(condition.condition);
    if (is_open(condition.condition))
      result.enclosed = false;
    else if (const auto* velocity = std::get_if<Velocity>(&condition.condition))
      prescribe(both_components(condition.boundary, mesh, numbering), rank, Prescribed::Kind::expression,
                velocity->value);
    else if (std::holds_alternative<Slip>(condition.condition))
      prescribe(normal_components(condition, mesh, numbering, x), rank, Prescribed::Kind::zero, {});
    else
      prescribe(both_components(condition.boundary, mesh, numbering), rank, Prescribed::Kind::zero, {});
  }
  prescribe(both_components(interface_name, mesh, numbering), interface_priority, Prescribed::Kind::interface,
            {});

  for (std::size_t i = 0; i < entries.size(); ++i)
    if (winner[i] > 0)
      result.prescribed.push_back(entries[i]);
  return result;
}

std::vector<std::uint8_t> fixed_unknowns(const Conditions& conditions, const mesh::Mesh& mesh)
{
  std::vector<std::uint8_t> fixed(3 * mesh.node_count(), 0);
  for (const Prescribed& entry : conditions.prescribed)
    fixed[3 * entry.node + entry.component] = 1;
  // Only the process with the first cell knows; the caller makes the marks agree.
  if (conditions.enclosed && mesh.cell_count() > 0 && mesh.number_of_cell(0) == 0)
    fixed[3 * mesh.cell(0)[0] + 2] = 1;
  return fixed;
}

}  // namespace blockfsi::fluid
