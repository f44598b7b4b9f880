#include "geometry/arc_length.hpp"

#include "element/line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace blockfsi::geometry
{

namespace
{

constexpr int degree = 8;
constexpr std::size_t node_count = degree + 1;

const std::vector<double>& nodes()
{
  static const std::vector<double> points = element::lobatto(degree);
  return points;
}

}  // namespace

ArcLength::ArcLength(const std::function<Point(double)>& curve)
{
  int parts = 4;
  sample(curve, parts);
  bool settled = false;
  // The whole length settles before that of the parts, hence one more halving.
  while (parts < 64 && !settled)
  {
    const double before = length();
    parts *= 2;
    sample(curve, parts);
    settled = std::abs(length() - before) <= 1e-13 * length();
  }
  sample(curve, 2 * parts);
}

void ArcLength::sample(const std::function<Point(double)>& curve, int parts)
{
  static const element::Table table = element::lagrange(nodes(), nodes());
  speed_.assign(parts * node_count, 0.0);
  ends_.assign(1, 0.0);
  Point end = curve(0.0);
  for (int part = 0; part < parts; ++part)
  {
    std::array<Point, node_count> x;
    x[0] = end;
    for (std::size_t i = 1; i < node_count; ++i)
      x[i] = curve(i == degree ? static_cast<double>(part + 1) / parts : (part + nodes()[i]) / parts);
    end = x[degree];
    for (std::size_t i = 0; i < node_count; ++i)
    {
      Point slope{};
      for (std::size_t k = 0; k < node_count; ++k)
        slope = combine(1.0, slope, table.first[i * node_count + k], x[k]);
      speed_[part * node_count + i] = norm(slope);
    }
    ends_.push_back(ends_.back() + within(part, 1.0));
  }
}

double ArcLength::within(int part, double u) const
{
  static const element::Rule rule = element::gauss(degree / 2 + 1);
  std::array<double, degree / 2 + 1> points{};
  std::transform(rule.points.begin(), rule.points.end(), points.begin(), [u](double p) { return p * u; });
  const element::Table table = element::lagrange(nodes(), points);
  double sum = 0.0;
  for (std::size_t q = 0; q < points.size(); ++q)
    for (std::size_t k = 0; k < node_count; ++k)
      sum += rule.weights[q] * table.value[q * node_count + k] * speed_[part * node_count + k];
  return sum * u;
}

double ArcLength::speed(int part, double u) const
{
  const element::Table table = element::lagrange(nodes(), std::span(&u, 1));
  double sum = 0.0;
  for (std::size_t k = 0; k < node_count; ++k)
    sum += table.value[k] * speed_[part * node_count + k];
  return sum;
}

double ArcLength::parameter(double share) const
{
  if (share <= 0.0 || share >= 1.0)
    return share <= 0.0 ? 0.0 : 1.0;
  const double target = share * length();
  const auto parts = static_cast<int>(ends_.size()) - 1;
  const auto above = std::upper_bound(ends_.begin(), ends_.end(), target);
  const int part = std::clamp(static_cast<int>(above - ends_.begin()) - 1, 0, parts - 1);
  const double rest = target - ends_[part];
  double low = 0.0;
  double high = 1.0;
  double u = rest / (ends_[part + 1] - ends_[part]);
  for (int iteration = 0; iteration < 60; ++iteration)
  {
    const double excess = within(part, u) - rest;
    (excess > 0.0 ? high : low) = u;
    double next = u - excess / speed(part, u);
    if (!(next > low && next < high))
      next = 0.5 * (low + high);
    const double change = std::abs(next - u);
    u = next;
    if (change < 1e-15)
      break;
  }
  return (part + u) / parts;
}

}  // namespace blockfsi::geometry
