#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace blockfsi
{

/// Position in a text file, both counted from 1; line 0 means the whole file.
struct Location
{
  std::string file;
  int line = 0;
  int column = 0;

  bool operator==(const Location&) const = default;
};

/// A mistake of the user: what is wrong, the value found, the remedy and, where known, the place.
/// what() reads "file:line:column: message".
class Error : public std::runtime_error
{
public:
  explicit Error(std::string message);
  Error(Location location, std::string message);

  const std::string& message() const { return message_; }
  const std::optional<Location>& location() const { return location_; }

  /// The same error with context in front of its message: "block 'wake': ...".
  Error within(std::string_view context) const;

  /// The same error at a place, unless it already has one.
  Error at(const Location& location) const;

private:
  std::string message_;
  std::optional<Location> location_;
};

}  // namespace blockfsi
