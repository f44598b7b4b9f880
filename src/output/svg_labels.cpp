#include "output/svg_labels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blockfsi::output::svg
{

namespace
{

/// Side of a square [pixels].
constexpr double side = 3.0;

int square(double pixels)
{
  return static_cast<int>(std::floor(pixels / side));
}

}  // namespace

double text_width(std::string_view text, double size)
{
  // All bytes of UTF-8 but those that continue a letter.
  const auto letters = std::count_if(text.begin(), text.end(),
                                     [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; });
  return 0.57 * size * static_cast<double>(letters);
}

Room::Room(double width, double height)
    : columns_(square(width) + 1), rows_(square(height) + 1),
      squares_(static_cast<std::size_t>(columns_) * rows_, is_free)
{
}

void Room::add_line_point(double x, double y)
{
  const int column = square(x);
  const int row = square(y);
  if (column >= 0 && row >= 0 && column < columns_ && row < rows_ && at(column, row) == is_free)
    at(column, row) = is_line;
}

void Room::block(const Box& box)
{
  for (int row = std::max(square(box.y), 0); row <= std::min(square(box.y + box.height), rows_ - 1); ++row)
    for (int column = std::max(square(box.x), 0); column <= std::min(square(box.x + box.width), columns_ - 1);
         ++column)
      at(column, row) = is_blocked;
}

std::optional<int> Room::cost(const Box& box) const
{
  if (box.x < 0.0 || box.y < 0.0 || square(box.x + box.width) >= columns_ ||
      square(box.y + box.height) >= rows_)
    return std::nullopt;
  int crossed = 0;
  for (int row = square(box.y); row <= square(box.y + box.height); ++row)
    for (int column = square(box.x); column <= square(box.x + box.width); ++column)
    {
      if (at(column, row) == is_blocked)
        return std::nullopt;
      crossed += at(column, row) == is_line ? 1 : 0;
    }
  return crossed;
}

std::optional<Box> Room::place_near(double x, double y, double width, double height)
{
  constexpr int rings = 5;
  constexpr int directions = 16;
  constexpr double ring_step = 9.0;  // pixels
  constexpr int ring_cost = 3;
  std::optional<Box> best;
  int least = 0;
  for (int ring = 0; ring < rings; ++ring)
    for (int direction = 0; direction < directions; ++direction)
    {
      const double angle = 2.0 * std::numbers::pi * (direction + 0.5) / directions;
      const double distance = 6.0 + ring_step * ring;
      // The nearest point of the box lies at that distance.
      const double dx = std::cos(angle) * distance;
      const double dy = -std::sin(angle) * distance;
      const Box box{x + dx + (std::cos(angle) - 1.0) * 0.5 * width,
                    y + dy - (std::sin(angle) + 1.0) * 0.5 * height, width, height};
      const std::optional<int> crossed = cost(box);
      if (!crossed || (best && *crossed + ring_cost * ring >= least))
        continue;
      best = box;
      least = *crossed + ring_cost * ring;
    }
  if (best)
    block(*best);
  return best;
}

}  // namespace blockfsi::output::svg
