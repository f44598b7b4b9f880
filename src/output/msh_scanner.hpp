#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi::output
{

/// Goes through a .msh file: lines of text between sections, numbers as text or little-endian bytes inside.
/// Errors tell the section and the line, or the byte in binary files.
class MshScanner
{
public:
  MshScanner(std::string_view content, std::string file) : content_(content), file_(std::move(file)) {}

  /// From here on numbers are bytes.
  void use_binary() { binary_ = true; }
  bool binary() const { return binary_; }

  /// The next section's name, without the dollar sign, or nothing at the end of the file.
  std::string next_section();
  /// Goes behind the end of the present section. Throws Error if there is none.
  void skip_section();
  /// Throws Error unless the present section ends here.
  void end_section();

  /// The rest of the line.
  std::string_view line();
  /// Numbers as text, in binary files too, as heads of sections have them.
  std::int64_t text_integer();
  double text_number();
  /// A name in quotes.
  std::string quoted();

  int integer();
  std::uint64_t size();
  double number();
  /// How many things of at least so many bytes (binary) or numbers (text) each follow. Throws Error if the
  /// rest of the file is too short for them, so that what is made for them fits into memory.
  std::size_t count(std::size_t bytes_each, std::size_t numbers_each);

  [[noreturn]] void fail(const std::string& message) const;

private:
  template <typename T>
  T read();
  std::string_view token();
  void skip_space();

  std::string_view content_;
  std::string file_;
  std::string section_;
  std::size_t at_ = 0;
  bool binary_ = false;
};

}  // namespace blockfsi::output
