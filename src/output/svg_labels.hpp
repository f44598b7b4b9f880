#pragma once

// Private to output/: where texts of a picture find room.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace blockfsi::output::svg
{

/// A box on a page [pixels].
struct Box
{
  double x = 0.0;  ///< left
  double y = 0.0;  ///< top
  double width = 0.0;
  double height = 0.0;
};

/// Width of a text in a sans-serif font of that size, near enough [pixels].
double text_width(std::string_view text, double size);

/// What the parts of a page are taken by, in squares of a few pixels.
class Room
{
public:
  Room(double width, double height);

  /// Lines may be crossed by a text that finds no better place.
  void add_line_point(double x, double y);
  void block(const Box& box);

  /// How many squares with lines a box covers; nothing where it is blocked or leaves the page.
  std::optional<int> cost(const Box& box) const;

  /// Near a point the place for a text of this size with the least cost, farther ones counting more, blocked
  /// from then on.
  std::optional<Box> place_near(double x, double y, double width, double height);

private:
  enum : std::uint8_t
  {
    is_free,
    is_line,
    is_blocked
  };

  std::uint8_t& at(int column, int row)
  {
    return squares_[static_cast<std::size_t>(row) * columns_ + column];
  }
  std::uint8_t at(int column, int row) const
  {
    return squares_[static_cast<std::size_t>(row) * columns_ + column];
  }

  int columns_;
  int rows_;
  std::vector<std::uint8_t> squares_;
};

}  // namespace blockfsi::output::svg
