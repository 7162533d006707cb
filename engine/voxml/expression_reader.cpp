#include "continua/voxml/expression_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "continua/core/characters.h"

namespace continua {
namespace {

using Kind = Expression::Kind;

constexpr int deepest_bracket = 100;
constexpr std::string_view space = " \t\r\n\f\v";

// Signs with their spellings. A spelling stands before the spellings that it begins with.
constexpr std::array<std::pair<std::string_view, std::string_view>, 16> spellings = {{
    {"!", "!"},
    {"!", "¬"},
    {"!", "~"},
    {"^", "^"},
    {"^", "&&"},
    {"^", "&"},
    {"^", "∧"},
    {"|", "||"},
    {"|", "|"},
    {"|", "∨"},
    {"->", "->"},
    {"->", "→"},
    {"×", "×"},
    {"'", "'"},
    {"'", "’"},
    {"'", "‘"},
}};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_plain(char c) { return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

bool begins_sign(std::string_view text) {
  return std::any_of(spellings.begin(), spellings.end(),
                     [&](const auto& spelling) { return text.starts_with(spelling.second); });
}

// Length in bytes of the character if a name can contain it, else 0: letters of any script, digits, `_`, `-`, at the
// beginning `+`, later `.`.
std::size_t name_character(std::string_view text, bool first) {
  if (text.empty()) return 0;
  const char c = text[0];
  if (is_plain(c)) return 1;
  if (c == '-' && text.substr(1).starts_with('>')) return 0;
  if (c == '-' || c == (first ? '+' : '.')) return 1;
  const auto length = character_length(text);
  return length > 1 && !begins_sign(text) ? length : 0;
}

}  // namespace

std::string_view ExpressionReader::rest() const {
  auto rest = text_.substr(at_);
  rest.remove_prefix(std::min(rest.find_first_not_of(space), rest.size()));
  return rest;
}

void ExpressionReader::skip(std::size_t length) { at_ = text_.size() - rest().size() + length; }

std::size_t ExpressionReader::sign_length(std::string_view sign) const {
  const auto here = rest();
  for (const auto& [meant, written] : spellings)
    if (meant == sign && here.starts_with(written)) return written.size();
  return here.starts_with(sign) ? sign.size() : 0;
}

bool ExpressionReader::take(std::string_view sign) {
  const auto length = sign_length(sign);
  if (length > 0) skip(length);
  return length > 0;
}

bool ExpressionReader::take_opening(std::string_view word) {
  const auto before = at_;
  if (take(word) && take("(")) return true;
  at_ = before;
  return false;
}

Outcome ExpressionReader::close(std::string_view bracket) {
  if (take(bracket) || (lenient_ && (at_end() || comes("]")))) return {};
  return expected(fmt::format("'{}'", bracket));
}

void ExpressionReader::skip_closing() {
  while (take(")") || take("]")) continue;
}

Error ExpressionReader::expected(std::string_view what) const {
  const auto here = rest();
  std::string found = "the end";
  if (const auto length = character_length(here))
    found = here[0] < ' ' && length == 1 ? fmt::format("byte {:#04x}", static_cast<unsigned>(here[0]))
                                         : fmt::format("'{}'", here.substr(0, length));
  else if (!here.empty())
    found = fmt::format("byte {:#04x}", static_cast<unsigned>(static_cast<unsigned char>(here[0])));
  const auto before = text_.substr(0, text_.size() - here.size());
  return {fmt::format("character {}", characters(before).size() + 1),
          fmt::format("found {}, expected {}", found, what)};
}

Result<Expression> ExpressionReader::expression() { return joined(Kind::either); }

// Operands of | or of ^, which binds more tightly.
Result<Expression> ExpressionReader::joined(Kind kind) {
  const bool either = kind == Kind::either;
  Expression all{kind, "", {}};
  do {
    auto each = either ? joined(Kind::both) : negated();
    if (!each) return each.error();
    if (each->kind == kind)
      std::move(each->arguments.begin(), each->arguments.end(), std::back_inserter(all.arguments));
    else
      all.arguments.push_back(std::move(*each));
  } while (take(either ? "|" : "^"));
  if (all.arguments.size() > 1) return all;
  return Expression(std::move(all.arguments[0]));
}

Result<Expression> ExpressionReader::negated() {
  if (depth_ == deepest_bracket) return expected(fmt::format("at most {} brackets in each other", deepest_bracket));
  ++depth_;
  const bool negation = take("!");
  auto inner = negation ? negated() : primary();
  --depth_;
  if (!inner || !negation) return inner;
  return Expression{Kind::negation, "", {std::move(*inner)}};
}

Result<Expression> ExpressionReader::primary() {
  if (comes("(") || comes("[")) return bracket();
  if (comes("'") || comes("\"")) return quoted();
  if (comes("<")) return vector();
  return named();
}

// (a), [a], or the part [2].
Result<Expression> ExpressionReader::bracket() {
  const bool square = !take("(");
  if (square) {
    take("[");
    const auto before = at_;
    const auto here = rest();
    if (const auto length = name_length()) {
      skip(length);
      if (comes("]") || at_end()) {
        if (auto problem = close("]")) return *problem;
        return Expression{Kind::component, std::string(here.substr(0, length)), {}};
      }
      at_ = before;
    }
  }
  auto inner = expression();
  if (!inner) return inner;
  if (auto problem = close(square ? "]" : ")")) return *problem;
  return inner;
}

Result<Expression> ExpressionReader::quoted() {
  const auto here = rest();
  const bool twofold = here[0] == '"';
  const auto begin = sign_length(twofold ? "\"" : "'");
  for (std::size_t end = begin; end < here.size(); ++end) {
    const auto tail = here.substr(end);
    const bool closes = twofold ? tail[0] == '"' : tail[0] == '\'' || tail.starts_with("’");
    if (!closes) continue;
    skip(end + (tail[0] == '\'' || twofold ? 1 : std::string_view("’").size()));
    return Expression{Kind::text, std::string(here.substr(begin, end - begin)), {}};
  }
  return expected("a text with a closing quotation mark");
}

// A place in numbers, <0.5; 0.9; -0.1>, kept as a name.
Result<Expression> ExpressionReader::vector() {
  take("<");
  std::string text = "<";
  do {
    const auto here = rest();
    const auto length = name_length();
    if (length == 0) return expected("a number");
    skip(length);
    text += (text.size() == 1 ? "" : "; ") + std::string(here.substr(0, length));
  } while (take(";") || take(","));
  if (!take(">")) return expected("'>'");
  return Expression{Kind::name, text + ">", {}};
}

// The rest of vec(x -> y × z), after the arrow.
Result<Expression> ExpressionReader::vector_onto(Expression vector) {
  auto through = expression();
  if (!through) return through;
  if (!take("×") && !take("*")) return expected("'×', as in vec(x -> y × z)");
  auto onto = expression();
  if (!onto) return onto;
  vector.arguments.push_back(std::move(*through));
  vector.arguments.push_back(std::move(*onto));
  if (auto problem = close(")")) return *problem;
  return vector;
}

std::size_t ExpressionReader::name_length() const {
  const auto here = rest();
  std::size_t length = name_character(here, true);
  while (length > 0) {
    const auto next = name_character(here.substr(length), false);
    if (next == 0) break;
    length += next;
  }
  return length;
}

// A name or a call; a number in brackets right after a name is part of it: handle[2], y[].
Result<Expression> ExpressionReader::named() {
  auto length = name_length();
  const auto here = rest();
  if (length == 0) return expected("a name");
  if (here.substr(length).starts_with('[')) {
    auto end = length + 1;
    while (end < here.size() && is_plain(here[end])) ++end;
    if (end < here.size() && here[end] == ']') length = end + 1;
  }
  skip(length);
  Expression expression{Kind::name, std::string(here.substr(0, length)), {}};
  if (!take("(")) return expression;
  expression.kind = Kind::call;
  if (take(")")) return expression;
  do {
    auto each = this->expression();
    if (!each) return each;
    expression.arguments.push_back(std::move(*each));
    if (expression.name == "vec" && expression.arguments.size() == 1 && take("->"))
      return vector_onto(std::move(expression));
  } while (take(",") || take(";"));
  if (auto problem = close(")")) return *problem;
  return expression;
}

}  // namespace continua
