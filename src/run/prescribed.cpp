#include "run/prescribed.hpp"

#include "block/connect.hpp"
#include "block/place.hpp"
#include "linalg/communicator.hpp"
#include "linalg/numbering.hpp"
#include "mesh/validity.hpp"
#include "motion/update.hpp"
#include "run/mesh_update.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace blockfsi::run
{

namespace
{

/// Angles that agree to this are the same [degrees].
constexpr double angle_tolerance = 1e-9;

double radians(double degrees)
{
  return degrees * std::numbers::pi / 180.0;
}

/// Largest distance between nodes of the same number in two meshes [m].
double largest_distance(std::span<const double> x, std::span<const double> y, int dim)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < x.size(); i += dim)
  {
    double square = 0.0;
    for (std::size_t c = i; c < i + dim; ++c)
      square += (x[c] - y[c]) * (x[c] - y[c]);
    largest = std::max(largest, square);
  }
  return std::sqrt(largest);
}

}  // namespace

struct PrescribedMesh::Data
{
  case_file::Case description;
  block::Skeleton skeleton;
  std::vector<std::int64_t> interface;
  block::Connected connected;
  linalg::Numbering numbering;
  std::vector<double> first;
  std::vector<double> interface_x;
  mesh::QualityTables quality_tables;
  mesh::ValidityTables validity_tables;
  std::vector<double> first_jacobian;
  std::vector<double> x;

  explicit Data(const case_file::Case& of)
      : description(of), skeleton(block::make_skeleton(of.layout)),
        interface(block::interface_nodes(of.layout, skeleton, of.fluid->region, of.solid->region)),
        connected(block::connect(of.layout, skeleton, of.fluid->region, linalg::part())),
        numbering(connected.mesh.lattice, connected.mesh.owner),
        first(block::initial_nodes(connected, skeleton)), quality_tables(connected.mesh),
        validity_tables(connected.mesh),
        first_jacobian(mesh::sample_jacobian(quality_tables, connected.mesh, first)), x(first)
  {
    for (const std::int64_t node : interface)
      for (int c = 0; c < skeleton.dim; ++c)
        interface_x.push_back(skeleton.x[node * skeleton.dim + c]);
  }

  motion::Update update() const
  {
    return make_update(description, {skeleton, connected.plan, connected.mesh, numbering, first, interface});
  }

  FlapMotion flap(FlapShape shape) const { return {*description.prescribed, shape}; }

  /// Moves the mesh to an angle and looks at it; the failure of the update, if any, goes to `failure`.
  SweepPoint visit(motion::Update& update, const FlapMotion& flap, double angle, std::string& failure)
  {
    const std::vector<double> d = flap.displacement(interface_x, skeleton.dim, radians(angle));
    SweepPoint point;
    point.angle = angle;
    const auto start = std::chrono::steady_clock::now();
    const motion::Report report = motion::follow(update, d, x);
    point.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    point.quality = mesh::measure(quality_tables, connected.mesh, x, first_jacobian);
    point.certified = report.ok && mesh::certify(validity_tables, connected.mesh, x).all_valid();
    failure = report.failure;
    motion::accept(update, d, x);
    return point;
  }
};

PrescribedMesh::PrescribedMesh(const case_file::Case& description)
    : data_(std::make_unique<Data>(description))
{
}

PrescribedMesh::~PrescribedMesh() = default;

const mesh::Mesh& PrescribedMesh::mesh() const
{
  return data_->connected.mesh;
}

std::int64_t PrescribedMesh::node_count() const
{
  return data_->connected.mesh.total_node_count;
}

Sweep PrescribedMesh::sweep(FlapShape shape)
{
  const case_file::Prescribed& wanted = *data_->description.prescribed;
  const FlapMotion flap = data_->flap(shape);
  motion::Update update = data_->update();
  Sweep sweep;
  sweep.shape = shape;
  const auto steps = std::llround(wanted.angle / wanted.step);
  for (long long k = 0; k <= steps; ++k)
  {
    const SweepPoint point = data_->visit(update, flap, static_cast<double>(k) * wanted.step, sweep.failure);
    sweep.points.push_back(point);
    if (!point.certified)
      return sweep;
    sweep.last_valid = point.angle;
    for (const double angle : wanted.show)
      if (std::abs(angle - point.angle) < angle_tolerance)
        sweep.snapshots.push_back({angle, data_->x});
  }
  sweep.is_complete = true;
  return sweep;
}

Cycles PrescribedMesh::cycle(FlapShape shape)
{
  const case_file::Prescribed& wanted = *data_->description.prescribed;
  const FlapMotion flap = data_->flap(shape);
  motion::Update update = data_->update();
  Cycles cycles;
  const long long quarter = std::llround(wanted.amplitude / wanted.step);
  std::string failure;
  for (int cycle = 0; cycle < wanted.cycles; ++cycle)
  {
    double least = 1.0;
    for (long long k = 1; k <= 4 * quarter; ++k)
    {
      // Up to the amplitude, down to its negative, and back.
      const long long at = k <= quarter ? k : k <= 3 * quarter ? 2 * quarter - k : k - 4 * quarter;
      const double angle = static_cast<double>(at) * wanted.step;
      const SweepPoint point = data_->visit(update, flap, angle, failure);
      least = std::min(least, point.quality.scaled_jacobian);
      if (!point.certified)
      {
        cycles.broke_at = angle;
        cycles.is_complete = false;
        return cycles;
      }
    }
    cycles.drift.push_back(largest_distance(data_->x, data_->first, data_->skeleton.dim));
    cycles.scaled_jacobian.push_back(least);
  }
  return cycles;
}

double Sweep::scaled_jacobian(double angle) const
{
  for (const SweepPoint& point : points)
    if (std::abs(point.angle - angle) < angle_tolerance && point.certified)
      return point.quality.scaled_jacobian;
  return std::numeric_limits<double>::quiet_NaN();
}

double Sweep::seconds() const
{
  std::vector<double> all;
  // At rest there is nothing to do, and the first move may factorise once for all.
  for (std::size_t k = 2; k < points.size(); ++k)
    all.push_back(points[k].seconds);
  if (all.empty())
    return std::numeric_limits<double>::quiet_NaN();
  std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
  return all[all.size() / 2];
}

}  // namespace blockfsi::run
