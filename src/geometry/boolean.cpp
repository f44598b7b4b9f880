#include "geometry/boolean.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

namespace blockfsi::geometry
{

namespace
{

/// Smaller of both, blended where they differ by less than r.
double blended(double a, double b, double r)
{
  const double difference = a - b;
  if (!(std::abs(difference) < r))
    return a < b ? a : b;
  return 0.5 * (a + b) - r + 0.5 * std::sqrt(2.0 * r * r - difference * difference);
}

Level blended(const Level& a, const Level& b, double r)
{
  const double difference = a.value - b.value;
  if (!(std::abs(difference) < r))
    return a.value < b.value ? a : b;
  const double tilt = 0.5 * difference / std::sqrt(2.0 * r * r - difference * difference);
  return {blended(a.value, b.value, r), combine(0.5 - tilt, a.gradient, 0.5 + tilt, b.gradient)};
}

double times(double sign, double value)
{
  return sign * value;
}

Level times(double sign, const Level& level)
{
  return {sign * level.value, scaled(sign, level.gradient)};
}

/// sign * min over sign_i φ_i, where sign_0 = sign and sign_i = others for the rest.
LevelSet smallest(std::string_view word, const std::vector<LevelSet>& domains, double blend, double sign,
                  double others)
{
  if (domains.empty())
    throw Error(fmt::format("the {} of no level sets is asked for; name at least one", word));
  if (!(blend >= 0.0 && std::isfinite(blend)))
    throw Error(fmt::format("the blend of the {} is {:.9g}; it must be a length or 0", word, blend));
  std::string text = fmt::format("{} of {}", word, domains[0].text());
  for (std::size_t i = 1; i < domains.size(); ++i)
    text += ", " + domains[i].text();
  const auto fold = [domains, blend, sign, others](const auto& evaluate)
  {
    auto result = times(sign, evaluate(domains[0]));
    for (std::size_t i = 1; i < domains.size(); ++i)
      result = blended(result, times(others, evaluate(domains[i])), blend);
    return times(sign, result);
  };
  return {text, [fold](const Point& x) { return fold([&x](const LevelSet& one) { return one(x); }); },
          [fold](const Point& x) { return fold([&x](const LevelSet& one) { return one.value(x); }); }};
}

}  // namespace

LevelSet complement(const LevelSet& domain)
{
  return {"complement of " + domain.text(), [domain](const Point& x) { return times(-1.0, domain(x)); },
          [domain](const Point& x) { return -domain.value(x); }};
}

LevelSet unite(const std::vector<LevelSet>& domains, double blend)
{
  return smallest("union", domains, blend, 1.0, 1.0);
}

LevelSet intersect(const std::vector<LevelSet>& domains, double blend)
{
  return smallest("intersection", domains, blend, -1.0, -1.0);
}

LevelSet difference(const std::vector<LevelSet>& domains, double blend)
{
  // Not below φ_0 and not below -φ_i is the maximum of φ_0 and -φ_i.
  return smallest("difference", domains, blend, -1.0, 1.0);
}

}  // namespace blockfsi::geometry
