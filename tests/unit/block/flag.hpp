#pragma once

#include "block/connect.hpp"
#include "block/corner_layout.hpp"
#include "block/layout.hpp"
#include "block/move.hpp"
#include "block/place.hpp"
#include "element/line.hpp"
#include "mesh/quality.hpp"
#include "mesh/validity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// A flag behind a cylinder that is bent as told: the layouts and motions of formulation.md chapter 9.
namespace blockfsi::block::testing
{

/// Where the channel's walls are, as seen from the middle of the cylinder of radius 0.05.
struct Channel
{
  double below;
  double above;
  double box;  ///< half side of the box of blocks around the cylinder
};

constexpr Channel narrow_channel = {-0.2, 0.21, 0.1};
constexpr Channel wide_channel = {-0.8, 0.8, 0.12};

/// 24 blocks of fluid around the cylinder and the flag, two of flag.
class FlagLayout
{
public:
  FlagLayout(const Channel& channel, int order, int divisions) : channel_(channel)
  {
    layout.order = order;
    layout.default_divisions = divisions;
    points();
    blocks();
    arcs();
    const auto boundary = [this](const char* name, const char* condition) {
      layout.boundaries.push_back({name, ByCondition{Condition(condition, {})}, {}});
    };
    boundary("inlet", "x = -0.2");
    boundary("outlet", "x = 2.3");
    layout.boundaries.push_back({"walls", walls_, {}});
    boundary("cylinder", "x^2 + y^2 < 0.0026");
  }

  Layout layout;

private:
  void point(const std::string& name, double x, double y)
  {
    number_[name] = static_cast<int>(layout.points.size());
    layout.points.push_back({name, {x, y, 0.0}, {}});
  }

  void points()
  {
    const double a = channel_.box;
    const double c = 0.05 / std::sqrt(2.0);
    const double root = std::sqrt(0.05 * 0.05 - 0.01 * 0.01);
    point("c135", -c, c);
    point("c225", -c, -c);
    point("c315", c, -c);
    point("c45", c, c);
    point("rt", root, 0.01);
    point("rb", root, -0.01);
    point("ft", a, 0.01);
    point("fb", a, -0.01);
    point("tt", 0.4, 0.01);
    point("tb", 0.4, -0.01);
    const std::array<double, 4> y4 = {channel_.below, -a, a, channel_.above};
    const std::array<std::pair<const char*, double>, 4> columns = {
        {{"i", -0.2}, {"b", -a}, {"r", a}, {"t", 0.4}}};
    for (const auto& [name, x] : columns)
      for (int k = 0; k < 4; ++k)
        point(name + std::to_string(k), x, y4[k]);
    const std::array<double, 6> y6 = {channel_.below, -a, -0.01, 0.01, a, channel_.above};
    for (int k = 0; k < 6; ++k)
    {
      point("d" + std::to_string(k), 0.75, y6[k]);
      point("o" + std::to_string(k), 2.3, y6[k]);
    }
    for (const auto& line :
         {std::vector{"i0", "b0", "r0", "t0", "d0", "o0"}, {"i3", "b3", "r3", "t3", "d5", "o5"}})
      for (std::size_t k = 1; k < line.size(); ++k)
        walls_.edges.push_back({number_.at(line[k - 1]), number_.at(line[k])});
  }

  void block(const std::array<std::string, 4>& names, const char* region = "fluid")
  {
    Block block;
    block.region = region;
    for (const std::string& name : names)
    {
      block.points.push_back(number_.at(name));
      block.name += name + " ";
    }
    layout.blocks.push_back(block);
  }

  void blocks()
  {
    block({"i0", "b0", "b1", "i1"});
    block({"i1", "b1", "b2", "i2"});
    block({"i2", "b2", "b3", "i3"});
    block({"b1", "c225", "c135", "b2"});
    block({"c135", "c45", "r2", "b2"});
    block({"rt", "ft", "r2", "c45"});
    block({"fb", "rb", "c315", "r1"});
    block({"b1", "r1", "c315", "c225"});
    block({"b0", "r0", "r1", "b1"});
    block({"b2", "r2", "r3", "b3"});
    block({"ft", "tt", "t2", "r2"});
    block({"r2", "t2", "t3", "r3"});
    block({"r1", "t1", "tb", "fb"});
    block({"r0", "t0", "t1", "r1"});
    block({"t0", "d0", "d1", "t1"});
    block({"t1", "d1", "d2", "tb"});
    block({"tb", "d2", "d3", "tt"});
    block({"tt", "d3", "d4", "t2"});
    block({"t2", "d4", "d5", "t3"});
    for (int k = 0; k < 5; ++k)
    {
      const std::string low = std::to_string(k);
      const std::string high = std::to_string(k + 1);
      block({"d" + low, "o" + low, "o" + high, "d" + high});
    }
    block({"rb", "fb", "ft", "rt"}, "flag");
    block({"fb", "tb", "tt", "ft"}, "flag");
  }

  void arcs()
  {
    for (const auto& [a, b] :
         {std::pair{"c225", "c135"}, {"c135", "c45"}, {"c225", "c315"}, {"c45", "rt"}, {"c315", "rb"}})
      layout.edges.push_back({number_.at(a), number_.at(b), geometry::Arc{}, {}, {}, {}});
  }

