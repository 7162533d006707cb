#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "continua/term/lexer.h"
#include "continua/term/syntax.h"

namespace continua {
namespace {

// How tightly the operators bind, from loosest to an operand.
enum Binding : int { loosest = 1, disjunction = 1, conjunction, negation, comparison, sum, product, operand };

int binding_of(const Token& token) {
  if (token.kind != Token::Kind::sign) return 0;
  if (token.text == "or") return disjunction;
  if (token.text == "and") return conjunction;
  if (token.text == "+" || token.text == "-") return sum;
  if (token.text == "*" || token.text == "/") return product;
  const bool compares = token.text == "=" || token.text == "!=" || token.text == "<" || token.text == "<=" ||
                        token.text == ">" || token.text == ">=";
  return compares ? comparison : 0;
}

Syntax name_syntax(std::size_t begin, std::string name, bool constant) {
  Syntax syntax;
  syntax.kind = Syntax::Kind::name;
  syntax.begin = begin;
  syntax.name = std::move(name);
  syntax.constant = constant;
  return syntax;
}

Syntax literal_syntax(std::size_t begin, Term literal) {
  Syntax syntax;
  syntax.begin = begin;
  syntax.literal = std::move(literal);
  return syntax;
}

bool is_number(const Syntax& syntax) {
  return syntax.kind == Syntax::Kind::literal && syntax.literal.kind() == Term::Kind::number;
}

class Parser {
 public:
  Parser(std::string_view text, const std::vector<std::string>& base_types) : lexer_(text), base_types_(base_types) {}

  Result<Syntax> whole() {
    if (auto problem = advance()) return *problem;
    auto syntax = expression(loosest);
    if (syntax && token_.kind != Token::Kind::end) return found("an operator or the end");
    return syntax;
  }

 private:
  // One level of nesting: an operand, and the operators after it that bind at least as tightly as `least`.
  Result<Syntax> expression(int least) {
    if (nesting_ >= deepest_term) return too_deep(token_.begin);
    ++nesting_;
    const auto from = token_.begin;
    auto left = prefixed();
    const auto span = [&](Syntax& syntax) {
      syntax.from = from;
      syntax.end = read_to_;
    };
    if (left) span(*left);
    while (left && binding_of(token_) >= least) {
      auto joined = infix(std::move(*left));
      left = std::move(joined);
      if (left) span(*left);
    }
    --nesting_;
    return left;
  }

  Result<Syntax> infix(Syntax left) {
    const Token sign = token_;
    const int binding = binding_of(sign);
    if (auto problem = advance()) return *problem;
    auto right = expression(binding + 1);
    if (!right) return right;
    if (binding == comparison && binding_of(token_) == comparison)
      return error(token_.begin,
                   fmt::format("found '{}' after a comparison; put one of the two in parentheses", token_.text));
    const auto begin = left.begin;
    return applied(name_syntax(sign.begin, sign.text, true), begin, std::move(left), std::move(*right));
  }

  Result<Syntax> prefixed() {
    if (!token_.is("not") && !token_.is("-")) return postfixed();
    const Token sign = token_;
    if (auto problem = advance()) return *problem;
    const bool number_follows = token_.kind == Token::Kind::number;
    auto inner = expression(sign.is("not") ? comparison : operand);
    if (!inner) return inner;
    if (sign.is("not")) return applied(name_syntax(sign.begin, "not", true), sign.begin, std::move(*inner));
    if (number_follows && is_number(*inner))
      return literal_syntax(sign.begin, Term::number(-inner->literal.number_value()));
    return applied(name_syntax(sign.begin, "negate", true), sign.begin, std::move(*inner));
  }

  // A primary and the argument lists after it.
  Result<Syntax> postfixed() {
    auto function = primary();
    while (function && token_.is("(")) {
      if (auto problem = advance()) return *problem;
      if (token_.is(")")) return found("an argument; a name without arguments is written without parentheses");
      auto arguments = separated(")");
      if (!arguments) return arguments.error();
      const auto begin = function->begin;
      for (auto& argument : *arguments) {
        function = applied(std::move(*function), begin, std::move(argument));
        if (!function) return function;
      }
    }
    return function;
  }

  Result<Syntax> primary() {
    if (token_.is("\\")) return lambda();
    if (token_.is("(")) return parenthesised();
    if (token_.is("[")) return list();
    if (token_.is("<")) return point();
    if (token_.kind == Token::Kind::sign || token_.kind == Token::Kind::end) return found("a term");
    Token token = token_;
    if (auto problem = advance()) return *problem;
    if (token.kind == Token::Kind::number) return literal_syntax(token.begin, Term::number(token.number));
    if (token.kind == Token::Kind::text) return literal_syntax(token.begin, Term::text(token.text));
    if (!token.quoted && token.text == "null") return literal_syntax(token.begin, Term::null());
    if (!token.quoted && token.text == "true") return literal_syntax(token.begin, Term::truth(true));
    if (!token.quoted && token.text == "false") return literal_syntax(token.begin, Term::truth(false));
    return name_syntax(token.begin, std::move(token.text), token.quoted);
  }

  // (term), or an operator as a name: (+).
  Result<Syntax> parenthesised() {
    const auto begin = token_.begin;
    if (auto problem = advance()) return *problem;
    if (binding_of(token_) > 0 || token_.is("not")) {
      const auto before = std::pair(lexer_, token_);
      const Token sign = token_;
      if (auto problem = advance()) return *problem;
      if (token_.is(")")) {
        if (auto problem = advance()) return *problem;
        return name_syntax(begin, sign.text, true);
      }
      std::tie(lexer_, token_) = before;
    }
    auto inner = expression(loosest);
    if (!inner) return inner;
    if (auto problem = expect(")")) return *problem;
    inner->bare = false;
    return inner;
  }

