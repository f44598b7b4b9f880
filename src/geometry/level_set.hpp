#pragma once

#include "core/expression.hpp"
#include "geometry/point.hpp"

#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace blockfsi::geometry
{

/// A level set's value and gradient at a point.
struct Level
{
  double value = 0.0;
  Point gradient{};
};

/// A domain given by a scalar field φ: φ < 0 inside, φ = 0 on its boundary, φ > 0 outside. A field of the
/// plane does not depend on z. A value: cheap to copy, immutable, safe to share between threads.
class LevelSet
{
public:
  using Evaluate = std::function<Level(const Point&)>;
  using Value = std::function<double(const Point&)>;

  /// The field that `level` gives with its gradient; `value`, if given, is the same without the gradient,
  /// for speed. `text` names the level set in messages. Calls must not allocate if searches shall not.
  LevelSet(std::string text, Evaluate level, Value value = {});
  /// The field of a formula in x, y, z at t = 0; gradients by forward differentiation.
  explicit LevelSet(const Expression& formula);

  /// φ and ∇φ at x.
  Level operator()(const Point& x) const { return field_->level(x); }
  /// φ at x.
  double value(const Point& x) const { return field_->value ? field_->value(x) : field_->level(x).value; }
  /// The same level set with another text.
  LevelSet named(std::string text) const;
  /// Whether both are copies of one level set.
  bool same_as(const LevelSet& other) const { return field_ == other.field_; }
  /// How the level set is named in messages: its formula, or what it was made of.
  const std::string& text() const { return field_->text; }

private:
  struct Field
  {
    std::string text;
    Evaluate level;
    Value value;
  };
  std::shared_ptr<const Field> field_;
};

/// The level set moved by a vector [m].
LevelSet translated(const LevelSet& domain, const Point& by);
/// The level set turned about the line through `center` along `axis`, right-handed, by `angle` [rad]. Throws
/// Error for an axis of length 0.
LevelSet rotated(const LevelSet& domain, const Point& center, const Point& axis, double angle);
/// The level set grown from `center` by a factor > 0; a distance stays a distance. Throws Error for others.
LevelSet grown(const LevelSet& domain, const Point& center, double factor);

}  // namespace blockfsi::geometry
