#include "core/expression_lexer.hpp"

#include "core/error.hpp"
#include "core/space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <system_error>
#include <utility>

namespace blockfsi::expression
{

namespace
{

bool is_digit(char c)
{
  return c >= '0' && c <= '9';
}

bool is_letter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool continues_letter(char c)
{
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// Signs of other languages and how they are written here.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> foreign = {
    {{"**", "^"}, {"&&", "and"}, {"||", "or"}, {"!", "not"}}};

}  // namespace

Lexer::Lexer(std::string_view text) : text_(text)
{
  advance();
}

void Lexer::advance()
{
  while (next_ < text_.size() && is_space(text_[next_]))
    ++next_;
  if (next_ == text_.size())
    now_ = {Token::Kind::end, {}, 0.0, next_};
  else if (is_digit(text_[next_]) || text_[next_] == '.')
    now_ = number(next_);
  else if (is_letter(text_[next_]))
  {
    std::size_t end = next_;
    while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end])))
      ++end;
    now_ = {Token::Kind::name, text_.substr(next_, end - next_), 0.0, next_};
  }
  else
    now_ = symbol(next_);
  next_ = now_.position + now_.text.size();
}

Token Lexer::number(std::size_t begin) const
{
  double value = 0.0;
  const char* first = text_.data() + begin;
  const auto [end, error] = std::from_chars(first, text_.data() + text_.size(), value);
  if (error == std::errc::invalid_argument)
    fail(begin, "found '.' where a number such as 0.5 is allowed");
  const std::string_view digits(first, static_cast<std::size_t>(end - first));
  if (error == std::errc::result_out_of_range)
    fail(begin, fmt::format("the number '{}' is too large or too small for a double", digits));
  return {Token::Kind::number, digits, value, begin};
}

Token Lexer::symbol(std::size_t begin) const
{
  static constexpr std::string_view singles = "+-*/^()<>=,";
  const std::string_view rest = text_.substr(begin);
  for (const std::string_view pair : {"==", "!=", "<=", ">="})
    if (rest.starts_with(pair))
      return {Token::Kind::symbol, rest.substr(0, 2), 0.0, begin};
  for (const auto& [sign, ours] : foreign)
    if (rest.starts_with(sign))
      fail(begin, fmt::format("found '{}', which is written '{}' here", sign, ours));
  if (singles.find(rest.front()) != std::string_view::npos)
    return {Token::Kind::symbol, rest.substr(0, 1), 0.0, begin};
  std::size_t size = 1;
  while (size < rest.size() && continues_letter(rest[size]))
    ++size;
  fail(begin, fmt::format("found '{}', which no formula contains; allowed are numbers, names and {}",
                          rest.substr(0, size), "+ - * / ^ ( ) , = == != < <= > >="));
}

void Lexer::fail(std::size_t position, std::string_view message) const
{
  // Columns count letters as an editor does, not bytes.
  const auto begin = text_.begin();
  const auto column = std::count_if(begin, begin + static_cast<std::ptrdiff_t>(position),
                                    [](char c) { return !continues_letter(c); });
  throw Error(fmt::format("column {} of \"{}\": {}", column + 1, text_, message));
}

void Lexer::expected(std::string_view allowed) const
{
  const std::string found = now_.kind == Token::Kind::end ? "the end" : fmt::format("'{}'", now_.text);
  fail(now_.position, fmt::format("found {} where {} is allowed", found, allowed));
}

}  // namespace blockfsi::expression
