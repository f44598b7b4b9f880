#include "geometry/level_set.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

namespace blockfsi::geometry
{

namespace
{

/// Rodrigues' rotation of v about a unit axis.
Point turned(const Point& v, const Point& axis, double cosine, double sine)
{
  const Point across = cross(axis, v);
  const double along = (1.0 - cosine) * dot(axis, v);
  return add(combine(cosine, v, sine, across), scaled(along, axis));
}

}  // namespace

LevelSet::LevelSet(std::string text, Evaluate level, Value value)
    : field_(std::make_shared<const Field>(Field{std::move(text), std::move(level), std::move(value)}))
{
}

LevelSet::LevelSet(const Expression& formula)
    : LevelSet(
          formula.text(),
          [formula](const Point& x)
          {
            const Expression::Derivatives at = formula.derivatives(x[0], x[1], x[2]);
            return Level{at.value, {at.by[0], at.by[1], at.by[2]}};
          },
          [formula](const Point& x) { return formula(x[0], x[1], x[2]); })
{
}

LevelSet LevelSet::named(std::string text) const
{
  return {std::move(text), field_->level, field_->value};
}

LevelSet translated(const LevelSet& domain, const Point& by)
{
  return {domain.text(), [domain, by](const Point& x) { return domain(subtract(x, by)); },
          [domain, by](const Point& x) { return domain.value(subtract(x, by)); }};
}

LevelSet rotated(const LevelSet& domain, const Point& center, const Point& axis, double angle)
{
  const double size = norm(axis);
  if (!(size > 0.0 && std::isfinite(size)))
    throw Error(fmt::format("the axis of a rotation is ({:.9g}, {:.9g}, {:.9g}); it must have a length",
                            axis[0], axis[1], axis[2]));
  const Point unit = scaled(1.0 / size, axis);
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  const auto back = [=](const Point& x)
  { return add(center, turned(subtract(x, center), unit, cosine, -sine)); };
  return {domain.text(),
          [=](const Point& x)
          {
            const Level level = domain(back(x));
            return Level{level.value, turned(level.gradient, unit, cosine, sine)};
          },
          [=](const Point& x) { return domain.value(back(x)); }};
}

LevelSet grown(const LevelSet& domain, const Point& center, double factor)
{
  if (!(factor > 0.0 && std::isfinite(factor)))
    throw Error(fmt::format("a level set is scaled by {:.9g}; the factor must be positive", factor));
  const auto back = [=](const Point& x) { return add(center, scaled(1.0 / factor, subtract(x, center))); };
  return {domain.text(),
          [=](const Point& x)
          {
            const Level level = domain(back(x));
            return Level{factor * level.value, level.gradient};
          },
          [=](const Point& x) { return factor * domain.value(back(x)); }};
}

}  // namespace blockfsi::geometry
