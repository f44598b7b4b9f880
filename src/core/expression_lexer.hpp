#pragma once

#include <cstddef>
#include <string_view>

namespace blockfsi::expression
{

/// A word of a formula.
struct Token
{
  enum class Kind
  {
    number,
    name,
    symbol,
    end
  };
  Kind kind = Kind::end;
  std::string_view text;
  double value = 0.0;        ///< of a number
  std::size_t position = 0;  ///< of its first byte
};

/// Cuts a formula into words, one at a time.
class Lexer
{
public:
  /// `text` must outlive the lexer. Throws Error for a letter that no formula contains.
  explicit Lexer(std::string_view text);

  /// The word at hand.
  const Token& now() const { return now_; }
  /// Goes on to the next word.
  void advance();

  /// Throws Error "column n of "text": message".
  [[noreturn]] void fail(std::size_t position, std::string_view message) const;
  /// Throws Error that the word at hand was found where something else is allowed.
  [[noreturn]] void expected(std::string_view allowed) const;

private:
  Token number(std::size_t begin) const;
  Token symbol(std::size_t begin) const;

  std::string_view text_;
  std::size_t next_ = 0;
  Token now_;
};

}  // namespace blockfsi::expression
