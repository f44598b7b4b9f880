#include "core/error.hpp"

#include <utility>

namespace blockfsi
{

namespace
{

std::string with_location(const Location& location, const std::string& message)
{
  std::string text = location.file;
  if (location.line > 0)
  {
    text += ":" + std::to_string(location.line);
    if (location.column > 0)
      text += ":" + std::to_string(location.column);
  }
  return text + ": " + message;
}

}  // namespace

Error::Error(std::string message) : std::runtime_error(message), message_(std::move(message)) {}

Error::Error(Location location, std::string message)
    : std::runtime_error(with_location(location, message)), message_(std::move(message)),
      location_(std::move(location))
{
}

Error Error::within(std::string_view context) const
{
  std::string message = std::string(context) + ": " + message_;
  return location_ ? Error(*location_, std::move(message)) : Error(std::move(message));
}

Error Error::at(const Location& location) const
{
  return location_ ? *this : Error(location, message_);
}

}  // namespace blockfsi
