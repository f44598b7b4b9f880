#include "geometry/box_tree.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace blockfsi::geometry;

TEST_CASE("the pairs of boxes that meet are those that comparing all of them finds")
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  for (const int count : {0, 1, 2, 5, 60, 400})
    for (const double size : {0.0, 0.1, 0.7})
    {
      std::vector<Box> boxes;
      for (int i = 0; i < count; ++i)
      {
        const Point low{place(generator), place(generator), place(generator)};
        boxes.push_back({low, {low[0] + size * place(generator), low[1] + size * place(generator), low[2]}});
        // Equal boxes and such that touch.
        if (i % 7 == 1)
          boxes.push_back({boxes.back().high, {2.0, 2.0, 2.0}});
        if (i % 7 == 2)
          boxes.push_back(boxes.back());
      }
      std::vector<std::pair<std::int32_t, std::int32_t>> expected;
      for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j)
          if (boxes[i].meets(boxes[j]))
            expected.emplace_back(i, j);
      CHECK((meeting_pairs(boxes) == expected));
    }
}

TEST_CASE("a box around points has them all and its margin")
{
  const std::vector<Point> points = {{1, 5, -1}, {3, 2, 0}, {2, 7, 4}};
  const Box box = box_around(points, 0.5);
  CHECK((box.low == Point{0.5, 1.5, -1.5}));
  CHECK((box.high == Point{3.5, 7.5, 4.5}));
}