  Channel channel_;
  std::map<std::string, int> number_;
  ByEdges walls_;
};

/// How the flag is bent: its axis turns by an angle that grows from the root to the tip.
enum class Bending
{
  uniform,  ///< with constant curvature ("bend")
  at_root   ///< in the first fifth, smoothly; the rest is straight ("rot")
};

/// Where the flag goes when its tip turns by an angle.
inline std::array<double, 2> bent_flag(Bending bending, double angle, const std::array<double, 2>& X)
{
  const double root = std::sqrt(0.05 * 0.05 - 0.01 * 0.01);
  const double length = 0.4 - root;
  const double s = (X[0] - root) / length;
  constexpr double share = 0.2;
  const auto turn = [&](double t)
  {
    if (bending == Bending::uniform)
      return angle * t;
    const double q = std::clamp(t / share, 0.0, 1.0);
    return angle * (3.0 * q * q - 2.0 * q * q * q);
  };
  static const element::Rule rule = element::gauss(16);
  std::array<double, 2> x = {root, 0.0};
  const double kink = bending == Bending::uniform ? s : std::min(s, share);
  for (const auto& [a, b] : {std::pair{0.0, kink}, {kink, s}})
    for (std::size_t k = 0; k < rule.points.size(); ++k)
    {
      const double theta = turn(a + (b - a) * rule.points[k]);
      x[0] += rule.weights[k] * (b - a) * length * std::cos(theta);
      x[1] += rule.weights[k] * (b - a) * length * std::sin(theta);
    }
  return {x[0] - std::sin(turn(s)) * X[1], x[1] + std::cos(turn(s)) * X[1]};
}

/// The fluid's mesh around the flag as its corners follow by a rule.
class BentFlag
{
public:
  BentFlag(const Layout& layout, CornerRule rule, bool slide = true)
      : BentFlag(layout,
                 [&](const BentFlag& self) {
                   return corner_motion(layout, self.skeleton_, "fluid", self.interface_,
                                        self.parameters(rule, slide));
                 })
  {
  }
  BentFlag(const Layout& layout, const NonlinearParameters& nonlinear)
      : BentFlag(layout,
                 [&](const BentFlag& self)
                 {
                   return CornerMotion(corner_graph(layout, self.skeleton_, "fluid", self.interface_,
                                                    self.parameters(CornerRule::nonlinear, true)),
                                       nonlinear);
                 })
  {
  }

  /// Bends the flag by an angle [degrees].
  CornerReport bend(Bending bending, double degrees)
  {
    for (std::size_t k = 0; k < interface_.size(); ++k)
    {
      const std::array<double, 2> X = {skeleton_.x[2 * interface_[k]], skeleton_.x[2 * interface_[k] + 1]};
      const std::array<double, 2> moved = bent_flag(bending, degrees * std::acos(-1.0) / 180.0, X);
      for (int i = 0; i < 2; ++i)
        displacement_[2 * k + i] = degrees == 0.0 ? 0.0 : moved[i] - X[i];
    }
    return follow();
  }
  CornerReport follow()
  {
    const CornerReport report = motion_.move(displacement_, skeleton_x_);
    block::place(connected_.plan, skeleton_x_, x_);
    return report;
  }

  double scaled_jacobian() const { return mesh::measure(quality_, connected_.mesh, x_).scaled_jacobian; }
  bool certified() const { return mesh::certify(validity_, connected_.mesh, x_).all_valid(); }
  /// Largest way of a node from its first place [m].
  double drift() const
  {
    double largest = 0.0;
    const std::vector<double> first = initial_nodes(connected_, skeleton_);
    for (std::size_t i = 0; i < x_.size(); ++i)
      largest = std::max(largest, std::abs(x_[i] - first[i]));
    return largest;
  }

  const Connected& connected() const { return connected_; }
  const Skeleton& skeleton() const { return skeleton_; }
  const std::vector<std::int64_t>& interface() const { return interface_; }
  std::vector<double>& displacement() { return displacement_; }
  SkeletonMotion& motion() { return motion_; }
  const std::vector<double>& x() const { return x_; }

private:
  template <typename Make>
  BentFlag(const Layout& layout, Make make)
      : skeleton_(make_skeleton(layout)), connected_(connect(layout, skeleton_, "fluid", {})),
        interface_(interface_nodes(layout, skeleton_, "fluid", "flag")),
        motion_(skeleton_, interface_, make(*this)), displacement_(2 * interface_.size(), 0.0),
        skeleton_x_(skeleton_.x), x_(initial_nodes(connected_, skeleton_)), quality_(layout.order),
        validity_(layout.order)
  {
  }
  CornerParameters parameters(CornerRule rule, bool slide) const
  {
    CornerParameters parameters;
    parameters.rule = rule;
    if (slide)
      parameters.slide = {{"walls"}};
    return parameters;
  }

  Skeleton skeleton_;
  Connected connected_;
  std::vector<std::int64_t> interface_;
  SkeletonMotion motion_;
  std::vector<double> displacement_;
  std::vector<double> skeleton_x_;
  std::vector<double> x_;
  mesh::QualityTables quality_;
  mesh::ValidityTables validity_;
};

/// The largest angle [degrees] up to which the mesh is certified valid, in steps.
struct Sweep
{
  double last = 0.0;
  std::map<double, double> scaled_jacobian;
  int iterations = 0;
  int steps = 0;
};

inline Sweep sweep(BentFlag& flag, Bending bending, double step, double end)
{
  Sweep result;
  for (double angle = step; angle <= end + 1e-9; angle += step)
  {
    const CornerReport report = flag.bend(bending, angle);
    result.iterations += report.iterations;
    ++result.steps;
    result.scaled_jacobian[angle] = flag.scaled_jacobian();
    if (!flag.certified())
      break;
    result.last = angle;
  }
  return result;
}

}  // namespace blockfsi::block::testing