  Result<Syntax> list() {
    Syntax syntax;
    syntax.kind = Syntax::Kind::list;
    syntax.begin = token_.begin;
    if (auto problem = advance()) return *problem;
    if (!token_.is("]")) {
      auto elements = separated("]");
      if (!elements) return elements.error();
      syntax.parts = std::move(*elements);
    } else if (auto problem = advance()) {
      return *problem;
    }
    return measured(std::move(syntax));
  }

  // <a, b, c>: a literal if its entries are literals, else xyz(a, b, c).
  Result<Syntax> point() {
    const auto begin = token_.begin;
    std::vector<Syntax> entries;
    for (int i = 0; i < 3; ++i) {
      if (i > 0 && !token_.is(",")) return found("',': a point has three coordinates");
      if (auto problem = advance()) return *problem;
      auto entry = expression(sum);  // the sign > ends the point
      if (!entry) return entry;
      entries.push_back(std::move(*entry));
    }
    if (token_.is(">=")) {  // <0, 0, 0>=p
      token_.text = "=";
      read_to_ = ++token_.begin;
    } else if (auto problem = expect(">")) {
      return *problem;
    }
    if (std::all_of(entries.begin(), entries.end(), is_number))
      return literal_syntax(begin, Term::point(entries[0].literal.number_value(), entries[1].literal.number_value(),
                                               entries[2].literal.number_value()));
    return applied(name_syntax(begin, "xyz", true), begin, std::move(entries[0]), std::move(entries[1]),
                   std::move(entries[2]));
  }

  // \x y. body, \x: type. body
  Result<Syntax> lambda() {
    std::vector<Syntax> binders;
    const auto begin = token_.begin;
    if (auto problem = advance()) return *problem;
    while (token_.kind == Token::Kind::name && !token_.quoted) {
      if (is_keyword(token_.text)) return found("the name of a variable");
      Syntax binder;
      binder.kind = Syntax::Kind::lambda;
      binder.begin = binders.empty() ? begin : token_.begin;
      binder.name = token_.text;
      binders.push_back(std::move(binder));
      if (auto problem = advance()) return *problem;
    }
    if (binders.empty()) return found("the name of a variable");
    if (binders.size() + nesting_ > deepest_term) return too_deep(token_.begin);
    if (token_.is(":")) {
      if (binders.size() > 1) return error(token_.begin, "found ':' after several variables; write \\x: e. \\y: e. …");
      if (auto problem = annotate(binders.back())) return *problem;
    }
    if (!token_.is(".")) return found("'.' before the body");
    if (auto problem = advance()) return *problem;
    auto body = expression(loosest);
    for (; body && !binders.empty(); binders.pop_back()) {
      Syntax binder = std::move(binders.back());
      binder.parts.push_back(std::move(*body));
      body = measured(std::move(binder));
    }
    return body;
  }

  Outcome annotate(Syntax& binder) {
    lexer_.skip_space();
    const auto begin = lexer_.at();
    auto type = Type::parse(lexer_.raw_until('.'), base_types_, begin + 1);
    if (!type) return type.error();
    binder.annotation = *type;
    return advance();
  }

  // Terms with commas between them, and the sign that closes them.
  Result<std::vector<Syntax>> separated(std::string_view close) {
    std::vector<Syntax> parts;
    for (;;) {
      auto part = expression(loosest);
      if (!part) return part.error();
      parts.push_back(std::move(*part));
      if (token_.is(close)) break;
      if (!token_.is(",")) return found(fmt::format("',' or '{}'", close));
      if (auto problem = advance()) return *problem;
    }
    if (auto problem = advance()) return *problem;
    return parts;
  }

  template <class... Arguments>
  Result<Syntax> applied(Syntax function, std::size_t begin, Arguments... arguments) {
    Syntax syntax;
    if (function.kind == Syntax::Kind::apply && function.bare) {
      syntax = std::move(function);
    } else {
      syntax.kind = Syntax::Kind::apply;
      syntax.parts.push_back(std::move(function));
    }
    syntax.begin = begin;
    (syntax.parts.push_back(std::move(arguments)), ...);
    return measured(std::move(syntax));
  }

  Result<Syntax> measured(Syntax syntax) const {
    syntax.depth = 1;
    for (const auto& part : syntax.parts) syntax.depth = std::max(syntax.depth, part.depth + 1);
    if (syntax.kind == Syntax::Kind::apply) syntax.depth += syntax.parts.size() - 2;
    if (syntax.depth > deepest_term) return too_deep(syntax.begin);
    return syntax;
  }

  Outcome advance() {
    read_to_ = lexer_.at();
    auto token = lexer_.next();
    if (!token) return token.error();
    token_ = std::move(*token);
    return {};
  }
  Outcome expect(std::string_view sign) {
    if (!token_.is(sign)) return found(fmt::format("'{}'", sign));
    return advance();
  }
  Error found(std::string_view expected) const {
    return error(token_.begin, fmt::format("found {}, expected {}", token_.described(), expected));
  }
  Error too_deep(std::size_t at) const {
    return error(at, fmt::format("the term is nested deeper than {}", deepest_term));
  }
  Error error(std::size_t at, std::string sentence) const { return {column(at), std::move(sentence)}; }

  Lexer lexer_;
  Token token_;
  const std::vector<std::string>& base_types_;
  std::size_t nesting_ = 0;
  std::size_t read_to_ = 0;  // the end of the token before token_
};

}  // namespace

Result<Syntax> parse_syntax(std::string_view text, const std::vector<std::string>& base_types) {
  return Parser(text, base_types).whole();
}

}  // namespace continua
