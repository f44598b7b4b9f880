#include "block/merge.hpp"

#include "block/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace blockfsi::block
{

namespace
{

/// New number of each point, after equal ones have become one.
std::vector<int> join_points(std::vector<Point>& points, double tolerance)
{
  std::vector<Point> kept;
  std::vector<int> number;
  for (const Point& point : points)
  {
    const auto same = std::find_if(kept.begin(), kept.end(),
                                   [&](const Point& other)
                                   {
                                     return std::hypot(point.x[0] - other.x[0], point.x[1] - other.x[1],
                                                       point.x[2] - other.x[2]) <= tolerance;
                                   });
    number.push_back(static_cast<int>(same - kept.begin()));
    if (same == kept.end())
      kept.push_back(point);
  }
  points = std::move(kept);
  return number;
}

void renumber(Layout& layout, const std::vector<int>& number)
{
  for (Block& block : layout.blocks)
    for (int& point : block.points)
      point = number[point];
  for (Edge& edge : layout.edges)
  {
    edge.a = number[edge.a];
    edge.b = number[edge.b];
  }
  for (HoleEdge& edge : layout.hole_edges)
  {
    edge.a = number[edge.a];
    edge.b = number[edge.b];
  }
  const auto renumber_face = [&number](std::vector<int>& face)
  {
    for (int& point : face)
      point = number[point];
  };
  for (Face& face : layout.faces)
    renumber_face(face.points);
  for (Boundary& boundary : layout.boundaries)
    if (auto* edges = std::get_if<ByEdges>(&boundary.rule))
      for (auto& edge : edges->edges)
        edge = {number[edge[0]], number[edge[1]]};
    else if (auto* faces = std::get_if<ByFaces>(&boundary.rule))
      for (std::vector<int>& face : faces->faces)
        renumber_face(face);
}

Error contradiction(const Layout& layout, const Edge& first, const Edge& second, const char* what)
{
  return mistake(second.where,
                 fmt::format("two pieces of the layout share the edge {} but give it different {}{}; let "
                             "both agree or only one of them say it",
                             edge_text(layout, first.a, first.b), what, place_text(first.where)));
}

/// Whether two curves from a to b (the second from b to a if turned) are the same, compared at a few points.
bool same_curve(const Layout& layout, const Edge& first, const Edge& second, double tolerance)
{
  const bool turned = first.a != second.a;
  for (const double t : {0.125, 0.25, 0.5, 0.75, 0.875})
  {
    const geometry::Point x =
        geometry::evaluate(first.curve, layout.points[first.a].x, layout.points[first.b].x, t);
    const geometry::Point y = geometry::evaluate(second.curve, layout.points[second.a].x,
                                                 layout.points[second.b].x, turned ? 1.0 - t : t);
    if (!(std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]) <= tolerance))
      return false;
  }
  return true;
}

/// Adds to the first entry what the second knows.
void unite(const Layout& layout, Edge& first, const Edge& second, double tolerance)
{
  if (first.divisions && second.divisions && *first.divisions != *second.divisions)
    throw contradiction(layout, first, second, "numbers of cells");
  if (!first.divisions)
    first.divisions = second.divisions;

  const bool turned = first.a != second.a;
  std::optional<Grading> grading = second.grading;
  if (grading && turned)
    grading = reversed(*grading);
  if (first.grading && grading && *first.grading != *grading)
    throw contradiction(layout, first, second, "gradings");
  if (!first.grading)
    first.grading = grading;

  if (std::holds_alternative<geometry::Segment>(second.curve))
    return;
  if (!std::holds_alternative<geometry::Segment>(first.curve))
  {
    if (!same_curve(layout, first, second, tolerance))
      throw contradiction(layout, first, second, "curves");
    return;
  }
  first.curve = second.curve;
  if (turned)
  {
    std::swap(first.a, first.b);
    first.grading = first.grading ? std::optional(reversed(*first.grading)) : std::nullopt;
  }
}

void join_edges(Layout& layout, double tolerance)
{
  std::vector<Edge> kept;
  std::map<std::pair<int, int>, std::size_t> known;
  for (const Edge& edge : layout.edges)
  {
    const auto [entry, is_new] = known.try_emplace(std::minmax(edge.a, edge.b), kept.size());
    if (is_new)
      kept.push_back(edge);
    else
      unite(layout, kept[entry->second], edge, tolerance);
  }
  layout.edges = std::move(kept);
}

/// Of several entries for one face the first that shapes it stays; shapes of different kinds contradict.
void join_faces(Layout& layout)
{
  std::vector<Face> kept;
  std::map<std::vector<int>, std::size_t> known;
  for (const Face& face : layout.faces)
  {
    std::vector<int> points = face.points;
    std::sort(points.begin(), points.end());
    const auto [entry, is_new] = known.try_emplace(std::move(points), kept.size());
    if (is_new)
    {
      kept.push_back(face);
      continue;
    }
    Face& first = kept[entry->second];
    if (std::holds_alternative<Interpolated>(first.geometry))
      first = face;
    else if (!std::holds_alternative<Interpolated>(face.geometry) &&
             face.geometry.index() != first.geometry.index())
      throw mistake(face.where,
                    fmt::format("two pieces of the layout share the {} but give it different shapes{}; "
                                "let only one of them say it",
                                side_text(layout, face.points), place_text(first.where)));
  }
  layout.faces = std::move(kept);
}

}  // namespace

void merge(Layout& layout, double tolerance)
{
  const std::vector<int> number = join_points(layout.points, tolerance);
  renumber(layout, number);
  join_edges(layout, tolerance);
  join_faces(layout);
}

}  // namespace blockfsi::block
