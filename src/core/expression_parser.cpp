#include "core/expression_parser.hpp"

#include "core/error.hpp"
#include "core/expression_lexer.hpp"
#include "core/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace blockfsi::expression
{

namespace
{

struct Function
{
  std::string_view name;
  Operation operation;
  int arity;
  bool more = false;  ///< may have more arguments than `arity`
};

constexpr std::array functions = {
    Function{"abs", Operation::abs, 1},       Function{"sqrt", Operation::sqrt, 1},
    Function{"exp", Operation::exp, 1},       Function{"log", Operation::log, 1},
    Function{"sin", Operation::sin, 1},       Function{"cos", Operation::cos, 1},
    Function{"tan", Operation::tan, 1},       Function{"asin", Operation::asin, 1},
    Function{"acos", Operation::acos, 1},     Function{"atan", Operation::atan, 1},
    Function{"atan2", Operation::atan2, 2},   Function{"sinh", Operation::sinh, 1},
    Function{"cosh", Operation::cosh, 1},     Function{"tanh", Operation::tanh, 1},
    Function{"min", Operation::min, 2, true}, Function{"max", Operation::max, 2, true},
    Function{"pow", Operation::power, 2},     Function{"floor", Operation::floor, 1},
    Function{"step", Operation::step, 1},     Function{"if", Operation::select, 3},
    Function{"ramp", Operation::ramp, 2}};

/// A surface's u and v are the first and the second argument, as x and y are.
constexpr std::array<std::string_view, 6> variable_names = {"x", "y", "z", "t", "u", "v"};

/// Deeper nesting than any person writes; keeps hostile texts from exhausting the stack of the process.
constexpr int largest_depth = 100;

/// Whether a part of a formula is a number or a statement that holds or not.
enum class Meaning
{
  number,
  statement
};

class Parser
{
public:
  Parser(std::string_view text, const Constants& constants, std::span<const std::string_view> variables,
         Purpose purpose)
      : lexer_(text), constants_(constants), variables_(variables), purpose_(purpose)
  {
    program_.text = text;
  }

  Program run()
  {
    const Meaning meaning = disjunction();
    if (lexer_.now().kind != Token::Kind::end)
      expected("an operator (+ - * / ^, a comparison, 'and', 'or') or the end");
    if (purpose_ == Purpose::condition && meaning == Meaning::number)
      lexer_.fail(0, "this is a number, not a condition; compare it with something, as in x = 0");
    return std::move(program_);
  }

private:
  /// Counts the nesting while one level is read.
  struct Level
  {
    explicit Level(Parser& parser) : parser_(parser)
    {
      if (++parser_.depth_ > largest_depth)
        parser_.lexer_.fail(
            parser_.lexer_.now().position,
            fmt::format("nested more than {} levels deep; simplify the formula", largest_depth));
    }
    ~Level() { --parser_.depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;
    Parser& parser_;
  };

  [[noreturn]] void expected(std::string_view allowed) const { lexer_.expected(allowed); }

  bool take(std::string_view text)
  {
    const Token& token = lexer_.now();
    if (token.kind == Token::Kind::number || token.kind == Token::Kind::end || token.text != text)
      return false;
    lexer_.advance();
    return true;
  }

  void require(std::string_view text)
  {
    if (!take(text))
      expected(fmt::format("'{}'", text));
  }

  void require_statement(Meaning meaning, std::size_t position, std::string_view word) const
  {
    if (meaning == Meaning::number)
      lexer_.fail(
          position,
          fmt::format("found a number beside '{}', where a comparison such as x = 0 is allowed", word));
  }

  Meaning disjunction()
  {
    const Level level(*this);
    return logic("or", Operation::either, &Parser::conjunction);
  }

  Meaning conjunction() { return logic("and", Operation::both, &Parser::negation); }

  Meaning logic(std::string_view word, Operation operation, Meaning (Parser::*operand)())
  {
    const std::size_t first = lexer_.now().position;
    Meaning meaning = (this->*operand)();
    while (lexer_.now().text == word)
    {
      require_statement(meaning, first, word);
      lexer_.advance();
      const std::size_t second = lexer_.now().position;
      require_statement((this->*operand)(), second, word);
      emit(operation, 2);
      meaning = Meaning::statement;
    }
    return meaning;
  }

  Meaning negation()
  {
    if (!take("not"))
      return comparison();
    const Level level(*this);
    const std::size_t position = lexer_.now().position;
    require_statement(negation(), position, "not");
    emit(Operation::invert, 1);
    return Meaning::statement;
  }

  Meaning comparison()
  {
    Meaning meaning = sum();
    if (!is_comparison(lexer_.now()))
      return meaning;
    const std::string_view sign = lexer_.now().text;
    lexer_.advance();
    // a > b is b < a; as the operands are on the stack already, it becomes -a < -b.
    const bool mirrored = sign.front() == '>';
    if (mirrored)
      emit(Operation::negate, 1);
    sum();
    if (mirrored)
      emit(Operation::negate, 1);
    emit(comparison_operation(sign), 2);
    if (is_comparison(lexer_.now()))
      lexer_.fail(lexer_.now().position, "comparisons cannot be chained; write 0 < x and x < 1");
    return Meaning::statement;
  }

  static bool is_comparison(const Token& token)
  {
    static constexpr std::array<std::string_view, 7> signs = {"=", "==", "!=", "<", "<=", ">", ">="};
    return token.kind == Token::Kind::symbol &&
           std::find(signs.begin(), signs.end(), token.text) != signs.end();
  }

  Operation comparison_operation(std::string_view sign) const
  {
    if (sign == "=" || sign == "==")
      return Operation::equal;
    if (sign == "!=")
      return Operation::differ;
    return sign.size() == 2 || purpose_ == Purpose::condition ? Operation::less_equal : Operation::less;
  }

  Meaning sum()
  {
    Meaning meaning = product();
    while (lexer_.now().text == "+" || lexer_.now().text == "-")
    {
      const Operation operation = lexer_.now().text == "+" ? Operation::add : Operation::subtract;
      lexer_.advance();
      product();
      emit(operation, 2);
      meaning = Meaning::number;
    }
    return meaning;
  }

  Meaning product()
  {
    Meaning meaning = sign();
    while (lexer_.now().text == "*" || lexer_.now().text == "/")
    {
      const Operation operation = lexer_.now().text == "*" ? Operation::multiply : Operation::divide;
      lexer_.advance();
      sign();
      emit(operation, 2);
      meaning = Meaning::number;
    }
    return meaning;
  }

  /// Unary minus binds weaker than ^, as in mathematics: -x^2 = -(x^2).
  Meaning sign()
  {
    if (!take("-"))
      return power();
    const Level level(*this);
    sign();
    emit(Operation::negate, 1);
    return Meaning::number;
  }

  Meaning power()
  {
    const Meaning meaning = primary();
    if (!take("^"))
      return meaning;
    const Level level(*this);
    sign();
    emit(Operation::power, 2);
    return Meaning::number;
  }

  Meaning primary()
  {
    const Token token = lexer_.now();
    if (token.kind == Token::Kind::number)
    {
      lexer_.advance();
      push({Operation::number, 0, token.value});
      return Meaning::number;
    }
    if (token.kind == Token::Kind::name && token.text != "and" && token.text != "or" && token.text != "not")
    {
      lexer_.advance();
      name(token);
      return Meaning::number;
    }
    if (!take("("))
      expected("a number, a name, '(' or '-'");
    const Meaning meaning = disjunction();
    require(")");
    return meaning;
  }

  void name(const Token& token)
  {
    const auto function = std::find_if(functions.begin(), functions.end(),
                                       [&](const Function& f) { return f.name == token.text; });
    if (function != functions.end())
      return call(*function, token);
    if (lexer_.now().text == "(")
      unknown_function(token);
    if (const auto variable = std::find(variables_.begin(), variables_.end(), token.text);
        variable != variables_.end())
    {
      const auto index = static_cast<std::size_t>(
          (std::find(variable_names.begin(), variable_names.end(), token.text) - variable_names.begin()) % 4);
      program_.uses[index] = true;
      push({static_cast<Operation>(static_cast<std::size_t>(Operation::x) + index)});
    }
    else if (const auto constant = constants_.find(token.text); constant != constants_.end())
      push({Operation::number, 0, constant->second});
    else if (token.text == "pi")
      push({Operation::number, 0, std::numbers::pi});
    else
      unknown_name(token);
  }

  void call(const Function& function, const Token& token)
  {
    if (lexer_.now().text != "(")
      expected(fmt::format("'(' after the function '{}'", function.name));
    lexer_.advance();
    int count = 0;
    do
    {
      disjunction();
      // min(a, b, c) is min(min(a, b), c).
      if (++count >= 2 && function.more)
        emit(function.operation, 2);
    } while (take(","));
    if (lexer_.now().text != ")")
      expected("',' or ')'");
    if (count < function.arity || (count > function.arity && !function.more))
      lexer_.fail(token.position, fmt::format("'{}' takes {}{} argument{}, found {}", function.name,
                                              function.more ? "at least " : "", function.arity,
                                              function.arity == 1 ? "" : "s", count));
    lexer_.advance();
    if (!function.more)
      emit(function.operation, static_cast<std::uint8_t>(function.arity));
  }

  [[noreturn]] void unknown_function(const Token& token) const
  {
    std::vector<std::string> names;
    names.reserve(functions.size());
    for (const Function& f : functions)
      names.emplace_back(f.name);
    lexer_.fail(token.position,
                fmt::format("unknown function '{}'{}", token.text, suggestion(token.text, names)));
  }

  [[noreturn]] void unknown_name(const Token& token) const
  {
    std::vector<std::string> names(variables_.begin(), variables_.end());
    for (const auto& [constant, value] : constants_)
      names.push_back(constant);
    names.emplace_back("pi");
    if (std::find(variable_names.begin(), variable_names.end(), token.text) != variable_names.end())
      lexer_.fail(token.position,
                  fmt::format("'{}' may not occur here; allowed are {}", token.text, listed(names)));
    // A wrong letter makes a likelier proposal than a wrong length: single letters are near to everything.
    const std::string hint = token.text.size() > 1 ? did_you_mean(token.text, names) : "";
    lexer_.fail(token.position, fmt::format("unknown name '{}'{}{}", token.text, hint.empty() ? ";" : hint,
                                            fmt::format(" known are {}", listed(names))));
  }

  void push(Instruction instruction)
  {
    if (++height_ > stack_size)
      lexer_.fail(0,
                  fmt::format("more than {} values wait for an operator; simplify the formula", stack_size));
    program_.code.push_back(instruction);
  }

  /// Appends an operation, or its result if all operands are numbers. Comparisons wait for their tolerance.
  void emit(Operation operation, std::uint8_t arity)
  {
    std::vector<Instruction>& code = program_.code;
    height_ -= static_cast<std::size_t>(arity - 1);
    code.push_back({operation, arity});
    const auto begin = code.end() - 1 - arity;
    const bool compares = operation >= Operation::equal && operation <= Operation::less_equal;
    const auto is_number = [](const Instruction& i) { return i.operation == Operation::number; };
    if (compares || !std::all_of(begin, code.end() - 1, is_number))
      return;
    const double value = evaluate({begin, code.end()}, {}, 0.0);
    code.erase(begin, code.end());
    code.push_back({Operation::number, 0, value});
  }

  Lexer lexer_;
  const Constants& constants_;
  std::span<const std::string_view> variables_;
  Purpose purpose_;
  Program program_;
  std::size_t height_ = 0;
  int depth_ = 0;
};

}  // namespace

Program parse(std::string_view text, const Constants& constants, std::span<const std::string_view> variables,
              Purpose purpose)
{
  return Parser(text, constants, variables, purpose).run();
}

}  // namespace blockfsi::expression
