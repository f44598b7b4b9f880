#include "block/overlaps.hpp"

#include "block/merge.hpp"
#include "block/round.hpp"
#include "block/transform.hpp"
#include "core/error.hpp"
#include "layouts.hpp"

#include <doctest/doctest.h>

using namespace blockfsi;
using namespace blockfsi::block;
using namespace blockfsi::block::testing;
using Point3 = std::array<double, 3>;

namespace
{

void add_box(Layout& layout, const std::string& name, Point3 from, Point3 to,
             std::array<int, 3> divisions = {1, 1, 1})
{
  block::Box box;
  box.name = name;
  box.region = "fluid";
  box.from = from;
  box.to = to;
  box.divisions = divisions;
  add(layout, box);
}

Layout boxes(Point3 from, Point3 to, std::array<int, 3> divisions = {1, 1, 1})
{
  Layout layout = empty(3, 1);
  add_box(layout, "a", {0, 0, 0}, {3, 3, 3}, divisions);
  add_box(layout, "b", from, to, divisions);
  merge(layout, 1e-9);
  return layout;
}

void add_ball(Layout& layout, const std::string& name, Point3 center, double radius, int around)
{
  Ball ball;
  ball.name = name;
  ball.region = "fluid";
  ball.center = center;
  ball.radius = radius;
  ball.around = around;
  ball.radial = 2;
  add(layout, ball);
}

void add_shell(Layout& layout, const std::string& name, std::array<double, 2> radii, int around)
{
  Shell shell;
  shell.name = name;
  shell.region = "fluid";
  shell.radii = radii;
  shell.around = around;
  shell.radial = 1;
  add(layout, shell);
}

std::string complaint(const Layout& layout)
{
  return message_of([&] { make_skeleton(layout); });
}

/// All points turned about an axis that is none of the coordinate's.
Layout turned(const Layout& layout)
{
  return transformed(layout, rotation({}, {1.0, 2.0, 0.5}, 0.7), "", "");
}

}  // namespace

TEST_CASE("boxes in space that run through each other are named, wherever they do")
{
  struct Sample
  {
    std::string what;
    Point3 from;
    Point3 to;
  };
  for (const Sample& sample : {Sample{"a corner in a corner", {2.5, 2.5, 2.5}, {4, 4, 4}},
                               Sample{"a bar through it", {1, 1, -1}, {2, 2, 4}},
                               Sample{"a bar through its middle", {1.5, 1.5, -1}, {1.6, 1.6, 4}},
                               Sample{"a thin bar into it", {1.31, 1.42, 2.9}, {1.32, 1.43, 4}},
                               Sample{"a bar through an edge", {2.5, -1, 2.5}, {4, 4, 3.5}},
                               Sample{"a bar as high and wide", {-1, 1, 0}, {4, 2, 3}},
                               Sample{"a plate through all of it", {-1, -1, 1}, {4, 4, 2}}})
  {
    CAPTURE(sample.what);
    for (const int divisions : {1, 3})
      for (const Layout& layout : {boxes(sample.from, sample.to, {divisions, divisions, divisions}),
                                   turned(boxes(sample.from, sample.to, {divisions, divisions, divisions}))})
      {
        const std::string told = complaint(layout);
        CAPTURE(told);
        CHECK(told.find("runs through the face over ") != std::string::npos);
        CHECK(told.find("of the block 'a block'") != std::string::npos);
        CHECK(told.find("of the block 'b block'") != std::string::npos);
      }
  }
}

TEST_CASE("a point on a face or on an edge of which it is no corner is named")
{
  for (const Layout& layout :
       {boxes({3, 1, 1}, {4, 2, 2}), boxes({3, 0, 0}, {4, 3, 2}), boxes({3, 3, 1}, {4, 4, 2}),
        turned(boxes({3, 1, 1}, {4, 2, 2})), boxes({1, 0, 0}, {2, 3, 3}), boxes({1, 0, 0}, {4, 3, 3})})
    CHECK(complaint(layout).find("of which it is no corner; divide the block there or move the point") !=
          std::string::npos);
}

TEST_CASE("boxes beside each other, or with a point or an edge in common, are accepted")
{
  CHECK(complaint(boxes({3.001, 1, 1}, {4, 2, 2})) == "");
  CHECK(complaint(boxes({-1, -1, 3.001}, {5, 5, 4})) == "");
  CHECK(complaint(turned(boxes({3.00001, 1, 1}, {4, 2, 2}))) == "");
  CHECK(complaint(boxes({3, 3, 3}, {4, 4, 4})) == "");
  CHECK(complaint(boxes({3, 3, 0}, {4, 4, 3})) == "");
  CHECK(complaint(turned(boxes({3, 3, 0}, {4, 4, 3}))) == "");
  CHECK(complaint(boxes({3, 0, 0}, {4, 3, 3})) == "");
}

TEST_CASE("a block within others with which it shares nothing is named")
{
  for (const Layout& layout : {boxes({1, 1, 1}, {2, 2, 2}), turned(boxes({0.1, 0.1, 0.1}, {0.2, 0.2, 0.2})),
                               boxes({-1, -1, -1}, {4, 4, 4})})
  {
    const std::string told = complaint(layout);
    CAPTURE(told);
    CHECK(told.find(" lies within the block ") != std::string::npos);
  }

  Layout in_ball = empty(3, 2);
  add_ball(in_ball, "ball", {0, 0, 0}, 1.0, 2);
  add_box(in_ball, "b", {-0.1, 0.6, -0.1}, {0.1, 0.7, 0.1});
  CHECK(complaint(in_ball).find("the block 'b block' lies within the block 'ball ") != std::string::npos);
}

TEST_CASE("what lies in a hole of other blocks is accepted, however thin the gap")
{
  for (const double gap : {0.1, 1e-3, 1e-5})
    for (const int order : {1, 2, 4})
      for (const int around : {1, 2, 5})
      {
        CAPTURE(gap);
        CAPTURE(order);
        CAPTURE(around);
        Layout layout = empty(3, order);
        add_shell(layout, "shell", {1.0, 1.5}, around);
        // Turned, so that its pieces are not those of the shell.
        Layout ball = empty(3, order);
        add_ball(ball, "ball", {0, 0, 0}, 1.0 - gap, around + 1);
        append(layout, turned(ball));
        CHECK(complaint(layout) == "");
      }
}

TEST_CASE("curved blocks that run through each other are named, those that nearly touch are not")
{
  for (const int order : {2, 3, 4})
    for (const int around : {3, 4, 8})
    {
      const auto balls = [&](double apart)
      {
        Layout layout = empty(3, order);
        add_ball(layout, "left", {0, 0, 0}, 1.0, around);
        add_ball(layout, "right", {apart, 0.1, 0.2}, 1.0, around);
        return layout;
      };
      CHECK(complaint(balls(2.0)) == "");
      CHECK(complaint(balls(1.98)) == "");  // the gap is 0.005
      CHECK(complaint(balls(1.8)).find("runs through the face over ") != std::string::npos);
      CHECK(complaint(balls(1.0)).find("runs through the face over ") != std::string::npos);
    }
}
